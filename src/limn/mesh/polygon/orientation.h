#pragma once
/// On which side of a line a point of the plane lies, without an error of rounding.

namespace limn::mesh {

struct Point2 {
  double x = 0, y = 0;
  friend bool operator==(const Point2&, const Point2&) = default;
};

/// Twice the signed area of the triangle a, b, c: positive where they run counterclockwise.
/// Rounded.
[[nodiscard]] inline double approx_turn(Point2 a, Point2 b, Point2 c) {
  return (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
}

/// Its sign: -1, 0 or 1, exact unless products of coordinates over- or underflow.
/// [Shewchuk 1997, Adaptive precision floating-point arithmetic, §4.3, without the middle stages]
[[nodiscard]] int turn(Point2 a, Point2 b, Point2 c);

}  // namespace limn::mesh
