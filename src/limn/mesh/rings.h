#pragma once
/// What is round all vertices at once, for those who ask again and again.

#include "limn/mesh/mesh.h"

namespace limn::mesh {

/// mesh.valence(v) for every vertex v, counted in one pass over the half-edges: many times as fast
/// as turning round each vertex. Cost O(V + corners), on one thread.
[[nodiscard]] std::vector<Index> valences(const Mesh& mesh);

/// The half-edges out of each vertex, counterclockwise, side by side: turning is reading. From a
/// half-edge to the next is otherwise two loads, of which the second waits for the first.
struct Rings {
  std::vector<Index> begin;      ///< where each vertex's begin, and where the last one's end
  std::vector<Index> halfedges;  ///< vertex by vertex, from halfedge_of_vertex on
  std::vector<Index> targets;    ///< the vertices to which these run
  std::vector<Index> place;      ///< of each half-edge: halfedges[place[h]] = h
};
/// Cost O(V + corners).
[[nodiscard]] Rings rings(const Mesh& mesh, const std::vector<Index>& valences);

}  // namespace limn::mesh
