#pragma once
/// Quotients of polynomials in indeterminates, as numbers that a weight expression can be evaluated
/// in: the weights as formulas in n and the parameters.
///
/// A square root that is no rational is an indeterminate t with t² = its radicand; a cosine is one
/// indeterminate for each angle 1/q of its kind, with Chebyshev's polynomials for its multiples.
/// Such indeterminates are not related to one another, so that `==` never calls different numbers
/// equal but may miss an equality. Without FLINT (number/polynomial_factors.h) quotients are not
/// brought to lowest terms.

#include <string>

#include "limn/base/error.h"
#include "limn/number/arithmetic.h"
#include "limn/number/polynomial.h"

namespace limn::number {

class Symbolic {
 public:
  Symbolic() = default;
  Symbolic(int value) : numerator_(value) {}
  Symbolic(Polynomial value) : numerator_(std::move(value)) {}

  /// Coprime (with FLINT); no square root stands in the denominator, and a monomial one is divided
  /// out.
  [[nodiscard]] const Polynomial& numerator() const { return numerator_; }
  [[nodiscard]] const Polynomial& denominator() const { return denominator_; }
  [[nodiscard]] bool is_zero() const { return numerator_.is_zero(); }
  [[nodiscard]] bool is_rational() const {
    return numerator_.is_rational() && denominator_ == Polynomial(1);
  }
  [[nodiscard]] bool depends_on(const std::string& name) const {
    return numerator_.depends_on(name) || denominator_.depends_on(name);
  }

  /// These fail, with the reason in the message, where the answer is no such number, and where it
  /// would be too large (thousands of terms).
  [[nodiscard]] static Result<Symbolic> add(const Symbolic& a, const Symbolic& b);
  [[nodiscard]] static Result<Symbolic> multiply(const Symbolic& a, const Symbolic& b);
  [[nodiscard]] static Result<Symbolic> divide(const Symbolic& a, const Symbolic& b);
  [[nodiscard]] static Result<Symbolic> sqrt(const Symbolic& square);

  [[nodiscard]] Symbolic negated() const;

  friend bool operator==(const Symbolic& a, const Symbolic& b) {
    return a.numerator_ == b.numerator_ && a.denominator_ == b.denominator_;
  }

 private:
  static Result<Symbolic> reduced(Polynomial numerator, Polynomial denominator);

  Polynomial numerator_;
  Polynomial denominator_ = 1;
};

/// A free variable: a parameter.
[[nodiscard]] Indeterminate variable(const std::string& name);
/// A whole number, n, k or omega, that is larger than any number that it is compared with: each
/// comparison calls `suppose` with what it took to be positive (as n - 5).
[[nodiscard]] Indeterminate whole_number(const std::string& name,
                                         std::function<void(const Polynomial&)> suppose = {});

/// cos and sin of multiples of π: the angle is a sum of rational multiples of π, of π/n and of
/// others like it. The sine of an angle whose place in the circle is not known has no sign, and
/// fails.
[[nodiscard]] Result<Symbolic> symbolic_cos(const Symbolic& angle);
[[nodiscard]] Result<Symbolic> symbolic_sin(const Symbolic& angle);
/// The indeterminate of π, whose multiples are what those take.
[[nodiscard]] Indeterminate pi_indeterminate();

/// Numerically; NaN where it depends on a free variable or a whole number.
[[nodiscard]] double approx(const Symbolic& a);
[[nodiscard]] double approx(const Symbolic& a,
                            const std::function<double(const std::string&)>& lookup);

template <>
struct Arithmetic<Symbolic> {
  static Symbolic from(const Rational& q) { return {Polynomial(q)}; }
  static Symbolic pi() { return {Polynomial(pi_indeterminate())}; }
  static Result<Symbolic> add(const Symbolic& a, const Symbolic& b) { return Symbolic::add(a, b); }
  static Result<Symbolic> subtract(const Symbolic& a, const Symbolic& b) {
    return Symbolic::add(a, b.negated());
  }
  static Result<Symbolic> multiply(const Symbolic& a, const Symbolic& b) {
    return Symbolic::multiply(a, b);
  }
  static Result<Symbolic> divide(const Symbolic& a, const Symbolic& b) {
    return Symbolic::divide(a, b);
  }
  static Result<Symbolic> cos(const Symbolic& a) { return symbolic_cos(a); }
  static Result<Symbolic> sin(const Symbolic& a) { return symbolic_sin(a); }
  static Result<Symbolic> sqrt(const Symbolic& a) { return Symbolic::sqrt(a); }
  /// Of what depends on no indeterminate but cosines and roots of numbers: decided from 1e-9 up. Of
  /// a·n + b·k + c: that for large n and k amid 0 … n-1. Of others: an error.
  static Result<int> sign(const Symbolic& a);
  static Result<long long> integer(const Symbolic& a);
  static double approx(const Symbolic& a) { return limn::number::approx(a); }
};

}  // namespace limn::number
