#pragma once
/// The roots of a polynomial whose coefficients are polynomials in indeterminates, as formulas.

#include <vector>

#include "limn/base/error.h"
#include "limn/number/closed_root.h"
#include "limn/number/polynomial.h"

namespace limn::number {

struct ClosedRoots {
  std::vector<ClosedRoot> roots;  ///< of the factors of degree 1 and 2; both roots of each of these
  /// The factors of higher degree, as polynomials in the unknown.
  struct Left {
    int degree;
    ClosedRoot polynomial;
  };
  std::vector<Left> left;
};

/// Factors over the rationals with all indeterminates independent, then solves what it can.
/// `unknown` has no negative exponents in a, and a is not 0. Fails where factor() does.
[[nodiscard]] Result<ClosedRoots> closed_roots(const Polynomial& a, const Indeterminate& unknown);

}  // namespace limn::number
