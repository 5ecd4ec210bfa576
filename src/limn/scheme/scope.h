#pragma once
/// The values of a scheme's formulas.

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "limn/scheme/evaluate.h"
#include "limn/scheme/scheme.h"

namespace limn::scheme {

/// Resolves the names of an expression: n, k and (by `give`) q where they are given, parameters,
/// lets. A let or a parameter may use these, and others of both; a circle is an error. Each is
/// evaluated once in the life of a scope.
template <class Number>
class Scope {
 public:
  Scope(const Scheme& scheme, std::optional<long long> n, std::optional<long long> k)
      : scheme_(scheme), n_(n), k_(k) {}

  /// From now on `name` has this value: n or k that the constructor left out, a parameter or a let
  /// in place of its definition, or any other name.
  void give(const std::string& name, Number value) {
    given_.insert_or_assign(name, std::move(value));
  }

  /// Value of a formula; an error carries the formula's place.
  [[nodiscard]] Result<Number> operator()(const Formula& formula) {
    located_ = false;
    return evaluate(formula);
  }

 private:
  static constexpr std::size_t kDeepest = 64;  // so that a hostile file cannot exhaust the stack

  Result<Number> evaluate(const Formula& formula) {
    Result<Number> value = limn::scheme::evaluate<Number>(
        formula.expression, [this](const std::string& name) { return lookup(name); });
    if (!value && !located_) locate(value.error(), formula);
    return value;
  }

  void locate(Error& error, const Formula& formula) {
    error.file = formula.place.file;
    error.line = formula.place.line;
    if (formula.place.line > 0) error.column = formula.place.column + error.column;
    located_ = true;
  }

  [[nodiscard]] const Formula* find(const std::string& name) const {
    for (const auto& [let, value] : scheme_.lets)
      if (let == name) return &value;
    for (const Parameter& parameter : scheme_.parameters)
      if (parameter.name == name) return &parameter.value;
    return nullptr;
  }

  Result<Number> lookup(const std::string& name);

  const Scheme& scheme_;
  std::optional<long long> n_, k_;
  std::map<std::string, Number> given_;
  std::map<const Formula*, Number> known_;
  std::vector<const Formula*> open_;  // being evaluated, outermost first
  bool located_ = false;
};

template <class Number>
Result<Number> Scope<Number>::lookup(const std::string& name) {
  using A = number::Arithmetic<Number>;
  if (name == "n" && n_) return A::from(Rational(*n_));
  if (name == "k" && k_) return A::from(Rational(*k_));
  if (const auto given = given_.find(name); given != given_.end()) return given->second;
  const Formula* formula = find(name);
  if (formula == nullptr) {
    if (name == "n" || name == "k")
      return Error{name + " has no value here",
                   name == "k" ? "k is defined in the weights of a role with a repeated step"
                               : "n is defined in rules of a vertex, a face or an edge's end"};
    if (name == "q")
      return Error{"q has no value here", "q is the number of quads at a vertex, in stages.pair"};
    return Error{"unknown name '" + name + "'", "names are n, k, the parameters and the lets"};
  }
  if (const auto known = known_.find(formula); known != known_.end()) return known->second;
  if (std::find(open_.begin(), open_.end(), formula) != open_.end())
    return Error{"'" + name + "' is defined in terms of itself"};
  if (open_.size() == kDeepest) return Error{"more than 64 definitions hang one on another"};
  open_.push_back(formula);
  Result<Number> value = evaluate(*formula);
  open_.pop_back();
  if (value) known_.emplace(formula, *value);
  return value;
}

}  // namespace limn::scheme
