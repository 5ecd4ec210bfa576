#pragma once
/// The limit surface at the vertices of dual levels (family.h) of closed meshes, however far the
/// rule looks: regular vertices have the patches' stencils, those near a centre that has not four
/// sides rows of a table by its sides. How far stencils and zones go is found by reading more than
/// they need. (Of a rule that looks beyond its face no limit points are known at the boundary.)

#include <optional>

#include "limn/fast/families/family.h"
#include "limn/fast/layout/dual_layout.h"

namespace limn::fast {

/// At level `level`, whose layout this is. Precondition: no boundary. Nothing where the patches are
/// smaller than the stencils reach, or than two zones side by side, or a vertex has no normal of
/// two sums. Fails as the reader. Cost: some ms for each number of sides.
[[nodiscard]] Result<std::optional<StepPlan>> plan_wide_dual_limit(const DualLayout& at, int level,
                                                                   LimitReader& reader);

}  // namespace limn::fast
