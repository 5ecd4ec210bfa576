#pragma once
/// Points near the boundary of a mesh that recedes (dual splits). Each edge off the boundary that
/// ends there leads from centre to centre of its faces, along a straight side of the mesh with rows
/// of points, and round the centre of a face at the boundary points need a table, for each way in
/// which the face may touch the boundary.

#include <map>
#include <set>

#include "limn/fast/limit/limit_forms.h"
#include "limn/fast/sites/stencil_tables.h"

namespace limn::fast {

struct RimTables {
  /// Points nearer than the `near`-th to a face's centre are in its zone, those nearer than that to
  /// a side of the mesh in rows. Patches must have as many old points a side.
  Index near = 0;
  /// Rows along a side, y < 0 for the points outside of it; and where the mesh is two points wide.
  std::vector<SideRow> wide, narrow;
  /// By pattern, turned so that it is the least of its turns; sector 0 at its first side.
  std::map<RimPattern, ZoneTable> zones;
};

/// Of new points. Fails where a rule is missing.
[[nodiscard]] Result<RimTables> read_rims(const Scheme& scheme, const GridCycle& cycle,
                                          const std::set<RimPattern>& patterns, const Reach& reach);

/// Of the limit surface, after so many steps, where a vertex's sums are over its own faces; else
/// nothing. Fails as `reader`.
[[nodiscard]] Result<std::optional<RimTables>> read_limit_rims(const Split& split,
                                                               const GridCycle& cycle,
                                                               const std::set<RimPattern>& patterns,
                                                               int steps_made, LimitReader& reader);

}  // namespace limn::fast
