#pragma once
/// Limit position and tangent plane at a vertex as weighted sums of the control points round it:
/// left eigenvectors of the subdivision matrix [BGSK §2.1, (2)], for any scheme.

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "limn/spectrum/eigencomponents.h"

namespace limn {

namespace mesh {
struct Sectors;  // lattice.h
}

/// Weights over the vertices of a star (dual splits: a face star) or, at the boundary, of a fan;
/// numbered as in mesh/lattice.h.
struct LimitStencil {
  int rings = 0;                 ///< of the star or fan
  std::vector<double> position;  ///< sums to 1
  /// The derivative along one direction of the characteristic map; sums to 0. Empty where no two
  /// eigenvectors lead all others but the position's and turn once round the vertex: there is no
  /// tangent plane then.
  std::vector<double> first_tangent;
  /// The same along a direction counterclockwise from the first, so that the cross product of the
  /// two points outward.
  std::vector<double> second_tangent;
  /// False where refinement does not flatten the faces round the vertex either: at valence 2, where
  /// frequency 1 is real and has no pair.
  bool has_plane = true;
};

/// At an interior vertex of valence n (dual splits: a face of n corners), n ≥ 3, on quads n ≥ 2. In
/// double precision. Cost: that of `analysis.blocks(n)` and of the eigenvectors of two blocks.
/// Fails as `FrequencyAnalysis::blocks` does, and where the scheme does not converge there (the
/// reason is the verdict's).
[[nodiscard]] Result<LimitStencil> approx_limit_stencil(FrequencyAnalysis& analysis, int n);

/// At the centre of a star, or a fan at the boundary, of such sectors, from its dense matrix; no
/// curvature. Fails as `sector_matrix` (sector_matrix.h) does and where the scheme does not
/// converge there. Cost: the cube of the number of vertices that control the surface.
[[nodiscard]] Result<LimitStencil> approx_sector_limit_stencil(const Scheme& scheme,
                                                               const mesh::Sectors& sectors);

/// The same at a boundary vertex of `faces` ≥ 1 faces of the scheme's lattice. For splits that keep
/// the old vertices. Fails also where the scheme has two lattices.
[[nodiscard]] Result<LimitStencil> approx_boundary_limit_stencil(const Scheme& scheme, int faces);

}  // namespace limn
