#pragma once
/// Where in the old mesh the half-edges and faces of a refined one lie, found by births, whatever
/// the split.

#include <vector>

#include "limn/mesh/split/split.h"

namespace limn::mesh {

/// Whether old edges are made of refined ones after every step, so that each refined face lies in
/// one old face: no dual splits, nor those that refine the boundary in every second step only.
[[nodiscard]] inline bool keeps_old_edges(const Split& split) {
  return !split.is_dual() && !split.boundary_rests();
}

/// The old half-edge that each refined half-edge lies on, in its direction; kNone: on none.
/// Precondition: keeps_old_edges. Cost O(fine mesh).
[[nodiscard]] std::vector<Index> old_halfedges(const Mesh& mesh, const SplitResult& fine);

/// The old face that each refined face lies in, given old_halfedges: the faces along old half-edges
/// lie in these half-edges' faces, and all others in that from which they are reached without
/// crossing an old edge; kNone where there is none. Cost O(fine mesh).
[[nodiscard]] std::vector<Index> faces_between(const Mesh& mesh, const Mesh& fine,
                                               const std::vector<Index>& old_halfedges);

/// The old face that each refined face is a part of. Where a split lays faces across old edges or
/// round old vertices (√3, √2 and dual splits), a face that lies in several old ones is given to
/// the one of them with the lowest number. Cost O(fine mesh).
[[nodiscard]] std::vector<Index> parent_faces(const Split& split, const Mesh& mesh,
                                              const SplitResult& fine);

}  // namespace limn::mesh
