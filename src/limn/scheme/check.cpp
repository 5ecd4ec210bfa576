#include "limn/scheme/check.h"

#include <fmt/core.h>

#include "limn/scheme/placement.h"

namespace limn {
namespace {

std::string at_valence(RuleKind kind, int n) {
  return rule_has_valence(kind) ? fmt::format(" at n = {}", n) : std::string();
}

std::optional<long long> valence_of(RuleKind kind, int n) {
  return rule_has_valence(kind) ? std::optional<long long>(n) : std::nullopt;
}

Error faulty_rule(RuleKind kind, int n, const std::string& fault, std::string hint,
                  const Place& place) {
  return {fmt::format("the {} rule {}{}", rule_name(kind), fault, at_valence(kind, n)),
          std::move(hint), place.file, place.line, place.column};
}

std::string decimal_or_fraction(const Exact& x) {
  return x.is_rational() ? to_string(x.rational()) : fmt::format("about {:.12g}", x.approx());
}

/// The weights of a repeated role for k = 0 … n-1: symmetric, and their sum.
Result<Exact> sum_of_repeated(const Scheme& scheme, RuleKind kind, int n, const Weight& weight) {
  std::vector<Exact> values;
  Exact sum;
  for (int k = 0; k < n; ++k) {
    Result<Exact> value = Scope<Exact>(scheme, n, k)(weight.value);
    if (!value) return value;
    sum += *value;
    values.push_back(std::move(*value));
  }
  for (int k = 1; k < n; ++k)
    if (!(values[static_cast<std::size_t>(k)] == values[static_cast<std::size_t>(n - k)]))
      return faulty_rule(kind, n,
                         fmt::format("is not symmetric: '{}' gives k = {} another weight than "
                                     "k = {}",
                                     weight.role, k, n - k),
                         "a weight must be the same for k and n-k", weight.value.place);
  return sum;
}

Result<Exact> sum_of_weight(const Scheme& scheme, RuleKind kind, int n, const Weight& weight) {
  if (weight.walk.repeated) return sum_of_repeated(scheme, kind, n, weight);
  const Result<Placement> placement = place(kind, scheme.split->lattice, weight.walk);
  if (!placement) return placement.error();
  Result<Exact> value = Scope<Exact>(scheme, valence_of(kind, n), std::nullopt)(weight.value);
  if (!value) return value;
  const Rational count = placement->times_n ? placement->count * n : placement->count;
  return Exact(count) * *value;
}

Status check_sum(const Scheme& scheme, RuleKind kind, int n, const RuleCase& rule_case) {
  Exact sum;
  for (const Weight& weight : rule_case.weights) {
    Result<Exact> part = sum_of_weight(scheme, kind, n, weight);
    if (!part) {
      Error error = part.error();
      if (error.message.find("rule") == std::string::npos)
        error.message += fmt::format(", in the {} rule{}", rule_name(kind), at_valence(kind, n));
      return error;
    }
    sum += *part;
  }
  if (sum == Exact(1)) return Done{};
  return faulty_rule(kind, n, "has weights that sum to " + decimal_or_fraction(sum) + ", not 1",
                     "each weight counts once per position of its role", rule_case.place);
}

Status check_parameters(const Scheme& scheme, RuleKind kind, int n) {
  for (const Parameter& parameter : scheme.parameters) {
    if (!parameter.low && !parameter.high) continue;
    const auto outside = [&](const std::optional<Formula>& bound, int side) -> Result<bool> {
      if (!bound) return false;
      Scope<Exact> scope(scheme, valence_of(kind, n), std::nullopt);
      Result<Exact> value = scope(parameter.value);
      if (!value) return value.error();
      Result<Exact> limit = scope(*bound);
      if (!limit) return limit.error();
      Result<int> sign = Arithmetic<Exact>::sign(*value - *limit);
      if (!sign) return sign.error();
      return *sign == side;
    };
    const Result<bool> below = outside(parameter.low, -1);
    const Result<bool> above = outside(parameter.high, 1);
    // a value in n has no value in rules without n, and is checked where it has one
    if (!below || !above) continue;
    if (!*below && !*above) continue;
    const Place& place = parameter.value.place;
    return Error{fmt::format("parameter {} = {} is {} its range [{}, {}]{}", parameter.name,
                             parameter.value.expression.text(), *below ? "below" : "above",
                             parameter.low ? parameter.low->expression.text() : "-inf",
                             parameter.high ? parameter.high->expression.text() : "inf",
                             at_valence(kind, n)),
                 {}, place.file, place.line, place.column};
  }
  return Done{};
}

}  // namespace

Error missing_rule(const Scheme& scheme, RuleKind kind, int n) {
  const bool rule_there = scheme.rule(kind).has_value();
  std::string hint = fmt::format("add a [{}] table", rule_name(kind));
  if (rule_there) hint = "add a case whose guard holds there";
  if (scheme.mask || scheme.factors)
    hint = "the scheme is given by its regular mask alone; write its rules to refine such a mesh";
  return {fmt::format("scheme '{}' has no {} rule{}", scheme.name, rule_name(kind),
                      at_valence(kind, n)),
          hint, scheme.file, 0, 0};
}

Result<const RuleCase*> applicable_case(const Scheme& scheme, RuleKind kind, int n) {
  const std::optional<Rule>& rule = scheme.rule(kind);
  if (!rule) return nullptr;
  for (const RuleCase& rule_case : *rule) {
    if (!rule_case.when) return &rule_case;
    Result<Exact> guard =
        Scope<Exact>(scheme, valence_of(kind, n), std::nullopt)(*rule_case.when);
    if (!guard) return guard.error();
    if (!guard->is_zero()) return &rule_case;
  }
  return nullptr;
}

Status check_rule(const Scheme& scheme, RuleKind kind, int n) {
  const Result<const RuleCase*> rule_case = applicable_case(scheme, kind, n);
  if (!rule_case) return rule_case.error();
  if (Status status = check_parameters(scheme, kind, n); !status) return status;
  if (*rule_case == nullptr) {
    // an edge's end without a case leaves the edge to the edge rule
    if (kind == RuleKind::edge_end || scheme.mask || scheme.factors) return Done{};
    return missing_rule(scheme, kind, n);
  }
  return check_sum(scheme, kind, n, **rule_case);
}

Status check_rules(const Scheme& scheme) {
  for (int i = 0; i < kRuleKinds; ++i) {
    const auto kind = static_cast<RuleKind>(i);
    if (!scheme.rule(kind)) continue;
    int first = kSmallestValence;
    int last = kLargestCheckedValence;
    if (kind == RuleKind::boundary_vertex) first = 2;
    const bool only_triangles = kind == RuleKind::face && !scheme.split->any_polygons;
    if (only_triangles || !rule_has_valence(kind)) last = first = 3;
    for (int n = first; n <= last; ++n)
      if (Status status = check_rule(scheme, kind, n); !status) return status;
  }
  return Done{};
}

}  // namespace limn
