// V' = V + E, E' = 2E + 3F, F' = 4F; all faces triangles.
//
// Face f has the half-edges 3f+i from vertex v_i, with the new vertex m_i on its edge. Its
// children are 4f+i = (v_i, m_i, m_{i-1}) for i = 0, 1, 2, and 4f+3 = (m_0, m_1, m_2).

#include "limn/base/parallel.h"
#include "limn/mesh/split/split_list.h"

namespace limn::mesh::detail {
namespace {

// first half-edge of the child at the origin of h
Index child_at(Index h) { return 3 * (h + h / 3); }

void split_face(const Mesh& mesh, Index f, Mesh::Arrays& out) {
  const Index vertices = mesh.vertex_count(), inner = 2 * mesh.edge_count() + 3 * f;
  const Index centre = child_at(3 * f) + 9;
  for (Index i = 0; i < 3; ++i) {
    const Index before = (i + 2) % 3;
    const Index h = 3 * f + i, p = 3 * f + before;
    const Index t = mesh.twin(h), g = mesh.twin(p);
    const Index a = child_at(h), b = a + 1, c = a + 2;
    out.origin[a] = mesh.origin(h);
    out.origin[b] = vertices + mesh.edge(h);
    out.origin[c] = vertices + mesh.edge(p);
    // the other side of the half edge at v_i is the child at v_i of the neighbour
    out.twin[a] = t == kNone ? kNone : child_at(mesh.next(t)) + 2;
    out.twin[b] = centre + before;
    out.twin[c] = g == kNone ? kNone : child_at(g);
    out.edge[a] = edge_at_origin(mesh, h);
    out.edge[b] = inner + before;
    out.edge[c] = edge_at_target(mesh, p);
    out.origin[centre + i] = vertices + mesh.edge(h);
    out.twin[centre + i] = child_at(3 * f + (i + 1) % 3) + 1;
    out.edge[centre + i] = inner + i;
  }
}

}  // namespace

SplitResult split_triangle_dyadic(const Mesh& mesh, int /*step*/) {
  assert(is_triangular(mesh));
  const Index faces = mesh.face_count(), edges = mesh.edge_count();
  Mesh::Arrays out = make_arrays(mesh.vertex_count() + edges, 2 * edges + 3 * faces, 3,
                                 std::ptrdiff_t{12} * faces);
  base::parallel_for_each(faces, [&](Index f) { split_face(mesh, f, out); });
  SplitResult result{Mesh::from_arrays(std::move(out)), {}};
  result.births.from_vertices = mesh.vertex_count();
  result.births.from_edges = edges;
  return result;
}

}  // namespace limn::mesh::detail
