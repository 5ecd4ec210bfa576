#pragma once
/// Closed forms of Hölder exponents, and whether they are attained (regularity.h says what that
/// means).

#include <optional>
#include <string>

#include "limn/base/budget.h"
#include "limn/regular/smoothness/regularity.h"

namespace limn::regular {

/// -log ρ / log √growth for ρ = |eigenvalue|^(1/length): "2", "3/2", "log2(24/7)", "log2(5)/3",
/// "2*log3(7)". Precondition: 0 < |eigenvalue| < 1, length ≥ 1, growth ≥ 2.
[[nodiscard]] std::string exponent_text(const Rational& eigenvalue, int length, int growth);

/// Decides it for a mask with stable shifts whose exponent `value` is known exactly; `whole` where
/// that is a whole number. Precondition: radius.exact, with an eigenvalue, for the differences of
/// order `sum_rules` ≥ value. Cost: seconds at most.
[[nodiscard]] Attainment decide_attainment(const Mask& mask, const JointSpectralRadius& radius,
                                           int sum_rules, double value, bool whole,
                                           const Stop& stop = {});

}  // namespace limn::regular
