#pragma once
/// Numbers with their derivatives: a weight evaluated in jets is known together with how it changes
/// as the scheme's names do, exactly but for rounding.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "limn/number/arithmetic.h"

namespace limn::number {

/// A value and its derivatives by some variables, always the same ones within a calculation.
struct Jet {
  double value = 0;
  std::vector<double> slopes;  ///< by variable; empty: a constant

  Jet() = default;
  Jet(double constant) : value(constant) {}
  /// Variable number `index` of `count` ones.
  [[nodiscard]] static Jet variable(double at, std::size_t index, std::size_t count) {
    Jet jet(at);
    jet.slopes.assign(count, 0.0);
    jet.slopes[index] = 1;
    return jet;
  }
  /// The derivative by variable j.
  [[nodiscard]] double slope(std::size_t j) const { return slopes.empty() ? 0 : slopes[j]; }
};

/// f(a, b) where f's derivatives there are by_a and by_b.
[[nodiscard]] inline Jet chained(double value, const Jet& a, double by_a, const Jet& b,
                                 double by_b) {
  Jet result(value);
  if (a.slopes.empty() && b.slopes.empty()) return result;
  result.slopes.resize(std::max(a.slopes.size(), b.slopes.size()));
  for (std::size_t j = 0; j < result.slopes.size(); ++j)
    result.slopes[j] = by_a * a.slope(j) + by_b * b.slope(j);
  return result;
}
[[nodiscard]] inline Jet chained(double value, const Jet& a, double by_a) {
  return chained(value, a, by_a, Jet(), 0);
}

inline Jet operator+(const Jet& a, const Jet& b) { return chained(a.value + b.value, a, 1, b, 1); }
inline Jet operator-(const Jet& a, const Jet& b) { return chained(a.value - b.value, a, 1, b, -1); }
inline Jet operator*(const Jet& a, const Jet& b) {
  return chained(a.value * b.value, a, b.value, b, a.value);
}

/// Values as those of double; signs and integers are the value's, whose derivatives are 0.
template <>
struct Arithmetic<Jet> {
  using Plain = Arithmetic<double>;

  static Jet from(const Rational& q) { return Jet(to_double(q)); }
  static Jet pi() { return Jet(Plain::pi()); }
  static Result<Jet> add(const Jet& a, const Jet& b) { return finite(a + b); }
  static Result<Jet> subtract(const Jet& a, const Jet& b) { return finite(a - b); }
  static Result<Jet> multiply(const Jet& a, const Jet& b) { return finite(a * b); }
  static Result<Jet> divide(const Jet& a, const Jet& b) {
    const Result<double> quotient = Plain::divide(a.value, b.value);
    if (!quotient) return quotient.error();
    return finite(chained(*quotient, a, 1 / b.value, b, -*quotient / b.value));
  }
  static Result<Jet> cos(const Jet& a) { return chained(std::cos(a.value), a, -std::sin(a.value)); }
  static Result<Jet> sin(const Jet& a) { return chained(std::sin(a.value), a, std::cos(a.value)); }
  static Result<Jet> sqrt(const Jet& a) {
    const Result<double> root = Plain::sqrt(a.value);
    if (!root) return root.error();
    if (*root == 0 && !a.slopes.empty()) return Error{"the square root of 0 has no derivative"};
    return *root == 0 ? Jet(0.0) : finite(chained(*root, a, 0.5 / *root));
  }
  static Result<int> sign(const Jet& a) { return Plain::sign(a.value); }
  static Result<long long> integer(const Jet& a) { return Plain::integer(a.value); }
  static double approx(const Jet& a) { return a.value; }

 private:
  static Result<Jet> finite(Jet a) {
    bool all = std::isfinite(a.value);
    for (const double slope : a.slopes) all = all && std::isfinite(slope);
    if (!all) return Error{"the number is too large"};
    return a;
  }
};

}  // namespace limn::number
