#pragma once
/// What a mesh that repair has cut must know of the cuts, to be refined as OpenSubdiv refines the
/// mesh that it was.

#include <array>
#include <vector>

#include "limn/mesh/repair/repair.h"
#include "limn/mesh/sharpness/sharpness.h"

namespace limn::mesh {

/// By numbers of the repaired mesh; empty where repair cut nothing.
struct Cuts {
  Index vertices = 0;                 ///< of the mesh that was cut
  std::vector<Index> vertex_of;       ///< of each vertex, which of these it is or is a copy of
  std::vector<Index> sharp_vertices;  ///< Repaired::sharp_vertices
  std::vector<std::array<Index, 2>> sharp_edges;  ///< Repaired::sharp_edges

  [[nodiscard]] bool empty() const { return vertex_of.empty(); }
};
[[nodiscard]] Cuts cuts_of(const Repaired& repaired);

/// Makes sharp what keeps the copies together: infinitely sharp_vertices and sharp_edges, whatever
/// was stated of them; and, as long as an edge of one sheet is sharp that ends at a cut vertex, the
/// copies of that vertex in the other sheets, since more than two sharp edges end there. To be
/// called when all other sharpness has been stated. Cost O(V + E), and a logarithm for what is cut.
void hold_cuts(const Mesh& mesh, const Cuts& cuts, Sharpness& sharpness);

/// As apply_boundary_mode of sharpness.h, where the boundary is that of the mesh as it was before
/// it was cut: an edge that was cut is none, and a vertex has the faces of all its copies. Cost O(V
/// + H), of a mesh that was cut E log E.
void apply_boundary_mode(const Mesh& mesh, BoundaryMode mode, const Cuts& cuts,
                         Sharpness& sharpness);

}  // namespace limn::mesh
