#include "limn/scheme/seen_from.h"

#include <algorithm>
#include <set>

namespace limn::scheme {
namespace {

/// Whether the expression uses the name, itself or by way of a let or a parameter.
bool uses(const Scheme& scheme, const Expression& expression, std::string_view wanted,
          std::set<std::string>& seen) {
  for (const std::string& name : expression.names()) {
    if (name == wanted) return true;
    if (!seen.insert(name).second) continue;
    for (const auto& [let, formula] : scheme.lets)
      if (let == name && uses(scheme, formula.expression, wanted, seen)) return true;
    for (const Parameter& parameter : scheme.parameters)
      if (parameter.name == name && uses(scheme, parameter.value.expression, wanted, seen))
        return true;
  }
  return false;
}

bool depends_on_valence(const Scheme& scheme, const Rule& rule) {
  std::set<std::string> seen;
  return std::any_of(rule.begin(), rule.end(), [&](const RuleCase& one) {
    return one.when || std::any_of(one.weights.begin(), one.weights.end(), [&](const Weight& w) {
             return uses(scheme, w.value.expression, "n", seen);
           });
  });
}

}  // namespace

bool has_rules_seen_from(const Scheme& scheme) {
  for (int i = 0; i < kRuleKinds; ++i) {
    const auto kind = static_cast<RuleKind>(i);
    const std::optional<Rule>& rule = scheme.rule(kind);
    if (!rule) continue;
    if (stands_in_for(kind, *scheme.split)) return true;
    if (kind == RuleKind::boundary_edge_end && depends_on_valence(scheme, *rule)) return true;
  }
  return false;
}

}  // namespace limn::scheme
