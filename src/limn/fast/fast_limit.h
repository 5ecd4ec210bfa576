#pragma once
/// Limit positions and normals by the fast engine (fast/fast_refiner.h).

#include "limn/fast/fast_refiner.h"

namespace limn {

/// The limit of a refiner of this scheme, for FastRefiner::evaluate_limit, from
/// approx_limit_stencil and approx_boundary_limit_stencil: the points of approx_limit_points
/// (limit_points.h), much faster. Nothing where the refiner takes none (FastRefiner::limit); ask
/// approx_limit_points then. Fails as the stencils. Cost: a stencil for each valence in the mesh.
[[nodiscard]] Result<std::optional<FastRefiner::Limit>> approx_fast_limit(
    const Scheme& scheme, const FastRefiner& refiner);

/// A refined mesh with limit positions and unit normals at its vertices.
struct FastLimitMesh {
  Polygons refined;             ///< with the points where refinement puts them
  std::vector<Point3> limit;    ///< one for each vertex
  std::vector<Point3> normals;  ///< of length 1, or zero; one for each vertex
};
/// All of it, from the positions of the control vertices. Nothing and failure as approx_fast_limit.
[[nodiscard]] Result<std::optional<FastLimitMesh>> approx_fast_limit_mesh(
    const Scheme& scheme, const FastRefiner& refiner, const std::vector<Point3>& positions);

}  // namespace limn
