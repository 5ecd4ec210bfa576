#pragma once
/// Whether a scheme is as a study demands; private to search/.

#include "limn/search/point.h"

namespace limn::search {

/// Proofs cost most, so they come when all else holds.
enum class Proofs { later, now };

/// Puts the truths of the study's demands into `outcome`, with its violation and reason: those that
/// need no proof, or those that do. What is undecided does not hold.
void check_demands(const Study& study, SchemeReading& reading, Proofs which, Outcome& outcome);

}  // namespace limn::search
