#pragma once
/// A neighbourhood (a star, a fan; mesh/lattice.h) found again in a mesh, by walking both in step.

#include <vector>

#include "limn/mesh/mesh.h"

namespace limn::mesh {

class Pattern {
 public:
  /// `shape` is connected. Its vertices 0 … inner-1 are those whose surroundings count: where a
  /// mesh has the pattern, they have as many faces there, and lie on the boundary if they do here.
  /// Vertices from `inner` on are the rim, beyond which anything may follow.
  Pattern(const Mesh& shape, Index inner);

  /// Fills vertices[i] with the vertex of `mesh` at the place of vertex i of the shape, half-edge
  /// `start` being at the place of half-edge 0. False where the mesh differs; `vertices` is then
  /// of no use. On a small mesh a vertex may come more than once. Cost O(size of the shape).
  [[nodiscard]] bool match(const Mesh& mesh, Index start, std::vector<Index>& vertices) const;

 private:
  bool place(const Mesh& mesh, Index start, std::vector<Index>& partner) const;

  /// How a half-edge's partner follows from that of an earlier one.
  struct Step {
    Index halfedge, from;
    bool across;  ///< by twin; else by next
  };
  Mesh shape_;
  Index inner_;
  std::vector<Step> steps_;  ///< after that of half-edge 0, in an order that can be followed
};

}  // namespace limn::mesh
