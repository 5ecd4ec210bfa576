#include "limn/scheme/check.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "limn/scheme/placement.h"
#include "limn/scheme/scope.h"

namespace limn {
namespace {

/// The rule of that kind: in a scheme of stages, what two averagings make of a vertex.
const Rule* rule_of(const Scheme& scheme, RuleKind kind) {
  if (scheme.stages) return kind == RuleKind::vertex ? &scheme.stages->pair : nullptr;
  return scheme.rule(kind) ? &*scheme.rule(kind) : nullptr;
}

std::string at_valence(RuleKind kind, int n) {
  return rule_has_valence(kind) ? fmt::format(" at n = {}", n) : std::string();
}

std::optional<long long> valence_of(RuleKind kind, int n) {
  return rule_has_valence(kind) ? std::optional<long long>(n) : std::nullopt;
}

Error faulty_rule(RuleKind kind, int n, const std::string& fault, std::string hint,
                  const Place& place) {
  return {fmt::format("the {} rule{} {}", rule_name(kind), at_valence(kind, n), fault),
          std::move(hint), place.file, place.line, place.column};
}

/// An error from an expression, with the rule it was needed for.
Error needed_by(RuleKind kind, int n, Error error) {
  error.message += fmt::format(", in the {} rule{}", rule_name(kind), at_valence(kind, n));
  return error;
}

/// An error of arithmetic between the values of one weight, with that weight's place.
Error placed(Error error, const Weight& weight) {
  const Place& place = weight.value.place;
  return {std::move(error.message), std::move(error.hint), place.file, place.line, place.column};
}

/// The values that names have in one rule at one valence, and for each k in its repeated roles.
class Scopes {
 public:
  Scopes(const Scheme& scheme, RuleKind kind, int n)
      : scheme_(scheme), n_(n), plain_(scheme, valence_of(kind, n), std::nullopt) {}

  [[nodiscard]] Result<Exact> operator()(const Formula& formula) { return plain_(formula); }
  /// 0 ≤ k < n
  [[nodiscard]] Result<Exact> operator()(const Formula& formula, int k) {
    if (repeated_.empty())
      for (int i = 0; i < n_; ++i) repeated_.emplace_back(scheme_, n_, i);
    return repeated_[static_cast<std::size_t>(k)](formula);
  }

 private:
  const Scheme& scheme_;
  int n_;
  Scope<Exact> plain_;
  std::vector<Scope<Exact>> repeated_;
};

/// The weights of a repeated role for k = 0 … n-1.
Result<std::vector<Exact>> repeated_weights(Scopes& scopes, RuleKind kind, int n,
                                            const Weight& weight) {
  std::vector<Exact> values;
  for (int k = 0; k < n; ++k) {
    Result<Exact> value = scopes(weight.value, k);
    if (!value) return needed_by(kind, n, value.error());
    values.push_back(std::move(*value));
  }
  return values;
}

/// Round a vertex or a face no k is the first; along an edge and in a corner k and n-k are
/// mirror images, unless the role is placed from both sides anyway.
Status check_symmetry(const std::vector<Exact>& values, RuleKind kind, const Weight& weight,
                      bool placed_twice) {
  const int n = static_cast<int>(values.size());
  const bool round = kind == RuleKind::vertex || kind == RuleKind::face;
  if (placed_twice && !round) return Done{};
  for (int k = 1; k < n; ++k) {
    const int mirror = round ? 0 : n - k;
    const Result<Exact> difference = Exact::subtract(values[static_cast<std::size_t>(k)],
                                                     values[static_cast<std::size_t>(mirror)]);
    if (!difference) return needed_by(kind, n, placed(difference.error(), weight));
    if (difference->is_zero()) continue;
    const std::string_view law = round ? "no k is the first here, so a weight must not depend on it"
                                       : "a weight must be the same for k and n-k";
    return faulty_rule(kind, n,
                       fmt::format("is not symmetric: '{}' gives k = {} another weight than k = {}",
                                   weight.role, std::min(k, mirror), std::max(k, mirror)),
                       std::string(law), weight.value.place);
  }
  return Done{};
}

Result<Exact> sum_of_weight(const Scheme& scheme, Scopes& scopes, RuleKind kind, int n,
                            const Weight& weight) {
  const Result<Placement> placement = place(kind, scheme.split->lattice, weight.walk);
  if (!placement) return placement.error();
  if (!weight.walk.repeated) {
    Result<Exact> value = scopes(weight.value);
    if (!value) return needed_by(kind, n, value.error());
    const Rational count = placement->times_n ? placement->count * n : placement->count;
    return Exact::multiply(Exact(count), *value);
  }
  const Result<std::vector<Exact>> values = repeated_weights(scopes, kind, n, weight);
  if (!values) return values.error();
  if (Status status = check_symmetry(*values, kind, weight, placement->starts.size() > 1); !status)
    return status.error();
  Result<Exact> sum = Exact(0);
  for (const Exact& value : *values)
    if (sum) sum = Exact::add(*sum, value);
  if (!sum) return needed_by(kind, n, placed(sum.error(), weight));
  return sum;
}

Error wrong_sum(RuleKind kind, int n, const Exact& sum, const Place& place) {
  if (!sum.is_rational() && std::abs(sum.approx() - 1) < 1e-9)
    return faulty_rule(kind, n, "has weights whose sum cannot be shown to be exactly 1",
                       "write the same square root wherever one is a multiple of another", place);
  const std::string value =
      sum.is_rational() ? to_string(sum.rational()) : fmt::format("about {:.12g}", sum.approx());
  return faulty_rule(kind, n, "has weights that sum to " + value + ", not 1",
                     "each weight counts once per position of its role", place);
}

Status check_sum(const Scheme& scheme, RuleKind kind, int n, const RuleCase& rule_case) {
  Scopes scopes(scheme, kind, n);
  Exact sum;
  for (const Weight& weight : rule_case.weights) {
    const Result<Exact> part = sum_of_weight(scheme, scopes, kind, n, weight);
    if (!part) return part.error();
    Result<Exact> longer = Exact::add(sum, *part);
    if (!longer) return needed_by(kind, n, placed(longer.error(), weight));
    sum = std::move(*longer);
  }
  if (sum == Exact(1)) return Done{};
  return wrong_sum(kind, n, sum, rule_case.place);
}

std::string range_text(const Parameter& parameter) {
  return fmt::format("[{}, {}]", parameter.low ? parameter.low->expression.text() : "-inf",
                     parameter.high ? parameter.high->expression.text() : "inf");
}

/// The sign of b - a; 1 where one of them is not stated.
Result<int> order(Scope<Exact>& scope, const std::optional<Formula>& a,
                  const std::optional<Formula>& b) {
  if (!a || !b) return 1;
  const Result<Exact> left = scope(*a);
  if (!left) return left.error();
  const Result<Exact> right = scope(*b);
  if (!right) return right.error();
  const Result<Exact> difference = Exact::subtract(*right, *left);
  if (!difference) return difference.error();
  return Arithmetic<Exact>::sign(*difference);
}

/// The parameter's value lies in its range, in the scope of one rule.
Status check_range(const Parameter& parameter, RuleKind kind, int n, Scope<Exact>& scope) {
  const Place& place = parameter.value.place;
  const auto fault = [&](const std::string& what) {
    return Error{fmt::format("parameter {} {}{}", parameter.name, what, at_valence(kind, n)),
                 {},
                 place.file,
                 place.line,
                 place.column};
  };
  const Result<int> width = order(scope, parameter.low, parameter.high);
  const Result<int> above_low = order(scope, parameter.low, parameter.value);
  const Result<int> below_high = order(scope, parameter.value, parameter.high);
  for (const Result<int>* result : {&width, &above_low, &below_high})
    if (!*result) return needed_by(kind, n, result->error());
  if (*width < 0) return fault(fmt::format("has the empty range {}", range_text(parameter)));
  if (*above_low > -1 && *below_high > -1) return Done{};
  return fault(fmt::format("= {} is {} its range {}", parameter.value.expression.text(),
                           *above_low < 0 ? "below" : "above", range_text(parameter)));
}

/// The same for each k where the value needs one.
Status check_parameter(const Scheme& scheme, const Parameter& parameter, RuleKind kind, int n) {
  if (!parameter.low && !parameter.high) return Done{};
  // what has no value in a rule without n, or without k, is checked where it has one
  const bool valued = [&] {
    Scope<Exact> scope(scheme, valence_of(kind, n), std::nullopt);
    return scope(parameter.value).ok();
  }();
  if (!valued && !rule_has_valence(kind)) return Done{};
  for (int k = 0; k < (valued ? 1 : n); ++k) {
    Scope<Exact> scope(scheme, valence_of(kind, n),
                       valued ? std::nullopt : std::optional<long long>(k));
    if (Status status = check_range(parameter, kind, n, scope); !status) return status;
  }
  return Done{};
}

/// Whether the value and its range are numbers, whatever names stand for.
bool is_of_numbers(const Parameter& parameter) {
  const auto is_number = [](const Formula& formula) { return formula.expression.names().empty(); };
  return is_number(parameter.value) && (!parameter.low || is_number(*parameter.low)) &&
         (!parameter.high || is_number(*parameter.high));
}

/// The weights of the case that applies, or that there is none.
Status check_case(const Scheme& scheme, RuleKind kind, int n) {
  const Result<const RuleCase*> rule_case = applicable_case(scheme, kind, n);
  if (!rule_case) return rule_case.error();
  if (*rule_case != nullptr) return check_sum(scheme, kind, n, **rule_case);
  if (stands_in_for(kind, *scheme.split) || scheme.mask || scheme.factors) return Done{};
  return missing_rule(scheme, kind, n);
}

/// Whether so much was spent that no arithmetic is left: what it says then is no fault.
bool is_exhausted() { return !Exact::multiply(Exact(1), Exact(1)).ok(); }

/// The valences at which a rule is checked.
std::pair<int, int> checked_valences(const Scheme& scheme, RuleKind kind) {
  if (!rule_has_valence(kind)) return {3, 3};
  const bool of_face = kind == RuleKind::face || kind == RuleKind::corner;
  if (of_face && !scheme.split->any_polygons) {
    const int only = regular_valence(kind, scheme.split->lattice);
    return {only, only};
  }
  const bool at_corner = kind == RuleKind::boundary_vertex || kind == RuleKind::boundary_edge_end;
  return {at_corner ? kSmallestValence - 1 : kSmallestValence, kLargestCheckedValence};
}

bool uses_any(const Formula& formula, const std::set<std::string>& names) {
  const std::vector<std::string>& used = formula.expression.names();
  return std::any_of(used.begin(), used.end(),
                     [&](const std::string& name) { return names.count(name) > 0; });
}

bool uses_any(const Parameter& parameter, const std::set<std::string>& names) {
  return names.count(parameter.name) > 0 || (parameter.low && uses_any(*parameter.low, names)) ||
         (parameter.high && uses_any(*parameter.high, names));
}

bool uses_any(const Rule& rule, const std::set<std::string>& names) {
  return std::any_of(rule.begin(), rule.end(), [&](const RuleCase& one) {
    return (one.when && uses_any(*one.when, names)) ||
           std::any_of(one.weights.begin(), one.weights.end(),
                       [&](const Weight& weight) { return uses_any(weight.value, names); });
  });
}

/// Where a rule or a case is missing: at the last case, or where the file says what it has.
Place place_without(const Scheme& scheme, RuleKind kind) {
  if (const Rule* rule = rule_of(scheme, kind); rule != nullptr && !rule->empty())
    return rule->back().place;
  if (scheme.mask) return scheme.mask->place;
  if (scheme.factors) return scheme.factors->place;
  return {scheme.file, 1, 1};
}

/// Whether the fault is one of a whole case: its sum, or that none applies.
bool is_of_case(const Rule& rule, const Error& fault) {
  return std::any_of(rule.begin(), rule.end(), [&](const RuleCase& one) {
    return one.place.line == fault.line && one.place.column == fault.column;
  });
}

}  // namespace

Error missing_rule(const Scheme& scheme, RuleKind kind, int n) {
  const bool by_mask = scheme.mask || scheme.factors;
  std::string hint = fmt::format("add a table [{}]", rule_name(kind));
  if (scheme.rule(kind)) hint = "add a case whose guard holds there, or one without a guard";
  if (by_mask)
    hint = "the scheme is given by its regular mask alone; write its rules to refine such a mesh";
  if (scheme.stages && kind != RuleKind::vertex)
    hint = "its step is a sequence of averagings; what asks for such a rule cannot be had of it";
  const bool has_cases = rule_of(scheme, kind) != nullptr;
  if (scheme.stages && has_cases) hint = "add a case to stages.pair whose guard holds there";
  const std::string where = has_cases || by_mask ? at_valence(kind, n) : std::string();
  const Place place = place_without(scheme, kind);
  return {fmt::format("scheme '{}' has no {} rule{}", scheme.name, rule_name(kind), where), hint,
          place.file, place.line, place.column};
}

Result<const RuleCase*> applicable_case(const Scheme& scheme, RuleKind kind, int n) {
  const Rule* rule = rule_of(scheme, kind);
  if (rule == nullptr) return nullptr;
  const ExactBudget budget(kExactWork);
  Scope<Exact> scope(scheme, valence_of(kind, n), std::nullopt);
  for (const RuleCase& rule_case : *rule) {
    if (!rule_case.when) return &rule_case;
    Result<Exact> guard = scope(*rule_case.when);
    if (!guard) return needed_by(kind, n, guard.error());
    if (!guard->is_zero()) return &rule_case;
  }
  return nullptr;
}

Status check_rule(const Scheme& scheme, RuleKind kind, int n) {
  const ExactBudget budget(kExactWork);
  for (const Parameter& parameter : scheme.parameters)
    if (Status status = check_parameter(scheme, parameter, kind, n); !status) return status;
  return check_case(scheme, kind, n);
}

Status check_ranges(const Scheme& scheme) {
  const ExactBudget budget(kExactWork);
  std::set<const Parameter*> left;
  for (const Parameter& parameter : scheme.parameters) left.insert(&parameter);
  for (int i = 0; i < kRuleKinds; ++i) {
    const auto kind = static_cast<RuleKind>(i);
    if (rule_of(scheme, kind) == nullptr) continue;
    const auto [first, last] = checked_valences(scheme, kind);
    for (int n = first; n <= last; ++n)
      for (const Parameter& parameter : scheme.parameters) {
        if (!left.contains(&parameter)) continue;
        if (Status status = check_parameter(scheme, parameter, kind, n); !status) return status;
        if (is_of_numbers(parameter)) left.erase(&parameter);  // the same at every valence
      }
  }
  return Done{};
}

void check_rules(const Scheme& scheme, const std::set<std::string>& valueless,
                 const std::function<bool(RuleKind)>& is_left_out, Faults& faults) {
  const ExactBudget budget(kExactWork);
  std::set<std::pair<int, int>> places;  // of faults
  const auto note = [&](const Status& status) {
    if (!status && places.insert({status.error().line, status.error().column}).second)
      faults.add(status.error());
    return status.ok() || !is_exhausted();
  };
  for (int i = 0; i < kRuleKinds; ++i) {
    const auto kind = static_cast<RuleKind>(i);
    const Rule* rule = rule_of(scheme, kind);
    if (rule == nullptr) continue;
    bool left_out = is_left_out(kind) || uses_any(*rule, valueless);
    const auto [first, last] = checked_valences(scheme, kind);
    for (int n = first; n <= last; ++n) {
      for (const Parameter& parameter : scheme.parameters)
        if (!uses_any(parameter, valueless) && !note(check_parameter(scheme, parameter, kind, n)))
          return;
      if (left_out) continue;
      const Status status = check_case(scheme, kind, n);
      if (!note(status)) return;
      // what fails within a weight may fail at another place of it at the next valence
      left_out = !status && !is_of_case(*rule, status.error());
    }
  }
}

}  // namespace limn
