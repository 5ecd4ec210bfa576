#pragma once
/// Values of several freed names at which several requirements hold at once.
///
/// Equations are solved by Newton's method with exact Jacobians (spectrum/block_slopes.h), damped,
/// from the scheme's own numbers and from points spread evenly over the ranges. With fewer
/// equations than names each step is the least one, so that of the many solutions one near the
/// scheme's own numbers is found. The other requirements, inequalities and verdicts, are then asked
/// of each solution. What uses a component that a valence does not have (a saddle at 3) is left out
/// there. That there is none, or no further one, is found by so many starts, not proved.

#include <optional>
#include <string>
#include <vector>

#include "limn/base/budget.h"
#include "limn/tune/freed_names.h"
#include "limn/tune/freed_scheme.h"
#include "limn/tune/solve.h"

namespace limn::tune {

/// Values of the freed names, in their order.
struct SystemSolution {
  std::vector<double> values;
  double residual = 0;  ///< the largest |left - right| of the equations
  /// Fractions that together solve as well as `values` do; nothing where one is not recognised.
  std::vector<std::optional<Rational>> rationals;
  Truth holds = Truth::undecided;  ///< all requirements, the labels as they are at `values`
  std::string reason;              ///< why not
  Eigencomponents found;           ///< at `values`
};

/// What `solve_system_at` finds at one valence.
struct SystemSolutions {
  int valence = 0;
  std::vector<Interval> searched;  ///< by name
  int starts = 0;                  ///< from which Newton's method began
  /// By their distance from the scheme's own numbers, in units of the ranges, if these are in them;
  /// else ascending. With fewer equations than names at most one.
  std::vector<SystemSolution> solutions;
  std::string reason;       ///< why there is no solution: nothing where there is one
  bool time_ended = false;  ///< nothing above is complete
};

/// Equations first, as many as names or fewer; the others after them. Fails where there is no
/// equation, more of them than names, or an empty range. Cost: some dozens of starts of up to 60
/// steps, each an eigenvalue problem and its eigenvectors for each frequency that is used.
/// `ranges`: one for each name, nullptr where none is stated.
[[nodiscard]] Result<SystemSolutions> solve_system_at(FreedNames& names,
                                                      const std::vector<Requirement>& requirements,
                                                      int n,
                                                      const std::vector<const SearchRange*>& ranges,
                                                      const Stop& stop = {});

}  // namespace limn::tune
