#pragma once
/// Points and directions of space, for pictures.

#include <array>
#include <cmath>

namespace limn::figure {

using SpaceVector = std::array<double, 3>;

[[nodiscard]] inline double dot(const SpaceVector& a, const SpaceVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

[[nodiscard]] inline SpaceVector cross(const SpaceVector& a, const SpaceVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// a + t b
[[nodiscard]] inline SpaceVector sum(const SpaceVector& a, const SpaceVector& b, double t = 1) {
  return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}

/// (1 − t) a + t b
[[nodiscard]] inline SpaceVector between(const SpaceVector& a, const SpaceVector& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

[[nodiscard]] inline double length(const SpaceVector& a) { return std::hypot(a[0], a[1], a[2]); }

/// Of length 1, or 0 where the length of `a` is 0 or not finite.
[[nodiscard]] inline SpaceVector normalised(const SpaceVector& a) {
  const double size = length(a);
  if (!(size > 0) || !std::isfinite(size)) return {};
  return {a[0] / size, a[1] / size, a[2] / size};
}

[[nodiscard]] inline bool finite(const SpaceVector& a) {
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

}  // namespace limn::figure
