#pragma once
/// Whether the rules of a scheme are the mask round an extraordinary vertex, wherever proofs take
/// the one for the other: at all places that are one edge (dual: half an edge) or more from it.
///
/// Far from an extraordinary vertex the mask stands for the rules only if a walk that passes near
/// the vertex ends where it would on the lattice. Walks that pass the vertex on different sides may
/// end at one point of the lattice, and at two where the valence is another; weights that cancel
/// at the one do not at the two. So the rows that the rules have there are compared with the
/// mask's, exactly, on a star of so many sectors that walks do not meet round it: what holds on it
/// holds at every valence, since walks on a star of n sectors are those of it with sectors counted
/// modulo n. Of a scheme of stages (Scheme::stages) the rows are those that the stages make, and
/// where a mean over the sectors is in one it is not the mask's.

#include "limn/certify/lattice/cell_matrices.h"
#include "limn/scheme/scheme.h"

namespace limn::certify {

/// Fails, with the reason, where a row is another one than the mask's, or where a role's walk may
/// go farther than the star's 13 sectors tell apart: over more than 5 edges to other faces (dual:
/// along more than 5 edges to other vertices), or over more than 4 edges to other vertices (dual:
/// faces). Cost: some hundredths of a second.
[[nodiscard]] Status check_regular_rows(const Scheme& scheme, const CellMatrices& cells);

}  // namespace limn::certify
