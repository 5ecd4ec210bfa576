#pragma once
/// A search whose outcomes are kept in a store. Whoever evaluates, the store has the same points at
/// the end: threads of this process (run_study.h), or processes on many machines.
///
///     while (search.next()) {
///       for (const std::size_t i : search.missing())      // in any order, at once
///         if (Status s = search.keep(i, evaluate_point(study, search.point(i))); !s) return s;
///       search.tell();
///     }
///     StudyRun run = std::move(search).end();

#include <mutex>
#include <optional>
#include <vector>

#include "limn/search/search.h"
#include "limn/search/store.h"

namespace limn::search {

/// Where a run stands.
struct StudyProgress {
  int generation = 0;
  long long done = 0;       ///< points, those of earlier runs among them
  long long most = 0;       ///< points that there will be at most
  long long feasible = 0;   ///< of those that are done
  double seconds_left = 0;  ///< an estimate; infinite while nothing was measured
};

struct StudyRun {
  std::vector<Evaluated> points;  ///< by generation and place, whole generations and the last part
  bool finished = false;          ///< false: it was stopped
  long long evaluated = 0;        ///< in this run; the others were in the store
};

class KeptSearch {
 public:
  /// Both must outlive it. Fails as Search::begin does.
  [[nodiscard]] static Result<std::unique_ptr<KeptSearch>> begin(const Study& study, Store& store);

  /// Goes on to the next generation; false: there is none, the search is finished.
  [[nodiscard]] bool next();
  [[nodiscard]] int generation() const { return progress_.generation; }
  /// Places in the generation, from 0, whose outcomes are not known yet, ascending.
  [[nodiscard]] std::vector<std::size_t> missing() const;
  [[nodiscard]] const Point& point(std::size_t place) const { return points_[place].point; }
  /// What was found at a place that is missing: in the store before it counts. From several threads
  /// at once. Fails as Store::add does.
  [[nodiscard]] Status keep(std::size_t place, const Outcome& outcome);
  /// The generation is done. Precondition: nothing is missing.
  void tell();

  /// Where it stands. From several threads at once.
  [[nodiscard]] StudyProgress progress() const;
  /// What there is, at any moment; then nothing else may be called.
  [[nodiscard]] StudyRun end() &&;

 private:
  KeptSearch(const Study& study, Store& store, Search search);
  void note(const Outcome& outcome);
  void move_known();

  const Study& study_;
  Store& store_;
  Search search_;
  double start_;
  std::vector<Evaluated> points_;  // of the generation
  std::vector<bool> known_;        // which of them have outcomes
  StudyRun run_;
  StudyProgress progress_;
  mutable std::mutex mutex_;  // guards known_, run_ and progress_ while points are evaluated
};

}  // namespace limn::search
