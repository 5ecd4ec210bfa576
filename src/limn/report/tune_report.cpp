#include "limn/report/tune_report.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "limn/number/near_rational.h"
#include "limn/report/eigen/eigen_report.h"
#include "limn/report/json_number.h"

namespace limn::report {
namespace {

using Json = nlohmann::ordered_json;

Json exact_json(const std::optional<Rational>& rational) {
  return rational ? Json(to_string(*rational)) : Json();
}

Json truth_json(Truth truth) {
  return truth == Truth::undecided ? Json() : Json(truth == Truth::yes);
}

Json solution_json(const Solution& solution) {
  Json json{{"value", solution.value},
            {"residual", solution.residual},
            {"exact", exact_json(solution.rational)},
            {"double", solution.is_double},
            {"holds", truth_json(solution.holds)},
            {"reason", solution.reason}};
  json.update(found_json(solution.found));
  return json;
}

Json end_json(const RangeEnd& end) {
  return {{"value", end.value},
          {"exact", exact_json(end.rational)},
          {"end_of_search", end.of_search},
          {"reason", end.reason}};
}

Json interval_json(Interval interval) { return {interval.low, interval.high}; }

std::string column_text(const std::optional<double>& value) {
  return value ? fmt::format("{:9.6f}", *value) : fmt::format("{:>9}", "–");
}

/// All digits that double has, and p/q where it is one.
std::string value_text(double value, const std::optional<Rational>& rational) {
  std::string digits = fmt::format("{:.16g}", value);
  if (!rational || is_integer(*rational)) return digits;
  return fmt::format("{} = {}", digits, to_string(*rational));
}

std::string remark(const std::string& text) { return "           " + text + "\n"; }

std::string end_text(const char* side, const RangeEnd& end) {
  return remark(fmt::format("{} {}: {}", side, value_text(end.value, end.rational),
                            end.of_search ? "end of the search" : end.reason));
}

std::string interval_text(Interval interval) {
  return fmt::format("[{}, {}]", value_text(interval.low, number::near_rational(interval.low)),
                     value_text(interval.high, number::near_rational(interval.high)));
}

}  // namespace

Json intervals_json(const std::vector<Interval>& intervals) {
  Json list = Json::array();
  for (const Interval interval : intervals) list.push_back(interval_json(interval));
  return list;
}

Json found_json(const Eigencomponents& found) {
  return {{"components",
           {{"position", number_json(found.position)},
            {"tangent", number_json(found.tangent)},
            {"cup", number_json(found.cup)},
            {"saddle", number_json(found.saddle)}}},
          {"verdict",
           {{"c1_necessary", to_string(found.verdict.c1_necessary)},
            {"regular_part", regular_part_json(found.verdict.regular_part)},
            {"bounded_curvature", to_string(found.verdict.bounded_curvature)}}}};
}

std::string found_text(int valence, const Eigencomponents& found, Truth holds) {
  return fmt::format("{:>7}  {} {} {}  {:<9} {:<13} {:<17} ", valence, column_text(found.tangent),
                     column_text(found.cup), column_text(found.saddle), to_string(holds),
                     to_string(found.verdict.c1_necessary),
                     to_string(found.verdict.bounded_curvature));
}

Json tune_json(const ValenceSolutions& solutions) {
  Json list = Json::array();
  for (const Solution& solution : solutions.solutions) list.push_back(solution_json(solution));
  return {{"valence", solutions.valence},
          {"searched", interval_json(solutions.searched)},
          {"samples", solutions.samples},
          {"solutions", std::move(list)},
          {"throughout", intervals_json(solutions.throughout)},
          {"reason", solutions.reason}};
}

Json tune_json(const ValenceRange& range) {
  Json list = Json::array();
  for (const RangePart& part : range.parts)
    list.push_back({{"low", end_json(part.low)}, {"high", end_json(part.high)}});
  return {{"valence", range.valence},     {"searched", interval_json(range.searched)},
          {"samples", range.samples},     {"closed", range.closed},
          {"undecided", range.undecided}, {"parts", std::move(list)},
          {"reason", range.reason}};
}

std::string solution_heading(const std::string& name) {
  return fmt::format("{:>7}  {:>9} {:>9} {:>9}  {:<9} {:<13} {:<17} {}\n", "valence", "tangent",
                     "cup", "saddle", "solves", "C1: necessary", "curvature bounded", name);
}

std::string tune_text(const std::string& name, const ValenceSolutions& solutions) {
  std::string text;
  for (const Solution& solution : solutions.solutions) {
    text += found_text(solutions.valence, solution.found, solution.holds) +
            value_text(solution.value, solution.rational) +
            (solution.is_double ? " (double)\n" : "\n");
    if (!solution.reason.empty()) text += remark(solution.reason);
  }
  for (const Interval part : solutions.throughout)
    text += fmt::format("{:>7}  solved by every {} in {}\n", solutions.valence, name,
                        interval_text(part));
  if (!solutions.reason.empty())
    text += fmt::format("{:>7}  {}\n", solutions.valence, solutions.reason);
  return text;
}

std::string tune_text(const std::string& name, const ValenceRange& range) {
  std::string text;
  const auto sign = [&](const RangeEnd& end) { return range.closed || end.of_search ? "<=" : "<"; };
  for (const RangePart& part : range.parts)
    text += fmt::format("{:>7}  {:.9g} {} {} {} {:.9g}\n", range.valence, part.low.value,
                        sign(part.low), name, sign(part.high), part.high.value) +
            end_text("from", part.low) + end_text("to", part.high);
  if (!range.reason.empty()) text += fmt::format("{:>7}  {}\n", range.valence, range.reason);
  return text;
}

std::string common_text(const std::string& name, const std::vector<Interval>& common) {
  if (common.empty()) return fmt::format("    all  no {} serves all these valences\n", name);
  std::string text;
  for (const Interval part : common)
    text += fmt::format("    all  {} between {} and {}\n", name,
                        value_text(part.low, number::near_rational(part.low)),
                        value_text(part.high, number::near_rational(part.high)));
  return text;
}

}  // namespace limn::report
