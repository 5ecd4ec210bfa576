// V' = V + 2E + F, E' = 3E + 3H (H half-edges), F' = 9F; all faces triangles. [Loop2003]
//
// Every edge is cut in three. Half-edge h from v has the new vertices a, near v, and b, near its
// target; the face has one more, c, in the middle. With p the half-edge before h in the face, h
// gives three triangles:
//
//     3h      (v, a, b_p)     at the corner
//     3h + 1  (a, b, c)       on the middle third of the edge
//     3h + 2  (a, c, b_p)     between the two
//
//             v
//            / \                 the first corner of a face, at the top:
//        b_p ─── a               3h, 3h + 2 and, to the right, 3h + 1
//          / \ / \               .
//         a_p ─ c ─ b            .
//
// Edge e becomes 3e at the origin of the half-edge that stands for it, 3e + 1 in the middle and
// 3e + 2 at the target; h adds the edges 3E + 3h (a–b_p), + 1 (a–c) and + 2 (b–c).

#include "limn/base/parallel.h"
#include "limn/mesh/split/split_list.h"

namespace limn::mesh::detail {
namespace {

void split_triangle_side(const Mesh& mesh, Index h, Mesh::Arrays& out) {
  const Index centre = mesh.vertex_count() + 2 * mesh.edge_count() + mesh.face(h);
  const Index inner = 3 * mesh.edge_count();
  const Index n = mesh.next(h), p = mesh.prev(h), t = mesh.twin(h), g = mesh.twin(p);
  const Index a = third_vertex_at_origin(mesh, h), b = third_vertex_at_target(mesh, h);
  const Index before = third_vertex_at_target(mesh, p);
  const auto put = [&, at = 9 * h](Index i, Index origin, Index twin, Index edge) {
    out.origin[at + i] = origin;
    out.twin[at + i] = twin;
    out.edge[at + i] = edge;
  };
  // what is on the other side of the third at v is the corner's triangle there
  put(0, mesh.origin(h), t == kNone ? kNone : 9 * mesh.next(t) + 2, third_at_origin(mesh, h));
  put(1, a, 9 * h + 8, inner + 3 * h);
  put(2, before, g == kNone ? kNone : 9 * g, third_at_target(mesh, p));
  put(3, a, t == kNone ? kNone : 9 * t + 3, 3 * mesh.edge(h) + 1);
  put(4, b, 9 * n + 7, inner + 3 * h + 2);
  put(5, centre, 9 * h + 6, inner + 3 * h + 1);
  put(6, a, 9 * h + 5, inner + 3 * h + 1);
  put(7, centre, 9 * p + 4, inner + 3 * p + 2);
  put(8, before, 9 * h + 1, inner + 3 * h);
}

}  // namespace

SplitResult split_triangle_ternary(const Mesh& mesh, int /*step*/) {
  assert(is_triangular(mesh));
  const Index sides = mesh.halfedge_count();
  Mesh::Arrays out = make_arrays(mesh.vertex_count() + 2 * mesh.edge_count() + mesh.face_count(),
                                 3 * (mesh.edge_count() + sides), 3, std::ptrdiff_t{9} * sides);
  base::parallel_for_each(sides, [&](Index h) { split_triangle_side(mesh, h, out); });
  SplitResult result{Mesh::from_arrays(std::move(out)), {}};
  result.births.from_vertices = mesh.vertex_count();
  result.births.thirds = true;
  result.births.from_edges = 2 * mesh.edge_count();
  result.births.from_faces = mesh.face_count();
  return result;
}

}  // namespace limn::mesh::detail
