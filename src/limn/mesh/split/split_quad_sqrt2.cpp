// A quad for each inner edge; any polygons. [VelhoZorin2001; their pairs of triangles are
// quads here]
//
// Each face f has a point c_f. The inner edge of h = v→w in face f and of its twin in face g gives
// the quad (v, c_g, w, c_f); a boundary edge h in face f the triangle (v, w, c_f): half of such a
// quad. Old inner edges are gone, as in sqrt3 they are flipped.
//
// In odd steps these half quads are completed. A triangle whose one boundary edge is b = v→w, with
// apex a, is *cut*: its point is born from the edge b, and lies on it, so that b gives no face, and
// the triangle's other edges give quads that end at the boundary. Two steps are so one of
// quad-dyadic, at the boundary too. Only triangles with exactly one boundary edge are cut, as all
// faces at the boundary are after an even step; others (in a mesh whose first step is odd) are
// refined as in an even step.
//
// With I inner edges, B boundary edges, C of them cut: V' = V + C + (F - C), F' = I + B - C,
// E' = H + B - C. Faces are numbered as the edges that they come from. Edge h of the refined mesh
// runs from the point of h's face to origin(h); edges H … are the boundary edges that are not cut,
// in order.

#include <array>

#include "limn/base/parallel.h"
#include "limn/mesh/split/split_list.h"

namespace limn::mesh::detail {
namespace {

class QuadSqrt2 {
 public:
  QuadSqrt2(const Mesh& mesh, int step) : mesh_(mesh), uncut_(mesh.halfedge_count()) {
    births_.from_vertices = mesh.vertex_count();
    births_.from_faces = mesh.face_count();
    if (step % 2 != 0) cut_boundary_faces();
    begin_faces();
  }

  SplitResult run() {
    const bool quads = triangles_ == 0;
    const Index vertices = births_.from_vertices + births_.from_edges + births_.from_faces;
    out_ = make_arrays(vertices, uncut_, quads ? 4 : 0, begin_.back());
    base::parallel_for_each(mesh_.edge_count(), [&](Index e) {
      const Index h = mesh_.halfedge_of_edge(e);
      if (mesh_.twin(h) != kNone)
        make_quad(h);
      else if (has_face(e))
        make_triangle(h);
    });
    if (!quads) out_.face_begin = faces_begin();
    return {Mesh::from_arrays(std::move(out_)), std::move(births_)};
  }

 private:
  void cut_boundary_faces() {
    const auto sides = [&](Index f) {
      Index count = 0;
      for (Index h = mesh_.face_begin(f); h < mesh_.face_begin(f + 1); ++h)
        count += mesh_.twin(h) == kNone ? 1 : 0;
      return count;
    };
    std::vector<Index> points(static_cast<std::size_t>(mesh_.face_count()), kNone);
    for (Index e = 0; e < mesh_.edge_count(); ++e) {
      if (!mesh_.is_boundary_edge(e)) continue;
      const Index f = mesh_.face(mesh_.halfedge_of_edge(e));
      if (mesh_.degree(f) != 3 || sides(f) != 1) continue;
      points[f] = mesh_.vertex_count() + static_cast<Index>(births_.edges.size());
      births_.edges.push_back(e);
    }
    if (births_.edges.empty()) return;
    births_.from_edges = static_cast<Index>(births_.edges.size());
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      if (points[f] != kNone) continue;
      points[f] =
          mesh_.vertex_count() + births_.from_edges + static_cast<Index>(births_.faces.size());
      births_.faces.push_back(f);
    }
    births_.from_faces = static_cast<Index>(births_.faces.size());
    points_ = std::move(points);
  }

  // where each edge's face begins, and the numbers of boundary edges that stay
  void begin_faces() {
    begin_.reserve(static_cast<std::size_t>(mesh_.edge_count()) + 1);
    begin_.push_back(0);
    stays_.assign(static_cast<std::size_t>(mesh_.edge_count()), kNone);
    for (Index e = 0; e < mesh_.edge_count(); ++e) {
      Index corners = 4;
      if (mesh_.is_boundary_edge(e)) {
        const bool cut = is_cut(mesh_.halfedge_of_edge(e));
        corners = cut ? 0 : 3;
        if (!cut) stays_[e] = uncut_++;
        triangles_ += cut ? 0 : 1;
      }
      begin_.push_back(begin_.back() + corners);
    }
  }

  [[nodiscard]] std::vector<Index> faces_begin() const {
    std::vector<Index> begin{0};
    for (std::size_t e = 1; e < begin_.size(); ++e)
      if (begin_[e] != begin_[e - 1]) begin.push_back(begin_[e]);
    return begin;
  }

  // the point of the face of h
  [[nodiscard]] Index point(Index h) const {
    return points_.empty() ? mesh_.vertex_count() + mesh_.face(h) : points_[mesh_.face(h)];
  }
  // whether the boundary half-edge h carries the point of its face
  [[nodiscard]] bool is_cut(Index h) const {
    return point(h) < mesh_.vertex_count() + births_.from_edges;
  }
  [[nodiscard]] bool has_face(Index e) const { return begin_[e + 1] != begin_[e]; }

  // the refined half-edges from the point of h's face to origin(h), and back: one of the four of an
  // inner edge's quad, or of the three of a boundary edge's triangle; kNone outside
  [[nodiscard]] Index outward(Index h) const { return half(h, 3, 1, 2); }
  [[nodiscard]] Index inward(Index h) const { return half(mesh_.prev(h), 2, 0, 1); }
  [[nodiscard]] Index half(Index h, Index first, Index second, Index at_boundary) const {
    const Index e = mesh_.edge(h);
    if (!has_face(e)) return kNone;
    if (mesh_.twin(h) == kNone) return begin_[e] + at_boundary;
    return begin_[e] + (mesh_.halfedge_of_edge(e) == h ? first : second);
  }

  void put(Index at, Index origin, Index twin, Index edge) {
    out_.origin[at] = origin;
    out_.twin[at] = twin;
    out_.edge[at] = edge;
  }
  void put_inward(Index h) { put(inward(h), mesh_.origin(h), outward(h), h); }
  void put_outward(Index h) { put(outward(h), point(h), inward(h), h); }

  void make_quad(Index h) {
    const Index t = mesh_.twin(h);
    put_inward(mesh_.next(t));  // v → c_g
    put_outward(t);             // c_g → w
    put_inward(mesh_.next(h));  // w → c_f
    put_outward(h);             // c_f → v
  }

  void make_triangle(Index h) {
    const Index e = mesh_.edge(h);
    put(begin_[e], mesh_.origin(h), kNone, stays_[e]);
    put_inward(mesh_.next(h));
    put_outward(h);
  }

  const Mesh& mesh_;
  Births births_;
  std::vector<Index> points_;  // per face; empty where no face is cut
  std::vector<Index> begin_;   // first refined half-edge of each edge's face, and one more
  std::vector<Index> stays_;   // of each boundary edge that is not cut, its number
  Index uncut_;                // refined edges
  Index triangles_ = 0;
  Mesh::Arrays out_;
};

}  // namespace

SplitResult split_quad_sqrt2(const Mesh& mesh, int step) { return QuadSqrt2(mesh, step).run(); }

}  // namespace limn::mesh::detail
