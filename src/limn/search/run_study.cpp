#include "limn/search/run_study.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <optional>
#include <thread>

#include "limn/base/parallel.h"

namespace limn {
namespace {

/// One run: what is shared by the threads of a generation.
class Runner {
 public:
  Runner(const Study& study, Store& store, const StudyOptions& options)
      : study_(study), store_(store), options_(options), start_(steady_seconds()) {}

  Result<StudyRun> run();

 private:
  /// All outcomes of a generation; nothing where it was stopped.
  Result<std::optional<std::vector<Outcome>>> outcomes_of(const Generation& generation);
  void evaluate(Evaluated& one, std::optional<Outcome>& outcome);
  void note(const Outcome& outcome, int generation);

  const Study& study_;
  Store& store_;
  const StudyOptions& options_;
  double start_;
  StudyRun run_;
  StudyProgress progress_;
  std::mutex mutex_;
  std::optional<Error> failure_;
};

void Runner::note(const Outcome& outcome, int generation) {
  progress_.generation = generation;
  ++progress_.done;
  progress_.feasible += outcome.feasible ? 1 : 0;
  progress_.most = std::max(study_.method.points, progress_.done);
  const double each = run_.evaluated > 0
                          ? (steady_seconds() - start_) / static_cast<double>(run_.evaluated)
                          : std::numeric_limits<double>::infinity();
  progress_.seconds_left = each * static_cast<double>(progress_.most - progress_.done);
  if (options_.progress) options_.progress(progress_);
}

void Runner::evaluate(Evaluated& one, std::optional<Outcome>& outcome) {
  if (asked(options_.stop)) return;
  {
    const std::scoped_lock lock(mutex_);
    if (failure_) return;
  }
  one.outcome = evaluate_point(study_, one.point);
  const Status kept = store_.add(one);
  const std::scoped_lock lock(mutex_);
  if (!kept) {
    failure_ = kept.error();
    return;
  }
  outcome = one.outcome;
  ++run_.evaluated;
  note(one.outcome, one.generation);
}

Result<std::optional<std::vector<Outcome>>> Runner::outcomes_of(const Generation& generation) {
  const std::size_t count = generation.points.size();
  std::vector<std::optional<Outcome>> outcomes(count);
  std::vector<Evaluated> points(count);
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < count; ++i) {
    points[i] = {generation.number, static_cast<int>(i), generation.points[i], {}};
    if (const Outcome* known = store_.find(point_key(points[i].point))) {
      points[i].outcome = *known;
      outcomes[i] = *known;
      note(*known, generation.number);
    } else {
      missing.push_back(i);
    }
  }
  parallel_for<std::size_t>(
      0, missing.size(),
      [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
          evaluate(points[missing[i]], outcomes[missing[i]]);
      },
      1);
  if (failure_) return *failure_;
  std::vector<Outcome> all;
  for (std::size_t i = 0; i < count; ++i) {
    if (!outcomes[i]) continue;
    all.push_back(*outcomes[i]);
    run_.points.push_back(std::move(points[i]));
  }
  if (all.size() < count) return std::optional<std::vector<Outcome>>();
  return std::optional(std::move(all));
}

Result<StudyRun> Runner::run() {
  Result<Search> search = Search::begin(study_);
  if (!search) return search.error();
  for (Generation next = search->next(); !next.points.empty(); next = search->next()) {
    const Result<std::optional<std::vector<Outcome>>> outcomes = outcomes_of(next);
    if (!outcomes) return outcomes.error();
    if (!*outcomes) return std::move(run_);
    search->tell(**outcomes);
  }
  run_.finished = true;
  return std::move(run_);
}

}  // namespace

Result<StudyRun> run_study(const Study& study, Store& store, const StudyOptions& options) {
  return Runner(study, store, options).run();
}

Result<StudyForecast> forecast_study(const Study& study, int sample) {
  Result<Search> search = Search::begin(study);
  if (!search) return search.error();
  const Generation first = search->next();
  StudyForecast forecast;
  forecast.points = study.method.points;
  const auto machine = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1U));
  forecast.threads = thread_limit() > 0 ? std::min(thread_limit(), machine) : machine;
  const std::size_t count =
      std::min(first.points.size(), static_cast<std::size_t>(std::max(sample, 1)));
  for (std::size_t i = 0; i < count; ++i)
    forecast.seconds_each +=
        evaluate_point(study, first.points[i * first.points.size() / count]).seconds;
  forecast.measured = static_cast<int>(count);
  if (count > 0) forecast.seconds_each /= static_cast<double>(count);
  forecast.seconds =
      forecast.seconds_each * static_cast<double>(forecast.points) / forecast.threads;
  return forecast;
}

}  // namespace limn
