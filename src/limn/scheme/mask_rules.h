#pragma once
/// Masks that a scheme file states, as rows or as factors, and the rules that follow from one.

#include "limn/mesh/lattice.h"
#include "limn/scheme/mask.h"

namespace limn::scheme {

/// Twice the offset, in the refined lattice, of a new vertex that lies `way` from an old one.
[[nodiscard]] inline LatticeVector mask_offset(const LatticeMatrix& dilation, mesh::Twelfths way) {
  const LatticeVector offset = dilation.apply(way);
  return {offset[0] / 6, offset[1] / 6};
}

/// What smooths along one step of the refined lattice: the box of arity(M) equal coefficients, by
/// twice the offset; sum 1.
[[nodiscard]] Laurent smoothing_direction(LatticeVector step, const LatticeMatrix& dilation);

/// The mask that rows or factors denote, at the scheme's present parameters. Fails, with the
/// place, on rows that form no hexagon or rectangle, on a mask whose centre does not fit the split,
/// on a count that is no integer in 0 … 64, on more than 24 refined edges from centre to rim, on
/// cosets that do not sum to 1.
[[nodiscard]] Result<Mask> mask_from_rows(const Scheme& scheme, const Rows& rows);
[[nodiscard]] Result<Mask> mask_from_factors(const Scheme& scheme, const Factors& factors);

/// Gives a scheme that has a mask or factors alone its rules at regular vertices and faces.
/// A mask without the lattice's full symmetry has no rules: nothing is added, and refining
/// says so.
[[nodiscard]] Status add_rules_from_mask(Scheme& scheme);

}  // namespace limn::scheme
