#include "limn/mesh/split/edge_paths.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

#include "limn/mesh/index.h"
#include "limn/mesh/split/heritage.h"

namespace limn::mesh {
namespace {

/// Gathers points, each refined vertex once.
class Paths {
 public:
  /// The point that is this vertex alone.
  Index vertex(Index v) {
    if (single_.size() <= at(v)) single_.resize(at(v) + 1, kNone);
    if (single_[at(v)] == kNone) single_[at(v)] = mean({v});
    return single_[at(v)];
  }
  Index mean(const std::vector<Index>& vertices) {
    paths_.vertices.insert(paths_.vertices.end(), vertices.begin(), vertices.end());
    paths_.begin.push_back(paths_.vertices.size());
    return paths_.point_count() - 1;
  }
  void join(Index from, Index to, Index edge) { paths_.segments.push_back({from, to, edge}); }
  EdgePaths take() { return std::move(paths_); }

 private:
  EdgePaths paths_;
  std::vector<Index> single_;
};

/// Of each edge of a refined mesh the control edge that it is a part of, or kNone.
using Parts = std::vector<Index>;

Parts all_edges(const Mesh& control) {
  Parts parts(at(control.edge_count()));
  std::iota(parts.begin(), parts.end(), Index{0});
  return parts;
}

void add_parts(const Mesh& mesh, const Parts& parts, Paths& paths) {
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e);
    if (parts[at(e)] != kNone)
      paths.join(paths.vertex(mesh.origin(h)), paths.vertex(mesh.target(h)), parts[at(e)]);
  }
}

EdgePaths kept_edges(const Split& split, Mesh mesh, int levels) {
  Parts parts = all_edges(mesh);
  for (int step = 0; step < levels; ++step) {
    SplitResult fine = split.apply(mesh, step);
    const std::vector<Index> old = old_halfedges(mesh, fine);
    Parts finer(at(fine.mesh.edge_count()));
    for (Index e = 0; e < fine.mesh.edge_count(); ++e) {
      const Index h = old[at(fine.mesh.halfedge_of_edge(e))];
      finer[at(e)] = h == kNone ? kNone : parts[at(mesh.edge(h))];
    }
    parts = std::move(finer);
    mesh = std::move(fine.mesh);
  }
  Paths paths;
  add_parts(mesh, parts, paths);
  return paths.take();
}

/// Of splits that refine the boundary in every second step: two steps as one, an even one first.
/// That turns inner edges, and the next one lays new edges along the old ones again.
class TwoSteps {
 public:
  TwoSteps(const Split& split, const Mesh& old, int step)
      : old_(old), first_(split.apply(old, step)), second_(split.apply(first_.mesh, step + 1)) {
    for (Index e = 0; e < old.edge_count(); ++e)
      if (old.is_boundary_edge(e)) boundary_.emplace(ends(old.halfedge_of_edge(e)), e);
    on_.assign(at(second_.mesh.vertex_count()), kNone);
    for (Index v = second_.births.from_vertices; v < second_.mesh.vertex_count(); ++v)
      on_[at(v)] = old_edge_of(v - second_.births.from_vertices);
  }

  [[nodiscard]] Parts parts(const Parts& before) const {
    const Mesh& fine = second_.mesh;
    Parts parts(at(fine.edge_count()), kNone);
    for (Index e = 0; e < fine.edge_count(); ++e) {
      const Index h = fine.halfedge_of_edge(e), a = fine.origin(h), b = fine.target(h);
      const Index of_a = on_[at(a)], of_b = on_[at(b)];
      const Index edge = of_a != kNone ? of_a : of_b;
      const bool whole = of_a != kNone && of_b != kNone
                             ? of_a == of_b
                             : edge != kNone && is_end(edge, of_a == kNone ? a : b);
      if (whole) parts[at(e)] = before[at(edge)];
    }
    return parts;
  }
  [[nodiscard]] Mesh take() { return std::move(second_.mesh); }

 private:
  using Ends = std::pair<Index, Index>;
  [[nodiscard]] static Ends sorted(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }
  [[nodiscard]] Ends ends(Index h) const { return sorted(old_.origin(h), old_.target(h)); }
  [[nodiscard]] bool is_end(Index edge, Index vertex) const {
    const Ends two = ends(old_.halfedge_of_edge(edge));
    return two.first == vertex || two.second == vertex;
  }

  /// Of the i-th vertex born in the second step.
  [[nodiscard]] Index old_edge_of(Index i) const {
    const Births& births = second_.births;
    const Mesh& mesh = first_.mesh;
    if (i < births.from_edges) {
      const Index h = edge_child(mesh, births, i).halfedge;
      const auto found = boundary_.find(sorted(mesh.origin(h), mesh.target(h)));
      return found == boundary_.end() ? kNone : found->second;
    }
    i -= births.from_edges;
    return old_edge_under(births.faces.empty() ? i : births.faces[at(i)]);
  }

  /// The old edge that a face of the first step lies across, if its corners are the points of two
  /// old faces and one end or both of the edge between them.
  [[nodiscard]] Index old_edge_under(Index face) const {
    std::vector<Index> faces, vertices;
    const Mesh& mesh = first_.mesh;
    for (Index h = mesh.face_begin(face); h < mesh.face_begin(face + 1); ++h) {
      const Index v = mesh.origin(h);
      if (v < first_.births.from_vertices)
        vertices.push_back(v);
      else
        faces.push_back(v - first_.births.from_vertices);
    }
    if (faces.size() != 2 || vertices.empty()) return kNone;
    for (Index h = old_.face_begin(faces[0]); h < old_.face_begin(faces[0] + 1); ++h) {
      const Index twin = old_.twin(h);
      if (twin == kNone || old_.face(twin) != faces[1]) continue;
      const Index edge = old_.edge(h);
      if (std::all_of(vertices.begin(), vertices.end(), [&](Index v) { return is_end(edge, v); }))
        return edge;
    }
    return kNone;
  }

  const Mesh& old_;
  SplitResult first_, second_;
  std::map<Ends, Index> boundary_;
  std::vector<Index> on_;  // of each vertex after both steps the old edge that it lies on
};

EdgePaths turned_edges(const Split& split, Mesh mesh, int levels) {
  Parts parts = all_edges(mesh);
  int step = 0;
  for (; step + 1 < levels; step += 2) {
    TwoSteps two(split, mesh, step);
    parts = two.parts(parts);
    mesh = two.take();
  }
  Paths paths;
  if (step == levels) {
    add_parts(mesh, parts, paths);
    return paths.take();
  }
  // the last step has turned inner edges: its points of faces are numbered like the faces
  const auto point_of = [&](Index h) { return mesh.vertex_count() + mesh.face(h); };
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (parts[at(e)] == kNone) continue;
    const Index h = mesh.halfedge_of_edge(e), twin = mesh.twin(h);
    const Index a = paths.vertex(mesh.origin(h)), b = paths.vertex(mesh.target(h));
    if (twin == kNone) {
      paths.join(a, b, parts[at(e)]);
      continue;
    }
    std::vector<Index> middle{point_of(h), point_of(twin)};
    if (split.lattice == Lattice::quad)  // a face lies across it, under √3 an edge
      middle.insert(middle.end(), {mesh.origin(h), mesh.target(h)});
    const Index between = paths.mean(middle);
    paths.join(a, between, parts[at(e)]);
    paths.join(between, b, parts[at(e)]);
  }
  return paths.take();
}

/// Of dual splits: faces and vertices of a refined mesh that one passes along a control edge.
class DualPaths {
 public:
  DualPaths(const Split& split, const Mesh& control) : split_(split), mesh_(control) {
    for (Index e = 0; e < mesh_.edge_count(); ++e) {
      const Index h = mesh_.halfedge_of_edge(e);
      if (mesh_.twin(h) == kNone) continue;
      paths_.push_back({{false, mesh_.origin(h)}, {false, mesh_.target(h)}});
      edges_.push_back(e);
    }
  }

  void refine(int step) {
    SplitResult fine = split_.apply(mesh_, step);
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      std::vector<Place> path;
      for (std::size_t k = 0; k < paths_[i].size(); ++k) {
        if (k > 0) path.push_back(between(paths_[i][k - 1], paths_[i][k], edges_[i], step, fine));
        path.push_back(child(paths_[i][k], fine));
      }
      std::erase_if(path, [](const Place& place) { return place.index == kNone; });
      paths_[i] = std::move(path);
    }
    mesh_ = std::move(fine.mesh);
  }

  [[nodiscard]] EdgePaths take() const {
    Paths paths;
    std::vector<Index> middles(at(mesh_.face_count()), kNone);
    const auto point = [&](const Place& place) {
      if (!place.is_face) return paths.vertex(place.index);
      Index& middle = middles[at(place.index)];
      if (middle == kNone) middle = paths.mean(corners(place.index));
      return middle;
    };
    for (std::size_t i = 0; i < paths_.size(); ++i)
      for (std::size_t k = 1; k < paths_[i].size(); ++k)
        paths.join(point(paths_[i][k - 1]), point(paths_[i][k]), edges_[i]);
    return paths.take();
  }

 private:
  struct Place {
    bool is_face = false;
    Index index = kNone;
  };

  [[nodiscard]] std::vector<Index> corners(Index face) const {
    std::vector<Index> list;
    for (Index h = mesh_.face_begin(face); h < mesh_.face_begin(face + 1); ++h)
      list.push_back(mesh_.origin(h));
    return list;
  }

  /// The new face on the other side of the new half-edge h, which is that of the old face.
  [[nodiscard]] static Index beyond(const Mesh& fine, Index h) {
    return fine.twin(h) == kNone ? kNone : fine.face(fine.twin(h));
  }
  /// Of the vertex at the origin of h, amid the surface: the new half-edge across one of its
  /// corners, which keeps the number of the old one that comes to the vertex there. At the boundary
  /// not every face has a child.
  [[nodiscard]] Index across_a_corner(Index h, const Mesh& fine) const {
    for (Index count = mesh_.valence(mesh_.origin(h)); count > 0; --count, h = mesh_.rotate(h)) {
      const Index before = mesh_.prev(h);
      if (before < fine.halfedge_count() && fine.origin(before) == mesh_.edge(before) &&
          fine.target(before) == mesh_.edge(h))
        return before;
    }
    return mesh_.prev(h);
  }
  /// Old faces keep their numbers. Of a vertex, the face round it; at the boundary there is none.
  [[nodiscard]] Place child(const Place& place, const SplitResult& fine) const {
    if (place.is_face) return place;
    if (mesh_.is_boundary_vertex(place.index)) return {true, kNone};
    const Index h = mesh_.halfedge_of_vertex(place.index);
    // across corners new edges run (midedge), or along old ones: then it is next to an edge's face
    if (fine.births.from_edges > 0) return {true, beyond(fine.mesh, across_a_corner(h, fine.mesh))};
    const Index quad = beyond(fine.mesh, h);
    for (Index g = fine.mesh.face_begin(quad); g < fine.mesh.face_begin(quad + 1); ++g)
      if (fine.mesh.origin(g) == h) return {true, beyond(fine.mesh, g)};
    return {true, kNone};
  }
  /// What the old edge between two places gives; of a face and a vertex there is none.
  [[nodiscard]] Place between(const Place& a, const Place& b, Index control_edge, int step,
                              const SplitResult& fine) const {
    const Index h = step == 0 ? mesh_.halfedge_of_edge(control_edge) : common(a, b);
    if (h == kNone) return {};
    if (fine.births.from_edges > 0) return {false, mesh_.edge(h)};
    return {true, beyond(fine.mesh, h)};
  }
  /// The half-edge of face a that leads to face b.
  [[nodiscard]] Index common(const Place& a, const Place& b) const {
    if (!a.is_face || !b.is_face) return kNone;
    for (Index h = mesh_.face_begin(a.index); h < mesh_.face_begin(a.index + 1); ++h)
      if (mesh_.twin(h) != kNone && mesh_.face(mesh_.twin(h)) == b.index) return h;
    return kNone;
  }

  const Split& split_;
  Mesh mesh_;
  std::vector<std::vector<Place>> paths_;
  std::vector<Index> edges_;  // the control edge of each
};

}  // namespace

EdgePaths edge_paths(const Split& split, const Mesh& control, int levels) {
  if (keeps_old_edges(split) || levels == 0) return kept_edges(split, control, levels);
  if (!split.is_dual()) return turned_edges(split, control, levels);
  DualPaths paths(split, control);
  for (int step = 0; step < levels; ++step) paths.refine(step);
  return paths.take();
}

}  // namespace limn::mesh
