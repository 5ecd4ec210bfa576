#pragma once
/// Splits: how one refinement step changes connectivity. Nothing here knows a weight.
/// A split is one source file (split_NAME.cpp) and one line in the list in split.cpp.
///
/// The vertices of the refined mesh are born from elements of the old one, in blocks, always
/// in this order: from vertices, from edges, from faces, from corners. `Births` says which
/// element each new vertex belongs to; the rules of a scheme (scheme/) say where it lies.

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "limn/mesh/mesh.h"

namespace limn {

// The dilation matrix M of a split: a vector with coordinates k in the control lattice has M k in
// the refined one. Everything that the analyses on the lattice know about a split is here and in
// its Lattice, so that a new split needs its M alone.

/// The regular meshes: triangles, six round a vertex; quads, four round a vertex.
enum class Lattice { triangle, quad };

using LatticeVector = std::array<int, 2>;  ///< coordinates in the lattice's basis, see lattice.h

/// An integer matrix, row by row. A dilation matrix is one that stretches the plane by
/// sqrt(|det M|) > 1, and turns it perhaps.
struct LatticeMatrix {
  std::array<LatticeVector, 2> rows;  ///< entry (i, j) is rows[i][j]

  /// det M, negative where M turns the plane over.
  [[nodiscard]] constexpr int determinant() const {
    return rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0];
  }
  /// |det M|: the number of refined faces for each old one, and of waves after one refinement.
  [[nodiscard]] constexpr int growth() const {
    return determinant() < 0 ? -determinant() : determinant();
  }
  /// Whether M turns the plane, besides stretching it: of the splits by half a sector.
  [[nodiscard]] constexpr bool turns() const { return rows[0][1] != 0; }
  /// M k
  [[nodiscard]] constexpr LatticeVector apply(LatticeVector k) const {
    return {rows[0][0] * k[0] + rows[0][1] * k[1], rows[1][0] * k[0] + rows[1][1] * k[1]};
  }
  /// det(M) M⁻¹ k
  [[nodiscard]] constexpr LatticeVector apply_adjugate(LatticeVector k) const {
    return {rows[1][1] * k[0] - rows[0][1] * k[1], rows[0][0] * k[1] - rows[1][0] * k[0]};
  }
  /// M⁻¹ k where that is a lattice vector.
  [[nodiscard]] std::optional<LatticeVector> divide(LatticeVector k) const;
  /// M⁻ᵀ t: phases per refined basis vector from phases per control basis vector.
  [[nodiscard]] constexpr std::array<double, 2> refined_phase(std::array<double, 2> t) const {
    const double det = determinant();
    return {(rows[1][1] * t[0] - rows[1][0] * t[1]) / det,
            (rows[0][0] * t[1] - rows[0][1] * t[0]) / det};
  }
  /// The same for integers and without the division: det(M) M⁻ᵀ κ.
  [[nodiscard]] constexpr LatticeVector refined_phase_times_determinant(LatticeVector k) const {
    return {rows[1][1] * k[0] - rows[1][0] * k[1], rows[0][0] * k[1] - rows[0][1] * k[0]};
  }

  /// Equal entries.
  friend constexpr bool operator==(const LatticeMatrix& a, const LatticeMatrix& b) {
    return a.rows == b.rows;
  }
};

/// The class of a refined lattice vector modulo M Z²: 0 … |det M| - 1, old vertices in class 0.
/// Classes are numbered in the lexicographic order of their least non-negative members.
[[nodiscard]] int coset_of(const LatticeMatrix& dilation, LatticeVector k);
/// One member of each class of Z² modulo M Z², (0, 0) first, in the order of coset_of.
[[nodiscard]] std::vector<LatticeVector> cosets(const LatticeMatrix& dilation);

/// One κ of each class of the dual lattice Z² modulo Mᵀ Z², (0, 0) first, the others in
/// lexicographic order: a wave with phases t, refined, is |det M| waves with phases t + 2πκ. For
/// M = 2I these are (0,0) and (0,1), (1,0), (1,1), in this order the artifacts Y1, Y2, Y3 of
/// [ADS §2.2]: Y1 leaves the phase along e1 alone, Y2 that along e2, Y3 that along e1 + e2.
[[nodiscard]] std::vector<LatticeVector> dual_cosets(const LatticeMatrix& dilation);

/// The length of the box that smooths one direction, 1 + z + … + z^{p-1}: the least p with p Z² in
/// M Z². 2 for dyadic splits and sqrt(2), 3 for ternary ones and sqrt(3).
[[nodiscard]] int arity(const LatticeMatrix& dilation);

/// Up to sign the directions of the lattice's edges: e1, e2 and, on triangles, e1 + e2.
[[nodiscard]] std::vector<LatticeVector> edge_directions(Lattice lattice);

/// Squared Cartesian length of a lattice vector, in edges.
[[nodiscard]] constexpr int squared_length(Lattice lattice, LatticeVector k) {
  const int dot = lattice == Lattice::triangle ? -k[0] * k[1] : 0;  // e1·e2 = -1/2 on triangles
  return k[0] * k[0] + k[1] * k[1] + dot;
}

/// The matrices that map the lattice to itself and keep lengths: 12 on triangles, 8 on quads.
[[nodiscard]] std::vector<LatticeMatrix> isometries(Lattice lattice);

/// Which old element each new vertex is born from, block by block.
struct Births {
  Index from_vertices = 0;  ///< new vertices 0 … : child of old vertex i; or none (dual)
  /// The next block: the number of new vertices born from edges. `edge_child` says to which edge
  /// each belongs: child i to edge i, or to what one of the following three says.
  Index from_edges = 0;
  /// Every edge is cut in three and has two children: 2e near the origin of halfedge_of_edge(e),
  /// 2e + 1 near its target.
  bool thirds = false;
  std::vector<Index> edges;  ///< those that have a child, or empty: the first `from_edges` edges
  /// A trisected boundary edge has two children, each named by the (boundary) half-edge it lies on
  /// and the end it is near: 2*halfedge + end with end 0 at the origin, 1 at the target.
  std::vector<Index> edge_ends;
  /// The next block, born from faces: face i, or faces[i] where that list is not empty.
  Index from_faces = 0;
  std::vector<Index> faces;  ///< the faces that have a child, or empty: all of them, or none
  /// Born from corners (half-edges): corner i. Under a dual split it lies half the way to the
  /// middle of its face, under one that keeps old vertices two thirds of it.
  Index from_corners = 0;
  /// Isolated vertices that a dual split passes on, unchanged, at the end.
  std::vector<Index> isolated;
};

/// The place of a vertex that is born from an edge: on an edge that is not cut in three, its
/// middle; else near one of its ends.
struct EdgeChild {
  Index halfedge;          ///< one of the edge's
  bool third = false;      ///< whether the edge is cut in three
  bool at_target = false;  ///< of a third: the end of the half-edge that it is near
};
/// Of the i-th vertex born from edges. Cost O(1).
[[nodiscard]] inline EdgeChild edge_child(const Mesh& mesh, const Births& births, Index i) {
  if (births.thirds) return {mesh.halfedge_of_edge(i / 2), true, i % 2 != 0};
  if (!births.edge_ends.empty()) {
    const Index end = births.edge_ends[static_cast<std::size_t>(i)];
    return {end / 2, true, end % 2 != 0};
  }
  const Index e = births.edges.empty() ? i : births.edges[static_cast<std::size_t>(i)];
  return {mesh.halfedge_of_edge(e)};
}
/// Of splits that give every edge children: the new vertex next to the origin of h on its edge.
[[nodiscard]] inline Index child_along(const Mesh& mesh, const Births& births, Index h) {
  const Index e = mesh.edge(h);
  if (!births.thirds) return births.from_vertices + e;
  return births.from_vertices + 2 * e + (mesh.halfedge_of_edge(e) == h ? 0 : 1);
}

/// One step of a split.
struct SplitResult {
  Mesh mesh;      ///< the refined connectivity
  Births births;  ///< where its vertices come from
};

/// A way of refining connectivity: its facts as data and one function.
struct Split {
  std::string_view name;         ///< as scheme files write it: "triangle-dyadic", …
  std::string_view description;  ///< one line for listings
  Lattice lattice;               ///< what a regular mesh looks like; where `mixed`, one of two
  bool any_polygons = false;     ///< the first step takes any polygons; else those of the lattice
  /// Triangles stay triangles and all other faces become quads, so that a mesh has both, and a
  /// regular one is of either lattice. Analyses on the lattice are those of the two splits that
  /// this one is on meshes of one kind, triangle-dyadic and quad-dyadic.
  bool mixed = false;
  /// Which old elements have a child.
  struct BirthPlaces {
    bool vertices = false;  ///< old vertices; where they have none the split is dual
    bool edges = false;     ///< edges: one in the middle, or
    bool thirds = false;    ///< two, each a third of the edge from one of its ends
    bool faces = false;     ///< faces
    bool corners = false;   ///< corners
  } births;                 ///< which old elements have a child
  /// The boundary is left alone in even steps, and each of its edges cut into so many pieces, 2 or
  /// 3, in odd ones. 0: the boundary is refined in every step.
  int odd_step_cut = 0;
  /// Coordinates of old vertices in the refined lattice; the lattice may turn (sqrt3: by 30°).
  LatticeMatrix dilation;
  /// One step. `step` counts from 0: see odd_step_cut.
  /// Preconditions: all faces are the lattice's unless any_polygons; dilation.growth() *
  /// halfedge_count() and the number of boundary edges are together below 2^31 (no split gives
  /// more half-edges than that). Cost O(V + H).
  SplitResult (*apply)(const Mesh& mesh, int step);

  /// Whether the boundary is refined in every second step only.
  [[nodiscard]] bool boundary_rests() const { return odd_step_cut > 0; }
  /// Whether old vertices go: new points lie half a step beside the refined lattice of old ones.
  [[nodiscard]] bool is_dual() const { return !births.vertices; }
  /// Whether edges have each one child, in the middle.
  [[nodiscard]] bool halves_edges() const { return births.edges && !births.thirds; }
};

/// All splits, in the order in which the documentation lists them.
[[nodiscard]] const std::vector<Split>& splits();
/// The split of that name, or nullptr. It lives as long as the program.
[[nodiscard]] const Split* find_split(std::string_view name);

}  // namespace limn
