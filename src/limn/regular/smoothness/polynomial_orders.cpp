#include "limn/regular/smoothness/regularity.h"

#include <vector>

#include "limn/regular/smoothness/transition_operators.h"

namespace limn {
namespace {

constexpr int kMostOrders = 40;

Rational monomial(const std::array<Rational, 2>& x, int i, int j) {
  Rational value = 1;
  for (; i > 0; --i) value *= x[0];
  for (; j > 0; --j) value *= x[1];
  return value;
}

/// Σ (k - centre)^(i, j) a(k) over each coset.
std::vector<Rational> moments(const Mask& mask, const std::array<Rational, 2>& centre, int i,
                              int j) {
  std::vector<Rational> sums(cosets(mask.dilation).size(), Rational(0));
  for (const auto& [k, value] : regular::integer_offsets(mask))
    sums[static_cast<std::size_t>(coset_of(mask.dilation, k))] +=
        value * monomial({k[0] - centre[0], k[1] - centre[1]}, i, j);
  return sums;
}

bool all_equal(const std::vector<Rational>& values) {
  for (const Rational& value : values)
    if (value != values.front()) return false;
  return true;
}

}  // namespace

PolynomialOrders polynomial_orders(const Mask& mask) {
  const Laurent coefficients = regular::integer_offsets(mask);
  std::array<Rational, 2> centre{0, 0};
  for (const auto& [k, value] : coefficients)
    for (std::size_t axis = 0; axis < 2; ++axis)
      centre[axis] += value * k[axis] / mask.dilation.growth();
  PolynomialOrders orders;
  bool reproduces = true;
  for (int degree = 0; degree < kMostOrders; ++degree) {
    bool generates = true;
    for (int i = 0; i <= degree; ++i) {
      const std::vector<Rational> sums = moments(mask, centre, i, degree - i);
      generates = generates && all_equal(sums);
      reproduces = reproduces && generates && sums.front() == (degree == 0 ? 1 : 0);
    }
    if (!generates) break;
    orders.sum_rules = degree + 1;
    if (reproduces) orders.reproduction = degree;
  }
  return orders;
}

}  // namespace limn
