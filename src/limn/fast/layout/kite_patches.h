#pragma once
/// What whole patches (kites.h) read and make.

#include <optional>

#include "limn/fast/kernel/step_plan.h"
#include "limn/fast/layout/kites.h"

namespace limn::fast {

/// The whole patches of `old`, with one run each, which begins at the patch's first point of
/// `made`. Places are (x, y). Where a stencil looks beyond both sides at a centre of other than
/// four patches, or beyond a rim's arm, the point is to be overwritten. Nothing where one looks
/// past the next patch.
[[nodiscard]] std::optional<PatchPlan> plan_kite_patches(const KiteLayout& old,
                                                         const KiteLayout& made,
                                                         std::vector<FinePoint> points,
                                                         std::vector<Stencil> stencils);

}  // namespace limn::fast
