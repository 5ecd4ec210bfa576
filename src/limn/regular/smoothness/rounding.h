#pragma once
/// Bounds of rounding errors that hold in double precision, whatever the order of summation
/// [Higham2002, §3].

#include <Eigen/Core>
#include <limits>

namespace limn::regular {

/// A sum of `terms` rounded products, or numbers, is exact but for this times the sum of their
/// sizes; twice the usual γ, so that what is computed with it may itself be rounded. terms ≤ 10⁶.
[[nodiscard]] inline double rounding_error(Eigen::Index terms) {
  return static_cast<double>(2 * terms + 4) * std::numeric_limits<double>::epsilon() / 2;
}

/// An upper bound of what was computed as `value` ≥ 0 from fewer than 10⁴ additions,
/// multiplications and divisions of numbers ≥ 0.
[[nodiscard]] inline double inflated(double value) {
  return value * (1 + 2e-12) + std::numeric_limits<double>::min();
}

}  // namespace limn::regular
