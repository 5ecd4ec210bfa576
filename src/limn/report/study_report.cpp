#include "limn/report/study_report.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "limn/base/printable.h"
#include "limn/report/json_number.h"
#include "limn/search/front.h"

namespace limn::report {
namespace {

std::string goal_of(const search::Objective& objective) {
  return objective.maximise ? "max" : "min";
}

double number_of(const std::optional<double>& value) { return value.value_or(NAN); }

long long feasible_count(const search::StudyRun& run) {
  return std::count_if(run.points.begin(), run.points.end(),
                       [](const search::Evaluated& one) { return one.outcome.feasible; });
}

std::vector<Cell> row_of(const search::Evaluated& one) {
  const search::Outcome& outcome = one.outcome;
  std::vector<Cell> row{static_cast<double>(one.generation), static_cast<double>(one.place)};
  for (const Rational& value : one.point) row.emplace_back(to_string(value));
  row.emplace_back(outcome.feasible ? 1.0 : 0.0);
  for (const std::optional<double>& value : outcome.objectives) row.emplace_back(number_of(value));
  for (const std::optional<Truth>& truth : outcome.demands)
    row.emplace_back(truth ? std::string(to_string(*truth)) : std::string());
  row.emplace_back(outcome.violation);
  row.emplace_back(outcome.reason);
  return row;
}

std::string described_demand(const search::Demand& demand) {
  return demand.text + (demand.certified ? ", certified" : "");
}

std::string axis_label(const search::Objective& objective) {
  const std::string_view unit = objective.value.row().unit;
  return objective.value.text() + (unit.empty() ? "" : fmt::format(" [{}]", unit));
}

/// The points of a front, of two objectives.
struct Marks {
  std::vector<double> x, y;

  void add(const search::Outcome& outcome) {
    x.push_back(number_of(outcome.objectives[0]));
    y.push_back(number_of(outcome.objectives[1]));
  }
};

figure::ChartPanel front_panel(const StudyResult& result) {
  Marks others, front, named;
  std::vector<std::string> labels;
  std::vector<bool> is_best(result.run.points.size(), false);
  for (const std::size_t i : result.best) {
    is_best[i] = true;
    front.add(result.run.points[i].outcome);
  }
  for (std::size_t i = 0; i < result.run.points.size(); ++i)
    if (!is_best[i] && result.run.points[i].outcome.feasible)
      others.add(result.run.points[i].outcome);
  for (const LandmarkOutcome& one : result.landmarks) {
    const std::vector<std::optional<double>>& values = one.outcome.objectives;
    if (!values[0] || !values[1]) continue;
    named.add(one.outcome);
    labels.push_back(one.label + (one.outcome.feasible ? "" : " (fails)"));
  }
  figure::ChartPanel panel;
  panel.x_label = axis_label(result.study.objectives[0]);
  panel.y_label = axis_label(result.study.objectives[1]);
  panel.series.push_back({.name = "feasible points",
                          .x = std::move(others.x),
                          .y = std::move(others.y),
                          .markers = true,
                          .line = false,
                          .style = 0});
  panel.series.push_back({.name = "front",
                          .x = std::move(front.x),
                          .y = std::move(front.y),
                          .markers = true,
                          .line = false,
                          .style = 1});
  if (!labels.empty())
    panel.series.push_back({.name = "other schemes",
                            .x = std::move(named.x),
                            .y = std::move(named.y),
                            .markers = true,
                            .line = false,
                            .labels = std::move(labels),
                            .style = 2});
  return panel;
}

/// The best value after so many points.
figure::ChartPanel descent_panel(const StudyResult& result) {
  const search::Objective& objective = result.study.objectives[0];
  figure::ChartPanel::Series series{.name = "best so far", .style = 1};
  std::optional<double> best;
  for (std::size_t i = 0; i < result.run.points.size(); ++i) {
    const search::Outcome& outcome = result.run.points[i].outcome;
    if (outcome.feasible) {
      const double value = *outcome.objectives[0];
      if (!best || (objective.maximise ? value > *best : value < *best)) best = value;
    }
    if (!best) continue;
    series.x.push_back(static_cast<double>(i + 1));
    series.y.push_back(*best);
  }
  figure::ChartPanel panel;
  panel.x_label = "points";
  panel.y_label = axis_label(objective);
  panel.series.push_back(std::move(series));
  return panel;
}

std::string caption_of(const StudyResult& result) {
  const search::Study& study = result.study;
  return fmt::format("{} points, {} of them feasible, {} on the front; {}.",
                     result.run.points.size(), feasible_count(result.run), result.best.size(),
                     search::to_string(study.method.kind));
}

std::string point_line(const search::Study& study, const search::Evaluated& one) {
  std::string line = " ";
  for (std::size_t i = 0; i < study.objectives.size(); ++i)
    line += fmt::format(" {} = {:.6g}", study.objectives[i].value.text(),
                        number_of(one.outcome.objectives[i]));
  line += "  at";
  for (std::size_t i = 0; i < study.coordinates.size(); ++i)
    line += fmt::format(" {} = {:.6g}", study.coordinates[i].label(), to_double(one.point[i]));
  return base::printable(line) + "\n";
}

}  // namespace

DescribedTable study_table(const search::Study& study,
                           const std::vector<search::Evaluated>& points) {
  DescribedTable table;
  table.columns = {{"generation", "in which it was asked for"}, {"place", "in the generation"}};
  for (const search::Coordinate& one : study.coordinates)
    table.columns.push_back({one.label(), one.valence ? "exactly, at this valence" : "exactly"});
  table.columns.push_back({"feasible", "1: all that is demanded holds"});
  for (const search::Objective& one : study.objectives)
    table.columns.push_back({one.value.text(), std::string(one.value.row().meaning)});
  for (const search::Demand& one : study.demands)
    table.columns.push_back({described_demand(one), "whether it holds"});
  table.columns.push_back({"violation", "how far from feasible"});
  table.columns.push_back({"reason", "why it is not"});
  for (const search::Evaluated& one : points) table.rows.push_back(row_of(one));
  return table;
}

DescribedTable front_table(const StudyResult& result) {
  std::vector<search::Evaluated> front;
  for (const std::size_t i : result.best) front.push_back(result.run.points[i]);
  return study_table(result.study, front);
}

figure::Figure study_figure(const StudyResult& result) {
  figure::Figure figure(1);
  if (!result.study.title.empty()) figure.title(result.study.title);
  figure.add(result.study.objectives.size() > 1 ? front_panel(result) : descent_panel(result),
             caption_of(result));
  return figure;
}

std::string study_text(const StudyResult& result, std::size_t most) {
  const search::Study& study = result.study;
  std::string text = fmt::format(
      "{}: {} points ({} asked for, in whole generations), {} of them feasible, {} evaluated now\n",
      base::printable(study.title.empty() ? study.file : study.title), result.run.points.size(),
      study.method.points, feasible_count(result.run), result.run.evaluated);
  if (result.best.empty()) {
    text += "no point is feasible\n";
    const auto nearest =
        std::min_element(result.run.points.begin(), result.run.points.end(),
                         [](const search::Evaluated& a, const search::Evaluated& b) {
                           return a.outcome.violation < b.outcome.violation;
                         });
    if (nearest != result.run.points.end())
      text += fmt::format("  the nearest fails: {}\n", base::printable(nearest->outcome.reason));
    return text;
  }
  const bool one = study.objectives.size() == 1;
  text += one ? "the optimum\n" : fmt::format("a front of {} points\n", result.best.size());
  const std::vector<std::size_t> shown =
      search::spread(study, result.run.points, result.best, most);
  for (const std::size_t i : shown) text += point_line(study, result.run.points[i]);
  for (const LandmarkOutcome& mark : result.landmarks) {
    text += fmt::format("  {}:", base::printable(mark.label));
    for (std::size_t i = 0; i < study.objectives.size(); ++i)
      text += mark.outcome.objectives[i]
                  ? fmt::format(" {} = {:.6g}", study.objectives[i].value.text(),
                                *mark.outcome.objectives[i])
                  : "";
    text +=
        mark.outcome.feasible ? "\n" : "  fails: " + base::printable(mark.outcome.reason) + "\n";
  }
  return text;
}

nlohmann::ordered_json study_json(const StudyResult& result) {
  using Json = nlohmann::ordered_json;
  const search::Study& study = result.study;
  const auto numbers = [](const search::Outcome& outcome) {
    Json list = Json::array();
    for (const std::optional<double>& value : outcome.objectives)
      list.push_back(finite(number_of(value)));
    return list;
  };
  Json objectives = Json::array(), best = Json::array(), compare = Json::array();
  for (const search::Objective& one : study.objectives)
    objectives.push_back({{"value", one.value.text()}, {"goal", goal_of(one)}});
  for (const std::size_t i : result.best) {
    const search::Evaluated& one = result.run.points[i];
    Json coordinates = Json::object();
    for (std::size_t j = 0; j < one.point.size(); ++j)
      coordinates[study.coordinates[j].label()] = to_string(one.point[j]);
    best.push_back({{"coordinates", coordinates}, {"objectives", numbers(one.outcome)}});
  }
  for (const LandmarkOutcome& one : result.landmarks)
    compare.push_back({{"label", one.label},
                       {"feasible", one.outcome.feasible},
                       {"objectives", numbers(one.outcome)},
                       {"reason", one.outcome.reason}});
  return {{"study", study.title.empty() ? study.file : study.title},
          {"scheme", study.scheme.name},
          {"method", search::to_string(study.method.kind)},
          {"points", result.run.points.size()},
          {"feasible", feasible_count(result.run)},
          {"evaluated", result.run.evaluated},
          {"finished", result.run.finished},
          {"objectives", objectives},
          {"best", best},
          {"compare", compare}};
}

namespace {

std::string call_of(const search::QuantityRow& row) {
  std::string text = std::string(row.name) + "(";
  for (std::size_t i = 0; i < row.arguments.size(); ++i)
    text += (i > 0 ? ", " : "") + std::string(row.arguments[i].name);
  return text + ")";
}

}  // namespace

std::string quantities_text() {
  std::string text;
  for (const search::QuantityRow& row : search::quantities()) {
    const std::string unit = row.unit.empty() ? "" : fmt::format(" [{}]", row.unit);
    text += fmt::format("{}\n    {}{}; costs {}\n", call_of(row), row.meaning, unit, row.cost);
  }
  return text;
}

nlohmann::ordered_json quantities_json() {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const search::QuantityRow& row : search::quantities()) {
    nlohmann::ordered_json arguments = nlohmann::ordered_json::array();
    for (const search::QuantityRow::Argument& one : row.arguments) arguments.push_back(one.name);
    list.push_back({{"name", row.name},
                    {"arguments", arguments},
                    {"meaning", row.meaning},
                    {"unit", row.unit},
                    {"cost", row.cost}});
  }
  return {{"quantities", list}};
}

}  // namespace limn::report
