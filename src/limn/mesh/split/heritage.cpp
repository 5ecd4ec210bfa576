#include "limn/mesh/split/heritage.h"

#include <array>

#include "limn/mesh/index.h"

namespace limn::mesh {
namespace {

/// Of splits that keep old edges.
class OldEdges {
 public:
  OldEdges(const Mesh& mesh, const SplitResult& fine) : mesh_(mesh), fine_(fine) {}

  /// The old half-edge that the refined half-edge g lies on.
  [[nodiscard]] Index halfedge(Index g) const {
    const Index a = fine_.mesh.origin(g), b = fine_.mesh.target(g);
    const Index of_a = halfedge_of(a), of_b = halfedge_of(b);
    Index h = of_a != kNone ? of_a : of_b;
    if (h == kNone || (of_a != kNone && of_b != kNone && mesh_.edge(of_a) != mesh_.edge(of_b)))
      return kNone;
    if (of_a != kNone && of_b != kNone) return oriented_like_children(h, a, b);
    const bool out = of_a == kNone;  // from an old vertex
    const Index v = out ? a : b;
    if (v >= fine_.births.from_vertices) return kNone;
    if ((out ? mesh_.origin(h) : mesh_.target(h)) == v) return h;
    if ((out ? mesh_.target(h) : mesh_.origin(h)) != v) return kNone;
    return mesh_.twin(h) != kNone ? mesh_.twin(h) : h;
  }

 private:
  /// Of the old edge that the refined vertex is born from; kNone: from none.
  [[nodiscard]] Index halfedge_of(Index vertex) const {
    const Index i = vertex - fine_.births.from_vertices;
    if (i < 0 || i >= fine_.births.from_edges) return kNone;
    return edge_child(mesh_, fine_.births, i).halfedge;
  }
  /// Between two children of one edge: they are numbered along halfedge_of_edge.
  [[nodiscard]] Index oriented_like_children(Index h, Index a, Index b) const {
    const Index along = mesh_.halfedge_of_edge(mesh_.edge(h));
    if (a < b) return along;
    return mesh_.twin(along) != kNone ? mesh_.twin(along) : along;
  }

  const Mesh& mesh_;
  const SplitResult& fine_;
};

/// Of splits that lay faces across old edges.
class FacesAcross {
 public:
  FacesAcross(const Mesh& mesh, const SplitResult& fine) : mesh_(mesh), fine_(fine) {}

  /// The lowest of the old faces that the births of a refined face name.
  [[nodiscard]] Index lowest(Index face) const {
    Index found = kNone;
    const auto take = [&](Index f) {
      if (f != kNone && (found == kNone || f < found)) found = f;
    };
    const Mesh& fine = fine_.mesh;
    for (Index g = fine.face_begin(face); g < fine.face_begin(face + 1); ++g)
      take(face_of(fine.origin(g)));
    if (found != kNone) return found;
    // two edges that follow each other round a face, or round a vertex, have a face in common
    for (Index g = fine.face_begin(face); g < fine.face_begin(face + 1); ++g)
      take(common(fine.origin(g), fine.target(g)));
    return found;
  }

 private:
  /// The only old face that a refined vertex can lie in; kNone: there are more.
  [[nodiscard]] Index face_of(Index vertex) const {
    const Births& births = fine_.births;
    Index i = vertex - births.from_vertices;
    if (i < 0) return kNone;
    if (i < births.from_edges) {
      const Index h = edge_child(mesh_, births, i).halfedge;
      return mesh_.twin(h) == kNone ? mesh_.face(h) : kNone;
    }
    i -= births.from_edges;
    if (i < births.from_faces) return births.faces.empty() ? i : births.faces[at(i)];
    i -= births.from_faces;
    return i < births.from_corners ? mesh_.face(i) : kNone;
  }
  [[nodiscard]] Index common(Index a, Index b) const {
    const Births& births = fine_.births;
    a -= births.from_vertices;
    b -= births.from_vertices;
    if (a < 0 || b < 0 || a >= births.from_edges || b >= births.from_edges) return kNone;
    Index found = kNone;
    for (const Index h : sides(a))
      for (const Index g : sides(b))
        if (h != kNone && g != kNone && mesh_.face(h) == mesh_.face(g) &&
            (found == kNone || mesh_.face(h) < found))
          found = mesh_.face(h);
    return found;
  }
  [[nodiscard]] std::array<Index, 2> sides(Index i) const {
    const Index h = edge_child(mesh_, fine_.births, i).halfedge;
    return {h, mesh_.twin(h)};
  }

  const Mesh& mesh_;
  const SplitResult& fine_;
};

/// Gives faces that have none the parents of their neighbours.
void spread(const Mesh& fine, const std::vector<Index>& barriers, std::vector<Index>& parents) {
  std::vector<Index> reached;
  for (Index f = 0; f < fine.face_count(); ++f)
    if (parents[at(f)] != kNone) reached.push_back(f);
  while (!reached.empty()) {
    const Index f = reached.back();
    reached.pop_back();
    for (Index g = fine.face_begin(f); g < fine.face_begin(f + 1); ++g) {
      const Index twin = fine.twin(g);
      const bool open = barriers.empty() || barriers[at(g)] == kNone;
      if (!open || twin == kNone || parents[at(fine.face(twin))] != kNone) continue;
      parents[at(fine.face(twin))] = parents[at(f)];
      reached.push_back(fine.face(twin));
    }
  }
}

}  // namespace

std::vector<Index> old_halfedges(const Mesh& mesh, const SplitResult& fine) {
  const OldEdges edges(mesh, fine);
  std::vector<Index> on(at(fine.mesh.halfedge_count()));
  for (Index g = 0; g < fine.mesh.halfedge_count(); ++g) on[at(g)] = edges.halfedge(g);
  return on;
}

std::vector<Index> faces_between(const Mesh& mesh, const Mesh& fine,
                                 const std::vector<Index>& old_halfedges) {
  std::vector<Index> parents(at(fine.face_count()), kNone);
  for (Index g = 0; g < fine.halfedge_count(); ++g)
    if (old_halfedges[at(g)] != kNone && parents[at(fine.face(g))] == kNone)
      parents[at(fine.face(g))] = mesh.face(old_halfedges[at(g)]);
  spread(fine, old_halfedges, parents);
  return parents;
}

std::vector<Index> parent_faces(const Split& split, const Mesh& mesh, const SplitResult& fine) {
  if (keeps_old_edges(split)) return faces_between(mesh, fine.mesh, old_halfedges(mesh, fine));
  const FacesAcross across(mesh, fine);
  std::vector<Index> parents(at(fine.mesh.face_count()));
  for (Index f = 0; f < fine.mesh.face_count(); ++f) parents[at(f)] = across.lowest(f);
  spread(fine.mesh, {}, parents);
  return parents;
}

}  // namespace limn::mesh
