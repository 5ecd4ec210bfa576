#pragma once
/// Curvature at a vertex where C1 is proved: all other eigenvalues against λ² [theory: Peters, Reif
/// 2008 §7].
///
/// unbounded: some other eigenvalue, real and effective, is larger than λ² in modulus, or λ² has an
/// effective eigenvector in a Jordan block. flat: all are smaller. bounded:
/// none is larger, and those that are equal are so exactly and without Jordan blocks. bounded and
/// flat also need the regular surface round the vertex to have bounded second differences.

#include "limn/certify/ring/eigenfunction.h"
#include "limn/scheme/mask.h"

namespace limn::certify {

/// `leader`: the enclosed pair of frequency 1, simple, larger than all others but 1.
[[nodiscard]] CurvatureClaim search_curvature(const Scheme& scheme, const ValenceBalls& balls,
                                              const EnclosedPair& leader,
                                              const RegularPart& regular,
                                              const Effective& effective);

/// Whether nothing is in a claim that the check would not read.
[[nodiscard]] bool holds_what_it_needs(const CurvatureClaim& claim);

/// Fails where the claim does not hold.
[[nodiscard]] Status check_curvature(const Scheme& scheme, const ValenceBalls& balls,
                                     const EnclosedPair& leader, const RegularPart& regular,
                                     const Effective& effective, const CurvatureClaim& claim);

}  // namespace limn::certify
