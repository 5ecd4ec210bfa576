#pragma once
/// Curvature at a vertex from left eigenvectors, where it is bounded.

#include "limn/limit/limit_stencil.h"

namespace limn {

/// How much of the cup and the two saddles a surface holds, as weights over the star of `rings`
/// rings. In coordinates (u, v) along the tangents of LimitStencil the surface is position + u ·
/// first
/// + v · second + cup (u² + v²) + first saddle (u² − v²) + second saddle 2uv + smaller terms:
/// exactly so at regular vertices where the scheme reproduces quadratics, elsewhere it is the best
/// fit at the ring round the vertex.
struct CurvatureStencil {
  int rings = 0;
  std::vector<double> cup, first_saddle, second_saddle;
};

/// Nothing where curvature is not bounded, or flat in a shape (the verdict says which), and at n =
/// 3, which has no saddles.
[[nodiscard]] Result<std::optional<CurvatureStencil>> approx_curvature_stencil(
    const Scheme& scheme, FrequencyAnalysis& analysis, int n);

}  // namespace limn
