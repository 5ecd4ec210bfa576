#pragma once
/// One valence: search for a proof, and its check.
///
/// Proved [Reif 1995; Peters, Reif 1998; Peters, Reif 2008 §5]: given C1 on the lattice; the
/// eigenvalue 1 is simple; the next, λ > 0, is simple in the block of frequency 1 and larger than
/// all others in all blocks, so it is exactly double and semisimple; the Jacobian of the map of its
/// eigenvectors has one sign, and the map winds once round the centre. Then almost all control nets
/// have C1 surfaces.
/// Refuted: the Jacobian has both signs, or what leads, simple, is of a frequency that winds more
/// than once or does not wind: then almost all control nets have surfaces that are no graphs over a
/// tangent plane.

#include "limn/certify/lattice/contraction.h"
#include "limn/certify/ring/ring_proof.h"
#include "limn/certify/vertex/curvature_proof.h"
#include "limn/regular/regular_mask.h"

namespace limn::certify {

/// What is proved of the regular lattice, and is the same at all valences.
struct RegularProof {
  CellMatrices cells;
  Contraction contraction;
  Contraction continuity;  ///< of cells with their neighbours: that gradients fit together
  RegularPart curvature;
};

struct ProofLimits {
  int bits = 128;
  int most_parts = 200'000;  ///< of cells, for one valence
  bool curvature = true;     ///< whether it is looked for
  Stop stop;
};

struct SearchedValence {
  ValenceClaim claim;
  /// Undecided for want of precision: not by a tie that is exact, nor by the map, whose enclosures
  /// are wide by other things than rounding.
  bool more_bits_may_help = false;
};

/// At n ≥ 3. `regular`, `signs`: of the scheme at its present parameters. Fails where the scheme
/// cannot be evaluated at n.
[[nodiscard]] Result<SearchedValence> search_valence(const Scheme& scheme,
                                                     const RegularProof& regular,
                                                     const CellSigns& signs, int n,
                                                     const ProofLimits& limits);

/// Fails, with the reason, where the claim is not shown. What is undecided claims nothing.
[[nodiscard]] Status check_valence(const Scheme& scheme, const RegularProof& regular,
                                   const CellSigns& signs, const ValenceClaim& claim);

}  // namespace limn::certify
