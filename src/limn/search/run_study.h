#pragma once
/// A study run on this machine: its generations one after the other, the points of each on all
/// threads.

#include <functional>
#include <vector>

#include "limn/base/time_budget.h"
#include "limn/search/search.h"
#include "limn/search/store.h"

namespace limn {

/// Where a run stands.
struct StudyProgress {
  int generation = 0;
  long long done = 0;       ///< points, those of earlier runs among them
  long long most = 0;       ///< points that there will be at most
  long long feasible = 0;   ///< of those that are done
  double seconds_left = 0;  ///< an estimate; infinite while nothing was measured
};

struct StudyOptions {
  Stop stop = {};  ///< asked before each point; what is in hand is finished and kept
  std::function<void(const StudyProgress&)> progress = {};  ///< from any thread, one at a time
};

struct StudyRun {
  std::vector<Evaluated> points;  ///< by generation and place, whole generations and the last part
  bool finished = false;          ///< false: it was stopped
  long long evaluated = 0;        ///< in this run; the others were in the store
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

}  // namespace limn
