// V' = H (corner h lies at the origin of half-edge h, in its face), then isolated vertices;
// F' = F + inner edges + inner vertices; any polygons. [Doo & Sabin 1978]
//
// The faces come in three blocks.
// - F-faces: face f shrunk; half-edge h runs from corner h to corner next(h).
// - E-faces, for inner edges in order: (next(h), h, next(t), t), where h stands for the edge and
//   t = twin(h); its first and third half-edge run along F-faces, the second and fourth cross
//   the edge, at the origin of h and at that of t.
// - V-faces, for inner vertices in order: the corners round the vertex, counterclockwise.
// Boundary edges and vertices give no face: the surface ends inside the control mesh.
// An inner vertex of valence 2 would give a 2-gon. It gives no face either: the two E-faces at
// it meet directly, as if the 2-gon were squeezed to one edge.

#include "limn/base/parallel.h"
#include "limn/mesh/split/split_list.h"

namespace limn::mesh::detail {
namespace {

struct Plan {
  std::vector<Index> inner_edge;  // of each edge its rank among the inner ones, or kNone
  Index inner_edges = 0;
  std::vector<Index> vertex_valence;  // 0 where there is no V-face nor a squeezed one
  std::vector<Index> vertex_begin;    // first half-edge of each V-face
  std::vector<Index> face_begin;      // of the refined mesh
};

Plan make_plan(const Mesh& mesh) {
  Plan plan;
  plan.inner_edge.assign(static_cast<std::size_t>(mesh.edge_count()), kNone);
  for (Index e = 0; e < mesh.edge_count(); ++e)
    if (!mesh.is_boundary_edge(e)) plan.inner_edge[e] = plan.inner_edges++;
  plan.vertex_valence.assign(static_cast<std::size_t>(mesh.vertex_count()), 0);
  base::parallel_for_each(mesh.vertex_count(), [&](Index v) {
    if (!mesh.is_boundary_vertex(v)) plan.vertex_valence[v] = mesh.valence(v);
  });
  plan.face_begin.reserve(static_cast<std::size_t>(mesh.face_count()) + plan.inner_edges +
                          mesh.vertex_count() + 1);
  for (Index f = 0; f <= mesh.face_count(); ++f) plan.face_begin.push_back(mesh.face_begin(f));
  Index end = mesh.halfedge_count();
  for (Index e = 0; e < plan.inner_edges; ++e) plan.face_begin.push_back(end += 4);
  plan.vertex_begin.assign(plan.vertex_valence.size(), kNone);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (plan.vertex_valence[v] < 3) continue;
    plan.vertex_begin[v] = end;
    plan.face_begin.push_back(end += plan.vertex_valence[v]);
  }
  return plan;
}

class DualSplit {
 public:
  DualSplit(const Mesh& mesh, const Plan& plan, Mesh::Arrays& out)
      : mesh_(mesh), plan_(plan), out_(out) {}

  void run() {
    base::parallel_for_each(mesh_.halfedge_count(), [&](Index h) {
      out_.origin[h] = h;
      out_.edge[h] = h;
    });
    base::parallel_for_each(mesh_.edge_count(), [&](Index e) { make_edge_face(e); });
    base::parallel_for_each(mesh_.vertex_count(), [&](Index v) {
      if (plan_.vertex_valence[v] >= 3) make_vertex_face(v);
    });
    squeeze();
  }

 private:
  void make_edge_face(Index e) {
    if (plan_.inner_edge[e] == kNone) return;
    const Index h = mesh_.halfedge_of_edge(e), t = mesh_.twin(h);
    const Index quad = mesh_.halfedge_count() + 4 * plan_.inner_edge[e];
    const Index crossing = mesh_.halfedge_count() + 2 * plan_.inner_edge[e];
    const Index corners[4] = {mesh_.next(h), h, mesh_.next(t), t};
    const Index edges[4] = {h, crossing, t, crossing + 1};
    for (Index i = 0; i < 4; ++i) {
      out_.origin[quad + i] = corners[i];
      out_.edge[quad + i] = edges[i];
    }
    out_.twin[quad] = h;
    out_.twin[h] = quad;
    out_.twin[quad + 2] = t;
    out_.twin[t] = quad + 2;
  }

  // the half-edge of an E-face that leaves corner h and crosses the edge of h, clockwise round
  // the origin of h
  [[nodiscard]] Index crossing(Index h) const {
    const Index e = mesh_.edge(h);
    return mesh_.halfedge_count() + 4 * plan_.inner_edge[e] +
           (mesh_.halfedge_of_edge(e) == h ? 1 : 3);
  }

  void make_vertex_face(Index v) {
    Index h = mesh_.halfedge_of_vertex(v);
    const Index begin = plan_.vertex_begin[v];
    for (Index i = begin; i < begin + plan_.vertex_valence[v]; ++i) {
      const Index after = mesh_.rotate(h), other = crossing(after);
      out_.origin[i] = h;
      out_.twin[i] = other;
      out_.twin[other] = i;
      out_.edge[i] = out_.edge[other];
      h = after;
    }
  }

  void squeeze() {
    std::vector<std::pair<Index, Index>> sides;
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      if (plan_.vertex_valence[v] != 2) continue;
      const Index h = mesh_.halfedge_of_vertex(v);
      sides.emplace_back(crossing(h), crossing(mesh_.rotate(h)));
    }
    squeeze_two_gons(out_, sides);
  }

  const Mesh& mesh_;
  const Plan& plan_;
  Mesh::Arrays& out_;
};

}  // namespace

SplitResult split_quad_dual(const Mesh& mesh, int /*step*/) {
  Births births;
  births.from_corners = mesh.halfedge_count();
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.is_isolated(v)) births.isolated.push_back(v);
  Plan plan = make_plan(mesh);
  const auto isolated = static_cast<Index>(births.isolated.size());
  Mesh::Arrays out =
      make_arrays(mesh.halfedge_count() + isolated, mesh.halfedge_count() + 2 * plan.inner_edges, 0,
                  plan.face_begin.back());
  DualSplit(mesh, plan, out).run();
  out.face_begin = std::move(plan.face_begin);
  return {Mesh::from_arrays(std::move(out)), std::move(births)};
}

}  // namespace limn::mesh::detail
