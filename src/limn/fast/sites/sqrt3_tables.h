#pragma once
/// All stencils of a √3 scheme, read by refining linear forms on stars and fans with the plain
/// engine: nothing here knows a rule.

#include <map>

#include "limn/fast/layout/sqrt3_patches.h"
#include "limn/fast/sites/sqrt3_reach.h"
#include "limn/fast/sites/stencil_tables.h"
#include "limn/refine/linear_form.h"

namespace limn::fast {

/// Of one step.
struct Sqrt3Tables {
  Sqrt3Reach reach;
  std::array<Stencil, kSqrt3Classes> interior;  ///< local, from the anchor
  /// Of new points (X, Y) along a boundary side that runs along the first axis, the mesh lying
  /// above: number 3·Y + X mod 3, for Y ≤ reach.strip_depth; thirds, from the point. Empty where
  /// there is no new point.
  std::vector<Stencil> strips;
  std::map<Index, ZoneTable> stars;  ///< by valence of an interior vertex
  std::map<Index, ZoneTable> fans;   ///< by number of faces at a boundary vertex
};

/// Forms over the old vertices of a site, as the rows of these targets.
[[nodiscard]] ZoneTable zone_table(const std::vector<LinearForm<double>>& forms,
                                   const Sqrt3Site& site, Index sectors,
                                   std::vector<SectorPoint> targets);

/// The tables that refining a mesh with vertices and faces of these kinds needs, of both steps.
/// Fails as read_stencils.
[[nodiscard]] Result<std::array<Sqrt3Tables, 2>> read_sqrt3_stencils(
    const Scheme& scheme, const std::vector<VertexKind>& kinds, const BoundarySides& sides);

}  // namespace limn::fast
