#pragma once
/// The regular mask: refining the regular lattice is new(m) = Σ_j a(m − 2j) old(j), with m in the
/// refined lattice. A scheme can be given by it, or by its factors; rules for regular meshes
/// then follow from it.

#include <array>
#include <map>

#include "limn/mesh/lattice.h"
#include "limn/scheme/scheme.h"

namespace limn {

/// Coefficients a(k) of a dyadic split, by *twice* the offset k from the mask's centre, in
/// the basis of mesh/lattice.h: even pairs for primal splits, odd pairs for dual ones. They sum to
/// |det M| = 4, and to 1 over each of the four cosets.
struct Mask {
  Lattice lattice = Lattice::triangle;
  std::map<std::array<int, 2>, Rational> coefficients;  // none of them 0
};

/// The key in `coefficients` of a new vertex that lies `way` from an old one: twice the offset in
/// the refined lattice of a dyadic split.
[[nodiscard]] inline std::array<int, 2> mask_offset(Twelfths way) {
  return {way[0] / 3, way[1] / 3};
}

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

}  // namespace limn
