// V' = E, then isolated vertices; F' = F + inner vertices; any polygons. [PetersReif1997]
//
// Every edge has one new vertex, m; old vertices are gone. The faces come in two blocks.
// - F-faces: half-edge h runs from m_h to m_next(h), across the corner at the target of h.
// - V-faces, for inner vertices in order: the new vertices round the vertex, counterclockwise.
// So edge h lies across a corner, between an F-face and a V-face. Two steps are one of quad-dual.
//
// An inner vertex of valence 2 would give a 2-gon: it gives no face, and the two F-faces at it meet
// directly, as in quad-dual. Boundary vertices give no face either: the surface ends inside the
// control mesh. Where both ends of an inner edge lie on the boundary its two faces would meet in
// one point only; each has a copy of it then (the second ones follow the E first vertices, in order
// of edges), and they part. So meshes that are to stay in one piece must be closed.

#include <numeric>

#include "limn/base/parallel.h"
#include "limn/mesh/split/split_list.h"

namespace limn::detail {
namespace {

class MidEdge {
 public:
  explicit MidEdge(const Mesh& mesh) : mesh_(mesh) {
    find_copies();
    begin_faces();
  }

  SplitResult run() {
    const Index corners = mesh_.halfedge_count();
    out_ = make_arrays(births_.from_edges + static_cast<Index>(births_.isolated.size()), corners, 0,
                       face_begin_.back());
    parallel_for_each(corners, [&](Index h) {
      out_.origin[h] = point(h);
      out_.edge[h] = h;
    });
    parallel_for_each(mesh_.vertex_count(), [&](Index v) {
      if (vertex_begin_[v] != kNone) make_vertex_face(v);
    });
    squeeze();
    out_.face_begin = std::move(face_begin_);
    return {Mesh::from_arrays(std::move(out_)), std::move(births_)};
  }

 private:
  void find_copies() {
    births_.from_edges = mesh_.edge_count();
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      if (mesh_.is_isolated(v)) births_.isolated.push_back(v);
    if (!mesh_.has_boundary()) return;
    std::vector<Index> twice;
    copy_.assign(static_cast<std::size_t>(mesh_.edge_count()), kNone);
    for (Index e = 0; e < mesh_.edge_count(); ++e) {
      const Index h = mesh_.halfedge_of_edge(e);
      if (mesh_.twin(h) == kNone || !mesh_.is_boundary_vertex(mesh_.origin(h)) ||
          !mesh_.is_boundary_vertex(mesh_.target(h)))
        continue;
      copy_[e] = mesh_.edge_count() + static_cast<Index>(twice.size());
      twice.push_back(e);
    }
    if (twice.empty()) return;
    births_.edges.resize(static_cast<std::size_t>(mesh_.edge_count()));
    std::iota(births_.edges.begin(), births_.edges.end(), 0);
    births_.edges.insert(births_.edges.end(), twice.begin(), twice.end());
    births_.from_edges = static_cast<Index>(births_.edges.size());
  }

  void begin_faces() {
    face_begin_.reserve(static_cast<std::size_t>(mesh_.face_count()) + mesh_.vertex_count() + 1);
    for (Index f = 0; f <= mesh_.face_count(); ++f) face_begin_.push_back(mesh_.face_begin(f));
    vertex_begin_.assign(static_cast<std::size_t>(mesh_.vertex_count()), kNone);
    Index end = mesh_.halfedge_count();
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      if (mesh_.is_isolated(v) || mesh_.is_boundary_vertex(v)) continue;
      const Index valence = mesh_.valence(v);
      if (valence == 2) two_gons_.push_back(v);
      if (valence < 3) continue;
      vertex_begin_[v] = end;
      face_begin_.push_back(end += valence);
    }
  }

  /// The new vertex on the edge of h, as the face of h has it.
  [[nodiscard]] Index point(Index h) const {
    const Index e = mesh_.edge(h);
    const bool second = !copy_.empty() && copy_[e] != kNone && mesh_.halfedge_of_edge(e) != h;
    return second ? copy_[e] : e;
  }

  void make_vertex_face(Index v) {
    Index h = mesh_.halfedge_of_vertex(v);
    for (Index i = vertex_begin_[v], count = mesh_.valence(v); count > 0; ++i, --count) {
      const Index other = mesh_.prev(h);  // comes to m_h, across the corner at v
      out_.origin[i] = point(h);
      out_.twin[i] = other;
      out_.twin[other] = i;
      out_.edge[i] = other;
      h = mesh_.rotate(h);
    }
  }

  void squeeze() {
    std::vector<std::pair<Index, Index>> sides;
    for (const Index v : two_gons_) {
      const Index h = mesh_.halfedge_of_vertex(v);
      sides.emplace_back(mesh_.prev(h), mesh_.prev(mesh_.rotate(h)));
    }
    squeeze_two_gons(out_, sides);
  }

  const Mesh& mesh_;
  Births births_;
  std::vector<Index> copy_;          // of each edge, or empty: the second vertex on it, or kNone
  std::vector<Index> face_begin_;    // of the refined mesh
  std::vector<Index> vertex_begin_;  // first half-edge of each V-face, or kNone
  std::vector<Index> two_gons_;
  Mesh::Arrays out_;
};

}  // namespace

SplitResult split_midedge(const Mesh& mesh, int /*step*/) { return MidEdge(mesh).run(); }

}  // namespace limn::detail
