#include "limn/tune/freed_scheme.h"

#include <algorithm>
#include <set>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "limn/base/near_word.h"
#include "limn/number/near_rational.h"
#include "limn/regular/regular_mask.h"
#include "limn/regular/smoothness/regularity.h"
#include "limn/scheme/check.h"
#include "limn/scheme/formulas.h"
#include "limn/scheme/scope.h"

namespace limn {
namespace {

constexpr double kDefaultReach = 4;         // of a search without a stated range: [-4, 4]
constexpr std::size_t kMostInstances = 96;  // kept at a time

using Names = std::set<std::string, std::less<>>;

const Parameter* find_parameter(const Scheme& scheme, const std::string& name) {
  for (const Parameter& parameter : scheme.parameters)
    if (parameter.name == name) return &parameter;
  return nullptr;
}

/// Adds the names that an expression uses, and those that their definitions use.
void collect(const Scheme& scheme, const Expression& expression, Names& names) {
  for (const std::string& name : expression.names()) {
    if (!names.insert(name).second) continue;
    if (const Formula* formula = scheme::find_definition(scheme, name))
      collect(scheme, formula->expression, names);
  }
}

bool is_interior(RuleKind kind) { return kind < RuleKind::boundary_vertex; }

/// Whether the rule's anchor may be the centre of a star. A face that surrounds one never is.
bool may_be_center(RuleKind kind) { return rule_has_valence(kind) && kind != RuleKind::face; }

struct Use {
  Names at_center, elsewhere, in_guards;  // of rules
  Names with_n, with_k;                   // definitions that depend on n, on k
};

Use uses_of(const Scheme& scheme) {
  Use use;
  for (int i = 0; i < kRuleKinds; ++i) {
    const auto kind = static_cast<RuleKind>(i);
    if (!is_interior(kind) || !scheme.rule(kind)) continue;
    for (const RuleCase& rule_case : *scheme.rule(kind)) {
      if (rule_case.when) collect(scheme, rule_case.when->expression, use.in_guards);
      for (const Weight& weight : rule_case.weights)
        collect(scheme, weight.value.expression,
                may_be_center(kind) ? use.at_center : use.elsewhere);
    }
  }
  const auto note = [&](const std::string& name, const Formula& formula) {
    Names inner;
    collect(scheme, formula.expression, inner);
    if (inner.count("n") > 0) use.with_n.insert(name);
    if (inner.count("k") > 0) use.with_k.insert(name);
  };
  for (const auto& [let, value] : scheme.lets) note(let, value);
  for (const Parameter& parameter : scheme.parameters) note(parameter.name, parameter.value);
  return use;
}

bool is_freeable(const Use& use, const std::string& name) {
  return use.at_center.count(name) + use.elsewhere.count(name) > 0 &&
         use.in_guards.count(name) + use.with_k.count(name) == 0;
}

Error not_freeable(const Scheme& scheme, const Use& use, const std::string& name) {
  const std::string why =
      scheme::find_definition(scheme, name) == nullptr
          ? fmt::format("scheme '{}' has no let and no parameter '{}'", scheme.name, name)
      : scheme.stages
          ? fmt::format(
                "the step of '{}' is a sequence of averagings, of which nothing is freed yet",
                scheme.name)
      : use.in_guards.count(name) > 0
          ? fmt::format("a case of a rule is chosen by '{}', so it cannot be freed", name)
      : use.with_k.count(name) > 0
          ? fmt::format("'{}' is a number for each k, so it cannot be freed", name)
          : fmt::format("no weight of an interior rule uses '{}'", name);
  const std::vector<std::string> known = freeable_names(scheme);
  return {why, known.empty()
                   ? fmt::format("scheme '{}' has nothing that can be freed", scheme.name)
                   : base::did_you_mean(name, known,
                                        fmt::format("can be freed: {}", fmt::join(known, ", ")))};
}

/// A name that the scheme does not use yet.
std::string unused_name(const Scheme& scheme) {
  std::string name = "x";
  while (scheme::find_definition(scheme, name) != nullptr) name += '_';
  return name;
}

Result<Expression> parse_part(std::string_view text, std::size_t begin, std::string_view part) {
  Result<Expression> expression = Expression::parse(part);
  if (expression) return expression;
  Error error = expression.error();
  error.message = fmt::format("range '{}': column {}: {}", text,
                              static_cast<int>(begin) + error.column, error.message);
  error.column = 0;
  return error;
}

}  // namespace

Result<SearchRange> SearchRange::parse(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos)
    return Error{fmt::format("range '{}' has no comma", text), "write both ends, as 0,1/8"};
  Result<Expression> low = parse_part(text, 0, text.substr(0, comma));
  if (!low) return low.error();
  Result<Expression> high = parse_part(text, comma + 1, text.substr(comma + 1));
  if (!high) return high.error();
  return SearchRange{std::move(*low), std::move(*high)};
}

std::vector<std::string> freeable_names(const Scheme& scheme) {
  const Use use = uses_of(scheme);
  std::vector<std::string> names;
  for (const auto& let : scheme.lets)
    if (is_freeable(use, let.first)) names.push_back(let.first);
  for (const Parameter& parameter : scheme.parameters)
    if (is_freeable(use, parameter.name)) names.push_back(parameter.name);
  return names;
}

struct FreedScheme::Instance {
  explicit Instance(const Scheme& original) : scheme(original) {}

  Scheme scheme;
  Formula* free = nullptr;  ///< what holds x in `scheme`
  std::unique_ptr<FrequencyAnalysis> analysis;
};

FreedScheme::FreedScheme(const Scheme& scheme, std::string name, bool everywhere)
    : original_(std::make_unique<Scheme>(scheme)),
      name_(std::move(name)),
      everywhere_(everywhere),
      regular_(regular_valence(scheme.split->is_dual() ? RuleKind::corner : RuleKind::vertex,
                               scheme.split->lattice)) {}
FreedScheme::~FreedScheme() = default;
FreedScheme::FreedScheme(FreedScheme&&) noexcept = default;
FreedScheme& FreedScheme::operator=(FreedScheme&&) noexcept = default;

Result<FreedScheme> FreedScheme::make(const Scheme& scheme, const std::string& name, Reach reach) {
  const Use use = uses_of(scheme);
  if (!is_freeable(use, name) || scheme::find_definition(scheme, name) == nullptr)
    return not_freeable(scheme, use, name);
  const bool one_number = use.elsewhere.count(name) > 0 || use.with_n.count(name) == 0;
  return FreedScheme(scheme, name, reach == Reach::everywhere || one_number);
}

/// A copy of the scheme with a let for x, to which the freed name refers.
Result<std::unique_ptr<FreedScheme::Instance>> FreedScheme::build(int n) const {
  auto instance = std::make_unique<Instance>(*original_);
  Scheme& scheme = instance->scheme;
  const std::string x = unused_name(scheme);
  Formula& formula = *scheme::find_definition(scheme, name_);
  std::string text = x;
  if (!everywhere(n))
    text = fmt::format("(n == {0}) * {1} + (n != {0}) * ({2})", n, x, formula.expression.text());
  // the file's own text, which may have decimals
  Result<Expression> expression = Expression::parse(text, Decimals::admitted);
  if (!expression) return expression.error();
  formula.expression = std::move(*expression);
  scheme.lets.emplace_back(x, Formula{Expression::constant(0), {}});
  instance->free = &scheme.lets.back().second;
  instance->analysis = std::make_unique<FrequencyAnalysis>(scheme);
  return instance;
}

Result<FreedScheme::Instance*> FreedScheme::named_at(int n, double x) {
  std::unique_ptr<Instance>& instance = named_[n];
  if (!instance) {
    Result<std::unique_ptr<Instance>> built = build(n);
    if (!built) return built.error();
    instance = std::move(built.value());
  }
  instance->free->expression = Expression::constant(Rational(x));
  return instance.get();
}

Result<FreedScheme::Instance*> FreedScheme::fixed_at(int n, double x) {
  if (fixed_.size() >= kMostInstances) fixed_.clear();
  std::unique_ptr<Instance>& instance = fixed_[x];
  if (!instance) {
    Result<std::unique_ptr<Instance>> built = build(n);
    if (!built) return built.error();
    instance = std::move(built.value());
    instance->free->expression = Expression::constant(Rational(x));
  }
  return instance.get();
}

Result<FrequencyAnalysis*> FreedScheme::analysis_at(int n, double x) {
  const Result<Instance*> instance = everywhere(n) ? fixed_at(n, x) : named_at(n, x);
  if (!instance) return instance.error();
  return (*instance)->analysis.get();
}

Result<FrequencyBlocks> FreedScheme::blocks(int n, double x) {
  const Result<FrequencyAnalysis*> analysis = analysis_at(n, x);
  if (!analysis) return analysis.error();
  return (*analysis)->blocks(n);
}

Result<FrequencyBlocks> FreedScheme::blocks(int n, double x, const std::vector<int>& frequencies) {
  const Result<FrequencyAnalysis*> analysis = analysis_at(n, x);
  if (!analysis) return analysis.error();
  return (*analysis)->blocks(n, frequencies);
}

RegularPart FreedScheme::regular_part(int n, double x) {
  if (!everywhere(n)) {
    if (!own_regular_part_) own_regular_part_ = find_regular_part(*original_);
    return *own_regular_part_;
  }
  const Result<Instance*> instance = fixed_at(n, x);
  if (!instance) return {Truth::undecided, instance.error().message};
  // sum rules hold exactly or not at all: 1/3 has some that the double next to it has not
  Scheme exact = (*instance)->scheme;
  exact.lets.back().second.expression =
      Expression::constant(number::near_rational(x).value_or(Rational(x)));
  const Result<Mask> mask = regular_mask(exact);
  if (!mask) return {Truth::undecided, mask.error().message};
  const int order = polynomial_orders(*mask).sum_rules;
  if (order > 2) return find_regular_part(*mask);
  const auto known = low_order_parts_.find(order);
  if (known != low_order_parts_.end()) return known->second;
  RegularPart part = find_regular_part(*mask);
  if (part.bounded == Truth::no) low_order_parts_.emplace(order, part);
  return part;
}

Result<double> FreedScheme::evaluate(
    const Expression& expression, int n, double x,
    const std::vector<std::pair<std::string_view, double>>& beside) {
  const Result<Instance*> instance = named_at(n, x);
  if (!instance) return instance.error();
  scheme::Scope<double> scope((*instance)->scheme, n, std::nullopt);
  return limn::scheme::evaluate<double>(expression, [&](const std::string& name) -> Result<double> {
    for (const auto& [known, value] : beside)
      if (known == name) return value;
    return scope({Expression::parse(name).value(), {}});
  });
}

Result<Interval> FreedScheme::search_range(int n, const SearchRange* stated) {
  const Parameter* parameter = find_parameter(*original_, name_);
  const Expression* low = stated != nullptr ? &stated->low : nullptr;
  const Expression* high = stated != nullptr ? &stated->high : nullptr;
  if (stated == nullptr && parameter != nullptr) {
    if (parameter->low) low = &parameter->low->expression;
    if (parameter->high) high = &parameter->high->expression;
  }
  Interval interval{-kDefaultReach, kDefaultReach};
  for (const auto& [end, expression] : {std::pair(&interval.low, low), {&interval.high, high}}) {
    if (expression == nullptr) continue;
    scheme::Scope<double> scope(*original_, n, std::nullopt);
    const Result<double> value = scope({*expression, {}});
    if (!value) {
      Error error = value.error();
      error.message =
          fmt::format("range of {}: '{}': {}", name_, expression->text(), error.message);
      error.column = 0;
      return error;
    }
    *end = *value;
  }
  if (low == nullptr && high != nullptr) interval.low = interval.high - 2 * kDefaultReach;
  if (high == nullptr && low != nullptr) interval.high = interval.low + 2 * kDefaultReach;
  if (interval.low < interval.high) return interval;
  return Error{fmt::format("the range [{:.6g}, {:.6g}] of {} is empty at n = {}", interval.low,
                           interval.high, name_, n),
               "write its lower end first"};
}

}  // namespace limn
