#pragma once
/// Where an equation's branches vanish along a range. Private to tune/.

#include <optional>
#include <vector>

#include "limn/base/budget.h"
#include "limn/tune/branches.h"

namespace limn::tune {

/// A root of one branch, named by the eigenvalue that it has there.
struct Root {
  double x = 0;
  Eigenvalue eigenvalue;
  bool is_double = false;  ///< the branch touches 0 and does not cross it
};

struct RootsFound {
  bool any_value = false;  ///< whether the equation has a value at any sample
  std::vector<Root> roots;
  std::vector<Interval> throughout;  ///< where several samples in a row satisfy the labels
  std::optional<Branch> nearest;     ///< the branch that came nearest to 0 …
  double nearest_x = 0;              ///< … and where
};

/// By `samples` ≥ 3 even samples, bisection and least distances. A branch that is 0 all along a
/// stretch has no roots there. Where `stop` says so, what was found until then.
[[nodiscard]] RootsFound find_roots(const Requirement& requirement, FreedScheme& scheme,
                                    const BlockCurve& curve, Interval interval, int samples,
                                    const Stop& stop = {});

/// left - right at x of the labels themselves; nothing where it has no value.
[[nodiscard]] std::optional<double> labelled_difference(const Requirement& requirement,
                                                        FreedScheme& scheme,
                                                        const BlockCurve& curve, double x);

}  // namespace limn::tune
