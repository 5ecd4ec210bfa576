#pragma once
/// Points near the boundary, where a dual scheme's rule looks beyond its own face. At the boundary
/// each edge off it runs, from centre to centre of its faces, along a straight side of the mesh,
/// with a strip of points that need stencils of their own; and round the centre of a face at the
/// boundary all points need a table, for each way in which the face may touch the boundary.

#include <array>
#include <map>
#include <vector>

#include "limn/fast/families/dual_zone.h"
#include "limn/fast/layout/dual_layout.h"
#include "limn/scheme/scheme.h"

namespace limn::fast {

/// How a face touches the boundary: for each side, bit 0 says whether it is off the boundary, and
/// bit 1 the same of the vertex before it.
using RimPattern = std::vector<Index>;

struct DualRims {
  /// How many steps the rule looks, at most. Fine points nearer than 2 · reach to a side of the
  /// mesh (or to the face's centre along it) are in strips (zones); patches must have as many old
  /// points a side.
  Index reach = 0;
  /// Fine points along a side, by how deep they lie (0 … 2 · reach - 1) and parity: number 2·depth
  /// + T mod 2. The first axis runs along the side, the second out of the mesh, the anchor is
  /// (⌊T/2⌋, ⌊-depth/2⌋).
  std::vector<Stencil> strip;
  /// The same where the mesh is two points wide: depths 0 and 1.
  std::vector<Stencil> narrow;
  /// By pattern, turned so that it is the least of its turns; sector 0 at its first side.
  std::map<RimPattern, DualZone> zones;
};

/// The tables that `control` needs. Fails as read_dual_tables does.
[[nodiscard]] Result<DualRims> read_dual_rims(const Scheme& scheme, const Mesh& control,
                                              Index reach);

/// Rows for the points along sides of the mesh, from the `from`-th fine point of a line to the one
/// before as many are left: by `strip`, or where the mesh is two points wide by `narrow`
/// (DualRims).
void add_dual_lines(const std::vector<Stencil>& strip, const std::vector<Stencil>& narrow,
                    Index from, const DualLayout& coarse, const DualLayout& fine,
                    std::vector<RowPlan>& rows);

/// Rows for the points of one step. coarse.n() is at least 2 · reach.
void add_dual_rims(const DualRims& rims, const DualLayout& coarse, const DualLayout& fine,
                   std::vector<RowPlan>& rows);

}  // namespace limn::fast
