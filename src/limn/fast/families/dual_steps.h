#pragma once
/// The plans of dual steps: which points of a level are made from which of the one before.

#include "limn/fast/layout/dual_layout.h"
#include "limn/fast/sites/dual_tables.h"

namespace limn::fast {

/// From the control mesh to level 1 (dual_layout.h). Precondition: tables.own_face.
[[nodiscard]] StepPlan plan_first_dual_step(const DualCorners& corners, const DualTables& tables);

/// From the level of n points along a patch's side to the next. Precondition: n is at least
/// tables.smallest_grid.
[[nodiscard]] StepPlan plan_dual_step(const DualCorners& corners, const DualTables& tables,
                                      Index n);

}  // namespace limn::fast
