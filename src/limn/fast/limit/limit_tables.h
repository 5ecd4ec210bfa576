#pragma once
/// The sums of the limit surface at the vertices of a level of patches (lattice_step.h), whatever
/// their number.
///
/// How far a vertex or a boundary is felt is not derived from the rules but read: on a site of each
/// kind, sums are compared with those of a regular vertex, or along boundary sides with those of a
/// straight boundary, and what differs is its zone.

#include "limn/fast/limit/limit_forms.h"
#include "limn/fast/limit/limit_sums.h"
#include "limn/fast/sites/stencil_tables.h"

namespace limn::fast {

/// What does not depend on the level.
struct LimitControl {
  const Split& split;
  const GridCycle& cycle;
  std::vector<StarShape> kinds;  ///< of places where patches meet; isolated ones have no sector
  bool boundary = false;         ///< whether sides of patches are on the boundary
  bool lone = false;             ///< whether all sides of one are
};

/// At the level that `level` steps of the cycle make of the patches, and `steps_made` of the
/// control mesh. Nothing where the sums are of no use or take more than the level's grid has. Fails
/// as `reader`.
[[nodiscard]] Result<std::optional<StencilTables>> read_limit_tables(const LimitControl& control,
                                                                     int level, int steps_made,
                                                                     LimitReader& reader);

}  // namespace limn::fast
