#pragma once
/// Limit points of a mesh with sharp edges and vertices.

#include "limn/limit/limit_points.h"
#include "limn/mesh/sharpness/sharpness.h"

namespace limn::limit {

/// Limit points, and the normals of vertices with several sides, whose `normals` are zero.
struct SharpLimitPoints : LimitPoints {
  SideNormals sides;  ///< by half-edges of the mesh
};

/// As `approx_limit_points` without sharpness; the scheme must take it (check_takes_sharpness). A
/// corner is its own limit; a vertex on a crease has that of the boundary of the mesh cut there,
/// and a normal on either side. At a dart, and for the normals of a corner's sides, the
/// neighbourhood is refined until they rest; there are no curvatures then (NaN). A vertex amid the
/// surface that is sharp itself has no normal; nor have the sides of corners under √3 and √2. Where
/// something fades, and near it and near darts and corners where rules go beyond the next
/// neighbours or are seen from them, the neighbourhood is refined until it has faded or is farther
/// off. Cost as without sharpness, and some ten milliseconds for each vertex whose neighbourhood is
/// refined until it rests, some milliseconds for each of the others that is refined. Without
/// `normals` corners are spared what their normals take, which are not given.
[[nodiscard]] Result<SharpLimitPoints> approx_limit_points(const Scheme& scheme, const Mesh& mesh,
                                                           const std::vector<Point3>& values,
                                                           const Sharpness& sharpness,
                                                           const LimitOptions& options = {},
                                                           bool normals = true);

}  // namespace limn::limit
