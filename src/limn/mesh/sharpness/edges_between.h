#pragma once
/// Edges that are stated by their ends. Private to sharpness/.

#include <vector>

#include "limn/mesh/mesh.h"

namespace limn::mesh {

/// The edges between two vertices: more than one where a mesh has such. Cost O(valence).
[[nodiscard]] inline std::vector<Index> edges_between(const Mesh& mesh, Index a, Index b) {
  std::vector<Index> edges;
  const Index first = mesh.halfedge_of_vertex(a);
  for (Index h = first; h != kNone;) {
    if (mesh.target(h) == b) edges.push_back(mesh.edge(h));
    const Index last = mesh.prev(h);
    if (mesh.twin(last) == kNone && mesh.origin(last) == b) edges.push_back(mesh.edge(last));
    h = mesh.rotate(h);
    if (h == first) break;
  }
  return edges;
}

}  // namespace limn::mesh
