#pragma once
/// Numbers in double precision with a bound of their error: as Ball, some ten times faster, and of
/// a precision that ends.

#include <algorithm>
#include <cmath>
#include <limits>

#include "limn/number/ball.h"
#include "limn/regular/smoothness/rounding.h"

namespace limn::certify {

/// All x with |x - value| ≤ error. What overflows has no sign.
struct DoubleBall {
  double value = 0;
  double error = 0;

  DoubleBall() = default;
  DoubleBall(double middle, double most) : value(middle), error(most) {}
  /// Holds all that `ball` holds.
  explicit DoubleBall(const number::Ball& ball)
      : value(ball.approx()), error(regular::inflated(ball.radius() + roundoff(value))) {}
  explicit DoubleBall(const Rational& number)
      : value(to_double(number)), error(regular::inflated(roundoff(value))) {}

  [[nodiscard]] bool is_positive() const { return value > error; }
  [[nodiscard]] bool is_negative() const { return -value > error; }
  [[nodiscard]] bool holds_zero() const { return !is_positive() && !is_negative(); }

  friend DoubleBall operator+(const DoubleBall& a, const DoubleBall& b) {
    const double sum = a.value + b.value;
    return {sum, regular::inflated(a.error + b.error + roundoff(sum))};
  }
  friend DoubleBall operator-(const DoubleBall& a, const DoubleBall& b) {
    return a + DoubleBall(-b.value, b.error);
  }
  friend DoubleBall operator*(const DoubleBall& a, const DoubleBall& b) {
    const double product = a.value * b.value;
    return {product, regular::inflated(std::abs(a.value) * b.error + a.error * std::abs(b.value) +
                                       a.error * b.error + roundoff(product))};
  }

 private:
  static double roundoff(double value) {
    return std::abs(value) * std::numeric_limits<double>::epsilon();
  }
};

}  // namespace limn::certify
