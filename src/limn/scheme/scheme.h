#pragma once
/// A scheme: the content of one scheme file. The rules exist here once; every reading of them
/// (refined positions, subdivision matrices, symbols, …) goes through `refine/` or `mask.h`.

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/split/split.h"
#include "limn/scheme/expression.h"
#include "limn/scheme/role.h"

namespace limn {

/// Where something stands in a scheme file, for errors; line 0: nowhere (a default, an option).
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

/// An expression and where its text begins.
struct Formula {
  Expression expression;
  Place place;
};

struct Weight {
  std::string role;  ///< as the file names it
  Walk walk;
  Formula value;  ///< of one position of the role
};

/// One alternative of a rule; the first whose guard holds is taken.
struct RuleCase {
  std::optional<Formula> when;
  std::vector<Weight> weights;
  Place place;
};
using Rule = std::vector<RuleCase>;

struct Parameter {
  std::string name;
  std::string meaning;
  Formula value;  ///< the default, or what `set_parameter` put in its place
  std::optional<Formula> low, high;
};

/// What the literature states of the scheme; the tests hold it true for every shipped file.
/// Known keys: tangent, cup, saddle (eigenvalues, in n), at the valences first … last.
struct Fact {
  int first = 0, last = 0;
  std::vector<std::pair<std::string, Formula>> values;
  std::string source;
  Place place;
};

/// The scheme is another one with its parameters set, at every value of its own; held true by the
/// tests as facts are.
struct Equivalence {
  std::string scheme;  ///< a shipped name
  /// Parameters of that scheme as expressions in this one's names, n among them; its others have
  /// their defaults.
  std::vector<std::pair<std::string, Formula>> with;
  std::string source;
  Place place;
};

/// Coefficients in rows from the top (largest e2) down; on triangles a hexagon of rows, each
/// shifted by half an edge against the next. Every coefficient is times `scale`.
struct Rows {
  std::vector<std::vector<Formula>> rows;
  std::optional<Formula> scale;
  Place place;
};

/// A regular mask as a product: one refinement, `stages` whole smoothing stages, single
/// directions (steps of the refined lattice, basis of lattice.h) with counts, and a kernel.
struct Factors {
  std::optional<Formula> stages;
  std::vector<std::pair<std::array<int, 2>, Formula>> directions;
  std::optional<Rows> kernel;
  Place place;
};

struct Scheme {
  std::string name;
  std::string title;
  std::string source;  ///< citation
  std::string notes;   ///< what a user should know, free text
  std::string file;    ///< path, or "NAME.toml" of a shipped scheme
  const Split* split = nullptr;
  std::vector<std::pair<std::string, Formula>> lets;
  std::vector<Parameter> parameters;
  std::array<std::optional<Rule>, kRuleKinds> rules;
  std::vector<Fact> facts;
  std::vector<Equivalence> equivalences;
  std::optional<Rows> stated_mask;  ///< facts: the regular mask as the literature prints it
  std::optional<Rows> mask;         ///< the scheme is given by its mask alone …
  std::optional<Factors> factors;   ///< … or by factors alone

  [[nodiscard]] const std::optional<Rule>& rule(RuleKind kind) const {
    return rules[static_cast<std::size_t>(kind)];
  }
};

/// Resolves the names of an expression: n and k where they are given, parameters, lets.
/// A let or a parameter may use n, k, and others of both; a circle is an error. Each is
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
    Result<Number> value = formula.expression.template evaluate<Number>(
        [this](const std::string& name) { return lookup(name); });
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
  using A = Arithmetic<Number>;
  if (name == "n" && n_) return A::from(Rational(*n_));
  if (name == "k" && k_) return A::from(Rational(*k_));
  if (const auto given = given_.find(name); given != given_.end()) return given->second;
  const Formula* formula = find(name);
  if (formula == nullptr) {
    if (name == "n" || name == "k")
      return Error{name + " has no value here",
                   name == "k" ? "k is defined in the weights of a role with a repeated step"
                               : "n is defined in rules of a vertex, a face or an edge's end"};
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

/// Reads a scheme file. Every fault (TOML syntax, unknown key, wrong type, unknown split, role or
/// name, a decimal, weights that do not sum to 1, an asymmetric rule, a vanishing
/// denominator…) is an error with file, line and column. `extends` takes the rules that the
/// file does not state from another scheme (a shipped name, or a path relative to the file).
[[nodiscard]] Result<Scheme> read_scheme(const std::string& path);
[[nodiscard]] Result<Scheme> parse_scheme(std::string_view text, const std::string& path);

/// A shipped scheme by name, or else a scheme file by path; an unknown name lists the near ones.
[[nodiscard]] Result<Scheme> find_scheme(const std::string& name_or_path);
/// Names of the shipped schemes, sorted.
[[nodiscard]] std::vector<std::string> shipped_schemes();

/// Sets parameters to expressions (which may use n and the lets), then checks the rules and the
/// ranges anew, of all of them together: counts of a box spline may fit only as a whole. Each
/// assignment is "name=expression". On an error the scheme is unchanged.
[[nodiscard]] Status set_parameters(Scheme& scheme, const std::vector<std::string>& assignments);
[[nodiscard]] Status set_parameter(Scheme& scheme, const std::string& assignment);

}  // namespace limn
