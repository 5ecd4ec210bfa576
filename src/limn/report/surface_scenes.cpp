#include "limn/report/surface_scenes.h"

#include "limn/extraordinary/limit_estimate.h"
#include "limn/extraordinary/limit_points.h"
#include "limn/refine/refine.h"

namespace limn {
namespace {

/// For each vertex: the surface, a panel's copy of it, and the tree that rays are cast into
/// (measured for pictures of triangles).
constexpr double kSurfaceBytes = 300;

SpaceVector vector_of(const Point3& p) { return {p.x, p.y, p.z}; }

}  // namespace

Result<SmoothSurface> limit_surface(const Scheme& scheme, const Mesh& control,
                                    const std::vector<Point3>& points, int steps) {
  RefineEstimate needed = estimate_with_limit(*scheme.split, control, steps, {.limit = true});
  needed.peak_bytes += needed.vertices * kSurfaceBytes;
  if (Status status = check_memory(needed, steps, available_memory()); !status)
    return status.error();
  const Result<Refined<Point3>> fine = refine(scheme, control, points, steps);
  if (!fine) return fine.error();
  LimitOptions options;
  options.steps_made = steps;
  const Result<LimitPoints> limit = approx_limit_points(scheme, fine->mesh, fine->values, options);
  if (!limit) return limit.error();
  SmoothSurface surface;
  for (const Point3& p : limit->positions) surface.vertices.push_back(vector_of(p));
  for (const Point3& n : limit->normals) surface.normals.push_back(vector_of(n));
  const Mesh& mesh = fine->mesh;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index first = mesh.face_begin(f);
    for (Index h = first + 1; h + 1 < mesh.face_begin(f + 1); ++h)
      surface.triangles.push_back({mesh.origin(first), mesh.origin(h), mesh.origin(h + 1)});
  }
  return surface;
}

Polygons polygons_of(const SmoothSurface& surface) {
  Polygons polygons;
  polygons.positions.reserve(surface.vertices.size());
  for (const SpaceVector& at : surface.vertices)
    polygons.positions.push_back({at[0], at[1], at[2]});
  for (const std::array<int, 3>& triangle : surface.triangles) {
    polygons.corners.insert(polygons.corners.end(), triangle.begin(), triangle.end());
    polygons.face_begin.push_back(static_cast<Index>(polygons.corners.size()));
  }
  return polygons;
}

ControlNet control_net(const Mesh& mesh, const std::vector<Point3>& points) {
  ControlNet net;
  for (const Point3& p : points) net.vertices.push_back(vector_of(p));
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e);
    net.edges.push_back({mesh.origin(h), mesh.target(h)});
  }
  return net;
}

}  // namespace limn
