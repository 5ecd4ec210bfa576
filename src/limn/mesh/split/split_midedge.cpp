// V' = E, then isolated vertices; F' = F + inner vertices; any polygons. [PetersReif1997]
//
// Every edge has one new vertex, m; old vertices are gone. The faces come in two blocks.
// - F-faces: half-edge h runs from m_h to m_next(h), across the corner at the target of h.
// - V-faces, for inner vertices in order: the new vertices round the vertex, counterclockwise.
// So edge h lies across a corner, between an F-face and a V-face. Two steps are one of quad-dual,
// at the boundary, too.
//
// An inner vertex of valence 2 would give a 2-gon: it gives no face, and the two F-faces at it meet
// directly, as in quad-dual.
//
// At the boundary steps take turns. In even ones a boundary vertex of two faces or more gives a
// third block of faces, closing ones: the new vertices round it, and an edge that closes them, the
// last of the face and of the mesh. Without these faces a step would lose all that lies at the
// boundary, and fall apart where an edge runs from boundary to boundary. In odd steps, which find
// them by these places, closing faces and edges give nothing: so after two steps the surface ends
// inside the control mesh as under quad-dual, with points that depend on no closing edge.
//
// An odd step on a mesh that no even one has made may still find an inner edge with both ends on
// the boundary, whose two faces would meet in one point only. Each has a copy of it then (the
// second ones follow the first vertices, in order of edges), and they part.

#include <numeric>

#include "limn/base/parallel.h"
#include "limn/mesh/split/split_list.h"

namespace limn::mesh::detail {
namespace {

class MidEdge {
 public:
  MidEdge(const Mesh& mesh, int step) : mesh_(mesh), closes_(step % 2 == 0) {
    if (!closes_) find_closing_faces();
    find_children();
    begin_faces();
  }

  SplitResult run() {
    const Index corners = kept_corners();
    out_ = make_arrays(births_.from_edges + static_cast<Index>(births_.isolated.size()),
                       corners + static_cast<Index>(closed_.size()) + open_edges_, 0,
                       face_begin_.back());
    base::parallel_for_each(corners, [&](Index h) {
      out_.origin[h] = point(h);
      out_.edge[h] = h;
    });
    base::parallel_for_each(mesh_.vertex_count(), [&](Index v) {
      if (vertex_begin_[v] != kNone) make_vertex_face(v, vertex_begin_[v], mesh_.valence(v));
    });
    base::parallel_for_each(static_cast<Index>(closed_.size()), [&](Index i) { close(i); });
    squeeze();
    out_.face_begin = std::move(face_begin_);
    return {Mesh::from_arrays(std::move(out_)), std::move(births_)};
  }

 private:
  /// The faces, and edges, from the last one on that lie as an even step lays closing ones: each
  /// face ends with a boundary edge, has no other, and meets none of the faces that follow it.
  void find_closing_faces() {
    const auto is_closing = [&](Index f, Index edge) {
      const Index end = mesh_.face_begin(f + 1) - 1;
      if (mesh_.twin(end) != kNone || mesh_.edge(end) != edge) return false;
      for (Index h = mesh_.face_begin(f); h < end; ++h)
        if (mesh_.twin(h) == kNone || mesh_.face(mesh_.twin(h)) > f) return false;
      return true;
    };
    while (closing_ < mesh_.face_count() &&
           is_closing(mesh_.face_count() - 1 - closing_, mesh_.edge_count() - 1 - closing_))
      ++closing_;
    // faces of inner vertices are open where they would meet that of a closing face
    for (Index h = kept_corners(); h < mesh_.halfedge_count(); ++h)
      open_edge_.push_back(mesh_.is_boundary_vertex(mesh_.target(h)) ? kNone : open_edges_++);
  }

  [[nodiscard]] Index kept_faces() const { return mesh_.face_count() - closing_; }
  [[nodiscard]] Index kept_corners() const { return mesh_.face_begin(kept_faces()); }
  /// Of half-edge h, which may be kNone.
  [[nodiscard]] bool is_kept(Index h) const { return h != kNone && h < kept_corners(); }

  void find_children() {
    births_.from_edges = mesh_.edge_count() - closing_;
    for (Index v = 0; v < mesh_.vertex_count(); ++v)
      if (mesh_.is_isolated(v)) births_.isolated.push_back(v);
    if (closes_ || !mesh_.has_boundary()) return;
    std::vector<Index> twice;
    copy_.assign(static_cast<std::size_t>(mesh_.edge_count()), kNone);
    for (Index e = 0; e < births_.from_edges; ++e) {
      const Index h = mesh_.halfedge_of_edge(e);
      if (!is_kept(h) || !is_kept(mesh_.twin(h)) || !mesh_.is_boundary_vertex(mesh_.origin(h)) ||
          !mesh_.is_boundary_vertex(mesh_.target(h)))
        continue;
      copy_[e] = births_.from_edges + static_cast<Index>(twice.size());
      twice.push_back(e);
    }
    if (twice.empty()) return;
    births_.edges.resize(static_cast<std::size_t>(births_.from_edges));
    std::iota(births_.edges.begin(), births_.edges.end(), 0);
    births_.edges.insert(births_.edges.end(), twice.begin(), twice.end());
    births_.from_edges = static_cast<Index>(births_.edges.size());
  }

  void begin_faces() {
    face_begin_.reserve(static_cast<std::size_t>(mesh_.face_count()) + mesh_.vertex_count() + 1);
    for (Index f = 0; f <= kept_faces(); ++f) face_begin_.push_back(mesh_.face_begin(f));
    vertex_begin_.assign(static_cast<std::size_t>(mesh_.vertex_count()), kNone);
    Index end = kept_corners();
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      if (mesh_.is_isolated(v)) continue;
      const Index valence = mesh_.valence(v);
      if (mesh_.is_boundary_vertex(v)) {
        if (closes_ && valence > 2) closed_.push_back(v);
        continue;
      }
      if (valence == 2) two_gons_.push_back(v);
      if (valence < 3) continue;
      vertex_begin_[v] = end;
      face_begin_.push_back(end += valence);
    }
    for (const Index v : closed_) face_begin_.push_back(end += mesh_.valence(v));
  }

  /// The new vertex on the edge of h, as the face of h has it.
  [[nodiscard]] Index point(Index h) const {
    const Index e = mesh_.edge(h);
    const bool second = !copy_.empty() && copy_[e] != kNone && mesh_.halfedge_of_edge(e) != h;
    return second ? copy_[e] : e;
  }

  /// From half-edge `begin` on, across the corners of `corners` faces round v.
  Index make_vertex_face(Index v, Index begin, Index corners) {
    Index h = mesh_.halfedge_of_vertex(v), last = kNone;
    for (Index i = begin; i < begin + corners; ++i) {
      last = mesh_.prev(h);  // comes to m_h, across the corner at v
      out_.origin[i] = point(h);
      if (is_kept(last)) {
        out_.twin[i] = last;
        out_.twin[last] = i;
        out_.edge[i] = last;
      } else {
        out_.edge[i] = kept_corners() + open_edge_[last - kept_corners()];
      }
      h = mesh_.rotate(h);
    }
    return last;
  }

  void close(Index i) {
    const Index v = closed_[i], begin = face_begin_[face_begin_.size() - 1 - closed_.size() + i];
    const Index corners = mesh_.valence(v) - 1;
    const Index last = make_vertex_face(v, begin, corners);
    out_.origin[begin + corners] = point(last);
    out_.edge[begin + corners] = kept_corners() + i;
  }

  void squeeze() {
    std::vector<std::pair<Index, Index>> sides;
    for (const Index v : two_gons_) {
      const Index h = mesh_.halfedge_of_vertex(v);
      const Index a = mesh_.prev(h), b = mesh_.prev(mesh_.rotate(h));
      if (is_kept(a) && is_kept(b)) sides.emplace_back(a, b);
    }
    squeeze_two_gons(out_, sides);
  }

  const Mesh& mesh_;
  bool closes_;
  Index closing_ = 0;             // faces, and edges, at the end, that an even step made
  Index open_edges_ = 0;          // of the refined mesh, each beside a corner of such a face
  std::vector<Index> open_edge_;  // of each half-edge of such a face: that at its target, or kNone
  Births births_;
  std::vector<Index> copy_;          // of each edge, or empty: the second vertex on it, or kNone
  std::vector<Index> face_begin_;    // of the refined mesh
  std::vector<Index> vertex_begin_;  // first half-edge of each V-face, or kNone
  std::vector<Index> two_gons_;
  std::vector<Index> closed_;  // boundary vertices that give a closing face
  Mesh::Arrays out_;
};

}  // namespace

SplitResult split_midedge(const Mesh& mesh, int step) { return MidEdge(mesh, step).run(); }

}  // namespace limn::mesh::detail
