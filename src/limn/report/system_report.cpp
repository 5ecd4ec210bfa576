#include "limn/report/system_report.h"

#include <algorithm>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "limn/base/printable.h"
#include "limn/report/tune_report.h"
#include "limn/scheme/file/scheme_text.h"
#include "limn/scheme/formulas.h"
#include "limn/tune/closed_form.h"

namespace limn::report {
namespace {

using Json = nlohmann::ordered_json;

/// Name j's number in words, exactly, where it was recognised.
std::optional<std::string> exact_text(const tune::SystemSolution& solution, int n, std::size_t j) {
  if (solution.rationals[j]) return to_string(*solution.rationals[j]);
  return tune::closed_form_at(n, solution.values[j]);
}

/// The first that holds; nullptr: there is none.
const tune::SystemSolution* chosen(const tune::SystemSolutions& at) {
  const auto found = std::find_if(at.solutions.begin(), at.solutions.end(),
                                  [](const auto& one) { return one.holds == Truth::yes; });
  return found == at.solutions.end() ? nullptr : &*found;
}

/// Valences and what a name is there.
struct Case {
  std::vector<int> valences;  ///< ascending
  std::string value;
};

/// "(n == 3)", "(n >= 5) * (n <= 9)", or a sum of such: 1 at these valences and 0 elsewhere.
std::string guard_text(const std::vector<int>& valences) {
  std::string text;
  for (std::size_t i = 0; i < valences.size();) {
    std::size_t end = i + 1;
    while (end < valences.size() && valences[end] == valences[end - 1] + 1) ++end;
    if (!text.empty()) text += " + ";
    text += end - i == 1 ? fmt::format("(n == {})", valences[i])
                         : fmt::format("(n >= {}) * (n <= {})", valences[i], valences[end - 1]);
    i = end;
  }
  return text;
}

std::string cases_text(const std::vector<Case>& cases, const std::string& elsewhere) {
  std::string text;
  std::vector<int> all;
  for (const Case& one : cases) {
    text += fmt::format("({}) * ({}) + ", guard_text(one.valences), one.value);
    all.insert(all.end(), one.valences.begin(), one.valences.end());
  }
  std::sort(all.begin(), all.end());
  return fmt::format("{}(1 - ({})) * ({})", text, guard_text(all), elsewhere);
}

/// What a file gives name j, and at which valences it keeps its own value.
struct Definition {
  std::string text;
  std::vector<int> kept;
};

Definition definition_of(const tune::FreedNames& names, std::size_t j,
                         const std::vector<tune::SystemSolutions>& solutions,
                         const std::optional<std::string>& form) {
  const FreedScheme& name = names.one(j);
  Definition definition;
  std::vector<Case> cases;
  for (const tune::SystemSolutions& at : solutions) {
    const tune::SystemSolution* solution = chosen(at);
    // at a regular valence that is solved beside others: their neighbours would have it, too
    const bool for_neighbours =
        !name.is_one_number() && name.everywhere(at.valence) && solutions.size() > 1;
    if (solution == nullptr || for_neighbours) {
      definition.kept.push_back(at.valence);
      continue;
    }
    std::string value = form ? *form
                             : exact_text(*solution, at.valence, j)
                                   .value_or(to_string(Rational(solution->values[j])));
    const auto same = std::find_if(cases.begin(), cases.end(),
                                   [&](const Case& one) { return one.value == value; });
    if (same == cases.end())
      cases.push_back({{at.valence}, std::move(value)});
    else
      same->valences.push_back(at.valence);
  }
  if (cases.empty()) return definition;
  definition.text =
      name.is_one_number()
          ? cases.front().value
          : cases_text(cases,
                       scheme::find_definition(names.original(), name.name())->expression.text());
  return definition;
}

std::string joined_requirements(const std::vector<Requirement>& requirements) {
  std::string text;
  for (const Requirement& one : requirements) text += (text.empty() ? "" : ", ") + one.text;
  return text;
}

}  // namespace

Json system_json(const tune::FreedNames& names, const tune::SystemSolutions& solutions) {
  Json list = Json::array();
  for (const tune::SystemSolution& one : solutions.solutions) {
    Json values = Json::object(), exact = Json::object();
    for (std::size_t j = 0; j < names.size(); ++j) {
      values[names.one(j).name()] = one.values[j];
      const std::optional<std::string> text = exact_text(one, solutions.valence, j);
      exact[names.one(j).name()] = text ? Json(*text) : Json();
    }
    Json entry{{"values", values}, {"exact", exact}, {"residual", one.residual}};
    entry["holds"] = one.holds == Truth::undecided ? Json() : Json(one.holds == Truth::yes);
    entry["reason"] = one.reason;
    entry.update(found_json(one.found));
    list.push_back(std::move(entry));
  }
  return {{"valence", solutions.valence},
          {"searched", intervals_json(solutions.searched)},
          {"starts", solutions.starts},
          {"solutions", std::move(list)},
          {"reason", solutions.reason}};
}

std::string system_heading() { return solution_heading(""); }

std::string system_text(const tune::FreedNames& names, const tune::SystemSolutions& solutions) {
  std::string text;
  for (const tune::SystemSolution& one : solutions.solutions) {
    text += found_text(solutions.valence, one.found, one.holds) + "\n";
    for (std::size_t j = 0; j < names.size(); ++j) {
      const std::string digits = fmt::format("{:.16g}", one.values[j]);
      text += fmt::format("           {} = {}", names.one(j).name(), digits);
      const std::optional<std::string> exact = exact_text(one, solutions.valence, j);
      text += exact && *exact != digits ? " = " + *exact + "\n" : "\n";
    }
    if (!one.reason.empty()) text += fmt::format("           {}\n", base::printable(one.reason));
  }
  if (!solutions.reason.empty())
    text += fmt::format("{:>7}  {}\n", solutions.valence, base::printable(solutions.reason));
  return text;
}

std::vector<std::optional<std::string>> common_forms(
    const tune::FreedNames& names, const std::vector<tune::SystemSolutions>& solutions) {
  std::vector<std::optional<std::string>> forms(names.size());
  for (std::size_t j = 0; j < names.size(); ++j) {
    std::vector<int> valences;
    std::vector<double> values;
    for (const tune::SystemSolutions& at : solutions)
      if (const tune::SystemSolution* solution = chosen(at)) {
        valences.push_back(at.valence);
        values.push_back(solution->values[j]);
      }
    if (valences.size() == solutions.size()) forms[j] = tune::closed_form(valences, values);
  }
  return forms;
}

Result<std::string> tuned_system_text(const tune::FreedNames& names,
                                      const std::vector<Requirement>& requirements,
                                      const std::vector<tune::SystemSolutions>& solutions,
                                      const std::string& extends) {
  const Scheme& scheme = names.original();
  const std::vector<std::optional<std::string>> forms = common_forms(names, solutions);
  std::vector<std::pair<std::string, std::string>> definitions;
  std::string list;
  std::vector<int> kept;
  for (std::size_t j = 0; j < names.size(); ++j) {
    if (names.one(j).is_one_number() && solutions.size() > 1)
      return Error{fmt::format("'{}' is one number everywhere, so a file can have that of one "
                               "valence only",
                               names.one(j).name()),
                   "give a single --valence"};
    const Definition definition = definition_of(names, j, solutions, forms[j]);
    if (definition.text.empty())
      return Error{fmt::format(
          "no solution was found to write, at n = {}: {}", solutions.front().valence,
          solutions.front().solutions.empty() ? solutions.front().reason
                                              : solutions.front().solutions.front().reason)};
    definitions.emplace_back(names.one(j).name(), definition.text);
    list += (j > 0 ? ", " : "") + names.one(j).name();
    kept = definition.kept;
  }
  double residual = 0;
  for (const tune::SystemSolutions& at : solutions)
    if (const tune::SystemSolution* solution = chosen(at))
      residual = std::max(residual, solution->residual);
  std::string text = fmt::format(
      "# Made by limn tune. Residuals are {:.1e} at most; long fractions are doubles, exactly;\n"
      "# fractions and formulas are recognised, not proved.\n",
      residual);
  if (!kept.empty())
    text += fmt::format("# The values of '{}' are kept at n = {}.\n", base::printable(scheme.name),
                        fmt::join(kept, ", "));
  text += fmt::format(
      "title   = {}\nextends = {}\nnotes   = {}\n",
      scheme::toml_string(scheme::derived_title(scheme, "tuned")), scheme::toml_string(extends),
      scheme::toml_string(fmt::format("{} such that {}", list, joined_requirements(requirements))));
  return text + scheme::weights_toml(scheme) + scheme::definitions_toml(scheme, definitions);
}

}  // namespace limn::report
