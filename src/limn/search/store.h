#pragma once
/// Where a study's points are kept: an SQLite file with one table of all points, for limn to resume
/// from and for users to query.
///
///     sqlite3 DIR/study.sqlite 'select * from points where feasible order by generation, place'

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "limn/search/point.h"

namespace limn::search {

/// A point, where the search asked for it, and what was found.
struct Evaluated {
  int generation = 0;  ///< from 1
  int place = 0;       ///< in the generation, from 0
  Point point;
  Outcome outcome;
};

class Store {
 public:
  /// Opens or makes the file, for this process alone. Fails where another process has it open,
  /// where it is of another study (restart: its points are thrown away instead), where it is no
  /// such file, and where limn was built without SQLite. Cost: that of reading all points.
  [[nodiscard]] static Result<Store> open(const std::string& path, const Study& study,
                                          bool restart = false);
  ~Store();
  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;

  /// What was found at a point in an earlier run, if it was evaluated.
  [[nodiscard]] const Outcome* find(const std::string& key) const;
  /// How many points were there when it was opened.
  [[nodiscard]] std::size_t size() const { return known_.size(); }
  /// Writes a point: once this returns it is there whatever happens to the process. From several
  /// threads at once. The same point a second time is refused, as an error. Cost: a millisecond.
  [[nodiscard]] Status add(const Evaluated& one);

 private:
  struct File;  // the database
  explicit Store(std::unique_ptr<File> file);
  [[nodiscard]] Status load(const Study& study);

  std::unique_ptr<File> file_;
  std::map<std::string, Outcome> known_;
};

}  // namespace limn::search
