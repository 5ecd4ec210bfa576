#include "limn/report/fairness_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "limn/base/printable.h"
#include "limn/report/json_number.h"
#include "limn/report/limit_report.h"

namespace limn::report {
namespace {

using Json = nlohmann::ordered_json;

/// One column of the tables: what it is called, its values and what they tend to.
struct FairnessColumn {
  const char* key;
  const char* title;  ///< nullptr: the one before, scaled
  double (*value)(const study::FairnessLevel&);
  fairness::Trend study::FairnessRecord::*trend;  ///< or none
  /// What rounding may change it by; nullptr: it is not ranked.
  double (*rounding)(const study::FairnessLevel&) = nullptr;
};
constexpr FairnessColumn kArea{
    "area", "area", [](const study::FairnessLevel& level) { return level.energies.area; },
    &study::FairnessRecord::area};
constexpr FairnessColumn kLaplacian{
    "laplacian_energy", "sum |Lp|^2",
    [](const study::FairnessLevel& level) { return level.laplacian_energy; }, nullptr,
    [](const study::FairnessLevel& level) { return level.laplacian_rounding; }};
constexpr FairnessColumn kScaledLaplacian{
    "scaled_laplacian", nullptr,
    [](const study::FairnessLevel& level) { return level.scaled_laplacian; },
    &study::FairnessRecord::scaled_laplacian};
constexpr FairnessColumn kThinPlate{
    "thin_plate", "thin plate",
    [](const study::FairnessLevel& level) { return level.energies.thin_plate; },
    &study::FairnessRecord::thin_plate,
    [](const study::FairnessLevel& level) { return level.energies.rounding.thin_plate; }};
constexpr FairnessColumn kVariation{
    "curvature_variation", "curv. variation",
    [](const study::FairnessLevel& level) { return level.energies.curvature_variation; },
    &study::FairnessRecord::curvature_variation,
    [](const study::FairnessLevel& level) { return level.energies.rounding.curvature_variation; }};

constexpr std::array kQuantities{kArea, kLaplacian, kScaledLaplacian, kThinPlate, kVariation};
constexpr std::array kEnergies{kLaplacian, kThinPlate, kVariation};

/// In the mesh width, which shrinks by sqrt(growth).
double order_of(const fairness::Trend& trend, int growth) {
  return -2 * std::log(trend.ratio) / std::log(growth);
}

Truth convergence(const study::FairnessRecord& record, const FairnessColumn& quantity) {
  return quantity.trend == nullptr ? Truth::undecided : (record.*quantity.trend).converges;
}

/// Whether the values without a trend, which depend on the sampling, compare.
bool same_sampling(const std::vector<study::FairnessRecord>& records) {
  return std::all_of(records.begin(), records.end(), [&](const study::FairnessRecord& record) {
    return record.split == records.front().split &&
           record.levels.size() == records.front().levels.size();
  });
}

/// The records with the least of an energy: several where rounding alone tells them apart. None of
/// fewer than two, or where they do not compare, or all are alike.
std::vector<std::size_t> fairest(const std::vector<study::FairnessRecord>& records,
                                 const FairnessColumn& quantity) {
  if (records.size() < 2 || (quantity.trend == nullptr && !same_sampling(records))) return {};
  const auto value = [&](std::size_t i) { return quantity.value(records[i].last()); };
  const auto counts = [&](std::size_t i) {
    return std::isfinite(value(i)) && convergence(records[i], quantity) != Truth::no;
  };
  std::optional<std::size_t> least;
  for (std::size_t i = 0; i < records.size(); ++i)
    if (counts(i) && (!least || value(i) < value(*least))) least = i;
  std::vector<std::size_t> best;
  for (std::size_t i = 0; least && i < records.size(); ++i)
    if (counts(i) && value(i) - value(*least) <= quantity.rounding(records[i].last()) +
                                                     quantity.rounding(records[*least].last()))
      best.push_back(i);
  if (best.size() == records.size()) best.clear();
  return best;
}

Json record_json(const study::FairnessRecord& record) {
  Json json{{"scheme", record.scheme},
            {"split", record.split},
            {"level", record.last().level},
            {"vertices", record.last().vertices}};
  for (const FairnessColumn& quantity : kQuantities)
    json[quantity.key] = finite(quantity.value(record.last()));
  for (const FairnessColumn& quantity : kQuantities) {
    if (quantity.trend == nullptr) continue;
    const fairness::Trend& trend = record.*quantity.trend;
    json["trends"][quantity.key] = {{"converges", to_string(trend.converges)},
                                    {"order", finite(order_of(trend, record.growth))},
                                    {"limit", finite(trend.limit)}};
  }
  json["levels"] = Json::array();
  for (const study::FairnessLevel& level : record.levels) {
    Json row{{"level", level.level},
             {"vertices", level.vertices},
             {"faces", level.faces},
             {"left_out", level.energies.left_out}};
    for (const FairnessColumn& quantity : kQuantities)
      row[quantity.key] = finite(quantity.value(level));
    json["levels"].push_back(row);
  }
  if (!record.refused.empty())
    json["missing"] = gaps_json({.limits = record.refused, .normals = {}, .curvatures = {}});
  return json;
}

std::string cell(const std::string& text) { return fmt::format("  {:>15}", text); }

std::string number(double value) { return fmt::format("{:.7g}", value); }

std::string limit_text(const fairness::Trend& trend) {
  switch (trend.converges) {
    case Truth::yes: return number(trend.limit);
    case Truth::no: return "grows";
    case Truth::undecided: break;
  }
  return "undecided";
}

std::string record_text(const study::FairnessRecord& record) {
  std::string text = fmt::format("\n{}\n  level  vertices", base::printable(record.scheme));
  for (const FairnessColumn& quantity : kQuantities)
    text +=
        cell(quantity.title != nullptr ? quantity.title : fmt::format("x {}^level", record.growth));
  for (const study::FairnessLevel& level : record.levels) {
    text += fmt::format("\n  {:>5}  {:>8}", level.level, level.vertices);
    for (const FairnessColumn& quantity : kQuantities) text += cell(number(quantity.value(level)));
  }
  std::string limits = fmt::format("\n  {:<15}", "tends to");
  std::string orders = fmt::format("\n  {:<15}", "order of change");
  for (const FairnessColumn& quantity : kQuantities) {
    if (quantity.trend == nullptr) {
      limits += cell("0");
      orders += cell("");
      continue;
    }
    const fairness::Trend& trend = record.*quantity.trend;
    const double order = order_of(trend, record.growth);
    limits += cell(limit_text(trend));
    orders += cell(std::isfinite(order) ? fmt::format("{:.2f}", order) : "");
  }
  orders.erase(orders.find_last_not_of(' ') + 1);
  text += limits + orders + '\n';
  if (const Index left_out = record.last().energies.left_out; left_out > 0)
    text += fmt::format("  {} of {} faces bend too sharply, or are degenerate: in the area alone\n",
                        left_out, record.last().faces);
  return text;
}

/// '*' at the fairest, and whether the energy has a limit at all.
std::string mark(const std::vector<study::FairnessRecord>& records, std::size_t i,
                 const FairnessColumn& energy) {
  const std::vector<std::size_t> best = fairest(records, energy);
  std::string text = std::find(best.begin(), best.end(), i) != best.end() ? "*" : " ";
  if (energy.trend == nullptr) return text + ' ';
  const Truth converges = convergence(records[i], energy);
  return text + (converges == Truth::no ? '^' : converges == Truth::undecided ? '?' : ' ');
}

/// What the marks mean that are there.
std::string legend(const std::string& marks, const std::vector<study::FairnessRecord>& records) {
  std::string text;
  if (marks.find('*') != std::string::npos) text += "* fairest (several: equal to rounding)\n";
  if (marks.find('^') != std::string::npos)
    text += "^ grows with the level, as far as these levels show: the limit may be infinite\n";
  if (marks.find('?') != std::string::npos)
    text += "? too few levels, or changes that shrink too slowly, to say whether it has a limit\n";
  if (!same_sampling(records))
    text += "sum |Lp|^2 depends on the sampling: it does not compare between splits and levels\n";
  return text;
}

/// All schemes at their last levels.
std::string comparison_text(const std::vector<study::FairnessRecord>& records) {
  std::size_t width = 6;
  for (const study::FairnessRecord& record : records)
    width = std::max(width, base::printable(record.scheme).size());
  std::string head = fmt::format("{:<{}}  level", "scheme", width);
  std::string rows;
  for (const FairnessColumn& quantity : {kArea, kLaplacian, kThinPlate, kVariation})
    head += cell(quantity.title) + "  ";
  head.erase(head.find_last_not_of(' ') + 1);
  std::string marks;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const study::FairnessRecord& record = records[i];
    std::string row = fmt::format("{:<{}}  {:>5}{}  ", base::printable(record.scheme), width,
                                  record.last().level, cell(number(record.last().energies.area)));
    for (const FairnessColumn& energy : kEnergies) {
      marks += mark(records, i, energy);
      row += cell(number(energy.value(record.last()))) + mark(records, i, energy);
    }
    row.erase(row.find_last_not_of(' ') + 1);
    rows += row + '\n';
  }
  return '\n' + head + '\n' + rows + legend(marks, records);
}

}  // namespace

nlohmann::ordered_json fairness_json(const std::string& mesh,
                                     const std::vector<study::FairnessRecord>& records) {
  Json json{{"mesh", mesh}, {"schemes", Json::array()}, {"fairest", Json::object()}};
  for (const study::FairnessRecord& record : records)
    json["schemes"].push_back(record_json(record));
  for (const FairnessColumn& energy : kEnergies)
    if (const auto best = fairest(records, energy); best.size() == 1)
      json["fairest"][energy.key] = records[best.front()].scheme;
  return json;
}

std::string fairness_text(const std::string& mesh,
                          const std::vector<study::FairnessRecord>& records) {
  std::string text = fmt::format("limit surfaces of {}\n", mesh);
  for (const study::FairnessRecord& record : records) text += record_text(record);
  return text + comparison_text(records);
}

figure::Figure fairness_figure(const std::string& mesh,
                               const std::vector<study::FairnessRecord>& records) {
  figure::Figure figure(3);
  figure.title(fmt::format("Energies of limit surfaces of {}, by level", mesh));
  for (const auto& [quantity, title] :
       {std::pair{kScaledLaplacian, "Σ|Lp|², scaled"}, std::pair{kThinPlate, "thin plate"},
        std::pair{kVariation, "curvature variation"}}) {
    figure::ChartPanel panel;
    panel.title = title;
    panel.x_label = "level";
    panel.log_y = true;
    for (const study::FairnessRecord& record : records) {
      figure::ChartPanel::Series series;
      series.name = record.scheme;
      series.markers = true;
      for (const study::FairnessLevel& level : record.levels) {
        series.x.push_back(level.level);
        series.y.push_back(quantity.value(level));
      }
      panel.series.push_back(std::move(series));
    }
    figure.add(std::move(panel));
  }
  return figure;
}

}  // namespace limn::report
