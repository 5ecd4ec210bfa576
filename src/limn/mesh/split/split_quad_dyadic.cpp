// V' = V + E + F, E' = 2E + H, F' = H (H half-edges); any polygons.
//
// Half-edge h from v, in face f, gives the quad h = (v, m_h, c_f, m_prev(h)), with m the new
// vertex on an edge and c_f that in the face.

#include "limn/base/parallel.h"
#include "limn/mesh/split/split_list.h"

namespace limn::mesh::detail {
namespace {

void split_corner(const Mesh& mesh, Index h, Mesh::Arrays& out) {
  const Index vertices = mesh.vertex_count(), edges = mesh.edge_count();
  const Index p = mesh.prev(h), t = mesh.twin(h), g = mesh.twin(p), quad = 4 * h;
  out.origin[quad] = mesh.origin(h);
  out.origin[quad + 1] = vertices + mesh.edge(h);
  out.origin[quad + 2] = vertices + edges + mesh.face(h);
  out.origin[quad + 3] = vertices + mesh.edge(p);
  out.twin[quad] = t == kNone ? kNone : 4 * mesh.next(t) + 3;
  out.twin[quad + 1] = 4 * mesh.next(h) + 2;
  out.twin[quad + 2] = 4 * p + 1;
  out.twin[quad + 3] = g == kNone ? kNone : 4 * g;
  out.edge[quad] = edge_at_origin(mesh, h);
  out.edge[quad + 1] = 2 * edges + h;
  out.edge[quad + 2] = 2 * edges + p;
  out.edge[quad + 3] = edge_at_target(mesh, p);
}

}  // namespace

SplitResult split_quad_dyadic(const Mesh& mesh, int /*step*/) {
  const Index edges = mesh.edge_count(), corners = mesh.halfedge_count();
  Mesh::Arrays out = make_arrays(mesh.vertex_count() + edges + mesh.face_count(),
                                 2 * edges + corners, 4, std::ptrdiff_t{4} * corners);
  base::parallel_for_each(corners, [&](Index h) { split_corner(mesh, h, out); });
  SplitResult result{Mesh::from_arrays(std::move(out)), {}};
  result.births.from_vertices = mesh.vertex_count();
  result.births.from_edges = edges;
  result.births.from_faces = mesh.face_count();
  return result;
}

}  // namespace limn::mesh::detail
