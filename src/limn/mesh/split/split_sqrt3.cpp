// F' = 3F; all faces triangles. [Kobbelt, sqrt(3)-Subdivision, 2000]
//
// Every half-edge h of a face gives triangle h of the refined mesh, three half-edges 3h, 3h+1,
// 3h+2. A face has a point q, or is *cut* (odd steps, at the boundary): a cut face with the
// boundary half-edge b = v→w and apex a has, instead of q, the points s and t on b, near v and
// near w. The *tip* of a half-edge is the point that its flipped edge will end at: q, or in a
// cut face t for next(b) and s for prev(b).
// - inner h, twin t:     (origin(h), tip(t), tip(h)), the second half-edge being the flipped edge
// - boundary, not cut:   (origin(h), target(h), q)
// - boundary, cut:       (s, t, a)
// With B cut faces: V' = V + 2B + (F - B), E' = E + H + B: edge e stays with the flipped or
// boundary edge (s–t where cut), E + h is the edge from the face's point to origin(h)
// (where cut: v–s, w–t, a–s), and E + H + i the edge a–t of the i-th cut face.
// Only faces with exactly one boundary edge are cut, as all at the boundary have after an even
// step; others (corners of a mesh whose first step is odd) are refined as in an even step.

#include "limn/base/parallel.h"
#include "limn/mesh/split/split_list.h"

namespace limn::mesh::detail {
namespace {

class Sqrt3 {
 public:
  Sqrt3(const Mesh& mesh, int step) : mesh_(mesh) {
    births_.from_faces = mesh.face_count();
    births_.from_vertices = mesh.vertex_count();
    if (step % 2 != 0) cut_boundary_faces();
  }

  SplitResult run() {
    const Index corners = mesh_.halfedge_count();
    out_ = make_arrays(births_.from_vertices + births_.from_edges + births_.from_faces,
                       mesh_.edge_count() + corners + births_.from_edges / 2, 3,
                       std::ptrdiff_t{3} * corners);
    base::parallel_for_each(corners, [&](Index h) {
      if (mesh_.twin(h) != kNone) return make_inner(h);
      if (cut(h) == kNone) return make_boundary(h);
      make_cut(h);
    });
    return {Mesh::from_arrays(std::move(out_)), std::move(births_)};
  }

 private:
  void cut_boundary_faces() {
    std::vector<Index> sides(static_cast<std::size_t>(mesh_.face_count()), 0);
    for (Index h = 0; h < mesh_.halfedge_count(); ++h)
      if (mesh_.twin(h) == kNone) ++sides[mesh_.face(h)];
    std::vector<Index> cuts(sides.size(), kNone), points(sides.size(), kNone);
    for (Index e = 0; e < mesh_.edge_count(); ++e) {
      const Index b = mesh_.halfedge_of_edge(e), f = mesh_.face(b);
      if (mesh_.twin(b) != kNone || sides[f] != 1) continue;
      cuts[f] = b;
      points[f] = mesh_.vertex_count() + static_cast<Index>(births_.edge_ends.size());
      births_.edge_ends.push_back(2 * b);
      births_.edge_ends.push_back(2 * b + 1);
    }
    if (births_.edge_ends.empty()) return;
    births_.from_edges = static_cast<Index>(births_.edge_ends.size());
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      if (cuts[f] != kNone) continue;
      points[f] =
          mesh_.vertex_count() + births_.from_edges + static_cast<Index>(births_.faces.size());
      births_.faces.push_back(f);
    }
    births_.from_faces = static_cast<Index>(births_.faces.size());
    cuts_ = std::move(cuts);
    points_ = std::move(points);
  }

  // the boundary half-edge of the cut face that h lies in, or kNone
  [[nodiscard]] Index cut(Index h) const { return cuts_.empty() ? kNone : cuts_[mesh_.face(h)]; }

  // q of the face of h, or s where it is cut (t is s + 1)
  [[nodiscard]] Index point(Index h) const {
    return points_.empty() ? mesh_.vertex_count() + mesh_.face(h) : points_[mesh_.face(h)];
  }

  [[nodiscard]] Index tip(Index h) const {
    const Index b = cut(h);
    return b != kNone && mesh_.prev(h) == b ? point(h) + 1 : point(h);
  }

  [[nodiscard]] Index apex_edge(Index b) const {
    return mesh_.edge_count() + mesh_.halfedge_count() + (point(b) - mesh_.vertex_count()) / 2;
  }

  void put(Index at, Index origin, Index twin, Index edge) {
    out_.origin[at] = origin;
    out_.twin[at] = twin;
    out_.edge[at] = edge;
  }

  // half-edge 3h+2 of a triangle that ends at a face point: q → origin(h)
  void put_spoke(Index h, Index from) {
    const Index p = mesh_.prev(h), g = mesh_.twin(p);
    put(3 * h + 2, from, g == kNone ? 3 * p + 1 : 3 * g, mesh_.edge_count() + h);
  }

  void make_inner(Index h) {
    const Index t = mesh_.twin(h), spokes = mesh_.edge_count();
    const Index left = cut(h), right = cut(t);
    if (right == kNone)
      put(3 * h, mesh_.origin(h), 3 * mesh_.next(t) + 2, spokes + mesh_.next(t));
    else if (mesh_.next(t) == right)  // from v along the boundary to s
      put(3 * h, mesh_.origin(h), kNone, spokes + right);
    else  // from a to t
      put(3 * h, mesh_.origin(h), 3 * right + 1, apex_edge(right));
    put(3 * h + 1, tip(t), 3 * t + 1, mesh_.edge(h));
    if (left == kNone)
      put_spoke(h, tip(h));
    else  // from t along the boundary to w, or from s to a
      put(3 * h + 2, tip(h), mesh_.prev(h) == left ? kNone : 3 * left + 2, spokes + h);
  }

  void make_boundary(Index h) {
    put(3 * h, mesh_.origin(h), kNone, mesh_.edge(h));
    put(3 * h + 1, mesh_.target(h), 3 * mesh_.next(h) + 2, mesh_.edge_count() + mesh_.next(h));
    put_spoke(h, point(h));
  }

  void make_cut(Index b) {
    const Index n = mesh_.next(b), p = mesh_.prev(b);
    put(3 * b, point(b), kNone, mesh_.edge(b));
    put(3 * b + 1, point(b) + 1, 3 * mesh_.twin(n), apex_edge(b));
    put(3 * b + 2, mesh_.origin(p), 3 * p + 2, mesh_.edge_count() + p);
  }

  const Mesh& mesh_;
  Births births_;
  std::vector<Index> cuts_, points_;  // per face; empty where no face is cut
  Mesh::Arrays out_;
};

}  // namespace

SplitResult split_sqrt3(const Mesh& mesh, int step) {
  assert(is_triangular(mesh));
  return Sqrt3(mesh, step).run();
}

}  // namespace limn::mesh::detail
