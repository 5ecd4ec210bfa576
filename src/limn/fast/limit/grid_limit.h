#pragma once
/// The limit surface at the vertices of a level of grids (grid_layout.h), as a plan (step_plan.h).

#include "limn/fast/limit/limit_tables.h"
#include "limn/fast/sites/zones.h"

namespace limn::fast {

/// What does not depend on the level.
struct GridControl {
  const Split& split;
  const GridCycle& cycle;
  const Mesh& mesh;                      ///< whose faces are the patches
  const std::vector<ZoneGroup>& groups;  ///< all vertices
  const std::vector<Index>& sides;       ///< boundary half-edges
  const PatchTopology& faces;
};

/// At the level that `level` steps make of the mesh, and `steps_made` of the control mesh. Nothing
/// where the sums are of no use or take more than the level's grid has. Fails as `reader`.
[[nodiscard]] Result<std::optional<StepPlan>> plan_grid_limit(const GridControl& control, int level,
                                                              int steps_made, LimitReader& reader);

}  // namespace limn::fast
