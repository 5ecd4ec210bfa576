#include "limn/mesh/lattice.h"

namespace limn::mesh {
namespace {

constexpr Index kTicks = 12;

Index centred(Index d, Index period) {
  return ((d + period / 2) % period + period) % period - period / 2;
}

Twelfths of_vertex(Index v, Index nx) { return {kTicks * (v % nx), kTicks * (v / nx)}; }

/// The vertex, moved by 1/parts of the sum of the ways to the other vertices of the face.
Twelfths towards(const Mesh& torus, Index nx, Index ny, Index h, Index count, Index parts) {
  const Twelfths v = of_vertex(torus.origin(h), nx);
  Twelfths way{0, 0};
  Index other = h;
  for (Index i = 0; i < count; ++i) {
    other = torus.next(other);
    const Twelfths d = torus_difference(v, of_vertex(torus.origin(other), nx), nx, ny);
    way = {way[0] + d[0], way[1] + d[1]};
  }
  return {v[0] + way[0] / parts, v[1] + way[1] / parts};
}

}  // namespace

Twelfths torus_difference(Twelfths from, Twelfths to, Index nx, Index ny) {
  return {centred(to[0] - from[0], kTicks * nx), centred(to[1] - from[1], kTicks * ny)};
}

Twelfths torus_birth_place(const Mesh& torus, Index nx, Index ny, const Births& births,
                           Index vertex) {
  if (vertex < births.from_vertices) return of_vertex(vertex, nx);
  vertex -= births.from_vertices;
  if (vertex < births.from_edges) {
    const EdgeChild child = edge_child(torus, births, vertex);
    if (!child.third) return towards(torus, nx, ny, child.halfedge, 1, 2);
    const Index h = child.at_target ? torus.twin(child.halfedge) : child.halfedge;
    return towards(torus, nx, ny, h, 1, 3);
  }
  vertex -= births.from_edges;
  const Index degree = torus.uniform_degree();
  if (vertex < births.from_faces)
    return towards(torus, nx, ny, torus.face_begin(vertex), degree - 1, degree);
  vertex -= births.from_faces;
  return towards(torus, nx, ny, vertex, degree - 1,
                 births.from_vertices > 0 ? 3 * degree / 2 : 2 * degree);
}

}  // namespace limn::mesh
