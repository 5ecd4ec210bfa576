// What a boundary mode makes sharp, and which faces holes.

#include <algorithm>
#include <tuple>

#include "limn/mesh/sharpness/cuts.h"

namespace limn {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// Of each edge, whether others lay in its place before the mesh was cut.
std::vector<bool> edges_that_were_cut(const Mesh& mesh, const std::vector<Index>& vertex_of) {
  std::vector<bool> cut(at(mesh.edge_count()), false);
  struct Stated {
    Index a, b, edge;
  };
  std::vector<Stated> edges;
  for (Index e = 0; !vertex_of.empty() && e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e), v = mesh.origin(h), w = mesh.target(h);
    if (at(std::max(v, w)) >= vertex_of.size()) continue;  // inside a face
    const auto [a, b] = std::minmax(vertex_of[at(v)], vertex_of[at(w)]);
    edges.push_back({a, b, e});
  }
  std::sort(edges.begin(), edges.end(), [](const Stated& x, const Stated& y) {
    return std::tie(x.a, x.b) < std::tie(y.a, y.b);
  });
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i].a == edges[i - 1].a && edges[i].b == edges[i - 1].b)
      cut[at(edges[i].edge)] = cut[at(edges[i - 1].edge)] = true;
  return cut;
}

/// What holds of a copy of a vertex then holds of all.
void spread_to_copies(const std::vector<Index>& vertex_of, std::vector<bool>& of_vertices) {
  std::vector<bool> of_cut;
  for (std::size_t v = 0; v < vertex_of.size(); ++v) {
    of_cut.resize(std::max(of_cut.size(), at(vertex_of[v]) + 1), false);
    if (of_vertices[v]) of_cut[at(vertex_of[v])] = true;
  }
  for (std::size_t v = 0; v < vertex_of.size(); ++v) of_vertices[v] = of_cut[at(vertex_of[v])];
}

void make_boundary_holes(const Mesh& mesh, const std::vector<Index>& vertex_of,
                         Sharpness& sharpness) {
  const std::vector<bool> cut = edges_that_were_cut(mesh, vertex_of);
  std::vector<bool> open(at(mesh.vertex_count()), false);  // has a boundary edge that is not stated
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (!mesh.is_boundary_edge(e) || cut[at(e)]) continue;
    if (!sharpness.edges.empty() && sharpness.edges[at(e)] >= kInfinitelySharp) continue;
    const Index h = mesh.halfedge_of_edge(e);
    open[at(mesh.origin(h))] = open[at(mesh.target(h))] = true;
  }
  spread_to_copies(vertex_of, open);
  for (Index h = 0; h < mesh.halfedge_count(); ++h) {
    if (!open[at(mesh.origin(h))]) continue;
    sharpness.holes.resize(at(mesh.face_count()));
    sharpness.holes[at(mesh.face(h))] = true;
  }
}

void sharpen_corners(const Mesh& mesh, const std::vector<Index>& vertex_of, Sharpness& sharpness) {
  std::vector<Index> fans;  // copies that have faces, of each vertex that was cut or not
  for (const Index v : vertex_of) fans.resize(std::max(fans.size(), at(v) + 1), 0);
  for (std::size_t v = 0; v < vertex_of.size(); ++v)
    if (!mesh.is_isolated(static_cast<Index>(v))) ++fans[at(vertex_of[v])];
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Index h = mesh.halfedge_of_vertex(v);
    if (h == kNone || mesh.twin(h) != kNone || mesh.twin(mesh.prev(h)) != kNone) continue;
    if (at(v) < vertex_of.size() && fans[at(vertex_of[at(v)])] > 1) continue;
    sharpness.vertices.resize(at(mesh.vertex_count()));
    sharpness.vertices[at(v)] = kInfinitelySharp;
  }
}

}  // namespace

void apply_boundary_mode(const Mesh& mesh, BoundaryMode mode, const Cuts& cuts,
                         Sharpness& sharpness) {
  const std::vector<Index>& vertex_of = cuts.vertex_of;
  switch (mode) {
    case BoundaryMode::none: return make_boundary_holes(mesh, vertex_of, sharpness);
    case BoundaryMode::edge_only: return;
    case BoundaryMode::edge_and_corner: return sharpen_corners(mesh, vertex_of, sharpness);
  }
}

void apply_boundary_mode(const Mesh& mesh, BoundaryMode mode, Sharpness& sharpness) {
  apply_boundary_mode(mesh, mode, {}, sharpness);
}

}  // namespace limn
