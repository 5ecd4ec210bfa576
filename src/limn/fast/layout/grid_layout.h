#pragma once
/// Numbers for the vertices of a regularly subdivided mesh of triangles or of quads, by arithmetic.
///
/// Every control edge is cut into n. Face f's *patch* is its triangle of points (x, y), x, y ≥ 0,
/// x + y ≤ n, with the face's corners 0, 1, 2 at (0, 0), (n, 0), (0, n); or its square 0 ≤ x, y ≤
/// n, with the corners at (0, 0), (n, 0), (n, n), (0, n). The *frame* of half-edge h is the same
/// with the origin of h at (0, 0) and its target at (n, 0). Vertices are numbered in blocks: the
/// control vertices, as they are; the n-1 inner points of each edge, from the origin of
/// halfedge_of_edge(e); the inner points of each patch, row by row (y = 1, 2, …), x ascending; and,
/// where the level has centres (lattice_step.h), those of each patch's n² cells in the order of the
/// cells, which is that of the faces of a level without. Faces come patch by patch, row by row, x
/// ascending. Of triangles: (x, y) (x+1, y) (x, y+1), and but for the last of a row (x+1, y) (x+1,
/// y+1) (x, y+1), then the next x. Of quads: (x, y) (x+1, y) (x+1, y+1) (x, y+1). A triangle with a
/// centre gives three faces, half-edge by half-edge: its origin, the centre across, the triangle's
/// own; at a boundary edge: its origin, its target, the centre. Of quads with centres the faces are
/// the grid's edges: each between its ends v, w and the centres beside it, (v, right, w, left) as
/// seen from v. A patch has those within it: row by row the upright ones between its cells, then
/// those over the row, x ascending; after all patches come those on the control edges, edge by edge
/// from the origin of halfedge_of_edge(e): at the boundary (v, w, left).

#include <cstdint>
#include <vector>

#include "limn/fast/kernel/stencil.h"
#include "limn/mesh/mesh.h"
#include "limn/mesh/split/split.h"

namespace limn::fast {

/// A half-edge by its edge: twice that, and 1 more where the half-edge leads.
using EdgeCode = Index;

/// Whether h stands for its edge, the lower half-edge of the two (mesh.h): the points of the edge
/// are numbered along it.
[[nodiscard]] inline bool leads(const Mesh& mesh, Index h) {
  // on the boundary the twin is the largest number of all
  return static_cast<std::uint32_t>(h) < static_cast<std::uint32_t>(mesh.twin(h));
}

[[nodiscard]] inline EdgeCode edge_code(const Mesh& mesh, Index h) {
  return 2 * mesh.edge(h) + (leads(mesh, h) ? 1 : 0);
}

class GridLayout {
 public:
  /// All faces of `control` are triangles or quads, as `lattice` has it (or there are none); it
  /// must outlive the layout. n ≥ 1, and all faces together have fewer than 2^31 corners.
  ///
  /// Places are given in steps of which `unit` make an edge of the grid: grid points have multiples
  /// of it, and `unit` > 1 with centres.
  GridLayout(const Mesh& control, Lattice lattice, Index n, Index unit = 1, bool centres = false);

  [[nodiscard]] const Mesh& control() const { return *mesh_; }
  [[nodiscard]] Index n() const { return n_; }
  [[nodiscard]] Lattice lattice() const { return lattice_; }
  [[nodiscard]] Index sides() const { return sides_; }
  [[nodiscard]] Index unit() const { return unit_; }
  [[nodiscard]] bool has_centres() const { return centres_; }
  /// The steps along a control edge.
  [[nodiscard]] Index side() const { return n() * unit_; }
  /// The grid alone, with places in its own steps.
  [[nodiscard]] GridLayout grid() const { return {control(), lattice_, n()}; }

  [[nodiscard]] Index vertex_count() const {
    return centres_at_ + (centres_ ? control().face_count() * n() * n() : 0);
  }
  [[nodiscard]] Index face_count() const {
    return control().face_count() * patch_faces() + control().edge_count() * edge_faces();
  }
  /// Of each patch, and of each control edge besides.
  [[nodiscard]] Index patch_faces() const {
    if (faces_are_edges()) return 2 * n() * (n() - 1);
    return (centres_ ? 3 : 1) * n() * n();
  }
  [[nodiscard]] Index edge_faces() const { return faces_are_edges() ? n() : 0; }
  [[nodiscard]] Index corner_count() const {
    const Index boundary = 2 * control().edge_count() - control().halfedge_count();
    return sides_ * face_count() - boundary * edge_faces();
  }

  /// The first inner point of an edge.
  [[nodiscard]] Index edge_begin(Index e) const { return edges_at_ + e * (n_ - 1); }
  /// The t-th point along a half-edge, 0 < t < n.
  [[nodiscard]] Index point_along(EdgeCode code, Index t) const {
    return edge_begin(code >> 1) + ((code & 1) != 0 ? t : n_ - t) - 1;
  }
  [[nodiscard]] Index edge_point(Index h, Index t) const {
    return point_along(edge_code(*mesh_, h), t);
  }
  /// The inner points of face f's grid, and how many these are; its centres.
  [[nodiscard]] Index face_begin(Index f) const { return faces_at_ + f * face_size_; }
  [[nodiscard]] Index face_size() const { return face_size_; }
  [[nodiscard]] Index centre_begin(Index f) const { return centres_at_ + f * n() * n(); }

  /// Whether there is a point at a place of the patch.
  [[nodiscard]] bool has_point(Index x, Index y) const {
    return unit_ == 1 || (centres_ ? (x - y) % unit_ == 0 : x % unit_ == 0 && y % unit_ == 0);
  }

  /// Where a point of a patch lies: at a corner, on a side (the `at`-th point along it), or the
  /// `at`-th of the patch's inner points or centres. Corners and sides are counted from those of
  /// the half-edge in whose frame the point is given.
  struct Spot {
    enum On { corner, edge, inner, centre } on = corner;
    Index side = 0;
    Index at = 0;
  };
  /// Of point (x, y) in the frame of a face's half-edge number k.
  [[nodiscard]] Spot spot(Index k, Index x, Index y) const;

  /// The number of a point in the frame of h.
  [[nodiscard]] Index point(Index h, Index x, Index y) const {
    const Index f = control().face(h);
    const Spot s = spot(h - sides_ * f, x, y);
    if (s.on == Spot::inner) return face_begin(f) + s.at;
    if (s.on == Spot::centre) return centre_begin(f) + s.at;
    const Index g = turned(h, s.side);
    return s.on == Spot::corner ? control().origin(g) : edge_point(g, s.at);
  }
  /// The same beyond the patch's sides, as far as its neighbours go; kNone where there is none.
  /// Past the ends of a side on the boundary, along the boundary.
  [[nodiscard]] Index point_beyond(Index h, Index x, Index y) const;

  /// The half-edge k sides after h in its face, 0 ≤ k < sides.
  [[nodiscard]] Index turned(Index h, Index k) const {
    if (sides_ == 4) return (h & ~3) | ((h + k) & 3);
    const Index end = 3 * control().face(h) + 3;
    return h + k < end ? h + k : h + k - 3;
  }

  /// The corners of the faces of patches first … last-1 (grid_faces.cpp).
  void write_faces(Index first, Index last, Index* out) const;
  /// Those of the control edges, which follow the last patch's. In parallel.
  void write_edge_faces(Index* out) const;
  /// Where each face begins among the corners of all: face_count() + 1 numbers.
  void write_face_begin(Index* out) const;

 private:
  [[nodiscard]] bool faces_are_edges() const { return centres_ && sides_ == 4; }
  /// Of each control edge how many before it lie on the boundary, and of all.
  [[nodiscard]] std::vector<Index> boundary_before() const;
  [[nodiscard]] Spot grid_spot(Index k, Index x, Index y) const;

  const Mesh* mesh_;
  Lattice lattice_;
  Index n_, sides_, unit_;
  bool centres_;
  Index face_size_, edges_at_, faces_at_, centres_at_;
};

/// Where point (a, b) of the frame of side 0, 1, … lies in the patch.
[[nodiscard]] Offset in_patch(Lattice lattice, Index n, Index side, Offset point);

/// The inner points of a patch, row by row.
[[nodiscard]] std::vector<Offset> inner_places(Lattice lattice, Index n);

/// The centres of a patch of n edges a side, in the order of their numbers, in steps of a grid
/// `unit` times as fine.
[[nodiscard]] std::vector<Offset> centre_places(Lattice lattice, Index n, Index unit);

}  // namespace limn::fast
