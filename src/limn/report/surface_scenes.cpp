#include "limn/report/surface_scenes.h"

#include <algorithm>

#include <fmt/core.h>

#include "limn/extraordinary/limit_points.h"
#include "limn/fast/fast_limit.h"
#include "limn/fast/limit_estimate.h"
#include "limn/refine/refine.h"

namespace limn {
namespace {

/// For each vertex: the surface, a panel's copy of it, and the tree that rays are cast into
/// (measured for pictures of triangles).
constexpr double kSurfaceBytes = 300;

SpaceVector vector_of(const Point3& p) { return {p.x, p.y, p.z}; }

std::vector<SpaceVector> vectors_of(const std::vector<Point3>& points) {
  std::vector<SpaceVector> vectors;
  vectors.reserve(points.size());
  for (const Point3& p : points) vectors.push_back(vector_of(p));
  return vectors;
}

/// Fans, each from a polygon's first corner.
std::vector<std::array<int, 3>> triangles_of(const Polygons& polygons) {
  std::vector<std::array<int, 3>> triangles;
  for (Index f = 0; f < polygons.face_count(); ++f) {
    const Index first = polygons.face_begin[f], end = polygons.face_begin[f + 1];
    for (Index i = first + 1; i + 1 < end; ++i)
      triangles.push_back({polygons.corners[first], polygons.corners[i], polygons.corners[i + 1]});
  }
  return triangles;
}

SmoothSurface surface_of(const Polygons& refined, const std::vector<Point3>& limit,
                         const std::vector<Point3>& normals) {
  return {.vertices = vectors_of(limit),
          .normals = vectors_of(normals),
          .triangles = triangles_of(refined)};
}

}  // namespace

Result<SmoothSurface> limit_surface(const Scheme& scheme, const Mesh& control,
                                    const std::vector<Point3>& points, int steps) {
  RefineEstimate needed = estimate_with_limit(*scheme.split, control, steps, {.limit = true});
  needed.peak_bytes += needed.vertices * kSurfaceBytes;
  if (Status status = check_memory(needed, steps, available_memory()); !status)
    return status.error();
  if (has_fast_layout(*scheme.split)) {
    const Result<std::optional<FastLimitMesh>> quick =
        approx_fast_limit_mesh(scheme, control, points, steps);
    if (!quick) return quick.error();
    if (*quick) return surface_of((*quick)->refined, (*quick)->limit, (*quick)->normals);
  }
  const Result<Refined<Point3>> fine = refine(scheme, control, points, steps);
  if (!fine) return fine.error();
  LimitOptions options;
  options.steps_made = steps;
  const Result<LimitPoints> limit = approx_limit_points(scheme, fine->mesh, fine->values, options);
  if (!limit) return limit.error();
  return surface_of(fine->mesh.polygons(fine->values), limit->positions, limit->normals);
}

DrawingEstimate estimate_drawing(const Scheme& scheme, const Mesh& control, int steps) {
  const RefineEstimate refined =
      has_fast_layout(*scheme.split)
          ? FastRefiner::estimate(*scheme.split, control, steps)
          : estimate_refinement(*scheme.split, control, steps, sizeof(Point3));
  DrawingEstimate drawing{.vertices = refined.vertices};
  // Euler's formula on any surface of some size: as many triangles as leave two a vertex
  drawing.triangles = std::max(2 * refined.vertices, refined.faces);
  // the scene, a figure's two copies of it, and how it is seen; and what is scanned
  constexpr double copies = 4;
  constexpr double vertex = 2 * sizeof(SpaceVector), triangle = sizeof(std::array<int, 3>);
  constexpr double scanned = 6 * sizeof(double);
  drawing.bytes = std::max(refined.peak_bytes + 2 * sizeof(Point3) * refined.vertices,
                           (copies * vertex + scanned) * drawing.vertices +
                               (copies * triangle + sizeof(int)) * drawing.triangles);
  return drawing;
}

Status check_drawable(const Scheme& scheme, const Mesh& control, int steps) {
  const DrawingEstimate drawing = estimate_drawing(scheme, control, steps);
  if (drawing.triangles <= kMostTriangles) return Done{};
  int fewer = steps - 1;
  while (fewer > 0 && estimate_drawing(scheme, control, fewer).triangles > kMostTriangles) --fewer;
  Error error;
  error.message =
      fmt::format("{} levels make about {:.3g} triangles, of which a picture takes {:g}", steps,
                  drawing.triangles, kMostTriangles);
  error.hint = fewer >= 0 ? fmt::format("draw {} levels", fewer) : "draw a smaller mesh";
  return error;
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
