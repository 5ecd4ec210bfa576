// Mesh::check: the laws of mesh.h, each tested only once those that it leans on hold.

#include "limn/mesh/mesh.h"

namespace limn {
namespace {

std::string at(const char* what, Index i) { return std::string(what) + " " + std::to_string(i); }

bool below(Index i, Index count) { return i >= 0 && i < count; }

std::string check_faces(const Mesh& mesh) {
  if (mesh.face_begin(0) != 0 || mesh.face_begin(mesh.face_count()) != mesh.halfedge_count())
    return "the faces do not cover the half-edges";
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (mesh.degree(f) < 3) return at("face", f) + " has fewer than three corners";
    for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h) {
      if (mesh.face(h) != f) return at("half-edge", h) + " does not name its face";
      if (mesh.prev(mesh.next(h)) != h) return at("half-edge", h) + ": prev does not undo next";
      if (!below(mesh.origin(h), mesh.vertex_count())) return at("half-edge", h) + " has no vertex";
    }
  }
  return {};
}

std::string check_twins(const Mesh& mesh) {
  for (Index h = 0; h < mesh.halfedge_count(); ++h) {
    const Index t = mesh.twin(h);
    if (t == kNone) continue;
    if (!below(t, mesh.halfedge_count())) return at("half-edge", h) + ": twin out of range";
    if (t == h || mesh.twin(t) != h) return at("half-edge", h) + ": twin is no involution";
    if (mesh.origin(h) != mesh.target(t) || mesh.target(h) != mesh.origin(t))
      return at("half-edge", h) + ": twin does not run the other way";
  }
  return {};
}

std::string check_edges(const Mesh& mesh) {
  std::vector<Index> uses(static_cast<std::size_t>(mesh.edge_count()), 0);
  for (Index h = 0; h < mesh.halfedge_count(); ++h) {
    if (!below(mesh.edge(h), mesh.edge_count())) return at("half-edge", h) + " has no edge";
    if (mesh.twin(h) != kNone && mesh.edge(h) != mesh.edge(mesh.twin(h)))
      return at("half-edge", h) + ": twin has another edge";
    ++uses[mesh.edge(h)];
  }
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e);
    if (!below(h, mesh.halfedge_count())) return at("edge", e) + " has no half-edge";
    if (mesh.edge(h) != e) return at("edge", e) + ": its half-edge has another edge";
    if (uses[e] != (mesh.is_boundary_edge(e) ? 1 : 2))
      return at("edge", e) + " has a wrong number of half-edges";
  }
  return {};
}

std::string check_vertices(const Mesh& mesh) {
  std::vector<Index> corners(static_cast<std::size_t>(mesh.vertex_count()), 0);
  for (Index h = 0; h < mesh.halfedge_count(); ++h) ++corners[mesh.origin(h)];
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Index first = mesh.halfedge_of_vertex(v);
    if (mesh.is_isolated(v)) {
      if (corners[v] != 0) return at("vertex", v) + " counts as isolated but has faces";
      continue;
    }
    if (!below(first, mesh.halfedge_count()) || mesh.origin(first) != v)
      return at("vertex", v) + ": its half-edge starts elsewhere";
    Index h = first, met = 0;
    do {
      ++met;
      h = mesh.rotate(h);
    } while (h != kNone && h != first && met <= corners[v]);
    if (met != corners[v] || (h == kNone) != mesh.is_boundary_vertex(v))
      return at("vertex", v) + ": its faces are not one fan from its half-edge";
  }
  return {};
}

}  // namespace

std::string Mesh::check() const {
  if (twin_.size() != origin_.size() || edge_.size() != origin_.size())
    return "the arrays differ in length";
  for (const auto law : {check_faces, check_twins, check_edges, check_vertices})
    if (std::string broken = law(*this); !broken.empty()) return broken;
  return {};
}

}  // namespace limn
