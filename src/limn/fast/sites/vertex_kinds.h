#pragma once
/// The vertices of a control mesh, sorted by what is round them.

#include <vector>

#include "limn/mesh/mesh.h"

namespace limn::fast {

/// Vertices that have as many faces in a ring, or in a fan (on the boundary). Isolated vertices
/// make a kind of their own, of no face.
struct VertexKind {
  bool open = false;
  Index faces = 0;
  std::vector<Index> vertices;  ///< ascending
};

/// Rings before fans, few faces before many. Cost O(half-edges).
[[nodiscard]] std::vector<VertexKind> vertex_kinds(const Mesh& mesh);

}  // namespace limn::fast
