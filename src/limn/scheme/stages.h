#pragma once
/// Schemes whose step is a sequence of averagings; private to scheme/.

#include "limn/scheme/scheme.h"

namespace limn::scheme {

/// The words of [stages] in scheme files: what is done first, and what then.
inline constexpr std::string_view kBilinear = "bilinear", kLinear = "linear", kAverage = "average";

/// The walk of a role of Stages::pair, by its name: one of kPairRoles.
[[nodiscard]] Walk pair_walk(std::string_view role);

/// The split that follows from them, once they are counted.
[[nodiscard]] const Split* split_of_stages(const Stages& stages);

/// Meshes are to have faces of that lattice alone: q, the number of quads at a vertex, becomes a
/// let, 0 or n. The split is not set. Precondition: scheme.stages, of a linear cut.
void restrict_stages(Scheme& scheme, Lattice lattice);

/// Counts the averagings at the scheme's present parameters, which must lie in their ranges, and
/// sets the split that follows.
/// Fails, at the formula, where it has no value or is no integer in 0 … kMostAveragings, of a
/// linear cut no even one. Precondition: scheme.stages.
[[nodiscard]] Status settle_stages(Scheme& scheme);

}  // namespace limn::scheme
