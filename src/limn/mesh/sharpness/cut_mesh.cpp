#include "limn/mesh/sharpness/cut_mesh.h"

#include <map>
#include <utility>

#include <fmt/core.h>

#include "limn/mesh/index.h"
#include "limn/mesh/sharpness/sharpness.h"

namespace limn::mesh {
namespace {

Mesh::Arrays arrays_of(const Mesh& mesh) {
  Mesh::Arrays arrays;
  arrays.vertex_count = mesh.vertex_count();
  arrays.edge_count = mesh.edge_count();
  arrays.degree = mesh.uniform_degree();
  if (arrays.degree == 0)
    for (Index f = 0; f <= mesh.face_count(); ++f) arrays.face_begin.push_back(mesh.face_begin(f));
  for (Index h = 0; h < mesh.halfedge_count(); ++h) {
    arrays.origin.push_back(mesh.origin(h));
    arrays.twin.push_back(mesh.twin(h));
    arrays.edge.push_back(mesh.edge(h));
  }
  return arrays;
}

}  // namespace

CutMesh cut_along(const Mesh& mesh, const std::vector<bool>& along) {
  Mesh::Arrays arrays = arrays_of(mesh);
  CutMesh cut;
  for (Index v = 0; v < mesh.vertex_count(); ++v) cut.originals.push_back(v);
  std::vector<bool> at_cut(cut.originals.size(), false);
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e), twin = mesh.twin(h);
    if (!along[at(e)] || twin == kNone) continue;
    arrays.twin[at(h)] = arrays.twin[at(twin)] = kNone;
    arrays.edge[at(twin)] = arrays.edge_count++;
    at_cut[at(mesh.origin(h))] = at_cut[at(mesh.target(h))] = true;
  }
  // each fan of a vertex begins at one half-edge that has no other side
  std::vector<bool> taken(cut.originals.size(), false);
  for (Index h = 0; h < mesh.halfedge_count(); ++h) {
    const Index v = mesh.origin(h);
    if (!at_cut[at(v)] || arrays.twin[at(h)] != kNone) continue;
    Index copy = v;
    if (taken[at(v)]) {
      copy = arrays.vertex_count++;
      cut.originals.push_back(v);
    }
    taken[at(v)] = true;
    for (Index out = h; out != kNone; out = arrays.twin[at(mesh.prev(out))])
      arrays.origin[at(out)] = copy;
  }
  cut.mesh = Mesh::from_arrays(std::move(arrays));
  return cut;
}

namespace {

class Joining {
 public:
  Joining(const Mesh& mesh, const CutMesh& cut, const SplitResult& fine)
      : mesh_(mesh), cut_(cut), fine_(fine), arrays_(arrays_of(fine.mesh)) {}

  Result<JoinedMesh> run() {
    number_vertices();
    for (Index& v : arrays_.origin) v = number_[at(v)];
    arrays_.vertex_count = births_.from_vertices + births_.from_edges + births_.from_faces;
    if (Status status = join_edges(); !status) return status.error();
    JoinedMesh joined{{Mesh::from_arrays(std::move(arrays_)), std::move(births_)}, {}};
    joined.seams.resize(at(joined.fine.mesh.edge_count()));
    for (const Index h : joined_) joined.seams[at(joined.fine.mesh.edge(h))] = true;
    return joined;
  }

 private:
  /// New vertices of both sides of a crease become one.
  void number_vertices() {
    const Births& old = fine_.births;
    births_.from_vertices = mesh_.vertex_count();
    number_.assign(cut_.originals.begin(), cut_.originals.end());
    std::map<Index, Index> of_place;  // twice the half-edge that stands for the edge, + the end
    for (Index i = 0; i < old.from_edges; ++i) {
      const EdgeChild child = edge_child(cut_.mesh, old, i);
      const Index stands = mesh_.halfedge_of_edge(mesh_.edge(child.halfedge));
      const bool turned = child.third && stands != child.halfedge;
      const Index place = 2 * stands + (child.at_target != turned ? 1 : 0);
      const auto [found, fresh] = of_place.try_emplace(place, births_.from_edges);
      number_.push_back(births_.from_vertices + found->second);
      if (!fresh) continue;
      ++births_.from_edges;
      if (child.third)
        births_.edge_ends.push_back(place);
      else
        births_.edges.push_back(mesh_.edge(child.halfedge));
    }
    births_.from_faces = old.from_faces;
    births_.faces = old.faces;
    for (Index i = 0; i < old.from_faces; ++i)
      number_.push_back(births_.from_vertices + births_.from_edges + i);
  }

  /// Finds the other sides of half-edges that have none for the cut, and numbers edges anew.
  Status join_edges() {
    std::map<std::pair<Index, Index>, Index> open;
    for (Index h = 0; h < fine_.mesh.halfedge_count(); ++h) {
      if (arrays_.twin[at(h)] != kNone) continue;
      const Index a = arrays_.origin[at(h)], b = arrays_.origin[at(fine_.mesh.next(h))];
      if (!open.try_emplace({a, b}, h).second)
        return Error{fmt::format("two creases join the same two vertices, {} and {}", a, b),
                     "this split needs a mesh with one edge between two vertices"};
    }
    for (const auto& [ends, h] : open) {
      const auto other = open.find({ends.second, ends.first});
      if (other == open.end()) continue;
      arrays_.twin[at(h)] = other->second;
      if (h < other->second) joined_.push_back(h);
    }
    number_edges();
    return Done{};
  }

  void number_edges() {
    std::vector<Index> number(at(arrays_.edge_count), kNone);
    Index count = 0;
    for (std::size_t h = 0; h < arrays_.edge.size(); ++h) {
      const Index twin = arrays_.twin[h];
      const bool first = twin == kNone || static_cast<Index>(h) < twin;
      if (first) number[at(arrays_.edge[h])] = count++;
      arrays_.edge[h] = first ? number[at(arrays_.edge[h])] : arrays_.edge[at(twin)];
    }
    arrays_.edge_count = count;
  }

  const Mesh& mesh_;
  const CutMesh& cut_;
  const SplitResult& fine_;
  Mesh::Arrays arrays_;
  Births births_;
  std::vector<Index> number_;  // of each refined vertex before joining
  std::vector<Index> joined_;  // half-edges that stand for joined edges
};

}  // namespace

Result<JoinedMesh> join_again(const Mesh& mesh, const CutMesh& cut, const SplitResult& fine) {
  return Joining(mesh, cut, fine).run();
}

}  // namespace limn::mesh
