// V' = V + E + Q, E' = 2E + H, F' = 4T + the corners of all other faces (T triangles, Q other
// faces, H half-edges); any polygons. Triangles are cut as by triangle-dyadic, all others as by
// quad-dyadic, and a mesh of one kind is numbered as there.
//
// The children of a face that begins with half-edge b begin with half-edge 4b. Half-edge h of a
// triangle gives the triangle (v, m_h, m_prev(h)) from 3h + b on, and the inner one is (m_0, m_1,
// m_2), from 4b + 9 on; of any other face it gives the quad (v, m_h, c, m_prev(h)) from 4h on. Here
// v is its origin, m the new vertex on an edge, c that of the face.

#include "limn/base/parallel.h"
#include "limn/mesh/split/split_list.h"

namespace limn::mesh::detail {
namespace {

class QuadTriangle {
 public:
  explicit QuadTriangle(const Mesh& mesh)
      : mesh_(mesh), child_(static_cast<std::size_t>(mesh.face_count()), kNone) {
    Index first = 0;  // of the children of each face in turn
    begin_.reserve(child_.size() + 1);
    begin_.push_back(first);
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const bool triangle = mesh.degree(f) == 3;
      if (!triangle) {
        child_[static_cast<std::size_t>(f)] = static_cast<Index>(cut_.size());
        cut_.push_back(f);
      }
      first += triangle ? 4 : mesh.degree(f);
      begin_.push_back(first);
    }
  }

  SplitResult run() {
    const Index vertices = mesh_.vertex_count(), edges = mesh_.edge_count();
    const auto cuts = static_cast<Index>(cut_.size());
    const Index degree = cuts == 0 ? 3 : cuts == mesh_.face_count() ? 4 : 0;
    out_ = make_arrays(vertices + edges + cuts, 2 * edges + mesh_.halfedge_count(), degree,
                       std::ptrdiff_t{4} * mesh_.halfedge_count());
    if (degree == 0) make_face_begin();
    base::parallel_for_each(mesh_.halfedge_count(), [&](Index h) {
      if (is_triangle(h))
        cut_triangle(h);
      else
        cut_quad(h);
    });
    SplitResult result{Mesh::from_arrays(std::move(out_)), {}};
    result.births.from_vertices = vertices;
    result.births.from_edges = edges;
    result.births.from_faces = cuts;
    if (degree == 0) result.births.faces = std::move(cut_);
    return result;
  }

 private:
  [[nodiscard]] bool is_triangle(Index h) const { return mesh_.degree(mesh_.face(h)) == 3; }
  // the first half-edge of the child at the origin of h, and the last one, which ends there
  [[nodiscard]] Index first(Index h) const {
    return is_triangle(h) ? 3 * h + mesh_.face_begin(mesh_.face(h)) : 4 * h;
  }
  [[nodiscard]] Index last(Index h) const { return first(h) + (is_triangle(h) ? 2 : 3); }
  [[nodiscard]] Index middle(Index h) const { return mesh_.vertex_count() + mesh_.edge(h); }

  void make_face_begin() {
    out_.face_begin.resize(static_cast<std::size_t>(begin_.back()) + 1);
    out_.face_begin.front() = 0;
    base::parallel_for_each(mesh_.face_count(), [&](Index f) {
      const Index from = 4 * mesh_.face_begin(f), corners = mesh_.degree(f) == 3 ? 3 : 4;
      const Index children = begin_[f + 1] - begin_[f];
      for (Index i = 1; i <= children; ++i) out_.face_begin[begin_[f] + i] = from + i * corners;
    });
  }

  void put(Index at, Index origin, Index twin, Index edge) {
    out_.origin[at] = origin;
    out_.twin[at] = twin;
    out_.edge[at] = edge;
  }
  // the two half-edges that lie on old edges
  void put_outer(Index h, Index p) {
    const Index t = mesh_.twin(h), g = mesh_.twin(p);
    put(first(h), mesh_.origin(h), t == kNone ? kNone : last(mesh_.next(t)),
        edge_at_origin(mesh_, h));
    put(last(h), middle(p), g == kNone ? kNone : first(g), edge_at_target(mesh_, p));
  }

  // edge 2E + h lies opposite to the origin of next(h)
  void cut_triangle(Index h) {
    const Index p = mesh_.prev(h), inner = 2 * mesh_.edge_count();
    const Index begin = mesh_.face_begin(mesh_.face(h)), center = 4 * begin + 9 - begin;
    put_outer(h, p);
    put(first(h) + 1, middle(h), center + p, inner + p);
    put(center + h, middle(h), first(mesh_.next(h)) + 1, inner + h);
  }

  void cut_quad(Index h) {
    const Index p = mesh_.prev(h), inner = 2 * mesh_.edge_count(), quad = 4 * h;
    const Index point = mesh_.vertex_count() + mesh_.edge_count() + child_[mesh_.face(h)];
    put_outer(h, p);
    put(quad + 1, middle(h), 4 * mesh_.next(h) + 2, inner + h);
    put(quad + 2, point, 4 * p + 1, inner + p);
  }

  const Mesh& mesh_;
  std::vector<Index> cut_;    // the faces that are no triangles
  std::vector<Index> child_;  // of each face its place among these; kNone: a triangle
  std::vector<Index> begin_;  // the first child of each face, and one more
  Mesh::Arrays out_;
};

}  // namespace

SplitResult split_quad_triangle(const Mesh& mesh, int /*step*/) { return QuadTriangle(mesh).run(); }

}  // namespace limn::mesh::detail
