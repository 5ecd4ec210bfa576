#pragma once
/// Curvature at a vertex from left eigenvectors, where it is bounded.

#include <string_view>
#include "limn/limit/limit_stencil.h"

namespace limn {

/// Why a vertex has no curvature.
enum class NoCurvature : char {
  none,         ///< it has one
  boundary,     ///< it lies on the boundary
  no_limit,     ///< it has no limit point, or no faces
  no_normal,    ///< its tangents vanish or are parallel, or there is no tangent pair
  unbounded,    ///< by the eigenvalues of the vertex: it grows towards it, or may
  regular,      ///< the scheme's regular surface has unbounded curvature everywhere
  direction,    ///< bounded, with another value from each side: second derivatives jump there
  not_regular,  ///< its neighbourhood never becomes regular (dual splits, beside the boundary)
  unknown,      ///< what it would follow from cannot be had
  too_large,    ///< not a number in double precision
};
[[nodiscard]] std::string_view to_string(NoCurvature reason);

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

struct VertexCurvature {
  std::optional<CurvatureStencil> stencil;
  NoCurvature missing = NoCurvature::none;  ///< why there is no stencil
};

/// No stencil where curvature is not bounded (the verdict says why), and where functions of
/// frequency 3 or more shrink as tangent² does, or others that are no real multiples of it:
/// curvature then hangs on the direction. Cost: O(n log n).
[[nodiscard]] Result<VertexCurvature> approx_curvature_stencil(const Scheme& scheme,
                                                               FrequencyAnalysis& analysis, int n);

}  // namespace limn
