#pragma once
/// Laurent polynomials over the rationals in named indeterminates: what formulas are made of.
///
/// An indeterminate is a free variable, a whole number that is not known yet (n, ω, k), a cosine,
/// or a square root. Indeterminates are equal where their names are; nothing else relates them, so
/// an identity such as that between cos(pi/n) and cos(2*pi/n) holds only where both are written by
/// one indeterminate.

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "limn/base/rational.h"

namespace limn::number {

class Polynomial;

enum class IndeterminateKind { whole, variable, cosine, root };

struct IndeterminateData {
  IndeterminateKind kind = IndeterminateKind::variable;
  std::string name;   ///< as scheme files write it: "n", "cos(2*pi/n)", "sqrt(2)"
  std::string latex;  ///< the same as LaTeX
  /// Of a cosine the angle over π, of a square root the radicand; of others nothing.
  std::shared_ptr<const Polynomial> argument;
  /// Of a whole number: called with every bound that a decision supposed it to exceed.
  std::function<void(const Polynomial& supposed_positive)> suppose;
};
using Indeterminate = std::shared_ptr<const IndeterminateData>;

struct IndeterminateLess {
  bool operator()(const Indeterminate& a, const Indeterminate& b) const;
};

/// The exponents of the indeterminates that occur, in the order of IndeterminateLess; none is 0.
using Monomial = std::vector<std::pair<Indeterminate, int>>;
struct MonomialLess {
  bool operator()(const Monomial& a, const Monomial& b) const;
};
[[nodiscard]] Monomial product(const Monomial& a, const Monomial& b);
[[nodiscard]] Monomial power(Monomial a, int exponent);

/// A sum of monomials with coefficients other than 0. Exponents may be negative.
class Polynomial {
 public:
  using Terms = std::map<Monomial, Rational, MonomialLess>;

  Polynomial() = default;
  Polynomial(int value) : Polynomial(Rational(value)) {}
  Polynomial(const Rational& value) { add({}, value); }
  Polynomial(const Indeterminate& indeterminate) { add({{indeterminate, 1}}, 1); }
  Polynomial(const Monomial& monomial, const Rational& coefficient) { add(monomial, coefficient); }

  [[nodiscard]] const Terms& terms() const { return terms_; }
  [[nodiscard]] bool is_zero() const { return terms_.empty(); }
  [[nodiscard]] bool is_rational() const;
  /// Precondition: is_rational().
  [[nodiscard]] Rational rational() const;
  /// The indeterminates that occur, in the order of IndeterminateLess; not those within cosines and
  /// roots.
  [[nodiscard]] std::vector<Indeterminate> indeterminates() const;
  /// Whether an indeterminate of this name occurs, within cosines and roots too.
  [[nodiscard]] bool depends_on(const std::string& name) const;
  /// a as the sum of coefficients[i] · symbolⁱ.
  [[nodiscard]] std::map<int, Polynomial> powers_of(const Indeterminate& indeterminate) const;
  /// The largest monomial that divides every term; negative exponents where those occur.
  [[nodiscard]] Monomial common_monomial() const;

  Polynomial& operator+=(const Polynomial& b);
  Polynomial& operator-=(const Polynomial& b);
  Polynomial& operator*=(const Rational& factor);
  friend Polynomial operator+(Polynomial a, const Polynomial& b) { return a += b; }
  friend Polynomial operator-(Polynomial a, const Polynomial& b) { return a -= b; }
  friend Polynomial operator-(Polynomial a) { return a *= Rational(-1); }
  /// Cost: the product of the numbers of terms.
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
  friend bool operator==(const Polynomial& a, const Polynomial& b);

 private:
  void add(const Monomial& monomial, const Rational& coefficient);

  Terms terms_;
};

/// exponent ≥ 0
[[nodiscard]] Polynomial power(const Polynomial& a, int exponent);

/// T_|j|(x): the polynomial with cos(jα) = T_j(cos α).
[[nodiscard]] Polynomial chebyshev(int j, const Polynomial& x);
/// U_{j-1}(x) for j ≥ 1, 0 for j = 0: sin(jα) = sin α · U_{j-1}(cos α); odd in j.
[[nodiscard]] Polynomial chebyshev_of_sine(int j, const Polynomial& x);

/// Coefficients a_j with a(x) = Σ a_j T_j(x) in the indeterminate x, whose exponents are not
/// negative.
[[nodiscard]] std::map<int, Polynomial> chebyshev_coefficients(const Polynomial& a,
                                                               const Indeterminate& x);

/// With `value` in place of an indeterminate whose exponents are not negative.
[[nodiscard]] Polynomial substituted(const Polynomial& a, const Indeterminate& indeterminate,
                                     const Polynomial& value);

/// The value where `lookup` gives that of each variable and whole number by name.
[[nodiscard]] double approx(const Polynomial& a,
                            const std::function<double(const std::string&)>& lookup);

}  // namespace limn::number
