#pragma once
/// What a sequence of values, one for each level of refinement, tends to.

#include <vector>

#include "limn/base/truth.h"

namespace limn::fairness {

struct Trend {
  /// Whether the values tend to a limit, judged by how the last changes follow each other. Samples
  /// prove nothing: "no" means that the changes do not shrink, as far as levels go.
  Truth converges = Truth::undecided;
  /// |change| / |change before|. Taken over two levels (the larger of the last two changes against
  /// that of the two before, if there are so many), so that changes which alternate, as those of
  /// the boundary under sqrt3, do not upset it. NaN with fewer than four values, or where changes
  /// vanish.
  double ratio;
  /// Where they converge: what a geometric series of changes comes to. Else NaN.
  double limit;
};

/// Changes shrink at a ratio up to kConvergent, and the last is less than the one before: the
/// values converge. From kDivergent on, with all of the last three changes upwards: they do not (1
/// is a logarithm: as much more at every level). Between: undecided; so are fewer than four values.
/// Changes below 1e-9 of the value, or below `negligible`, are no changes: then the last value is
/// the limit.
inline constexpr double kConvergent = 0.75;
inline constexpr double kDivergent = 0.95;
[[nodiscard]] Trend trend_of(const std::vector<double>& values, double negligible = 0);

}  // namespace limn::fairness
