#include "limn/certify/all/range_rules.h"

#include <algorithm>

#include <fmt/core.h>

#include "limn/spectrum/symbolic_weights.h"

namespace limn::certify {
namespace {

/// A formula's value for the valences of the range.
Result<PowerBall> value_of(const number::Polynomial& formula);

Result<PowerBall> value_of(const number::Indeterminate& indeterminate) {
  using A = number::Arithmetic<PowerBall>;
  if (indeterminate->name == "n") return PowerBall::valence();
  if (indeterminate->name == "pi") return A::pi();
  if (!indeterminate->argument) return Error{"'" + indeterminate->name + "' has no value here"};
  Result<PowerBall> argument = value_of(*indeterminate->argument);
  if (!argument) return argument;
  if (indeterminate->kind == number::IndeterminateKind::root) return A::sqrt(*argument);
  return A::cos(*argument * A::pi());
}

Result<PowerBall> value_of(const number::Polynomial& formula) {
  PowerBall sum;
  for (const auto& [monomial, coefficient] : formula.terms()) {
    PowerBall product(coefficient);
    for (const auto& [indeterminate, exponent] : monomial) {
      Result<PowerBall> factor = value_of(indeterminate);
      if (!factor) return factor;
      for (int i = 0; i < std::abs(exponent); ++i)
        product = exponent > 0 ? product * *factor : product / *factor;
    }
    sum = sum + product;
  }
  return sum;
}

Result<PowerBall> value_of(const number::Symbolic& formula) {
  Result<PowerBall> numerator = value_of(formula.numerator());
  if (!numerator) return numerator;
  Result<PowerBall> denominator = value_of(formula.denominator());
  if (!denominator) return denominator;
  return number::Arithmetic<PowerBall>::divide(*numerator, *denominator);
}

/// The case of a rule that applies for all valences of the range.
Result<const RuleCase*> case_of_range(const Scheme& scheme, RuleKind kind) {
  const std::optional<Rule>& rule = scheme.rule(kind);
  if (!rule) return nullptr;
  scheme::Scope<PowerBall> scope(scheme, std::nullopt, std::nullopt);
  scope.give("n", PowerBall::valence());
  for (const RuleCase& one : *rule) {
    if (!one.when) return &one;
    const Result<PowerBall> guard = scope(*one.when);
    if (!guard) return guard.error();
    const Result<int> sign = number::Arithmetic<PowerBall>::sign(*guard);
    if (!sign) return sign.error();
    if (*sign != 0) return &one;
  }
  return nullptr;
}

/// Sums of formulas, or the first error of one.
class Total {
 public:
  void add(const Result<number::Symbolic>& term) {
    result_ = combined(number::Symbolic::add, term);
  }
  void add_times(const number::Symbolic& factor, const number::Symbolic& term) {
    add(number::Symbolic::multiply(factor, term));
  }
  [[nodiscard]] const Result<number::Symbolic>& result() const { return result_; }

 private:
  template <class Operation>
  Result<number::Symbolic> combined(Operation&& operation,
                                    const Result<number::Symbolic>& term) const {
    if (!result_) return result_;
    if (!term) return term;
    return operation(*result_, *term);
  }
  Result<number::Symbolic> result_ = number::Symbolic(0);
};

}  // namespace

Result<RangeRules> RangeRules::make(const Scheme& scheme, int from) {
  RangeRules rules;
  rules.scheme_ = &scheme;
  rules.from_ = from;
  if (Status chosen = rules.choose_cases(); !chosen) return chosen.error();
  Result<spectrum::SectorPattern> pattern = exact_pattern(scheme, from);
  if (!pattern) return pattern.error();
  rules.pattern_ = std::move(*pattern);
  rules.basis_ = real_basis(rules.pattern_);
  if (Status found = rules.find_sums(); !found) return found.error();
  rules.find_dependence();
  for (const spectrum::SectorTerm& term : rules.pattern_.terms)
    if (term.repeated >= 0 && term.slope == 0 && term.row != spectrum::kCenter &&
        term.column != spectrum::kCenter)
      return Error{
          "weights of several places fall on one vertex; this is not proved for all valences"};
  return rules;
}

Status RangeRules::choose_cases() {
  // n = from itself is decided exactly, so that a guard may change there
  const ValenceRange range(
      number::Ball::hull(number::Ball(0), number::Ball(Rational(Integer(1), Integer(from_ + 1)))));
  const Result<spectrum::CenterCases> cases = spectrum::center_cases(*scheme_, from_);
  if (!cases) return cases.error();
  if (scheme_->stages) return Error{"the scheme's step is a sequence of averagings"};
  const std::vector<RuleKind> kinds = spectrum::center_rules(*scheme_->split);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const Result<const RuleCase*> chosen = case_of_range(*scheme_, kinds[i]);
    if (!chosen || *chosen != (*cases)[i])
      return Error{
          fmt::format("the {} rule's guards do not choose one case for all valences n ≥ {}",
                      rule_name(kinds[i]), from_)};
  }
  return Done{};
}

Status RangeRules::find_sums() {
  const spectrum::NamesKept kept{};
  spectrum::SymbolicWeights weights(*scheme_, kept);
  std::map<RuleKind, Total> sums;
  for (std::size_t i = 0; i < pattern_.names.size(); ++i) {
    const spectrum::NamedWeight& name = pattern_.names[i];
    if (name.regular) continue;
    Total& sum = sums[name.kind];
    if (!name.repeated) {
      const Result<number::Symbolic> value = weights.plain(name);
      if (!value) return value.error();
      sum.add_times(name.per_sector ? weights.n() : number::Symbolic(1), *value);
      continue;
    }
    const Result<spectrum::RepeatedWeight> value = weights.repeated(name);
    if (!value) return value.error();
    Repeated& to = repeated_[i];
    to.harmonics = value->harmonics;
    to.half_harmonics = value->half_harmonics;
    for (const auto& [k, weight] : value->first) to.apart.emplace_back(k, weight);
    for (const auto& [k, weight] : value->last) to.apart.emplace_back(-k, weight);
    for (const auto& [k, weight] : to.apart) sum.add(weight);
    for (const auto* harmonics : {&to.harmonics, &to.half_harmonics})
      for (const auto& [m, weight] : *harmonics) {
        if (m == 0) sum.add_times(weights.n(), weight);
        if (!weight.is_zero()) last_special_ = std::max(last_special_, m);
      }
  }
  for (const auto& [kind, sum] : sums) {
    if (!sum.result()) return sum.result().error();
    if (!(*sum.result() == number::Symbolic(1)))
      return Error{
          fmt::format("that the weights of the {} rule sum to 1 for all valences is not shown",
                      rule_name(kind))};
  }
  if (weights.least_valence() > from_)
    return Error{fmt::format("the weights' formulas hold for valences n ≥ {} alone",
                             weights.least_valence())};
  return Done{};
}

void RangeRules::find_dependence() {
  const ValenceRange range(
      number::Ball::hull(number::Ball(0), number::Ball(Rational(Integer(1), Integer(from_)))));
  const auto depends = [&](int name) {
    const auto number = static_cast<std::size_t>(name);
    const spectrum::NamedWeight& one = pattern_.names[number];
    if (one.regular) return false;
    if (!one.repeated) {
      const Result<PowerBall> value = plain(one);
      return !value || !value->is_constant();
    }
    const auto& apart = repeated_.at(number).apart;
    return std::any_of(apart.begin(), apart.end(),
                       [](const auto& one_of) { return one_of.second.depends_on("n"); });
  };
  for (const spectrum::SectorTerm& term : pattern_.terms) {
    if (term.row == spectrum::kCenter || term.column == spectrum::kCenter) continue;
    if (term.repeated >= 0) same_weights_ = false;
    if (term.repeated >= 0 && depends(term.repeated)) steady_ = false;
    for (const int name : term.names)
      if (depends(name)) steady_ = false;
  }
}

Result<PowerBall> RangeRules::plain(const spectrum::NamedWeight& name) const {
  scheme::Scope<PowerBall> scope = scope_of<PowerBall>(*scheme_, name, std::nullopt, 0);
  if (!name.regular) scope.give("n", PowerBall::valence());
  Result<PowerBall> value = scope(name.weight->value);
  if (!value) return value;
  return number::Arithmetic<PowerBall>::multiply(*value, PowerBall(name.share));
}

Result<NamedValues<PowerBall>> RangeRules::values(int frequency) const {
  const std::size_t count = pattern_.names.size();
  NamedValues<PowerBall> result{PowerBall::valence(), {}};
  result.values.resize(count);
  result.positions.resize(count);
  result.amid.resize(count);
  result.amid_half.resize(count);
  const auto add_harmonic = [&](const std::map<int, number::Symbolic>& harmonics,
                                PowerBall& sum) -> Status {
    const auto harmonic = harmonics.find(frequency);
    if (harmonic == harmonics.end()) return Done{};
    const Result<PowerBall> value = value_of(harmonic->second);
    if (!value) return value.error();
    const Rational share(Integer(1), Integer(frequency == 0 ? 1 : 2));
    sum = *value * PowerBall::valence() * PowerBall(share);
    return Done{};
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (!pattern_.names[i].repeated) {
      Result<PowerBall> value = plain(pattern_.names[i]);
      if (!value) return value.error();
      result.values[i].push_back(std::move(*value));
      continue;
    }
    const Repeated& repeated = repeated_.at(i);
    for (const auto& [k, weight] : repeated.apart) {
      Result<PowerBall> value = value_of(weight);
      if (!value) return value.error();
      result.positions[i].push_back(k);
      result.values[i].push_back(std::move(*value));
    }
    if (Status status = add_harmonic(repeated.harmonics, result.amid[i]); !status)
      return status.error();
    if (Status status = add_harmonic(repeated.half_harmonics, result.amid_half[i]); !status)
      return status.error();
  }
  return result;
}

number::BallMatrix RangeRules::block(const NamedValues<PowerBall>& values,
                                     const Phase<number::Ball>& phase) const {
  const Phase<PowerBall> at = [&](int numerator, int denominator) {
    const Turn<number::Ball> turn = phase(numerator, denominator);
    return Turn<PowerBall>(PowerBall(turn.cosine), PowerBall(turn.to_imaginary),
                           PowerBall(turn.to_real));
  };
  const number::DenseMatrix<PowerBall> block =
      RealBlock<PowerBall>(pattern_, basis_, values, at, false).make();
  number::BallMatrix result(block.rows(), block.rows());
  for (std::size_t i = 0; i < block.rows(); ++i)
    for (std::size_t j = 0; j < block.rows(); ++j) result(i, j) = block(i, j).ball();
  return result;
}

number::DenseMatrix<PowerBall> RangeRules::constant_block(
    const NamedValues<PowerBall>& values) const {
  const Phase<PowerBall> none = [](int, int) {
    return Turn<PowerBall>({PowerBall(1), PowerBall(0)});
  };
  return RealBlock<PowerBall>(pattern_, basis_, values, none, true).make();
}

}  // namespace limn::certify
