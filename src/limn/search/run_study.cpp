#include "limn/search/run_study.h"

#include <algorithm>
#include <mutex>
#include <optional>
#include <thread>

#include "limn/base/parallel.h"

namespace limn::search {
namespace {

/// The missing points of a generation on all threads. False: it was stopped before they were done.
Result<bool> evaluate_missing(const Study& study, KeptSearch& search, const StudyOptions& options) {
  const std::vector<std::size_t> missing = search.missing();
  std::mutex mutex;  // guards failure, and lets progress be told one at a time
  std::optional<Error> failure;
  base::parallel_for<std::size_t>(
      0, missing.size(),
      [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last && !asked(options.stop); ++i) {
          {
            const std::scoped_lock lock(mutex);
            if (failure) return;
          }
          const Status kept =
              search.keep(missing[i], evaluate_point(study, search.point(missing[i])));
          const std::scoped_lock lock(mutex);
          if (!kept)
            failure = kept.error();
          else if (options.progress)
            options.progress(search.progress());
        }
      },
      1);
  if (failure) return *failure;
  return search.missing().empty();
}

}  // namespace

Result<StudyRun> run_study(const Study& study, Store& store, const StudyOptions& options) {
  const Result<std::unique_ptr<KeptSearch>> search = KeptSearch::begin(study, store);
  if (!search) return search.error();
  while ((*search)->next()) {
    const Result<bool> done = evaluate_missing(study, **search, options);
    if (!done) return done.error();
    if (!*done) break;
    (*search)->tell();
  }
  return std::move(**search).end();
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

}  // namespace limn::search
