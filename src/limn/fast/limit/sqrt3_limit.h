#pragma once
/// The limit surface at the vertices of a level of √3 grids, as a plan (step_plan.h).
///
/// How far a vertex is felt is not derived from the rules but read: on a star or fan of each kind,
/// sums are compared with those of a regular vertex, or along boundary sides with those of a
/// straight boundary, and what differs is its zone.

#include "limn/fast/families/family.h"
#include "limn/fast/layout/triangle_frame.h"
#include "limn/fast/sites/zones.h"

namespace limn::fast {

/// What does not depend on the level.
struct Sqrt3Control {
  const Mesh& mesh;
  const Split& split;
  const std::vector<ZoneGroup>& groups;  ///< all vertices
  const std::vector<Index>& sides;       ///< boundary half-edges
  const HugeArray<TriangleTopology>& faces;
};

/// Nothing where zones of control vertices come too near one another, or a normal is not that of
/// two sums. Where sums look one ring far there is a plan at every level, but at level 1 not for
/// meshes with a triangle that is alone; where two or three, from level 3 or 4 on, with boundaries
/// from 4 or 5. Fails as `reader`; at levels 0 and 1 it has nothing instead. Cost: some ms for each
/// valence, most of it the reader's.
[[nodiscard]] Result<std::optional<StepPlan>> plan_sqrt3_limit(const Sqrt3Control& control,
                                                               int level, LimitReader& reader);

}  // namespace limn::fast
