// What a boundary mode makes sharp, and which faces holes.

#include <algorithm>
#include <cstdint>
#include <utility>

#include "limn/mesh/edge_sides.h"
#include "limn/mesh/index.h"
#include "limn/mesh/sharpness/cuts.h"

namespace limn {
namespace {

using mesh::at;

/// Of each edge, whether others lay in its place before the mesh was cut.
std::vector<bool> edges_that_were_cut(const Mesh& mesh, const std::vector<Index>& vertex_of) {
  std::vector<bool> cut(at(mesh.edge_count()), false);
  std::vector<std::pair<std::uint64_t, Index>> edges;  // as it was then, and now
  for (Index e = 0; !vertex_of.empty() && e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e), v = mesh.origin(h), w = mesh.target(h);
    if (at(std::max(v, w)) >= vertex_of.size()) continue;  // inside a face
    edges.emplace_back(mesh::detail::edge_between(vertex_of[at(v)], vertex_of[at(w)]), e);
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i].first == edges[i - 1].first)
      cut[at(edges[i].second)] = cut[at(edges[i - 1].second)] = true;
  return cut;
}

/// What holds of a copy of a vertex then holds of all.
void spread_to_copies(const mesh::Cuts& cuts, std::vector<bool>& of_vertices) {
  std::vector<bool> of_cut(at(cuts.vertices), false);
  for (std::size_t v = 0; v < cuts.vertex_of.size(); ++v)
    if (of_vertices[v]) of_cut[at(cuts.vertex_of[v])] = true;
  for (std::size_t v = 0; v < cuts.vertex_of.size(); ++v)
    of_vertices[v] = of_cut[at(cuts.vertex_of[v])];
}

void make_boundary_holes(const Mesh& mesh, const mesh::Cuts& cuts, Sharpness& sharpness) {
  const std::vector<bool> cut = edges_that_were_cut(mesh, cuts.vertex_of);
  std::vector<bool> open(at(mesh.vertex_count()), false);  // has a boundary edge that is not stated
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (!mesh.is_boundary_edge(e) || cut[at(e)]) continue;
    if (!sharpness.edges.empty() && sharpness.edges[at(e)] >= kInfinitelySharp) continue;
    const Index h = mesh.halfedge_of_edge(e);
    open[at(mesh.origin(h))] = open[at(mesh.target(h))] = true;
  }
  spread_to_copies(cuts, open);
  for (Index h = 0; h < mesh.halfedge_count(); ++h) {
    if (!open[at(mesh.origin(h))]) continue;
    sharpness.holes.resize(at(mesh.face_count()));
    sharpness.holes[at(mesh.face(h))] = true;
  }
}

void sharpen_corners(const Mesh& mesh, const mesh::Cuts& cuts, Sharpness& sharpness) {
  const std::vector<Index>& vertex_of = cuts.vertex_of;
  std::vector<Index> fans(at(cuts.vertices), 0);  // copies that have faces
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

void mesh::apply_boundary_mode(const Mesh& mesh, BoundaryMode mode, const mesh::Cuts& cuts,
                               Sharpness& sharpness) {
  switch (mode) {
    case BoundaryMode::none: return make_boundary_holes(mesh, cuts, sharpness);
    case BoundaryMode::edge_only: return;
    case BoundaryMode::edge_and_corner: return sharpen_corners(mesh, cuts, sharpness);
  }
}

void apply_boundary_mode(const Mesh& mesh, BoundaryMode mode, Sharpness& sharpness) {
  mesh::apply_boundary_mode(mesh, mode, {}, sharpness);
}

}  // namespace limn
