#include "limn/scheme/parameter_setter.h"

#include <algorithm>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "limn/base/near_word.h"
#include "limn/base/printable.h"
#include "limn/scheme/check.h"
#include "limn/scheme/scope.h"

namespace limn::scheme {
namespace {

/// How a value depends on one parameter: as a polynomial of at most this degree.
struct Degree {
  int degree = 0;
  std::optional<Rational> constant;  ///< the value, of a literal: what exponents may be
};

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

Error unknown_parameter(const Scheme& scheme, const std::string& name) {
  std::vector<std::string> known;
  known.reserve(scheme.parameters.size());
  for (const Parameter& parameter : scheme.parameters) known.push_back(parameter.name);
  return {fmt::format("scheme '{}' has no parameter '{}'", scheme.name, name),
          known.empty()
              ? "it has no parameters"
              : base::did_you_mean(name, known, fmt::format("it has {}", fmt::join(known, ", ")))};
}

/// Puts the expression in place; nothing is checked yet. `set`: the names that were set so far.
Status assign(Scheme& scheme, const std::string& assignment, std::set<std::string>& set) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos)
    return Error{fmt::format("'{}' sets no parameter", assignment),
                 "write name=expression, as a=1/8"};
  const std::string name = trimmed(assignment.substr(0, equals));
  const auto found = std::find_if(scheme.parameters.begin(), scheme.parameters.end(),
                                  [&](const Parameter& p) { return p.name == name; });
  if (found == scheme.parameters.end()) return unknown_parameter(scheme, name);
  if (!set.insert(name).second)
    return Error{fmt::format("parameter '{}' is set twice", name),
                 "give it one value, by -p or after the scheme's colon"};
  Result<Expression> expression = Expression::parse(assignment.substr(equals + 1));
  if (!expression) {
    Error error = expression.error();
    error.message = fmt::format("-p {}: column {}: {}", assignment,
                                static_cast<int>(equals) + 1 + error.column, error.message);
    error.column = 0;
    return error;
  }
  found->value = {std::move(*expression), {}};
  return Done{};
}

/// The number that the formula is, if it is one whatever names stand for.
std::optional<Rational> constant_of(const Scheme& scheme, const Formula& formula) {
  if (!formula.expression.names().empty()) return std::nullopt;
  const number::ExactBudget budget(kExactWork);
  const Result<number::Exact> value =
      Scope<number::Exact>(scheme, std::nullopt, std::nullopt)(formula);
  if (!value || !value->is_rational()) return std::nullopt;
  return value->rational();
}

}  // namespace
}  // namespace limn::scheme

namespace limn::number {

/// Fails where the value is no polynomial of the parameter, or might be none.
template <>
struct Arithmetic<scheme::Degree> {
  using Degree = scheme::Degree;
  static Degree from(const Rational& q) { return {0, q}; }
  static Degree pi() { return {}; }
  static Result<Degree> add(const Degree& a, const Degree& b) {
    return Degree{std::max(a.degree, b.degree), {}};
  }
  static Result<Degree> subtract(const Degree& a, const Degree& b) { return add(a, b); }
  static Result<Degree> multiply(const Degree& a, const Degree& b) {
    return Degree{a.degree + b.degree, {}};
  }
  static Result<Degree> divide(const Degree& a, const Degree& b) {
    if (b.degree > 0) return Error{"the divisor depends on it"};
    return Degree{a.degree, {}};
  }
  static Result<Degree> cos(const Degree& a) { return independent(a); }
  static Result<Degree> sin(const Degree& a) { return independent(a); }
  static Result<Degree> sqrt(const Degree& a) { return independent(a); }
  /// Of no use but to be told that it does not depend on the parameter.
  static Result<int> sign(const Degree& a) {
    if (a.degree > 0) return Error{"the sign depends on it"};
    return 1;
  }
  static Result<long long> integer(const Degree& a) {
    if (!a.constant) return Error{"the exponent is no literal"};
    return Arithmetic<Exact>::integer(Exact(*a.constant));
  }

 private:
  static Result<Degree> independent(const Degree& a) {
    if (a.degree > 0) return Error{"the argument depends on it"};
    return Degree{};
  }
};

}  // namespace limn::number

namespace limn::scheme {
namespace detail {

Status assign_parameters(Scheme& scheme, const std::vector<std::string>& assignments) {
  std::set<std::string> set;
  for (const std::string& assignment : assignments)
    if (Status status = assign(scheme, assignment, set); !status) return status;
  return Done{};
}

Error in_assignments(const std::vector<std::string>& assignments, Error fault) {
  fault.message =
      fmt::format("-p {}: {}", base::printable(fmt::format("{}", fmt::join(assignments, " -p "))),
                  fault.message);
  if (fault.line == 0) fault.column = 0;
  return fault;
}

std::optional<int> degree_of_weights(const Scheme& scheme, const std::string& parameter) {
  if (scheme.mask || scheme.factors || scheme.stages || scheme.has_decimals) return std::nullopt;
  Scope<Degree> scope(scheme, std::nullopt, std::nullopt);
  scope.give(parameter, {1, {}});
  scope.give("n", {});
  scope.give("k", {});
  int most = 0;
  for (const std::optional<Rule>& rule : scheme.rules) {
    if (!rule) continue;
    for (const RuleCase& one : *rule) {
      if (one.when) {
        const Result<Degree> guard = scope(*one.when);
        if (!guard || guard->degree > 0) return std::nullopt;
      }
      for (const Weight& weight : one.weights) {
        const Result<Degree> value = scope(weight.value);
        if (!value) return std::nullopt;
        most = std::max(most, value->degree);
      }
    }
  }
  return most;
}

}  // namespace detail

ParameterSetter::ParameterSetter(Scheme scheme) : scheme_(std::move(scheme)) { note(scheme_); }

ParameterSetter::Line& ParameterSetter::line(const Scheme& scheme, std::size_t parameter) {
  constexpr std::size_t kMostLines = 64;
  Key key{parameter, {}};
  for (std::size_t i = 0; i < scheme.parameters.size(); ++i)
    key.second.push_back(i == parameter ? std::string()
                                        : scheme.parameters[i].value.expression.text());
  if (const auto found = lines_.find(key); found != lines_.end()) return found->second;
  if (lines_.size() == kMostLines) lines_.clear();
  const std::string& name = scheme.parameters[parameter].name;
  return lines_.emplace(std::move(key), Line{detail::degree_of_weights(scheme, name), {}})
      .first->second;
}

/// That all rules are right with these parameters.
void ParameterSetter::note(const Scheme& scheme) {
  for (std::size_t i = 0; i < scheme.parameters.size(); ++i)
    if (const auto value = constant_of(scheme, scheme.parameters[i].value)) {
      Line& at = line(scheme, i);
      if (at.degree && !at.is_proved()) at.checked.insert(*value);
    }
}

Result<Scheme> ParameterSetter::with(const std::vector<std::string>& assignments) {
  Scheme changed = scheme_;
  if (Status status = detail::assign_parameters(changed, assignments); !status)
    return status.error();
  for (std::size_t i = 0; i < changed.parameters.size(); ++i) {
    if (!constant_of(changed, changed.parameters[i].value) || !line(changed, i).is_proved())
      continue;
    if (Status status = check_ranges(changed); !status)
      return detail::in_assignments(assignments, status.error());
    return changed;
  }
  changed = scheme_;
  if (Status status = set_parameters(changed, assignments); !status) return status.error();
  note(changed);
  return changed;
}

}  // namespace limn::scheme
