#pragma once
/// Norms of difference schemes: how much, at most, k steps enlarge the differences of an order
/// [DynLevin2002 §4].

#include <optional>
#include <vector>

#include "limn/base/budget.h"
#include "limn/scheme/mask.h"

namespace limn::regular {

/// For k = 1 … most_steps an upper bound, rounded up, of the least c with
///   max |D' S^k f| ≤ c · max |D f|,
/// D' and D over all products of `order` differences along the lattice's edges, of the refined and
/// of the control data. It is the ∞-norm of k steps of the difference scheme, the one with the
/// least norm where several belong to one mask; a linear program for each kind of refined
/// difference. Precondition: sum rules of that order. Ends early: with the first c below
/// `enough`^k, before a k that would cost more than some seconds, and where `stop` asks for it.
[[nodiscard]] std::vector<double> difference_norms(const Mask& mask, int order, int most_steps,
                                                   double enough, const Stop& stop = {});

/// The least k ≤ most_steps for which k steps of the differences of an order have a norm, in the
/// sense above, of at most |det M|^{-order·k/2}, in exact rationals: then differences over h^order
/// are bounded at every level. Steps for which the bound is irrational are passed over. Of the
/// differences those are taken in which no direction occurs more than `most_alike` times: as long
/// as they span, they bound all, and box splines, whose own directions are repeated a few times,
/// have the bound for these alone. Nothing where no such k was found, or would cost more than a
/// second. Precondition: sum rules of that order.
[[nodiscard]] std::optional<int> steps_that_bound_differences(const Mask& mask, int order,
                                                              int most_alike, int most_steps,
                                                              const Stop& stop = {});

}  // namespace limn::regular
