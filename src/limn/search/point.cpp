#include "limn/search/point.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "limn/base/budget.h"
#include "limn/scheme/file/scheme_files.h"
#include "limn/scheme/file/scheme_text.h"
#include "limn/scheme/formulas.h"
#include "limn/scheme/scope.h"
#include "limn/search/demands.h"

namespace limn::search {
namespace {

/// Beyond every objective of a feasible point.
constexpr double kInfeasible = 1e9;
/// The violation of a point that is no scheme at all.
constexpr double kNoScheme = 100;

/// The definition of a freed name: its number, or a number for each valence that has one and its
/// own definition elsewhere.
std::string new_definition(const Study& study, const Point& point, const std::string& name) {
  std::vector<std::pair<int, Rational>> numbers;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const Coordinate& coordinate = study.coordinates[i];
    if (coordinate.name != name) continue;
    if (!coordinate.valence) return to_string(point[i]);
    numbers.emplace_back(*coordinate.valence, point[i]);
  }
  return scheme::definition_by_valence(numbers,
                                       scheme::find_definition(study.scheme, name)->expression);
}

std::vector<std::string> freed_names(const Study& study) {
  std::vector<std::string> names;
  for (const Coordinate& coordinate : study.coordinates)
    if (std::find(names.begin(), names.end(), coordinate.name) == names.end())
      names.push_back(coordinate.name);
  return names;
}

/// The scheme file of a point and those that it extends, which are the study's: no file is opened,
/// so that a point has the same outcome wherever it is evaluated.
std::vector<SourceText> point_texts(const Study& study, const Point& point) {
  std::vector<SourceText> texts = study.scheme.texts;
  texts.front().name = study.scheme_name;
  texts.insert(texts.begin(), {"point.toml", point_text(study, point, study.scheme_name)});
  return texts;
}

void evaluate_objectives(const Study& study, SchemeReading& reading, Outcome& outcome) {
  for (std::size_t i = 0; i < study.objectives.size(); ++i) {
    const Result<double> value = study.objectives[i].value(reading);
    if (value) {
      outcome.objectives[i] = *value;
    } else {
      outcome.violation += 1;
      if (outcome.reason.empty()) outcome.reason = value.error().message;
    }
  }
}

/// Whether a scheme that fails a demand is asked for its objectives all the same.
enum class Failing { is_left, is_evaluated };

Outcome evaluate(const Study& study, const Result<Scheme>& scheme, Failing failing, double start) {
  Outcome outcome;
  outcome.objectives.resize(study.objectives.size());
  outcome.demands.resize(study.demands.size());
  if (scheme) {
    SchemeReading reading(*scheme, study.valences, study.effort, study.certify_options());
    check_demands(study, reading, Proofs::later, outcome);
    if (outcome.violation == 0 || failing == Failing::is_evaluated)
      evaluate_objectives(study, reading, outcome);
    if (outcome.violation == 0) check_demands(study, reading, Proofs::now, outcome);
  } else {
    outcome.reason = scheme.error().message;
    outcome.violation = kNoScheme;
  }
  outcome.feasible = outcome.violation == 0;
  outcome.seconds = steady_seconds() - start;
  return outcome;
}

}  // namespace

Rational snapped(double u) {
  constexpr double kParts = 1 << kUnitBits;
  return {Integer(std::llround(std::clamp(u, 0.0, 1.0) * kParts)), Integer(1 << kUnitBits)};
}

Point point_at(const Study& study, const UnitPoint& unit) {
  Point point;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const Coordinate& coordinate = study.coordinates[i];
    point.push_back(coordinate.low + unit[i] * (coordinate.high - coordinate.low));
  }
  return point;
}

std::string point_key(const Point& point) {
  std::string key;
  for (const Rational& value : point) key += (key.empty() ? "" : " ") + to_string(value);
  return key;
}

std::string point_text(const Study& study, const Point& point, const std::string& extends,
                       const std::string& notes) {
  std::string text =
      fmt::format("title   = {}\nextends = {}\n",
                  scheme::toml_string(scheme::derived_title(study.scheme, "of a study")),
                  scheme::toml_string(extends));
  if (!notes.empty()) text += fmt::format("notes   = {}\n", scheme::toml_string(notes));
  std::vector<std::pair<std::string, std::string>> definitions;
  for (const std::string& name : freed_names(study))
    definitions.emplace_back(name, new_definition(study, point, name));
  return text + scheme::weights_toml(study.scheme) +
         scheme::definitions_toml(study.scheme, definitions);
}

Outcome evaluate_point(const Study& study, const Point& point) {
  const double start = steady_seconds();
  return evaluate(study, parse_texts(point_texts(study, point)), Failing::is_left, start);
}

Outcome evaluate_scheme(const Study& study, const Scheme& scheme) {
  return evaluate(study, scheme, Failing::is_evaluated, steady_seconds());
}

std::vector<double> fitness(const Study& study, const Outcome& outcome) {
  std::vector<double> values(study.objectives.size(), kInfeasible * (1 + outcome.violation));
  if (!outcome.feasible) return values;
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = study.objectives[i].maximise ? -*outcome.objectives[i] : *outcome.objectives[i];
  return values;
}

}  // namespace limn::search
