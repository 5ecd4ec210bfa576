#pragma once
/// The plans of dual steps: which points of a level are made from which of the one before.

#include "limn/fast/sites/kite_rows.h"

namespace limn::fast {

struct KiteTables {
  StencilTables interior;  ///< stars by number of sides, 4 among them
  RimTables rims;          ///< where there is a boundary
  /// Whether the rule sees its own face alone. Then it may stand in the first step, too.
  [[nodiscard]] bool own_face() const { return interior.reach.rim == 1; }
};

/// The tables that steps on these kites need. Fails as read_stencils.
[[nodiscard]] Result<KiteTables> read_kite_tables(const Scheme& scheme, const GridCycle& cycle,
                                                  const Kites& kites, const KiteGroups& groups);

/// From the control mesh to level 1 (kites.h). Precondition: tables.own_face().
[[nodiscard]] StepPlan plan_first_kite_step(const Kites& kites, const KiteTables& tables);

/// From the level of n points along a patch's side to the next. Precondition: patches are as large
/// as the tables' reach asks for.
[[nodiscard]] StepPlan plan_kite_step(const Kites& kites, const KiteGroups& groups,
                                      const GridCycle& cycle, const KiteTables& tables, Index n);

}  // namespace limn::fast
