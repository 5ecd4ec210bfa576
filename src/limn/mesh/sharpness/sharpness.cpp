#include "limn/mesh/sharpness/sharpness.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "limn/mesh/index.h"
#include "limn/mesh/split/heritage.h"

namespace limn {
namespace {

bool is_sharp(double s) { return s > 0; }
bool is_fading(double s) { return s > 0 && s < kInfinitelySharp; }

using mesh::at;

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

/// What the child edge inherits at refined half-edge g, which lies on the old half-edge h.
double sharpness_on(const Mesh& mesh, const SplitResult& fine, const ChildSharpness& children,
                    Index g, Index h) {
  const std::size_t e = at(mesh.edge(h));
  const bool turned = mesh.halfedge_of_edge(mesh.edge(h)) != h;
  const Index a = fine.mesh.origin(g), b = fine.mesh.target(g);
  const double first = children.edge_ends[2 * e], last = children.edge_ends[2 * e + 1];
  if (a < fine.births.from_vertices) return turned ? last : first;
  if (b < fine.births.from_vertices) return turned ? first : last;
  return (first + last) / 2;
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
  const std::vector<Index> on = mesh::old_halfedges(mesh, fine);
  if (!sharpness.edges.empty()) {
    result.edges.assign(at(fine.mesh.edge_count()), 0);
    for (Index e = 0; e < fine.mesh.edge_count(); ++e) {
      const Index g = fine.mesh.halfedge_of_edge(e);
      if (on[at(g)] != kNone && !fine.mesh.is_boundary_edge(e))
        result.edges[at(e)] = sharpness_on(mesh, fine, children, g, on[at(g)]);
    }
  }
  if (!sharpness.holes.empty()) {
    const std::vector<Index> parents = mesh::faces_between(mesh, fine.mesh, on);
    result.holes.resize(parents.size());
    for (std::size_t f = 0; f < parents.size(); ++f)
      result.holes[f] = parents[f] != kNone && sharpness.holes[at(parents[f])];
  }
  return result;
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
