#include "limn/report/compare/field.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "limn/base/printable.h"
#include "limn/mesh/split/split.h"
#include "limn/report/compare/compare_rows.h"

namespace limn::report {
namespace {

std::vector<std::string> names(const std::vector<TableRow>& rows) {
  std::vector<std::string> names;
  names.reserve(rows.size());
  for (const TableRow& row : rows) names.push_back(row.name);
  return names;
}

/// What may stand in a cell of a Markdown table.
std::string cell_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '|' || c == '*' || c == '_' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

/// Which of the marks a scheme has: lattice of triangles or of quads, approximating or not.
std::string kind_of(const study::SchemeRecord& scheme) {
  const Split* split = find_split(scheme.split);
  const bool triangles = split != nullptr && split->lattice == Lattice::triangle;
  const bool interpolating = scheme.interpolating && *scheme.interpolating;
  return fmt::format("{}, {}", triangles ? "triangles" : "quads",
                     interpolating ? "interpolating" : "approximating");
}

/// Points of one kind, each with the names of the schemes that lie there.
struct Points {
  figure::ChartPanel::Series series;
  std::vector<std::vector<std::string>> names;

  void add(double x, double y, const std::string& name) {
    const auto near = [](double a, double b) { return std::abs(a - b) < 1e-6; };
    for (std::size_t i = 0; i < names.size(); ++i)
      if (near(series.x[i], x) && near(series.y[i], y)) return names[i].push_back(name);
    series.x.push_back(x);
    series.y.push_back(y);
    names.push_back({name});
  }

  /// A few names, and how many more; the table has them all.
  [[nodiscard]] std::string label(std::size_t i) const {
    constexpr std::ptrdiff_t kShown = 2;
    const auto count = static_cast<std::ptrdiff_t>(names[i].size());
    if (count <= kShown + 1) return fmt::format("{}", fmt::join(names[i], ", "));
    const auto begin = names[i].begin();
    return fmt::format("{} and {} more", fmt::join(begin, begin + kShown, ", "), count - kShown);
  }
};

}  // namespace

std::string field_text(const Comparison& comparison) {
  const std::vector<TableRow> rows = field_rows(comparison);
  TableSection turned;
  for (std::size_t i = 0; i < comparison.schemes.size(); ++i) {
    TableRow line{base::printable(comparison.schemes[i].label)};
    for (const TableRow& row : rows) line.cells.push_back(row.cells[i]);
    turned.rows.push_back(std::move(line));
  }
  return table_text(names(rows), {turned}, false) + missing_text(comparison);
}

std::string field_markdown(const Comparison& comparison) {
  const std::vector<TableRow> rows = field_rows(comparison);
  std::string text = "| scheme |", rule = "| --- |";
  for (const TableRow& row : rows) {
    text += fmt::format(" {} |", cell_text(row.name));
    rule += " --- |";
  }
  text += "\n" + rule + "\n";
  for (std::size_t i = 0; i < comparison.schemes.size(); ++i) {
    text += fmt::format("| {} |", cell_text(base::printable(comparison.schemes[i].label)));
    for (const TableRow& row : rows) text += fmt::format(" {} |", cell_text(row.cells[i].text));
    text += "\n";
  }
  return text;
}

figure::Figure field_figure(const Comparison& comparison) {
  figure::ChartPanel panel{
      .x_label =
          fmt::format("control edges per wavelength for {:g} % of artifacts, worst direction",
                      comparison.tolerance),
      .y_label = "Hölder exponent on the regular lattice"};
  std::map<std::string, Points> kinds;
  for (const study::SchemeRecord& scheme : comparison.schemes)
    if (scheme.sampling && scheme.regularity)
      kinds[kind_of(scheme)].add(scheme.sampling->worst.edges_per_wavelength,
                                 std::max(scheme.regularity->holder.lower, 0.0), scheme.label);
  for (auto& [name, points] : kinds) {
    figure::ChartPanel::Series& series = points.series;
    for (std::size_t i = 0; i < points.names.size(); ++i) series.labels.push_back(points.label(i));
    series.name = name;
    series.markers = true;
    series.line = false;
    panel.series.push_back(std::move(series));
  }
  figure::Figure figure(1);
  figure.title("Subdivision schemes: how smooth, and how densely to sample");
  figure.add(std::move(panel),
             "Each scheme by the smoothness of its regular surfaces (the lower end of a proved "
             "bracket, 0 where none is proved) and by the number of control edges that a wave must "
             "be long for its artifacts to stay below the bound. High and to the left is better.");
  return figure;
}

}  // namespace limn::report
