#pragma once
/// Factors and greatest common divisors of polynomials in indeterminates, by FLINT. Without FLINT
/// (see LIMN_FORMULAS in CMakeLists.txt) each of these is an error that says so.

#include <utility>
#include <vector>

#include "limn/base/error.h"
#include "limn/number/polynomial.h"

namespace limn::number {

/// content · ∏ factorᵉ. Factors are irreducible over the rationals with their indeterminates taken
/// as independent, have coprime integer coefficients and, as single indeterminates, may have e < 0.
struct PolynomialFactors {
  Rational content = 1;
  std::vector<std::pair<Polynomial, int>> factors;
};

/// Of a polynomial other than 0. Cost: multivariate factorisation; small for what schemes give.
/// Fails where the coefficients are so long that it might not end (millions of bits together).
[[nodiscard]] Result<PolynomialFactors> factor(const Polynomial& a);

/// a and b over their greatest common divisor, exactly.
struct Coprime {
  Polynomial a, b;
  Polynomial divisor;
};
/// b other than 0; neither with negative exponents. Fails as `factor` does.
[[nodiscard]] Result<Coprime> without_common_divisor(const Polynomial& a, const Polynomial& b);

/// The largest q with (a/q) of coprime integer coefficients, signed like the coefficient of the
/// leading monomial. Precondition: a is not 0. Needs no FLINT.
[[nodiscard]] Rational content(const Polynomial& a);

}  // namespace limn::number
