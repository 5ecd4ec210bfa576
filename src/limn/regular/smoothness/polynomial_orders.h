#pragma once
/// Which polynomials a mask generates and reproduces: its sum rules, exactly, for any dilation.

#include "limn/scheme/mask.h"

namespace limn {

/// Orders count: order k speaks of all polynomials of degree < k.
struct PolynomialOrders {
  /// The largest k for which the moments Σ_j p(j) a(j) over each coset of M Z² are equal for all
  /// p of degree < k. Then the scheme maps polynomials of degree < k to such, and where the shifts
  /// of φ are stable, k - 1 bounds the r of C^r [CDM §8; Jia1998].
  int sum_rules = 0;
  /// The largest d such that sampled polynomials of degree ≤ d have themselves as limits, sample
  /// points as in the mask's own parametrisation (its mean offset moved to 0): ≤ sum_rules - 1;
  /// -1 where not even constants are reproduced.
  int reproduction = -1;
};

/// Cost: small; orders above 40 are not looked for (box splines of 16 directions have fewer).
[[nodiscard]] PolynomialOrders polynomial_orders(const Mask& mask);

}  // namespace limn
