#pragma once
/// How far two surfaces are apart, whatever their connectivity.
///
///     const Result<SurfaceDistance> apart = approx_surface_distance(loop, butterfly);
///     apart->largest, apart->mean, apart->largest / apart->diagonal

#include <array>
#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/polygons.h"

namespace limn::mesh {

/// From each vertex of one surface to the nearest point of the other's triangles, both ways.
/// The same with the surfaces exchanged, to the last bit.
struct SurfaceDistance {
  /// Of all vertices of both: the Hausdorff distance as far as vertices show it. It is never more
  /// than the distance of the polygon meshes, and less by at most the distance from a point of a
  /// face to the nearest vertex.
  double largest = 0;
  double mean = 0;  ///< over both surfaces, by area: a vertex has a third of each of its triangles
  std::array<Point3, 2> where = {};  ///< where it is largest: a point of a and one of b
  double diagonal = 0;  ///< of the least box along the axes that holds the vertices of both
  /// One for each vertex: of a to b, and of b to a; NaN at vertices without a face.
  std::vector<double> from_a = {}, from_b = {};
};

/// Polygons of more than three corners count as the triangles that `triangulated` cuts. Meshes
/// that sample smooth surfaces with edges h differ from these by about κh²/8, κ the curvature; a
/// smaller distance says that the surfaces are equal as far as such samples can tell. In double
/// precision. Fails where a surface has no triangle with an area, or a corner that is no vertex or
/// not finite. Cost O(V log F), on all threads: about 1 s for two surfaces of 100 000 vertices each
/// on one.
[[nodiscard]] Result<SurfaceDistance> approx_surface_distance(const Polygons& a, const Polygons& b);

}  // namespace limn::mesh
