#pragma once
/// The limit surface at the vertices of a level of kites (kites.h), as a plan (step_plan.h).

#include "limn/fast/limit/limit_tables.h"
#include "limn/fast/limit/one_ring.h"
#include "limn/fast/sites/kite_rows.h"

namespace limn::fast {

/// What does not depend on the level.
struct KiteControl {
  const Split& split;
  const GridCycle& cycle;
  const KiteGroups& groups;
  bool own_face = false;  ///< whether the rule sees its own face alone
};

/// At level `level`, whose layout this is. Nothing where read_limit_tables finds nothing, and at a
/// boundary where the rule or the sums look beyond a vertex's own faces: of such rules no limit
/// points are known there. Fails as `reader`.
[[nodiscard]] Result<std::optional<StepPlan>> plan_kite_limit(const KiteControl& control,
                                                              const KiteLayout& at, int level,
                                                              LimitReader& reader);

}  // namespace limn::fast
