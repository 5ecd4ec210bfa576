#include "limn/mesh/polygon/orientation.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace limn::mesh {
namespace {

int sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

/// Whether a - b is a double, and which.
bool exact_difference(double a, double b, double& difference) {
  difference = a - b;
  const double b_part = a - difference;
  return a - (difference + b_part) == 0 && b_part - b == 0;
}

/// A sum of doubles of increasing size that do not overlap; its sign is that of the last.
class Expansion {
 public:
  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }
  [[nodiscard]] int sign() const {
    for (std::size_t i = size_; i-- > 0;)
      if (parts_[i] != 0) return mesh::sign(parts_[i]);
    return 0;
  }

 private:
  void add(double x) {
    for (std::size_t i = 0; i < size_; ++i) {
      const double part = parts_[i], sum = x + part;
      const double of_part = sum - x;
      parts_[i] = (x - (sum - of_part)) + (part - of_part);
      x = sum;
    }
    parts_[size_++] = x;
  }

  std::array<double, 12> parts_{};
  std::size_t size_ = 0;
};

}  // namespace

int turn(Point2 a, Point2 b, Point2 c) {
  constexpr double kRounding = 3.3306690738754716e-16;  // (3 + 16 ε) ε, ε = 2^-53 [Shewchuk]
  double ax = 0, ay = 0, bx = 0, by = 0;
  bool exact = exact_difference(a.x, c.x, ax);
  exact = exact_difference(a.y, c.y, ay) && exact;
  exact = exact_difference(b.x, c.x, bx) && exact;
  exact = exact_difference(b.y, c.y, by) && exact;
  const double left = ax * by, right = ay * bx;
  if (std::abs(left - right) > kRounding * (std::abs(left) + std::abs(right)))
    return sign(left - right);
  // what is collinear on a lattice ends here
  if (exact && left == right) {
    const double left_rest = std::fma(ax, by, -left), right_rest = std::fma(ay, bx, -right);
    return left_rest > right_rest ? 1 : left_rest < right_rest ? -1 : 0;
  }
  Expansion sum;
  sum.add_product(a.x, b.y);
  sum.add_product(-a.y, b.x);
  sum.add_product(b.x, c.y);
  sum.add_product(-b.y, c.x);
  sum.add_product(c.x, a.y);
  sum.add_product(-c.y, a.x);
  return sum.sign();
}

}  // namespace limn::mesh
