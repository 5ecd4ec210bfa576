#pragma once
/// Limit points of a mesh with sharp edges and vertices.

#include "limn/limit/limit_points.h"
#include "limn/mesh/sharpness/sharpness.h"

namespace limn {

/// As `approx_limit_points` without sharpness. What is sharp must be infinitely so (precondition:
/// !sharpness.fades(); refine until it is) and the scheme must take it (check_takes_sharpness). A
/// corner is its own limit; a vertex on a crease has that of the boundary of the mesh cut there. At
/// a dart, and near darts and corners where a scheme's smooth rules go beyond the next neighbours,
/// the neighbourhood is refined until the point rests. Normals and curvatures of vertices with more
/// than one side, of darts, and where the neighbourhood is refined, are not given: zero, and NaN.
/// LimitOptions::vertices is not heeded: all are done. Cost as without sharpness, and some ten
/// milliseconds for each vertex whose neighbourhood is refined.
[[nodiscard]] Result<LimitPoints> approx_limit_points(const Scheme& scheme, const Mesh& mesh,
                                                      const std::vector<Point3>& values,
                                                      const Sharpness& sharpness,
                                                      const LimitOptions& options = {});

}  // namespace limn
