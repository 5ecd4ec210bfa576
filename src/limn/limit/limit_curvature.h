#pragma once
/// Curvature at a vertex from left eigenvectors, where it is bounded.

#include <optional>
#include <vector>

#include "limn/limit/limit_points.h"
#include "limn/limit/limit_stencil.h"

namespace limn::limit {

/// How much of the cup and the two saddles a surface holds, as weights over the star of `rings`
/// rings. In coordinates (u, v) along the tangents of LimitStencil the surface is position +
/// u · first + v · second + cup (u² + v²) + first saddle (u² − v²) + second saddle 2uv + `jumps` +
/// smaller terms: exactly so at regular vertices where the scheme reproduces quadratics, elsewhere
/// it is the best fit at the rings round the vertex.
struct CurvatureStencil {
  int rings = 0;
  std::vector<double> cup, first_saddle, second_saddle;
  /// How much there is of the functions of frequency 1 that shrink as tangent² does, as u |u| + v
  /// |v|. They are no quadratics, so there is one curvature where all of these vanish, and else
  /// another from each side. A biquadratic spline has them where its pieces meet, at the centre of
  /// a regular face; what one step makes of a regular vertex's surroundings is one piece, and has
  /// none of them.
  std::vector<std::vector<double>> jumps;
};

/// Curvature at a vertex, or why there is none.
struct VertexCurvature {
  std::optional<CurvatureStencil> stencil;  ///< nothing where curvature is not known
  NoCurvature missing = NoCurvature::none;  ///< why there is no stencil
};

/// No stencil where curvature is not bounded (the verdict says why), and where functions of
/// frequency 3 or more shrink as tangent² does, or others that are no real multiples of it:
/// curvature then depends on the direction. Cost: O(n log n).
[[nodiscard]] Result<VertexCurvature> approx_curvature_stencil(const Scheme& scheme,
                                                               FrequencyAnalysis& analysis, int n);

}  // namespace limn::limit
