#pragma once
/// Rules whose weights are decimals from a published table: rounded, so that they sum to 1 to
/// rounding alone.

#include "limn/scheme/scheme.h"

namespace limn::scheme {

/// How far from 1 such weights may sum.
inline constexpr double kDecimalTolerance = 1e-3;

/// Divides the weights of a rule's case by their sum, as expressions, where at some checked valence
/// that sum is not 1 and at every one within kDecimalTolerance of 1. After that each reading sees
/// weights that sum to exactly 1. A case with a repeated role, whose sum over k is no expression,
/// and one whose sum is farther off stay as they are, for the check to refuse. Precondition: the
/// scheme's names are known and its roles can be placed.
void divide_by_sums(Scheme& scheme);

}  // namespace limn::scheme
