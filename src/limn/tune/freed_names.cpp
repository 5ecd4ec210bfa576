#include "limn/tune/freed_names.h"

#include <algorithm>

#include <fmt/core.h>

#include "limn/number/near_rational.h"
#include "limn/regular/regular_mask.h"
#include "limn/regular/smoothness/regularity.h"
#include "limn/scheme/formulas.h"
#include "limn/scheme/scope.h"
#include "limn/tune/margin.h"

namespace limn::tune {
namespace {

/// Names that the scheme does not use yet.
std::vector<std::string> unused_names(const Scheme& scheme, std::size_t count) {
  std::vector<std::string> names;
  for (int i = 1; names.size() < count; ++i) {
    std::string name = fmt::format("x{}", i);
    if (scheme::find_definition(scheme, name) == nullptr) names.push_back(std::move(name));
  }
  return names;
}

}  // namespace

struct FreedNames::Instance {
  Scheme scheme;
  std::vector<std::string> variables;
  std::unique_ptr<spectrum::SlopeAnalysis> analysis;
};

FreedNames::FreedNames(std::vector<FreedScheme> each) : each_(std::move(each)) {}
FreedNames::~FreedNames() = default;
FreedNames::FreedNames(FreedNames&&) noexcept = default;
FreedNames& FreedNames::operator=(FreedNames&&) noexcept = default;

Result<FreedNames> FreedNames::make(const Scheme& scheme, const std::vector<std::string>& names,
                                    Reach reach) {
  if (names.empty()) return Error{"nothing is freed"};
  std::vector<FreedScheme> each;
  for (const std::string& name : names) {
    for (const FreedScheme& other : each)
      if (other.name() == name) return Error{fmt::format("'{}' is freed twice", name)};
    Result<FreedScheme> freed = FreedScheme::make(scheme, name, reach);
    if (!freed) return freed.error();
    each.push_back(*std::move(freed));
  }
  return FreedNames(std::move(each));
}

Result<double> FreedNames::own_value(std::size_t j, int n) const {
  return scheme::Scope<double>(original(), n,
                               std::nullopt)(*scheme::find_definition(original(), each_[j].name()));
}

Result<FreedNames::Instance*> FreedNames::at(int n) {
  std::unique_ptr<Instance>& instance = instances_[n];
  if (instance) return instance.get();
  auto made = std::make_unique<Instance>();
  made->scheme = original();
  made->variables = unused_names(original(), size());
  for (std::size_t j = 0; j < size(); ++j) {
    Formula& formula = *scheme::find_definition(made->scheme, each_[j].name());
    const std::string& x = made->variables[j];
    Result<Expression> expression = Expression::parse(
        each_[j].everywhere(n)
            ? x
            : fmt::format("(n == {0}) * {1} + (n != {0}) * ({2})", n, x, formula.expression.text()),
        Decimals::admitted);  // the file's own text may have some
    if (!expression) return expression.error();
    formula.expression = *std::move(expression);
    made->scheme.lets.emplace_back(x, Formula{Expression::constant(0), {}});
  }
  made->analysis = std::make_unique<spectrum::SlopeAnalysis>(made->scheme, made->variables);
  instance = std::move(made);
  return instance.get();
}

Result<spectrum::BlockSlopes> FreedNames::slopes(int n, const std::vector<double>& x,
                                                 const std::vector<int>& frequencies) {
  const Result<Instance*> instance = at(n);
  if (!instance) return instance.error();
  return (*instance)->analysis->blocks(n, x, frequencies);
}

Result<Scheme> FreedNames::with_numbers(int n, const std::vector<double>& x) {
  const Result<Instance*> instance = at(n);
  if (!instance) return instance.error();
  Scheme scheme = (*instance)->scheme;
  for (std::size_t j = 0; j < size(); ++j)
    scheme::find_definition(scheme, (*instance)->variables[j])->expression =
        Expression::constant(Rational(x[j]));
  return scheme;
}

Result<FrequencyBlocks> FreedNames::blocks(int n, const std::vector<double>& x) {
  const Result<Scheme> scheme = with_numbers(n, x);
  if (!scheme) return scheme.error();
  return FrequencyAnalysis(*scheme).blocks(n);
}

RegularPart FreedNames::regular_part(int n, const std::vector<double>& x) {
  Result<Scheme> scheme = with_numbers(n, x);
  if (!scheme) return {Truth::undecided, scheme.error().message};
  // sum rules hold exactly or not at all: 1/3 has some that the double next to it has not
  for (std::size_t j = 0; j < size(); ++j) {
    const std::optional<Rational> simple = number::near_rational(x[j]);
    if (!simple && each_[j].everywhere(n))
      return {Truth::undecided, known_in_digits_only(each_[j].name())};
    if (simple)
      scheme::find_definition(*scheme, (*at(n))->variables[j])->expression =
          Expression::constant(*simple);
  }
  const Result<Mask> mask = regular_mask(*scheme);
  if (!mask) return {Truth::undecided, mask.error().message};
  return find_regular_part(*mask);
}

Result<number::Jet> FreedNames::evaluate(
    const Expression& expression, int n, const std::vector<double>& x,
    const std::vector<std::pair<std::string_view, number::Jet>>& beside) {
  const Result<Instance*> instance = at(n);
  if (!instance) return instance.error();
  scheme::Scope<number::Jet> scope((*instance)->scheme, n, std::nullopt);
  for (std::size_t j = 0; j < size(); ++j)
    scope.give((*instance)->variables[j], number::Jet::variable(x[j], j, size()));
  return limn::scheme::evaluate<number::Jet>(expression,
                                             [&](const std::string& name) -> Result<number::Jet> {
                                               for (const auto& [known, value] : beside)
                                                 if (known == name) return value;
                                               return scope({Expression::parse(name).value(), {}});
                                             });
}

}  // namespace limn::tune
