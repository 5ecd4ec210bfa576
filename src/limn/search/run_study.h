#pragma once
/// A study run on this machine: its generations one after the other, the points of each on all
/// threads.

#include <functional>

#include "limn/base/budget.h"
#include "limn/search/kept_search.h"

namespace limn::search {

struct StudyOptions {
  Stop stop = {};  ///< asked before each point; what is in hand is finished and kept
  std::function<void(const StudyProgress&)> progress = {};  ///< from any thread, one at a time
};

/// Runs or resumes. A point that the store has is not evaluated again; each new one is there before
/// it counts. The same points in every run that finishes, on any number of threads, however often
/// it was interrupted. Fails as Search::begin and Store::add do.
[[nodiscard]] Result<StudyRun> run_study(const Study& study, Store& store,
                                         const StudyOptions& options = {});

/// What a study will cost.
struct StudyForecast {
  long long points = 0;     ///< at most
  double seconds_each = 0;  ///< the mean of `measured` points, on one thread
  int measured = 0;         ///< of the first generation
  double seconds = 0;       ///< at most, on so many threads
  int threads = 1;
};
/// Evaluates up to `sample` points, spread over the first generation, and keeps nothing.
[[nodiscard]] Result<StudyForecast> forecast_study(const Study& study, int sample = 8);

}  // namespace limn::search
