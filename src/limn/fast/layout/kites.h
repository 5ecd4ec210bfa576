#pragma once
/// Numbers for the vertices of a mesh made by dual steps, by arithmetic alone: those of quads on
/// kites.
///
/// Cut by quad-dyadic, the control mesh falls into *kites*, one for each corner h (half-edge h;
/// mesh.h): the quadrangle between the centre of its face, the midpoints of edges prev(h) and h,
/// and its vertex. The kite is the *patch* of h. A level cuts it into n × n cells, n = 2^(level-1),
/// whose middles are the level's points. Point (x, y), 0 ≤ x, y < n, lies x steps from the first
/// one at the face's centre towards the midpoint of edge prev(h), and y steps towards that of edge
/// h.
///
/// Where the vertex of h lies on the boundary, the mesh recedes and the patch is a *rim*: of its
/// points there are (0, 0), the *arm* (x, 0) where edge prev(h) is not on the boundary, and the arm
/// (0, y) where edge h is not. The other patches are whole.
///
/// Vertices are numbered in blocks: the n² points of each whole patch in the order of half-edges,
/// row by row (y = 0, 1, …), x ascending; the points of each rim: (0, 0), those of its arm along x,
/// then along y, both outward; the isolated vertices of the control mesh.
///
/// Faces come in blocks, too:
/// - of each control face, in order, its corners' points (0, 0);
/// - of each vertex off the boundary its corners' points (n-1, n-1), counterclockwise;
/// - of each whole patch, rows y = 0 … n-2 of quads x = -1 … n-1, the first and last being those
///   across its sides x = 0 and x = n-1: (x, y) (x+1, y) (x+1, y+1) (x, y+1);
/// - of each arm along y the quads x = -1, y = 0 … n-2 alike;
/// - of each inner edge the quad at its midpoint.

#include <cstddef>
#include <utility>
#include <vector>

#include "limn/mesh/mesh.h"

namespace limn::fast {

/// Numbers of points that one call of a parallel loop makes.
inline constexpr Index kNumberGrain = 16384;

/// What the layouts of all levels have in common.
class Kites {
 public:
  /// No interior vertex of `control` has valence 2 (such faces are lost; split_quad_dual.cpp). The
  /// mesh must outlive this.
  explicit Kites(const Mesh& control);

  [[nodiscard]] const Mesh& control() const { return *mesh_; }
  [[nodiscard]] bool is_whole(Index h) const { return whole_rank(h) >= 0; }
  /// Which of the whole patches, or of the rims, that of h is.
  [[nodiscard]] Index whole_rank(Index h) const { return has_rims() ? place_[at(h)] : h; }
  [[nodiscard]] Index rim_rank(Index h) const { return ~place_[at(h)]; }
  [[nodiscard]] bool has_y_arm(Index h) const { return mesh_->twin(h) != kNone; }
  [[nodiscard]] bool has_x_arm(Index h) const { return mesh_->twin(mesh_->prev(h)) != kNone; }
  /// The arms of the rims before a rim, or of all.
  [[nodiscard]] Index arms_before(Index rim) const { return arms_before_[at(rim)]; }
  [[nodiscard]] bool has_rims() const { return arms_before_.size() > 1; }
  [[nodiscard]] Index rim_count() const { return static_cast<Index>(arms_before_.size()) - 1; }

  /// Whether point (x, y) is there, x and y being within the patch.
  [[nodiscard]] bool has_point(Index h, Index x, Index y) const {
    return is_whole(h) || (x == 0 && y == 0) || (y == 0 && has_x_arm(h)) ||
           (x == 0 && has_y_arm(h));
  }

  /// The half-edges of whole patches, and of rims with an arm along y: of inner edges, from the
  /// boundary on.
  [[nodiscard]] const std::vector<Index>& wholes() const { return wholes_; }
  [[nodiscard]] const std::vector<Index>& lines() const { return lines_; }
  [[nodiscard]] const std::vector<Index>& inner_edges() const { return inner_edges_; }
  [[nodiscard]] const std::vector<Index>& inner_vertices() const { return inner_vertices_; }
  /// Corners before those at inner vertex number i (or after the last).
  [[nodiscard]] Index vertex_begin(Index i) const { return vertex_begin_[at(i)]; }
  [[nodiscard]] const std::vector<Index>& isolated() const { return isolated_; }
  /// Whether all faces, and all inner vertices, have four corners.
  [[nodiscard]] bool is_regular() const;

 private:
  static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
  void place_patches();
  void list_inner_elements();

  const Mesh* mesh_;
  std::vector<Index> place_;  // rank, or its complement for a rim; empty where there are none
  std::vector<Index> wholes_, lines_, arms_before_{0};
  std::vector<Index> inner_edges_, inner_vertices_, vertex_begin_, isolated_;
};

/// One level. Light: keeps a reference to the kites.
class KiteLayout {
 public:
  /// n = 2^(level-1) points along a patch's side; there are fewer than 2^31 corners in all.
  KiteLayout(const Kites& kites, Index n);

  [[nodiscard]] Index n() const { return n_; }
  [[nodiscard]] Index vertex_count() const { return isolated_at_ + count(kites_->isolated()); }
  [[nodiscard]] Index face_count() const { return quads_ + control().face_count() + inner_count(); }
  [[nodiscard]] Index corner_count() const {
    return 4 * quads_ + control().halfedge_count() + kites_->vertex_begin(inner_count());
  }

  /// Point (x, y) of the patch of h, which must have it.
  [[nodiscard]] Index point(Index h, Index x, Index y) const {
    if (kites_->is_whole(h)) return kites_->whole_rank(h) * n_ * n_ + y * n_ + x;
    const Index rim = kites_->rim_rank(h);
    const Index begin = rims_at_ + rim + kites_->arms_before(rim) * (n_ - 1);
    return begin + (y > 0 && kites_->has_x_arm(h) ? n_ - 1 : 0) + x + y;
  }
  /// Point (t, u), 0 ≤ t < 2n, of the line of h, which runs from the centre of its face to that of
  /// its twin's: u ≥ 0 on the side of the origin of h, u < 0 on the other.
  [[nodiscard]] Index line_point(Index h, Index t, Index u) const;
  [[nodiscard]] Index isolated_begin() const { return isolated_at_; }
  /// The isolated vertices' numbers.
  [[nodiscard]] std::vector<Index> isolated() const;

  [[nodiscard]] const Kites& kites() const { return *kites_; }

  /// The corners of all faces: corner_count() numbers. In parallel.
  void write_faces(Index* out) const;
  /// Where each face begins in them: face_count() + 1 numbers. In parallel.
  void write_face_begin(Index* out) const;

 private:
  template <class List>
  static Index count(const List& list) {
    return static_cast<Index>(list.size());
  }
  [[nodiscard]] const Mesh& control() const { return kites_->control(); }
  [[nodiscard]] Index inner_count() const { return count(kites_->inner_vertices()); }
  void write_patch(Index h, Index* out) const;
  /// The quad across the line of h, between its t-th points and the next.
  void write_across(Index h, Index t, Index* out) const;
  void write_vertex(Index v, Index* out) const;

  const Kites* kites_;
  Index n_, rims_at_, isolated_at_;
  Index arm_quads_at_, edge_quads_at_, quads_;  // quads before the arms', the edges', in all
};

}  // namespace limn::fast
