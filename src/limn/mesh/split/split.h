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
  /// The next block: the number of new vertices born from edges. Where `edge_ends` is empty child i
  /// belongs to edge i, or to edges[i] where that list is not empty.
  Index from_edges = 0;
  std::vector<Index> edges;  ///< the boundary edges that have a child, or empty: all edges have
  /// A trisected boundary edge has two children, each named by the (boundary) half-edge it lies on
  /// and the end it is near: 2*halfedge + end with end 0 at the origin, 1 at the target.
  std::vector<Index> edge_ends;
  /// The next block, born from faces: face i, or faces[i] where that list is not empty.
  Index from_faces = 0;
  std::vector<Index> faces;  ///< the faces that have a child, or empty: all of them
  /// Born from corners (dual splits): corner (half-edge) i.
  Index from_corners = 0;
  /// Isolated vertices that a dual split passes on, unchanged, at the end.
  std::vector<Index> isolated;
};

/// One step of a split.
struct SplitResult {
  Mesh mesh;      ///< the refined connectivity
  Births births;  ///< where its vertices come from
};

/// A way of refining connectivity: its facts as data and one function.
struct Split {
  std::string_view name;         ///< as scheme files write it: "triangle-dyadic", …
  std::string_view description;  ///< one line for listings
  Lattice lattice;               ///< what a regular mesh looks like
  bool any_polygons = false;     ///< the first step takes any polygons; else only triangles
  /// Which old elements have a child.
  struct BirthPlaces {
    bool vertices = false;  ///< old vertices
    bool edges = false;     ///< edges
    bool faces = false;     ///< faces
    bool corners = false;   ///< corners (dual splits)
  } births;                 ///< which old elements have a child
  /// The boundary is left alone in even steps, and each of its edges cut into so many pieces, 2 or
  /// 3, in odd ones. 0: the boundary is refined in every step.
  int odd_step_cut = 0;
  /// Coordinates of old vertices in the refined lattice; the lattice may turn (sqrt3: by 30°).
  LatticeMatrix dilation;
  /// One step. `step` counts from 0: see odd_step_cut.
  /// Preconditions: all faces are triangles unless any_polygons; dilation.growth() *
  /// halfedge_count() and the number of boundary edges are together below 2^31 (no split gives
  /// more half-edges than that). Cost O(V + H).
  SplitResult (*apply)(const Mesh& mesh, int step);

  /// Whether the boundary is refined in every second step only.
  [[nodiscard]] bool boundary_rests() const { return odd_step_cut > 0; }
};

/// All splits, in the order in which the documentation lists them.
[[nodiscard]] const std::vector<Split>& splits();
/// The split of that name, or nullptr. It lives as long as the program.
[[nodiscard]] const Split* find_split(std::string_view name);

}  // namespace limn
