#include "limn/scheme/check.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "limn/scheme/placement.h"
#include "limn/scheme/scope.h"

namespace limn::scheme {
namespace {

/// The rule of that kind: in a scheme of stages, what two averagings make of a vertex.
const Rule* rule_of(const Scheme& scheme, RuleKind kind) {
  if (scheme.stages) return kind == RuleKind::vertex ? &scheme.stages->pair : nullptr;
  return scheme.rule(kind) ? &*scheme.rule(kind) : nullptr;
}

/// A rule at a valence (ignored where it has none), and of pairs of averagings the quads there.
struct Spot {
  RuleKind kind;
  int n;
  std::optional<int> quads = {};

  [[nodiscard]] std::string text() const {
    if (!rule_has_valence(kind)) return {};
    return fmt::format(" at n = {}", n) + (quads ? fmt::format(", q = {}", *quads) : "");
  }
  [[nodiscard]] std::optional<long long> valence() const {
    return rule_has_valence(kind) ? std::optional<long long>(n) : std::nullopt;
  }
  [[nodiscard]] Scope<number::Exact> scope(const Scheme& scheme,
                                           std::optional<long long> k = std::nullopt) const {
    Scope<number::Exact> scope(scheme, valence(), k);
    if (quads) scope.give(std::string(kQuads), number::Exact(*quads));
    return scope;
  }
};

Error faulty_rule(const Spot& at, const std::string& fault, std::string hint, const Place& place) {
  return {fmt::format("the {} rule{} {}", rule_name(at.kind), at.text(), fault), std::move(hint),
          place.file, place.line, place.column};
}

/// An error from an expression, with the rule it was needed for.
Error needed_by(const Spot& at, Error error) {
  error.message += fmt::format(", in the {} rule{}", rule_name(at.kind), at.text());
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
  Scopes(const Scheme& scheme, const Spot& at)
      : scheme_(scheme), at_(at), plain_(at.scope(scheme)) {}

  [[nodiscard]] Result<number::Exact> operator()(const Formula& formula) { return plain_(formula); }
  /// 0 ≤ k < n
  [[nodiscard]] Result<number::Exact> operator()(const Formula& formula, int k) {
    if (repeated_.empty())
      for (int i = 0; i < at_.n; ++i) repeated_.emplace_back(scheme_, at_.n, i);
    return repeated_[static_cast<std::size_t>(k)](formula);
  }

 private:
  const Scheme& scheme_;
  Spot at_;
  Scope<number::Exact> plain_;
  std::vector<Scope<number::Exact>> repeated_;
};

/// The weights of a repeated role for k = 0 … n-1.
Result<std::vector<number::Exact>> repeated_weights(Scopes& scopes, const Spot& at,
                                                    const Weight& weight) {
  std::vector<number::Exact> values;
  for (int k = 0; k < at.n; ++k) {
    Result<number::Exact> value = scopes(weight.value, k);
    if (!value) return needed_by(at, value.error());
    values.push_back(std::move(*value));
  }
  return values;
}

/// Round a vertex or a face no k is the first; along an edge and in a corner k and n-k are
/// mirror images, unless the role is placed from both sides anyway.
Status check_symmetry(const std::vector<number::Exact>& values, const Spot& at,
                      const Weight& weight, bool placed_twice) {
  const int n = static_cast<int>(values.size());
  const bool round = at.kind == RuleKind::vertex || at.kind == RuleKind::face;
  if (placed_twice && !round) return Done{};
  for (int k = 1; k < n; ++k) {
    const int mirror = round ? 0 : n - k;
    const Result<number::Exact> difference = number::Exact::subtract(
        values[static_cast<std::size_t>(k)], values[static_cast<std::size_t>(mirror)]);
    if (!difference) return needed_by(at, placed(difference.error(), weight));
    if (difference->is_zero()) continue;
    const std::string_view law = round ? "no k is the first here, so a weight must not depend on it"
                                       : "a weight must be the same for k and n-k";
    return faulty_rule(at,
                       fmt::format("is not symmetric: '{}' gives k = {} another weight than k = {}",
                                   weight.role, std::min(k, mirror), std::max(k, mirror)),
                       std::string(law), weight.value.place);
  }
  return Done{};
}

/// How often a weight of a pair of averagings counts.
int count_of_pair(const Scheme& scheme, const Spot& at, const Weight& weight) {
  if (pair_role(weight) == PairRole::self) return 1;
  if (pair_role(weight) == PairRole::ring) return at.n;
  if (at.quads) return *at.quads;
  return scheme.split->lattice == Lattice::quad ? at.n : 0;
}

Result<number::Exact> plain_sum(Scopes& scopes, const Spot& at, const Weight& weight,
                                const Rational& count) {
  Result<number::Exact> value = scopes(weight.value);
  if (!value) return needed_by(at, value.error());
  return number::Exact::multiply(number::Exact(count), *value);
}

Result<number::Exact> sum_of_weight(const Scheme& scheme, Scopes& scopes, const Spot& at,
                                    const Weight& weight) {
  if (scheme.stages) return plain_sum(scopes, at, weight, count_of_pair(scheme, at, weight));
  const Result<Placement> placement = place(at.kind, scheme.split->lattice, weight.walk);
  if (!placement) return placement.error();
  if (!weight.walk.repeated)
    return plain_sum(scopes, at, weight,
                     placement->times_n ? placement->count * at.n : placement->count);
  const Result<std::vector<number::Exact>> values = repeated_weights(scopes, at, weight);
  if (!values) return values.error();
  if (Status status = check_symmetry(*values, at, weight, placement->starts.size() > 1); !status)
    return status.error();
  Result<number::Exact> sum = number::Exact(0);
  for (const number::Exact& value : *values)
    if (sum) sum = number::Exact::add(*sum, value);
  if (!sum) return needed_by(at, placed(sum.error(), weight));
  return sum;
}

Error wrong_sum(const Spot& at, const number::Exact& sum, const Place& place) {
  if (!sum.is_rational() && std::abs(sum.approx() - 1) < 1e-9)
    return faulty_rule(at, "has weights whose sum cannot be shown to be exactly 1",
                       "write the same square root wherever one is a multiple of another", place);
  const std::string value =
      sum.is_rational() ? to_string(sum.rational()) : fmt::format("about {:.12g}", sum.approx());
  return faulty_rule(at, "has weights that sum to " + value + ", not 1",
                     "each weight counts once per position of its role", place);
}

Status check_sum(const Scheme& scheme, const Spot& at, const RuleCase& rule_case) {
  Scopes scopes(scheme, at);
  number::Exact sum;
  for (const Weight& weight : rule_case.weights) {
    const Result<number::Exact> part = sum_of_weight(scheme, scopes, at, weight);
    if (!part) return part.error();
    Result<number::Exact> longer = number::Exact::add(sum, *part);
    if (!longer) return needed_by(at, placed(longer.error(), weight));
    sum = std::move(*longer);
  }
  if (sum == number::Exact(1)) return Done{};
  return wrong_sum(at, sum, rule_case.place);
}

std::string range_text(const Parameter& parameter) {
  return fmt::format("[{}, {}]", parameter.low ? parameter.low->expression.text() : "-inf",
                     parameter.high ? parameter.high->expression.text() : "inf");
}

/// The sign of b - a; 1 where one of them is not stated.
Result<int> order(Scope<number::Exact>& scope, const std::optional<Formula>& a,
                  const std::optional<Formula>& b) {
  if (!a || !b) return 1;
  const Result<number::Exact> left = scope(*a);
  if (!left) return left.error();
  const Result<number::Exact> right = scope(*b);
  if (!right) return right.error();
  const Result<number::Exact> difference = number::Exact::subtract(*right, *left);
  if (!difference) return difference.error();
  return number::Arithmetic<number::Exact>::sign(*difference);
}

/// The parameter's value lies in its range, in the scope of one rule.
Status check_range(const Parameter& parameter, const Spot& at, Scope<number::Exact>& scope) {
  const Place& place = parameter.value.place;
  const auto fault = [&](const std::string& what) {
    return Error{fmt::format("parameter {} {}{}", parameter.name, what, at.text()),
                 {},
                 place.file,
                 place.line,
                 place.column};
  };
  const Result<int> width = order(scope, parameter.low, parameter.high);
  const Result<int> above_low = order(scope, parameter.low, parameter.value);
  const Result<int> below_high = order(scope, parameter.value, parameter.high);
  for (const Result<int>* result : {&width, &above_low, &below_high})
    if (!*result) return needed_by(at, result->error());
  if (*width < 0) return fault(fmt::format("has the empty range {}", range_text(parameter)));
  if (*above_low > -1 && *below_high > -1) return Done{};
  return fault(fmt::format("= {} is {} its range {}", parameter.value.expression.text(),
                           *above_low < 0 ? "below" : "above", range_text(parameter)));
}

/// The same for each k where the value needs one.
Status check_parameter(const Scheme& scheme, const Parameter& parameter, const Spot& at) {
  if (!parameter.low && !parameter.high) return Done{};
  // what has no value in a rule without n, or without k, is checked where it has one
  const bool valued = at.scope(scheme)(parameter.value).ok();
  if (!valued && !rule_has_valence(at.kind)) return Done{};
  for (int k = 0; k < (valued ? 1 : at.n); ++k) {
    Scope<number::Exact> scope =
        at.scope(scheme, valued ? std::nullopt : std::optional<long long>(k));
    if (Status status = check_range(parameter, at, scope); !status) return status;
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
Status check_case(const Scheme& scheme, const Spot& at) {
  const Result<const RuleCase*> rule_case = applicable_case(scheme, at.kind, at.n, at.quads);
  if (!rule_case) return rule_case.error();
  if (*rule_case != nullptr) return check_sum(scheme, at, **rule_case);
  if (stands_in_for(at.kind, *scheme.split) || scheme.mask || scheme.factors) return Done{};
  return missing_rule(scheme, at.kind, at.n, at.quads);
}

/// Whether so much was spent that no arithmetic is left: what it says then is no fault.
bool is_exhausted() { return !number::Exact::multiply(number::Exact(1), number::Exact(1)).ok(); }

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

/// All that check_rules looks at of one rule: at each valence, where both kinds of faces meet, with
/// any number of quads.
std::vector<Spot> checked_spots(const Scheme& scheme, RuleKind kind) {
  std::vector<Spot> spots;
  const auto [first, last] = checked_valences(scheme, kind);
  for (int n = first; n <= last; ++n) {
    if (!scheme.split->mixed) spots.push_back({kind, n});
    for (int q = 0; scheme.split->mixed && q <= n; ++q) spots.push_back({kind, n, q});
  }
  return spots;
}

using scheme::uses_any;

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

bool uses_any(const Formula& formula, const std::set<std::string>& names) {
  const std::vector<std::string>& used = formula.expression.names();
  return std::any_of(used.begin(), used.end(),
                     [&](const std::string& name) { return names.count(name) > 0; });
}

Error missing_rule(const Scheme& scheme, RuleKind kind, int n, std::optional<int> quads) {
  const bool by_mask = scheme.mask || scheme.factors;
  std::string hint = fmt::format("add a table [{}]", rule_name(kind));
  if (scheme.rule(kind)) hint = "add a case whose guard holds there, or one without a guard";
  if (by_mask)
    hint = "the scheme is given by its regular mask alone; write its rules to refine such a mesh";
  if (scheme.stages && kind != RuleKind::vertex)
    hint = "its step is a sequence of averagings; what asks for such a rule cannot be had of it";
  const bool has_cases = rule_of(scheme, kind) != nullptr;
  if (scheme.stages && has_cases) hint = "add a case to stages.pair whose guard holds there";
  const std::string where = has_cases || by_mask ? Spot{kind, n, quads}.text() : std::string();
  const Place place = place_without(scheme, kind);
  return {fmt::format("scheme '{}' has no {} rule{}", scheme.name, rule_name(kind), where), hint,
          place.file, place.line, place.column};
}

Result<const RuleCase*> applicable_case(const Scheme& scheme, RuleKind kind, int n,
                                        std::optional<int> quads) {
  const Rule* rule = rule_of(scheme, kind);
  if (rule == nullptr) return nullptr;
  const number::ExactBudget budget(kExactWork);
  const Spot at{kind, n, quads};
  Scope<number::Exact> scope = at.scope(scheme);
  for (const RuleCase& rule_case : *rule) {
    if (!rule_case.when) return &rule_case;
    Result<number::Exact> guard = scope(*rule_case.when);
    if (!guard) return needed_by(at, guard.error());
    if (!guard->is_zero()) return &rule_case;
  }
  return nullptr;
}

Status check_rule(const Scheme& scheme, RuleKind kind, int n, std::optional<int> quads) {
  const number::ExactBudget budget(kExactWork);
  const Spot at{kind, n, quads};
  for (const Parameter& parameter : scheme.parameters)
    if (Status status = check_parameter(scheme, parameter, at); !status) return status;
  return check_case(scheme, at);
}

Status check_ranges(const Scheme& scheme) {
  const number::ExactBudget budget(kExactWork);
  std::set<const Parameter*> left;
  for (const Parameter& parameter : scheme.parameters) left.insert(&parameter);
  for (int i = 0; i < kRuleKinds; ++i) {
    const auto kind = static_cast<RuleKind>(i);
    if (rule_of(scheme, kind) == nullptr) continue;
    for (const Spot& at : checked_spots(scheme, kind))
      for (const Parameter& parameter : scheme.parameters) {
        if (!left.contains(&parameter)) continue;
        if (Status status = check_parameter(scheme, parameter, at); !status) return status;
        if (is_of_numbers(parameter)) left.erase(&parameter);  // the same at every valence
      }
  }
  return Done{};
}

void check_rules(const Scheme& scheme, const std::set<std::string>& valueless,
                 const std::function<bool(RuleKind)>& is_left_out, base::Faults& faults) {
  const number::ExactBudget budget(kExactWork);
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
    for (const Spot& at : checked_spots(scheme, kind)) {
      for (const Parameter& parameter : scheme.parameters)
        if (!uses_any(parameter, valueless) && !note(check_parameter(scheme, parameter, at)))
          return;
      if (left_out) continue;
      const Status status = check_case(scheme, at);
      if (!note(status)) return;
      // what fails within a weight may fail at another place of it at the next valence
      left_out = !status && !is_of_case(*rule, status.error());
    }
  }
}

}  // namespace limn::scheme
