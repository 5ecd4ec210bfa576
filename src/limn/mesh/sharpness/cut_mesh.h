#pragma once
/// A mesh cut along edges, and what a split has made of it joined again: how a crease is refined as
/// a boundary that is seen from either side.

#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/split/split.h"

namespace limn::mesh {

/// A mesh that was cut: the same faces and half-edges, by the same numbers. A vertex is there once
/// for each fan that the cuts leave of its faces; one of these keeps its number, further ones are
/// numbered behind all vertices, as is the second side of each cut edge behind all edges.
struct CutMesh {
  Mesh mesh;                     ///< with boundaries where it was cut
  std::vector<Index> originals;  ///< of each of its vertices, the number before
};
/// Cuts along the interior edges with along[e]; what is said of boundary edges is ignored. An edge
/// alone, that meets no other, cuts nothing apart, but its vertices lie on a boundary then.
/// Cost O(V + H).
[[nodiscard]] CutMesh cut_along(const Mesh& mesh, const std::vector<bool>& along);

/// A refined mesh that was joined again.
struct JoinedMesh {
  SplitResult fine;         ///< births: in numbers of the mesh that was cut
  std::vector<bool> seams;  ///< of each of its edges: where it was joined
};
/// Joins what a split with a boundary that rests (split.h) has made of a mesh cut along edges: such
/// a split treats a cut as it does a boundary, so that the connectivity depends on it. `cut` is
/// cut_along(mesh, …), `fine` the split of that; the half-edges keep their numbers. Fails where two
/// creases join the same two vertices. Cost O(fine mesh).
[[nodiscard]] Result<JoinedMesh> join_again(const Mesh& mesh, const CutMesh& cut,
                                            const SplitResult& fine);

}  // namespace limn::mesh
