#pragma once
/// Exact numbers of the cyclotomic fields ℚ(ζ_N), ζ_N = e^{2πi/N}: what rational arithmetic
/// with cosines of rational multiples of π gives. Weights such as 3/8 + cos(2π/n)/4 live
/// here, so that "these weights sum to 1" is decided, not estimated.

#include <string>
#include <vector>

#include "limn/base/rational.h"

namespace limn::number {

/// Coefficients of Φ_N, lowest degree first. Thread-safe; computed once per N.
[[nodiscard]] const std::vector<Integer>& cyclotomic_polynomial(int n);

class Cyclotomic {
 public:
  Cyclotomic() : Cyclotomic(Rational(0)) {}
  Cyclotomic(Rational value) : coefficients_{std::move(value)} {}

  /// cos(2π p/q), q ≥ 1.
  static Cyclotomic cos_turn(long long p, long long q);

  [[nodiscard]] bool is_zero() const { return is_rational() && coefficients_[0] == 0; }
  [[nodiscard]] bool is_rational() const { return order_ == 1; }
  /// N of the field ℚ(ζ_N) that the number is written in, and its φ(N) coefficients.
  [[nodiscard]] int order() const { return order_; }
  [[nodiscard]] const std::vector<Rational>& coefficients() const { return coefficients_; }
  /// Precondition: is_rational().
  [[nodiscard]] const Rational& rational() const { return coefficients_[0]; }

  /// The real part as a double; error about φ(N) units in the last place of the coefficients.
  [[nodiscard]] double approx() const;

  /// Precondition: !is_zero(). Cost O(φ(N)²) rational operations, as for a product.
  [[nodiscard]] Cyclotomic inverse() const;

  Cyclotomic& operator+=(const Cyclotomic& b);
  Cyclotomic& operator-=(const Cyclotomic& b);
  Cyclotomic& operator*=(const Cyclotomic& b);
  friend Cyclotomic operator+(Cyclotomic a, const Cyclotomic& b) { return a += b; }
  friend Cyclotomic operator-(Cyclotomic a, const Cyclotomic& b) { return a -= b; }
  friend Cyclotomic operator*(Cyclotomic a, const Cyclotomic& b) { return a *= b; }
  friend bool operator==(const Cyclotomic& a, const Cyclotomic& b) { return (a - b).is_zero(); }

 private:
  /// The same number written in ℚ(ζ_order), a multiple of the present order.
  [[nodiscard]] Cyclotomic lifted(int order) const;
  void reduce();  // to degree < φ(N), and to N = 1 where it is rational
  void assign(std::vector<Integer> numerators, const Integer& denominator);  // and reduce

  int order_ = 1;                       // N
  std::vector<Rational> coefficients_;  // of 1, ζ, …, ζ^{φ(N)-1}
};

}  // namespace limn::number
