#pragma once
/// Private to the splits: their functions, one per split_NAME.cpp, and what they share.

#include <cassert>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "limn/base/large_vector.h"
#include "limn/mesh/split/split.h"

namespace limn::mesh::detail {

SplitResult split_triangle_dyadic(const Mesh& mesh, int step);
SplitResult split_quad_dyadic(const Mesh& mesh, int step);
SplitResult split_quad_dual(const Mesh& mesh, int step);
SplitResult split_sqrt3(const Mesh& mesh, int step);
SplitResult split_quad_sqrt2(const Mesh& mesh, int step);
SplitResult split_midedge(const Mesh& mesh, int step);
SplitResult split_triangle_ternary(const Mesh& mesh, int step);
SplitResult split_quad_ternary(const Mesh& mesh, int step);
SplitResult split_quad_triangle(const Mesh& mesh, int step);

/// A dyadic split cuts edge e into edge 2e, at the origin of the half-edge that stands for e,
/// and edge 2e+1. These are the halves at the origin and at the target of h.
inline Index edge_at_origin(const Mesh& mesh, Index h) {
  const Index e = mesh.edge(h);
  return 2 * e + (mesh.halfedge_of_edge(e) == h ? 0 : 1);
}
inline Index edge_at_target(const Mesh& mesh, Index h) {
  const Index e = mesh.edge(h);
  return 2 * e + (mesh.halfedge_of_edge(e) == h ? 1 : 0);
}

/// A ternary split cuts edge e into the edges 3e, 3e+1, 3e+2 and gives it the new vertices V + 2e,
/// V + 2e + 1, in the order from the origin of the half-edge that stands for e. Those at the origin
/// and at the target of h:
inline Index third_at_origin(const Mesh& mesh, Index h) {
  const Index e = mesh.edge(h);
  return 3 * e + (mesh.halfedge_of_edge(e) == h ? 0 : 2);
}
inline Index third_at_target(const Mesh& mesh, Index h) {
  const Index e = mesh.edge(h);
  return 3 * e + (mesh.halfedge_of_edge(e) == h ? 2 : 0);
}
inline Index third_vertex_at_origin(const Mesh& mesh, Index h) {
  return mesh.vertex_count() + edge_at_origin(mesh, h);
}
inline Index third_vertex_at_target(const Mesh& mesh, Index h) {
  return mesh.vertex_count() + edge_at_target(mesh, h);
}

/// Arrays with room for `halfedges` half-edges, no twin set.
inline Mesh::Arrays make_arrays(Index vertices, Index edges, Index degree,
                                std::ptrdiff_t halfedges) {
  assert(halfedges <= std::numeric_limits<Index>::max());
  Mesh::Arrays arrays;
  arrays.vertex_count = vertices;
  arrays.edge_count = edges;
  arrays.degree = degree;
  const auto size = static_cast<std::size_t>(halfedges);
  arrays.origin = base::large_vector<Index>(size);
  arrays.twin = base::large_vector<Index>(size, kNone);
  arrays.edge = base::large_vector<Index>(size);
  return arrays;
}

/// Each of these pairs of half-edges, the two sides of a 2-gon, becomes one edge, the one with the
/// lower number; the numbers of edges close up over those that are gone. Cost O(half-edges) where
/// there is one.
void squeeze_two_gons(Mesh::Arrays& arrays, const std::vector<std::pair<Index, Index>>& sides);

/// True where the triangle splits may be applied: every face (if any) has three corners.
inline bool is_triangular(const Mesh& mesh) {
  return mesh.face_count() == 0 || mesh.uniform_degree() == 3;
}

}  // namespace limn::mesh::detail
