#pragma once
/// A study's search, generation by generation: what to evaluate next, and what came of it. Whoever
/// evaluates (this process, or many on many machines) has the same results.
///
///     Result<Search> search = Search::begin(study);
///     for (Generation g = search->next(); !g.points.empty(); g = search->next()) {
///       std::vector<Outcome> outcomes;
///       for (const Point& p : g.points) outcomes.push_back(evaluate_point(study, p));
///       search->tell(outcomes);
///     }

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "limn/search/method.h"
#include "limn/search/point.h"

namespace limn::search {

/// Points that do not depend on one another's outcomes.
struct Generation {
  int number = 0;             ///< from 1
  std::vector<Point> points;  ///< different ones, none of an earlier generation; empty: the end
};

class Search {
 public:
  /// `study` must outlive the search. Fails as make_method does.
  [[nodiscard]] static Result<Search> begin(const Study& study);

  /// The next generation. The search ends with the generation that reaches the study's number of
  /// points, or when the method is done.
  [[nodiscard]] Generation next();
  /// The outcomes of its points, in order. After a failed or unfinished generation tell nothing:
  /// a search that begins anew asks the same again.
  void tell(const std::vector<Outcome>& outcomes);

  /// Points that were told so far.
  [[nodiscard]] long long told() const { return told_; }

 private:
  Search(const Study& study, std::unique_ptr<Method> method)
      : study_(&study), method_(std::move(method)) {}

  const Study* study_;
  std::unique_ptr<Method> method_;
  std::map<std::string, std::vector<double>> worth_;  // by point_key
  std::vector<std::string> asked_;                    // by the method, keys with repetitions
  std::vector<std::string> fresh_;                    // of those, what the generation has
  int generation_ = 0;
  long long told_ = 0;
};

}  // namespace limn::search
