#include "limn/limit/vertex_sides.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "limn/mesh/index.h"
#include "limn/mesh/unit_normal.h"

namespace limn::limit {
namespace {

/// An edge's name is its sharpness, which is infinite and so is inherited as it is: this much and
/// the number of the edge.
constexpr double kNamed = 2 * kInfinitelySharp;

using mesh::at;

/// As VertexSides; sides begin at edges that are inside the mesh and of which `is_sharp(e)` holds,
/// the first at one of which `is_first(e)` holds.
template <class IsSharp, class IsFirst>
VertexSides sides_at(const Mesh& mesh, Index v, IsSharp is_sharp, IsFirst is_first) {
  VertexSides sides;
  sides.open = mesh.is_boundary_vertex(v);
  const auto begins = [&](Index h) { return mesh.twin(h) != kNone && is_sharp(mesh.edge(h)); };
  Index first = mesh.halfedge_of_vertex(v);
  if (!sides.open) {
    const Index start = first;
    Index h = start;
    do {
      if (begins(h) && is_first(mesh.edge(h))) {
        first = h;
        break;
      }
      h = mesh.rotate(h);
    } while (h != start);
  }
  Index h = first, before = first;
  do {
    if (h == first || begins(h)) sides.begins.push_back(sides.halfedges.size());
    sides.halfedges.push_back(h);
    before = h;
    h = mesh.rotate(h);
  } while (h != kNone && h != first);
  sides.begins.push_back(sides.halfedges.size());
  sides.last = h == first ? mesh.target(first) : mesh.origin(mesh.prev(before));
  return sides;
}

bool is_infinite(const Mesh& mesh, const Sharpness& sharpness, Index e) {
  return sharpness_of_edge(mesh, sharpness, e) >= kInfinitelySharp;
}

}  // namespace

VertexSides sides_of(const Mesh& mesh, const Sharpness& sharpness, Index v) {
  return sides_at(
      mesh, v, [&](Index e) { return is_infinite(mesh, sharpness, e); },
      [](Index) { return true; });
}

void name_edges(const Mesh& mesh, const Sharpness& sharpness, Index v, const PartCutter& cutter,
                MeshPart& part) {
  const Index first = mesh.halfedge_of_vertex(v);
  Index h = first;
  do {
    if (mesh.twin(h) != kNone && is_infinite(mesh, sharpness, mesh.edge(h)))
      part.sharpness.edges[at(part.mesh.edge(cutter.number(h)))] = kNamed + mesh.edge(h);
    h = mesh.rotate(h);
  } while (h != kNone && h != first);
}

VertexSides same_sides(const MeshPart& part, Index centre, const Mesh& mesh,
                       const VertexSides& sides) {
  const double first = kNamed + mesh.edge(sides.halfedges[0]);
  const auto sharp = [&](Index e) { return sharpness_of_edge(part.mesh, part.sharpness, e); };
  VertexSides found = sides_at(
      part.mesh, centre, [&](Index e) { return sharp(e) >= kNamed; },
      [&](Index e) { return sharp(e) == first; });
  if (found.count() != sides.count()) found.begins.assign(1, 0);
  return found;
}

std::vector<Point3> normals_of_faces(const Mesh& mesh, const std::vector<Point3>& values,
                                     const VertexSides& sides) {
  std::vector<Point3> normals;
  std::vector<std::array<double, 3>> chain;
  for (std::size_t side = 0; side < sides.count(); ++side) {
    chain.clear();
    double size = 0;
    const auto add = [&](Index v) {
      const Point3& p = values[at(v)];
      chain.push_back({p.x, p.y, p.z});
      size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    };
    const std::size_t end = sides.begins[side + 1];
    for (std::size_t i = sides.begins[side]; i < end; ++i) add(mesh.target(sides.halfedges[i]));
    add(end < sides.halfedges.size() ? mesh.target(sides.halfedges[end]) : sides.last);
    const std::array<double, 3> normal = mesh::unit_normal<double>(chain, size);
    normals.push_back({normal[0], normal[1], normal[2]});
  }
  return normals;
}

}  // namespace limn::limit
