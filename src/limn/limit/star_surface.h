#pragma once
/// The limit surface on the faces round an extraordinary vertex, sampled finely.

#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/mesh.h"
#include "limn/scheme/scheme.h"

namespace limn {

/// A piece of the limit surface as a mesh.
struct StarSurface {
  Mesh mesh;                      ///< what became of the faces round the centre
  std::vector<Point3> positions;  ///< limit points, one per vertex
  std::vector<Point3> normals;    ///< unit normals there, zero where there is none
};

/// The surface whose control points are `values` on the star of n ≥ 3 sectors and `rings` rings
/// (dual splits: face star; refine/star_step.h), after so many steps; every second one for sqrt3,
/// whose steps turn the star, and of sqrt2 twice as many. `rings` must be those that control the
/// surface round the centre (FrequencyBlocks) and one more. Without boundary rules. `values` has an
/// entry for each vertex of the star. Cost: that of approx_limit_points on n |det M|^steps faces.
/// Fails as `approx_limit_points`.
[[nodiscard]] Result<StarSurface> approx_star_surface(const Scheme& scheme, int n, int rings,
                                                      const std::vector<Point3>& values, int steps);

}  // namespace limn
