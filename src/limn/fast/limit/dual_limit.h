#pragma once
/// The limit surface at the vertices of dual levels (family.h) where the rule sees its own face
/// alone: a vertex goes to the centre of its face after one step (at the boundary, of the middle
/// one of its faces, or of the face between the middle two), so its sums are over the faces round
/// it. Those of regular vertices are the patches' stencils; the rows of all others are read on
/// these faces by themselves, once for each sequence of their degrees.
///
/// Both give nothing where the sums look beyond these faces, or a vertex has no normal of two sums.
/// Fails as the reader. Cost: some 0.1 ms for each sequence.

#include <optional>

#include "limn/fast/families/family.h"
#include "limn/fast/layout/dual_layout.h"

namespace limn::fast {

/// At level `level`, whose layout this is.
[[nodiscard]] Result<std::optional<StepPlan>> plan_dual_limit(const DualLayout& at, int level,
                                                              LimitReader& reader);

/// At the vertices of any mesh, rows alone. Nothing where an interior vertex has valence 2, or one
/// a valence beyond kLargestDualTable (dual_tables.h).
[[nodiscard]] Result<std::optional<StepPlan>> plan_control_dual_limit(const Mesh& mesh, int level,
                                                                      LimitReader& reader);

}  // namespace limn::fast
