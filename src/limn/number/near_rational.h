#pragma once
/// Simple fractions behind numbers.

#include <optional>

#include "limn/base/rational.h"

namespace limn::number {

/// p/q with the least q ≤ `largest` within `tolerance` (1 + |x|) of x, where |x| < 1e6. By chance a
/// number has one with the probability 1e6 · tolerance about.
[[nodiscard]] std::optional<Rational> near_rational(double x, double tolerance = 1e-13,
                                                    long long largest = 1000);

}  // namespace limn::number
