#pragma once
/// Splits: how one refinement step changes connectivity. Nothing here knows a weight.
/// A split is one source file (split_NAME.cpp) and one line in the list in split.cpp.
///
/// The vertices of the refined mesh are born from elements of the old one, in blocks, always
/// in this order: from vertices, from edges, from faces, from corners. `Births` says which
/// element each new vertex belongs to; the rules of a scheme (scheme/) say where it lies.

#include <string_view>
#include <vector>

#include "limn/mesh/mesh.h"
#include "limn/mesh/split/dilation.h"

namespace limn {

/// Which old element each new vertex is born from, block by block.
struct Births {
  Index from_vertices = 0;  ///< new vertices 0 … : child of old vertex i; or none (dual)
  /// The next block: new vertices born from edges. Empty `edge_ends` with from_edges = E means
  /// child i belongs to edge i. A trisected boundary edge has two children, each named by the
  /// (boundary) half-edge it lies on and the end it is near: `edge_ends`, 2*halfedge + end
  /// with end 0 at the origin, 1 at the target.
  Index from_edges = 0;
  std::vector<Index> edge_ends;
  /// Born from faces: face i, or faces[i] where the list is not empty.
  Index from_faces = 0;
  std::vector<Index> faces;
  /// Born from corners (dual splits): corner (half-edge) i.
  Index from_corners = 0;
  /// Isolated vertices that a dual split passes on, unchanged, at the end.
  std::vector<Index> isolated;
};

struct SplitResult {
  Mesh mesh;
  Births births;
};

struct Split {
  std::string_view name;         ///< as scheme files write it: "triangle-dyadic", …
  std::string_view description;  ///< one line for listings
  Lattice lattice;               ///< what a regular mesh looks like
  bool any_polygons = false;     ///< the first step takes any polygons; else only triangles
  /// What new vertices are born from.
  struct BirthPlaces {
    bool vertices = false, edges = false, faces = false, corners = false;
  } births;
  /// The boundary is left alone in even steps and each of its edges cut in three in odd ones.
  bool trisects_boundary = false;
  /// Coordinates of old vertices in the refined lattice; the lattice may turn (sqrt3: by 30°).
  LatticeMatrix dilation;
  /// One step. `step` counts from 0: sqrt3 refines the boundary in every second step only.
  /// Preconditions: all faces are triangles unless any_polygons; dilation.growth() *
  /// halfedge_count() is below 2^31 (no split gives more half-edges than that).
  SplitResult (*apply)(const Mesh& mesh, int step);
};

/// All splits, in the order in which the documentation lists them.
[[nodiscard]] const std::vector<Split>& splits();
/// The split of that name, or nullptr.
[[nodiscard]] const Split* find_split(std::string_view name);

}  // namespace limn
