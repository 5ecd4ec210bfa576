#pragma once
/// Walks over the expressions that a scheme is made of.

#include <string_view>

#include "limn/scheme/scheme.h"

namespace limn::scheme {

/// The formula of a let or a parameter; nullptr: there is none of that name.
template <class MaybeConstScheme>
[[nodiscard]] auto* find_definition(MaybeConstScheme& scheme, std::string_view name) {
  for (auto& [let, value] : scheme.lets)
    if (let == name) return &value;
  for (auto& parameter : scheme.parameters)
    if (parameter.name == name) return &parameter.value;
  return static_cast<decltype(&scheme.lets.front().second)>(nullptr);
}

/// Calls visit(formula) for parameters, rules, stages, facts and equivalences, in this order: for
/// all that uses lets, but for masks and factors.
template <class Visit>
void each_rule_formula(const Scheme& scheme, Visit&& visit) {
  for (const Parameter& parameter : scheme.parameters) {
    visit(parameter.value);
    if (parameter.low) visit(*parameter.low);
    if (parameter.high) visit(*parameter.high);
  }
  const auto visit_rule = [&](const Rule& rule) {
    for (const RuleCase& rule_case : rule) {
      if (rule_case.when) visit(*rule_case.when);
      for (const Weight& weight : rule_case.weights) visit(weight.value);
    }
  };
  for (const std::optional<Rule>& rule : scheme.rules)
    if (rule) visit_rule(*rule);
  if (scheme.stages) {
    visit(scheme.stages->times);
    visit_rule(scheme.stages->pair);
  }
  for (const Fact& fact : scheme.facts)
    for (const auto& value : fact.values) visit(value.second);
  for (const Equivalence& same : scheme.equivalences)
    for (const auto& value : same.with) visit(value.second);
}

/// Calls visit(formula) for entries and scales of masks, and for stages, directions and kernel.
template <class Visit>
void each_mask_formula(const Scheme& scheme, Visit&& visit) {
  const auto visit_rows = [&](const Rows& rows) {
    for (const auto& row : rows.rows)
      for (const Formula& entry : row) visit(entry);
    if (rows.scale) visit(*rows.scale);
  };
  if (scheme.mask) visit_rows(*scheme.mask);
  if (scheme.stated_mask) visit_rows(*scheme.stated_mask);
  if (!scheme.factors) return;
  if (scheme.factors->stages) visit(*scheme.factors->stages);
  for (const auto& direction : scheme.factors->directions) visit(direction.second);
  if (scheme.factors->kernel) visit_rows(*scheme.factors->kernel);
}

}  // namespace limn::scheme
