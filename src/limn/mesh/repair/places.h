#pragma once
/// Vertices that lie in one place, or nearly.

#include <vector>

#include "limn/mesh/polygons.h"

namespace limn::mesh {

/// For each point the one that stands for its place: itself, or an earlier one that stands for
/// itself and lies within `distance` ≥ 0, the nearest of those (of several the first). So no point
/// is farther than `distance` from the one that stands for it, and two that stand for themselves
/// are farther than that apart. With 0, points that are equal (-0 is 0). A point that is not finite
/// stands for itself. Cost O(points), expected, where few lie within `distance` of each other.
[[nodiscard]] std::vector<Index> places_of(const std::vector<Point3>& points, double distance = 0);

/// The diagonal of the least box along the axes that holds the finite points; 0 where there is
/// none, and infinite where it is no double.
[[nodiscard]] double diagonal_of(const std::vector<Point3>& points);

/// Boundary edges of a mesh that joining vertices in one place would close: the mesh looks as if
/// each face (or patch) had been given vertices of its own.
struct OpenSeams {
  Index vertices = 0;  ///< those that lie where an earlier one of the boundary lies
  Index edges = 0;     ///< pairs of boundary edges between the same two places
};

/// `boundary`: the ends of the boundary edges, two by two. An edge between three boundary edges or
/// more does not count: joining would make it non-manifold. Cost O(n log n).
[[nodiscard]] OpenSeams open_seams(const std::vector<Index>& boundary,
                                   const std::vector<Point3>& points);

}  // namespace limn::mesh
