// V' = V + 2E + H (H half-edges), E' = 3E + 3H, F' = 9F; all faces quads. [NiNasriPeters2007]
//
// Every edge is cut in three. Half-edge h from v has the new vertices a, near v, and b, near its
// target; its corner of the face has one, c, at a third of the way along either side. With p the
// half-edge before h in the face, and n the one after it, h gives two quads:
//
//     2h      (v, a, c, b_p)      at the corner
//     2h + 1  (a, b, c_n, c)      on the middle third of the edge
//
// and face f one in the middle, 2H + f: (c, c_n, …). Other polygons would keep a face of as many
// corners in the middle at every step, an extraordinary face that never becomes a vertex: they are
// refused.
//
// Edge e becomes 3e at the origin of the half-edge that stands for it, 3e + 1 in the middle and
// 3e + 2 at the target; h adds the edges 3E + 3h (a–c), + 1 (b–c_n) and + 2 (c–c_n).

#include "limn/base/parallel.h"
#include "limn/mesh/split/split_list.h"

namespace limn::mesh::detail {
namespace {

void split_quad_side(const Mesh& mesh, Index h, Mesh::Arrays& out) {
  const Index corners = mesh.vertex_count() + 2 * mesh.edge_count();
  const Index inner = 3 * mesh.edge_count(), middle = 8 * mesh.halfedge_count();
  const Index n = mesh.next(h), p = mesh.prev(h), t = mesh.twin(h), g = mesh.twin(p);
  const Index a = third_vertex_at_origin(mesh, h), b = third_vertex_at_target(mesh, h);
  const auto put = [&](Index at, Index origin, Index twin, Index edge) {
    out.origin[at] = origin;
    out.twin[at] = twin;
    out.edge[at] = edge;
  };
  const Index first = 8 * h;
  put(first, mesh.origin(h), t == kNone ? kNone : 8 * mesh.next(t) + 3, third_at_origin(mesh, h));
  put(first + 1, a, first + 7, inner + 3 * h);
  put(first + 2, corners + h, 8 * p + 5, inner + 3 * p + 1);
  put(first + 3, third_vertex_at_target(mesh, p), g == kNone ? kNone : 8 * g,
      third_at_target(mesh, p));
  put(first + 4, a, t == kNone ? kNone : 8 * t + 4, 3 * mesh.edge(h) + 1);
  put(first + 5, b, 8 * n + 2, inner + 3 * h + 1);
  put(first + 6, corners + n, middle + h, inner + 3 * h + 2);
  put(first + 7, corners + h, first + 1, inner + 3 * h);
  put(middle + h, corners + h, first + 6, inner + 3 * h + 2);
}

}  // namespace

SplitResult split_quad_ternary(const Mesh& mesh, int /*step*/) {
  assert(mesh.face_count() == 0 || mesh.uniform_degree() == 4);
  const Index sides = mesh.halfedge_count();
  Mesh::Arrays out = make_arrays(mesh.vertex_count() + 2 * mesh.edge_count() + sides,
                                 3 * (mesh.edge_count() + sides), 4, std::ptrdiff_t{9} * sides);
  base::parallel_for_each(sides, [&](Index h) { split_quad_side(mesh, h, out); });
  SplitResult result{Mesh::from_arrays(std::move(out)), {}};
  result.births.from_vertices = mesh.vertex_count();
  result.births.thirds = true;
  result.births.from_edges = 2 * mesh.edge_count();
  result.births.from_corners = sides;
  return result;
}

}  // namespace limn::mesh::detail
