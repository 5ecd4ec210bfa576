#pragma once
/// The best points of a study: the optimum, or the Pareto front.

#include <vector>

#include "limn/search/store.h"

namespace limn::search {

/// Numbers of the feasible points that no other feasible point is as good as in every objective and
/// better in one; with one objective, those that reach the optimum. Of points with equal objectives
/// the first. Ascending by the first objective's fitness, then the next. Cost: n log n for one or
/// two objectives, n times the front for more.
[[nodiscard]] std::vector<std::size_t> best_points(const Study& study,
                                                   const std::vector<Evaluated>& points);

/// At most `count` of a front, spread evenly by arc length in units of the objectives' ranges, its
/// ends among them (count 1: the first).
[[nodiscard]] std::vector<std::size_t> spread(const Study& study,
                                              const std::vector<Evaluated>& points,
                                              const std::vector<std::size_t>& front,
                                              std::size_t count);

}  // namespace limn::search
