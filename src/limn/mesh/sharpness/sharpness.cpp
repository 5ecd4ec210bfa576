#include "limn/mesh/sharpness/sharpness.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limn {
namespace {

bool is_sharp(double s) { return s > 0; }
bool is_fading(double s) { return s > 0 && s < kInfinitelySharp; }

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

}  // namespace

bool Sharpness::any() const {
  return std::any_of(edges.begin(), edges.end(), is_sharp) ||
         std::any_of(vertices.begin(), vertices.end(), is_sharp);
}

bool Sharpness::fades() const {
  return std::any_of(edges.begin(), edges.end(), is_fading) ||
         std::any_of(vertices.begin(), vertices.end(), is_fading);
}

bool Sharpness::has_holes() const {
  return std::find(holes.begin(), holes.end(), true) != holes.end();
}

ChildSharpness child_sharpness(const Mesh& mesh, const Sharpness& sharpness) {
  ChildSharpness result;
  result.vertices.assign(at(mesh.vertex_count()), 0);
  for (std::size_t v = 0; v < sharpness.vertices.size(); ++v)
    result.vertices[v] = after_step(sharpness.vertices[v]);
  // of the edges that fade at each vertex
  std::vector<double> sums(at(mesh.vertex_count()), 0);
  std::vector<Index> counts(at(mesh.vertex_count()), 0);
  const auto ends = [&](Index e) {
    const Index h = mesh.halfedge_of_edge(e);
    return std::array<Index, 2>{mesh.origin(h), mesh.target(h)};
  };
  const bool chaikin = sharpness.method == CreaseMethod::chaikin;
  for (Index e = 0; chaikin && e < mesh.edge_count(); ++e) {
    const double s = sharpness_of_edge(mesh, sharpness, e);
    if (!is_fading(s)) continue;
    for (const Index v : ends(e)) {
      sums[at(v)] += s;
      ++counts[at(v)];
    }
  }
  result.edge_ends.resize(2 * at(mesh.edge_count()));
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const double s = sharpness_of_edge(mesh, sharpness, e);
    for (std::size_t end = 0; end < 2; ++end) {
      double& child = result.edge_ends[2 * at(e) + end];
      child = after_step(s);
      if (!chaikin || !is_fading(s)) continue;
      const std::size_t v = at(ends(e)[end]);
      if (counts[v] > 1) child = std::max(0.0, (3 * s + (sums[v] - s) / (counts[v] - 1)) / 4 - 1);
    }
  }
  return result;
}

namespace {

/// Which old edges and faces the refined ones lie on.
class Heritage {
 public:
  Heritage(const Mesh& mesh, const SplitResult& fine) : mesh_(mesh), fine_(fine) {}

  /// The old half-edge that the refined half-edge g lies on, in its direction; kNone: on none.
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

  /// What the child edge there inherits.
  [[nodiscard]] double sharpness(Index g, Index h, const ChildSharpness& children) const {
    const std::size_t e = at(mesh_.edge(h));
    const bool turned = mesh_.halfedge_of_edge(mesh_.edge(h)) != h;
    const Index a = fine_.mesh.origin(g), b = fine_.mesh.target(g);
    const double first = children.edge_ends[2 * e], last = children.edge_ends[2 * e + 1];
    if (a < fine_.births.from_vertices) return turned ? last : first;
    if (b < fine_.births.from_vertices) return turned ? first : last;
    return (first + last) / 2;
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

/// Holes of the refined mesh: the faces along old half-edges belong to these half-edges' faces, and
/// all others to that from which they are reached without crossing an old edge.
std::vector<bool> inherit_holes(const Mesh& mesh, const std::vector<bool>& holes, const Mesh& fine,
                                const std::vector<Index>& on) {
  std::vector<Index> owner(at(fine.face_count()), kNone), reached;
  for (Index g = 0; g < fine.halfedge_count(); ++g) {
    Index& face = owner[at(fine.face(g))];
    if (on[at(g)] == kNone || face != kNone) continue;
    face = mesh.face(on[at(g)]);
    reached.push_back(fine.face(g));
  }
  while (!reached.empty()) {
    const Index f = reached.back();
    reached.pop_back();
    for (Index g = fine.face_begin(f); g < fine.face_begin(f + 1); ++g) {
      const Index twin = fine.twin(g);
      if (on[at(g)] != kNone || twin == kNone || owner[at(fine.face(twin))] != kNone) continue;
      owner[at(fine.face(twin))] = owner[at(f)];
      reached.push_back(fine.face(twin));
    }
  }
  std::vector<bool> result(at(fine.face_count()), false);
  for (std::size_t f = 0; f < result.size(); ++f)
    result[f] = owner[f] != kNone && holes[at(owner[f])];
  return result;
}

}  // namespace

Sharpness inherit(const Mesh& mesh, const Sharpness& sharpness, const ChildSharpness& children,
                  const SplitResult& fine) {
  Sharpness result;
  result.method = sharpness.method;
  if (!sharpness.vertices.empty()) {
    result.vertices.assign(at(fine.mesh.vertex_count()), 0);
    std::copy(children.vertices.begin(), children.vertices.end(), result.vertices.begin());
  }
  if (sharpness.edges.empty() && sharpness.holes.empty()) return result;
  const Heritage heritage(mesh, fine);
  std::vector<Index> on(at(fine.mesh.halfedge_count()));
  for (Index g = 0; g < fine.mesh.halfedge_count(); ++g) on[at(g)] = heritage.halfedge(g);
  if (!sharpness.edges.empty()) {
    result.edges.assign(at(fine.mesh.edge_count()), 0);
    for (Index e = 0; e < fine.mesh.edge_count(); ++e) {
      const Index g = fine.mesh.halfedge_of_edge(e);
      if (on[at(g)] != kNone && !fine.mesh.is_boundary_edge(e))
        result.edges[at(e)] = heritage.sharpness(g, on[at(g)], children);
    }
  }
  if (!sharpness.holes.empty()) result.holes = inherit_holes(mesh, sharpness.holes, fine.mesh, on);
  return result;
}

namespace {

void make_boundary_holes(const Mesh& mesh, Sharpness& sharpness) {
  std::vector<bool> open(at(mesh.vertex_count()), false);  // has a boundary edge that is not stated
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (!mesh.is_boundary_edge(e)) continue;
    if (!sharpness.edges.empty() && sharpness.edges[at(e)] >= kInfinitelySharp) continue;
    const Index h = mesh.halfedge_of_edge(e);
    open[at(mesh.origin(h))] = open[at(mesh.target(h))] = true;
  }
  for (Index h = 0; h < mesh.halfedge_count(); ++h) {
    if (!open[at(mesh.origin(h))]) continue;
    sharpness.holes.resize(at(mesh.face_count()));
    sharpness.holes[at(mesh.face(h))] = true;
  }
}

void sharpen_corners(const Mesh& mesh, Sharpness& sharpness) {
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Index h = mesh.halfedge_of_vertex(v);
    if (h == kNone || mesh.twin(h) != kNone || mesh.twin(mesh.prev(h)) != kNone) continue;
    sharpness.vertices.resize(at(mesh.vertex_count()));
    sharpness.vertices[at(v)] = kInfinitelySharp;
  }
}

}  // namespace

void apply_boundary_mode(const Mesh& mesh, BoundaryMode mode, Sharpness& sharpness) {
  switch (mode) {
    case BoundaryMode::none: return make_boundary_holes(mesh, sharpness);
    case BoundaryMode::edge_only: return;
    case BoundaryMode::edge_and_corner: return sharpen_corners(mesh, sharpness);
  }
}

Index sharpen_by_angle(const Mesh& mesh, const std::vector<Point3>& positions, double degrees,
                       Sharpness& sharpness) {
  std::vector<Point3> normals(at(mesh.face_count()));
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index begin = mesh.face_begin(f);
    const Point3 first = positions[at(mesh.origin(begin))];
    for (Index h = begin; h < mesh.face_begin(f + 1); ++h)
      normals[at(f)] = normals[at(f)] + cross(positions[at(mesh.origin(h))] - first,
                                              positions[at(mesh.target(h))] - first);
  }
  const double limit = degrees * M_PI / 180;
  Index count = 0;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (mesh.is_boundary_edge(e)) continue;
    const Index h = mesh.halfedge_of_edge(e);
    const Point3 a = normals[at(mesh.face(h))], b = normals[at(mesh.face(mesh.twin(h)))];
    if (dot(a, a) == 0 || dot(b, b) == 0) continue;
    const Point3 across = cross(a, b);
    if (!(std::atan2(std::sqrt(dot(across, across)), dot(a, b)) > limit)) continue;
    sharpness.edges.resize(at(mesh.edge_count()));
    sharpness.edges[at(e)] = kInfinitelySharp;
    ++count;
  }
  return count;
}

Polygons without_holes(const Polygons& polygons, const std::vector<bool>& holes,
                       std::vector<Index>& kept) {
  const std::size_t vertices = polygons.positions.size();
  std::vector<bool> of_hole(vertices, false), of_face(vertices, false);
  for (Index f = 0; f < polygons.face_count(); ++f)
    for (Index c = polygons.face_begin[at(f)]; c < polygons.face_begin[at(f) + 1]; ++c)
      (holes[at(f)] ? of_hole : of_face)[at(polygons.corners[at(c)])] = true;
  Polygons result;
  std::vector<Index> number(vertices, kNone);
  for (std::size_t v = 0; v < vertices; ++v) {
    if (of_hole[v] && !of_face[v]) continue;
    number[v] = result.vertex_count();
    kept.push_back(static_cast<Index>(v));
    result.positions.push_back(polygons.positions[v]);
  }
  for (Index f = 0; f < polygons.face_count(); ++f) {
    if (holes[at(f)]) continue;
    for (Index c = polygons.face_begin[at(f)]; c < polygons.face_begin[at(f) + 1]; ++c)
      result.corners.push_back(number[at(polygons.corners[at(c)])]);
    result.face_begin.push_back(static_cast<Index>(result.corners.size()));
  }
  return result;
}

}  // namespace limn
