#include "limn/report/tuned_scheme.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "limn/base/printable.h"
#include "limn/scheme/file/scheme_text.h"
#include "limn/scheme/formulas.h"
#include "limn/scheme/scope.h"

namespace limn::report {
namespace {

/// Of the solutions that hold the nearest to the scheme's own value; nullptr: there is none.
const Solution* chosen(const ValenceSolutions& solutions, double own) {
  const Solution* best = nullptr;
  for (const Solution& solution : solutions.solutions)
    if (solution.holds == Truth::yes &&
        (best == nullptr || std::abs(solution.value - own) < std::abs(best->value - own)))
      best = &solution;
  return best;
}

Rational fraction(const Solution& solution) {
  return solution.rational ? *solution.rational : Rational(solution.value);
}

/// The freed name's new definition and what was decided about it.
struct TunedDefinition {
  std::string text;
  std::vector<int> kept;  ///< valences with the scheme's own value
  double residual = 0;    ///< the largest
  bool any = false;
};

TunedDefinition define(const FreedScheme& freed, const std::vector<ValenceSolutions>& solutions,
                       bool one_number) {
  const Scheme& scheme = freed.original();
  const Formula& own = *scheme::find_definition(scheme, freed.name());
  TunedDefinition definition;
  std::vector<std::pair<int, Rational>> numbers;
  for (const ValenceSolutions& at : solutions) {
    const Result<double> own_value = scheme::Scope<double>(scheme, at.valence, std::nullopt)(own);
    const Solution* solution = chosen(at, own_value ? *own_value : 0);
    const bool for_neighbours = !one_number && freed.everywhere(at.valence) && solutions.size() > 1;
    if (solution == nullptr || for_neighbours) {
      definition.kept.push_back(at.valence);
      continue;
    }
    definition.any = true;
    definition.residual = std::max(definition.residual, solution->residual);
    numbers.emplace_back(at.valence, fraction(*solution));
  }
  if (!one_number)
    definition.text = scheme::definition_by_valence(numbers, own.expression);
  else if (!numbers.empty())
    definition.text = to_string(numbers.front().second);
  return definition;
}

}  // namespace

Result<std::string> tuned_scheme_text(const FreedScheme& freed, const Requirement& requirement,
                                      const std::vector<ValenceSolutions>& solutions,
                                      const std::string& extends) {
  const Scheme& scheme = freed.original();
  const bool one_number = freed.is_one_number();
  if (one_number && solutions.size() > 1)
    return Error{fmt::format("'{}' is one number everywhere, so a file can have that of one "
                             "valence only",
                             freed.name()),
                 "give a single --valence"};
  const TunedDefinition definition = define(freed, solutions, one_number);
  if (!definition.any) return Error{fmt::format("no {} was found to write", freed.name())};
  const std::string task = fmt::format("{} such that {}", freed.name(), requirement.text);
  std::string text = fmt::format(
      "# Made by limn tune. Residuals are {:.1e} at most; long fractions are doubles, exactly.\n",
      definition.residual);
  if (!definition.kept.empty())
    text += fmt::format("# The value of '{}' is kept at n = {}.\n", base::printable(scheme.name),
                        fmt::join(definition.kept, ", "));
  text += fmt::format("title   = {}\nextends = {}\nnotes   = {}\n",
                      scheme::toml_string(scheme::derived_title(scheme, "tuned")),
                      scheme::toml_string(extends), scheme::toml_string(task));
  return text + scheme::weights_toml(scheme) +
         scheme::definitions_toml(scheme, {{freed.name(), definition.text}});
}

}  // namespace limn::report
