#pragma once
/// Laurent polynomials in two variables over the rationals, for masks.

#include <array>
#include <map>
#include <optional>

#include "limn/base/rational.h"

namespace limn {

/// Coefficients by exponents, none of them 0. Masks write *twice* the exponent, so that dual
/// ones, with exponents ½, 3/2, …, are polynomials too; the functions below do not care.
using Exponents = std::array<int, 2>;
/// A Laurent polynomial: its coefficients by exponents, in lexicographic order; none is 0.
using Laurent = std::map<Exponents, Rational>;

/// a·b. Cost: the product of the numbers of terms.
[[nodiscard]] Laurent product(const Laurent& a, const Laurent& b);
/// a^exponent, exponent ≥ 0. Cost: that of so many products.
[[nodiscard]] Laurent power(const Laurent& a, int exponent);
/// a scaled by a number other than 0.
[[nodiscard]] Laurent scaled(const Laurent& a, const Rational& factor);
/// a(1/z)
[[nodiscard]] Laurent reflected(const Laurent& a);
/// The sum of the coefficients, a(1).
[[nodiscard]] Rational total(const Laurent& a);

/// 1 + z^step + … + z^{(count-1) step}, shifted to be its own reflection in doubled exponents:
/// terms at (2i - count + 1) step. count ≥ 2, step not 0.
[[nodiscard]] Laurent centred_box(Exponents step, int count);

/// a / centred_box(step, count) where the division leaves nothing over; else nothing.
/// Cost: linear in the box that a fills.
[[nodiscard]] std::optional<Laurent> divided_by_box(const Laurent& a, Exponents step, int count);

}  // namespace limn
