#pragma once
/// The mesh that stages live on: the control mesh, cut. It is not made: it has a vertex for each
/// old vertex and edge and for each face that is cut into quads, and its faces lie at the corners
/// of the control mesh (a triangle that is cut into triangles has one more in its middle), so the
/// averagings are index arithmetic on the control mesh. Private to refine/.

#include <array>
#include <vector>

#include "limn/mesh/split/split.h"
#include "limn/scheme/scheme.h"

namespace limn::refine::detail {

class StagedMesh {
 public:
  /// Edges at an interior vertex, and quads.
  struct Star {
    Index edges, quads;
  };

  /// `mesh` and `births` must outlive it. Cost O(faces) where both kinds meet.
  StagedMesh(const Stages& stages, const Mesh& mesh, const Births& births)
      : mesh_(mesh), births_(births), faces_at_(mesh.vertex_count() + mesh.edge_count()) {
    // under a dual split births are corners; the cut is that of all faces all the same
    const bool linear = stages.first == Stages::First::linear;
    centers_count_ = linear ? births.from_faces : mesh.face_count();
    all_ = centers_count_ == mesh.face_count();
    if (all_ || centers_count_ == 0) return;
    centers_.assign(static_cast<std::size_t>(mesh.face_count()), kNone);
    for (Index i = 0; i < centers_count_; ++i)
      centers_[static_cast<std::size_t>(births.faces[static_cast<std::size_t>(i)])] = faces_at_ + i;
  }

  [[nodiscard]] Index vertex_count() const { return faces_at_ + centers_count_; }
  /// Vertices from here on are those of faces.
  [[nodiscard]] Index faces_at() const { return faces_at_; }
  /// The face that vertex i ≥ faces_at is of.
  [[nodiscard]] Index face_of(Index i) const {
    return all_ ? i - faces_at_ : births_.faces[static_cast<std::size_t>(i - faces_at_)];
  }
  [[nodiscard]] Index middle(Index h) const { return mesh_.vertex_count() + mesh_.edge(h); }
  /// Of the face of h; kNone: that is a triangle, cut into triangles.
  [[nodiscard]] Index center(Index h) const {
    if (centers_count_ == 0) return kNone;
    return all_ ? faces_at_ + mesh_.face(h) : centers_[static_cast<std::size_t>(mesh_.face(h))];
  }
  /// Of face h of a mesh of quads alone.
  [[nodiscard]] std::array<Index, 4> corners(Index h) const {
    return {mesh_.origin(h), middle(h), center(h), middle(mesh_.prev(h))};
  }

  /// Round vertex i, which is neither on the boundary nor isolated. Cost O(its edges).
  [[nodiscard]] Star star(Index i) const {
    if (i >= faces_at_) {
      const Index degree = mesh_.degree(face_of(i));
      return {degree, degree};
    }
    if (i >= mesh_.vertex_count()) {
      const Index h = mesh_.halfedge_of_edge(i - mesh_.vertex_count());
      Star star{2, 0};
      for (const Index side : {h, mesh_.twin(h)}) {
        star.edges += center(side) == kNone ? 2 : 1;
        star.quads += center(side) == kNone ? 0 : 2;
      }
      return star;
    }
    Star star{0, 0};
    const Index first = mesh_.halfedge_of_vertex(i);
    Index h = first;
    do {
      ++star.edges;
      star.quads += center(h) == kNone ? 0 : 1;
      h = mesh_.rotate(h);
    } while (h != first);
    return star;
  }

  /// Whether vertex i is no vertex of a face, or lies on the boundary.
  [[nodiscard]] bool is_isolated(Index i) const {
    return i < mesh_.vertex_count() && mesh_.is_isolated(i);
  }
  [[nodiscard]] bool is_on_boundary(Index i) const {
    if (i < mesh_.vertex_count()) return mesh_.is_boundary_vertex(i);
    return i < faces_at_ && mesh_.is_boundary_edge(i - mesh_.vertex_count());
  }

 private:
  const Mesh& mesh_;
  const Births& births_;
  Index faces_at_, centers_count_ = 0;
  bool all_ = true;             // whether all faces are cut into quads
  std::vector<Index> centers_;  // of each face its vertex, where only some have one
};

}  // namespace limn::refine::detail
