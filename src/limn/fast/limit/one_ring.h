#pragma once
/// The limit surface at the vertices of any mesh where sums look no farther than the faces round a
/// vertex, its one-ring: rows alone, read once for each sequence of the faces' degrees.

#include <optional>
#include <span>

#include "limn/fast/families/family.h"

namespace limn::fast {

/// At a level of any polygons that `level` steps made, whose vertex v has the number numbers[v], or
/// v where none are given. Nothing where the sums look farther, a vertex has no normal of two sums,
/// an interior one valence 2, or one a valence beyond kLargestTable (stencil_tables.h). Fails as
/// the reader. Cost: some 0.1 ms for each sequence.
[[nodiscard]] Result<std::optional<StepPlan>> plan_one_rings(const Mesh& mesh,
                                                             std::span<const Index> numbers,
                                                             int level, LimitReader& reader);

}  // namespace limn::fast
