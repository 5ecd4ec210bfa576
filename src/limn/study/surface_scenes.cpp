#include "limn/study/surface_scenes.h"

#include <algorithm>

#include <fmt/core.h>

#include "limn/base/memory.h"
#include "limn/refine/refine_estimate.h"
#include "limn/surface/refine_surface.h"
#include "limn/surface/surface_estimate.h"

namespace limn::study {
namespace {

std::vector<figure::SpaceVector> vectors_of(const std::vector<Point3>& points) {
  std::vector<figure::SpaceVector> vectors;
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

figure::SmoothSurface surface_of(const RefinedSurface& surface) {
  return {.vertices = vectors_of(surface.limit),
          .normals = vectors_of(surface.normals),
          .triangles = triangles_of(surface.polygons)};
}

}  // namespace

Result<figure::SmoothSurface> limit_surface(const Scheme& scheme, const Mesh& control,
                                            const std::vector<Point3>& points, int steps,
                                            LimitGaps* gaps) {
  refine::RefineEstimate needed =
      surface::estimate_with_limit(scheme, control, steps, {.quick = false, .limit = true});
  needed.peak_bytes += needed.vertices * kSurfaceBytes;
  if (Status status = refine::check_memory(needed, steps, base::available_memory()); !status)
    return status.error();
  Result<RefinedSurface> surface =
      refine_surface(scheme, control, points,
                     {.levels = steps, .limit = true, .normals = true, .partial = gaps != nullptr});
  if (!surface) return surface.error();
  if (gaps != nullptr) *gaps = std::move(surface->gaps);
  return surface_of(*surface);
}

DrawingEstimate estimate_drawing(const Scheme& scheme, const Mesh& control, int steps) {
  const refine::RefineEstimate refined = surface::estimate_with_limit(scheme, control, steps, {});
  DrawingEstimate drawing{.vertices = refined.vertices};
  // Euler's formula on any surface of some size: as many triangles as leave two a vertex
  drawing.triangles = std::max(2 * refined.vertices, refined.faces);
  // the scene, a figure's two copies of it, and how it is seen; and what is scanned
  constexpr double copies = 4;
  constexpr double vertex = 2 * sizeof(figure::SpaceVector), triangle = sizeof(std::array<int, 3>);
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

Polygons polygons_of(const figure::SmoothSurface& surface) {
  Polygons polygons;
  polygons.positions.reserve(surface.vertices.size());
  for (const figure::SpaceVector& at : surface.vertices)
    polygons.positions.push_back({at[0], at[1], at[2]});
  for (const std::array<int, 3>& triangle : surface.triangles) {
    polygons.corners.insert(polygons.corners.end(), triangle.begin(), triangle.end());
    polygons.face_begin.push_back(static_cast<Index>(polygons.corners.size()));
  }
  return polygons;
}

figure::ControlNet control_net(const Mesh& mesh, const std::vector<Point3>& points) {
  figure::ControlNet net;
  for (const Point3& p : points) net.vertices.push_back(vector_of(p));
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e);
    net.edges.push_back({mesh.origin(h), mesh.target(h)});
  }
  return net;
}

}  // namespace limn::study
