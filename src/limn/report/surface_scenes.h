#pragma once
/// Limit surfaces as scenes to be drawn.

#include <vector>

#include "limn/mesh/mesh.h"
#include "limn/report/figure/surface_scene.h"
#include "limn/scheme/scheme.h"

namespace limn {

/// The limit surface of a control mesh, sampled after so many steps, with limit normals; faces are
/// cut into triangles by fans. Fails as `refine` and `approx_limit_points` do, and before the work
/// where that and a picture of it need more memory than there is.
[[nodiscard]] Result<SmoothSurface> limit_surface(const Scheme& scheme, const Mesh& control,
                                                  const std::vector<Point3>& points, int steps);

/// Its vertices and triangles.
[[nodiscard]] Polygons polygons_of(const SmoothSurface& surface);

/// The edges of a mesh.
[[nodiscard]] ControlNet control_net(const Mesh& mesh, const std::vector<Point3>& points);

}  // namespace limn
