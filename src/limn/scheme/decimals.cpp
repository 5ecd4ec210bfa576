#include "limn/scheme/decimals.h"

#include <cmath>

#include <fmt/core.h>

#include "limn/scheme/check.h"
#include "limn/scheme/placement.h"
#include "limn/scheme/scope.h"

namespace limn::scheme {
namespace {

/// Σ count · weight as text; nothing where a role is repeated.
std::optional<std::string> sum_text(const Scheme& scheme, RuleKind kind, const RuleCase& one) {
  std::string text;
  for (const Weight& weight : one.weights) {
    if (weight.walk.repeated) return std::nullopt;
    const Result<Placement> placement = place(kind, scheme.split->lattice, weight.walk);
    if (!placement) return std::nullopt;
    text += fmt::format("{}{}{}*({})", text.empty() ? "" : " + ", to_string(placement->count),
                        placement->times_n ? "*n" : "", weight.value.expression.text());
  }
  return text;
}

/// Whether the sum is 1 to rounding wherever the case applies, and not exactly 1 at every n.
bool is_rounded(const Scheme& scheme, RuleKind kind, const RuleCase& one, const Formula& sum) {
  bool off = false;
  for (int n = kSmallestValence - 1; n <= kLargestCheckedValence; ++n) {
    const Result<const RuleCase*> applies = applicable_case(scheme, kind, n);
    if (!applies) return false;
    if (*applies != &one) continue;
    std::optional<long long> valence;
    if (rule_has_valence(kind)) valence = n;
    const Result<number::Exact> value = Scope<number::Exact>(scheme, valence, std::nullopt)(sum);
    if (!value || !(std::abs(value->approx() - 1) <= kDecimalTolerance)) return false;
    off = off || !(*value == number::Exact(1));
  }
  return off;
}

}  // namespace

void divide_by_sums(Scheme& scheme) {
  for (int i = 0; i < kRuleKinds; ++i) {
    const auto kind = static_cast<RuleKind>(i);
    std::optional<Rule>& rule = scheme.rules[static_cast<std::size_t>(i)];
    if (!rule) continue;
    for (RuleCase& one : *rule) {
      const std::optional<std::string> text = sum_text(scheme, kind, one);
      if (!text) continue;
      Result<Expression> sum = Expression::parse(*text, Decimals::admitted);
      if (!sum || !is_rounded(scheme, kind, one, {std::move(*sum), one.place})) continue;
      for (Weight& weight : one.weights) {
        Result<Expression> quotient = Expression::parse(
            fmt::format("({}) / ({})", weight.value.expression.text(), *text), Decimals::admitted);
        if (quotient) weight.value.expression = std::move(*quotient);
      }
    }
  }
}

}  // namespace limn::scheme
