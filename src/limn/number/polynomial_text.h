#pragma once
/// Polynomials in indeterminates as text that scheme files could hold, and as LaTeX.

#include <string>

#include "limn/number/notation.h"
#include "limn/number/polynomial.h"
#include "limn/number/polynomial_factors.h"

namespace limn::number {

/// Which term of a sum is written first: "3/8 + cos(2*pi/n)/4" rises, "5*n^2 - 30*n + 49" falls.
enum class TermOrder { rising, falling };

/// The other order where only that begins without a minus. "0" of no terms.
[[nodiscard]] std::string sum_text(const Polynomial& a, Notation notation,
                                   TermOrder order = TermOrder::falling);

/// A product; factors with negative exponents make its denominator. Sums in it have the angles that
/// write them shortest.
[[nodiscard]] std::string product_text(const PolynomialFactors& product, Notation notation);

/// Polynomials in a cosine's square alone in the cosine of the double angle instead.
[[nodiscard]] Polynomial with_double_angles(const Polynomial& a);

/// As a sum of cosines of multiple angles, without powers of them.
[[nodiscard]] Polynomial with_multiple_angles(const Polynomial& a);

/// The same polynomial in the angles that write it shortest: as it is, with double angles, or as a
/// sum of cosines of multiple angles.
[[nodiscard]] Polynomial with_best_angles(const Polynomial& a);

/// A name as LaTeX: "n", "\omega", "\mathit{tension}".
[[nodiscard]] std::string latex_name(const std::string& name);

/// cos(π q m) of a monomial m. No multiple of an angle is resolved.
[[nodiscard]] Indeterminate cosine_indeterminate(const Rational& q, const Monomial& monomial);
/// The q and m of a cosine's indeterminate.
struct CosineAngle {
  Rational q;
  Monomial monomial;
};
[[nodiscard]] CosineAngle angle_of(const Indeterminate& cosine);

}  // namespace limn::number
