#pragma once
/// Powers of rationals.

#include <concepts>

#include "limn/base/rational.h"

namespace limn::number {

/// qⁿ, exactly; 1 where n ≤ 0. Cost: n products.
template <std::integral Exponent>
[[nodiscard]] Rational power(const Rational& q, Exponent n) {
  Rational result = 1;
  for (Exponent i = 0; i < n; ++i) result *= q;
  return result;
}

}  // namespace limn::number
