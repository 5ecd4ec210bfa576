#pragma once
/// Proofs of C1 for reports that show many schemes.

#include <vector>

#include "limn/certify/certificate/certificate.h"
#include "limn/scheme/scheme.h"

namespace limn::study {

/// What certify (certify/certify.h) answers at the valences first … last, 3 ≤ first: undecided also
/// where it fails, as for schemes without rules there, where limn was built without Arb, and where
/// the bound on the work of one valence is reached, which is smaller than the command's. Cost: some
/// hundredths of a second a valence.
[[nodiscard]] std::vector<certify::Answer> c1_answers(const Scheme& scheme, int first, int last);

}  // namespace limn::study
