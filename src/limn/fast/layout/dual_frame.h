#pragma once
/// What whole patches (dual_layout.h) read of their neighbours.

#include "limn/fast/kernel/step_plan.h"
#include "limn/fast/layout/dual_layout.h"

namespace limn::fast {

/// The whole patches of `old`, each with so many rows beyond its sides, and one run each, which
/// begins at the patch's first point of `fresh`; without the run's points and their stencils.
/// Places are (x, y). What is beyond both sides at a centre is of use only where four patches meet
/// there, beyond a rim's arm only in the row next to the patch. Precondition: halo ≤ old.n().
[[nodiscard]] PatchPlan frame_dual_patches(const DualLayout& old, const DualLayout& fresh,
                                           Index halo);

/// The limit surface at all points of whole patches by three stencils (step_plan.h), which reach
/// `halo` rows beyond.
[[nodiscard]] PatchPlan plan_dual_limit_patches(const DualLayout& at, Index halo,
                                                std::vector<Stencil> stencils);

}  // namespace limn::fast
