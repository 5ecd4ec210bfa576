#include "limn/search/kept_search.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "limn/base/budget.h"

namespace limn::search {

KeptSearch::KeptSearch(const Study& study, Store& store, Search search)
    : study_(study), store_(store), search_(std::move(search)), start_(steady_seconds()) {
  progress_.most = study.method.points;
}

Result<std::unique_ptr<KeptSearch>> KeptSearch::begin(const Study& study, Store& store) {
  Result<Search> search = Search::begin(study);
  if (!search) return search.error();
  return std::unique_ptr<KeptSearch>(new KeptSearch(study, store, *std::move(search)));
}

bool KeptSearch::next() {
  const Generation generation = search_.next();
  points_.clear();
  known_.assign(generation.points.size(), false);
  if (generation.points.empty()) {
    run_.finished = true;
    return false;
  }
  progress_.generation = generation.number;
  for (std::size_t i = 0; i < generation.points.size(); ++i) {
    points_.push_back({generation.number, static_cast<int>(i), generation.points[i], {}});
    const Outcome* found = store_.find(point_key(generation.points[i]));
    if (found == nullptr) continue;
    points_[i].outcome = *found;
    known_[i] = true;
    note(*found);
  }
  return true;
}

std::vector<std::size_t> KeptSearch::missing() const {
  const std::scoped_lock lock(mutex_);
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < known_.size(); ++i)
    if (!known_[i]) places.push_back(i);
  return places;
}

void KeptSearch::note(const Outcome& outcome) {
  ++progress_.done;
  progress_.feasible += outcome.feasible ? 1 : 0;
  progress_.most = std::max(study_.method.points, progress_.done);
  const double each = run_.evaluated > 0
                          ? (steady_seconds() - start_) / static_cast<double>(run_.evaluated)
                          : std::numeric_limits<double>::infinity();
  progress_.seconds_left = each * static_cast<double>(progress_.most - progress_.done);
}

Status KeptSearch::keep(std::size_t place, const Outcome& outcome) {
  Evaluated& one = points_[place];
  one.outcome = outcome;
  if (Status kept = store_.add(one); !kept) return kept;
  const std::scoped_lock lock(mutex_);
  known_[place] = true;
  ++run_.evaluated;
  note(outcome);
  return Done{};
}

void KeptSearch::tell() {
  std::vector<Outcome> outcomes;
  for (const Evaluated& one : points_) outcomes.push_back(one.outcome);
  move_known();
  search_.tell(outcomes);
}

void KeptSearch::move_known() {
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (known_[i]) run_.points.push_back(std::move(points_[i]));
  points_.clear();
  known_.clear();
}

StudyProgress KeptSearch::progress() const {
  const std::scoped_lock lock(mutex_);
  return progress_;
}

StudyRun KeptSearch::end() && {
  move_known();
  return std::move(run_);
}

}  // namespace limn::search
