#pragma once
/// What a study found, as text, JSON, tables and a figure: `limn study`.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "limn/figure/figure.h"
#include "limn/report/data_table.h"
#include "limn/search/run_study.h"

namespace limn::report {

/// A scheme drawn beside what was found.
struct LandmarkOutcome {
  std::string label;
  search::Outcome outcome;
};

/// What a report is made of.
struct StudyResult {
  const search::Study& study;
  const search::StudyRun& run;
  std::vector<std::size_t> best = {};  ///< best_points of run.points
  std::vector<LandmarkOutcome> landmarks = {};
};

/// Points as a table: generation, place, the coordinates as fractions, feasible, the objectives,
/// the demands, the violation and the reason; without times, so that it is the same in every run.
[[nodiscard]] DescribedTable study_table(const search::Study& study,
                                         const std::vector<search::Evaluated>& points);
/// The front, or the optimum: the same table of the best points, in their order.
[[nodiscard]] DescribedTable front_table(const StudyResult& result);

/// Objectives against one another, each point a mark, the front a line, other schemes with their
/// names; with one objective, the best value against the number of points.
[[nodiscard]] figure::Figure study_figure(const StudyResult& result);

/// A paragraph: how many points, how many feasible, and the best ones, at most `most` of them.
[[nodiscard]] std::string study_text(const StudyResult& result, std::size_t most = 12);
/// {"study", "scheme", "method", "points", "feasible", "evaluated", "finished", "objectives":
/// [{"value", "goal"}], "best": [{"coordinates": {label: fraction}, "objectives": [numbers]}],
/// "compare": [{"label", "feasible", "objectives", "reason"}]}.
[[nodiscard]] nlohmann::ordered_json study_json(const StudyResult& result);

/// The table of quantities, for people.
[[nodiscard]] std::string quantities_text();
[[nodiscard]] nlohmann::ordered_json quantities_json();

}  // namespace limn::report
