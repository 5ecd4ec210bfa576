#include "limn/spectrum/eigen_formula.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/core.h>

#include "limn/scheme/check.h"
#include "limn/scheme/lattice_schemes.h"
#include "limn/scheme/scope.h"
#include "limn/spectrum/block_formulas.h"

namespace limn {
namespace {

constexpr std::size_t kFewValences = 2;  // are treated one by one

/// The formulas where one set of rule cases applies.
class CaseFormulas {
 public:
  CaseFormulas(const Scheme& scheme, const spectrum::NamesKept& kept, int rings)
      : scheme_(scheme), kept_(kept), rings_(rings) {}

  /// Appends them for the valences given, in rising order.
  Status append(const spectrum::CenterCases& cases, const std::vector<int>& valences,
                std::vector<ValenceFormulas>& list) const {
    if (Status status = check_stages(); !status) return status;
    const spectrum::RegularNames named = [&](const spectrum::NamedWeight& name) {
      spectrum::SymbolicWeights weights(scheme_, kept_);
      const Result<number::Symbolic> value = weights.plain(name);
      return !value || !value->is_zero();
    };
    const Result<int> rings = rings_ > 0 ? rings_ : spectrum::control_rings(scheme_, cases, named);
    if (!rings) return rings.error();
    const Result<spectrum::SectorPattern> pattern =
        spectrum::sector_pattern(scheme_, cases, *rings, named);
    if (!pattern) return pattern.error();
    std::vector<int> single = valences;
    if (valences.size() > kFewValences) {
      spectrum::SymbolicWeights weights(scheme_, kept_);
      const Result<spectrum::BlockFormulas> blocks =
          spectrum::BlockFormulas::make(*pattern, weights, kept_.unknown);
      if (!blocks) return blocks.error();
      const auto from = std::lower_bound(valences.begin(), valences.end(), weights.least_valence());
      single.assign(valences.begin(), from);
      if (from != valences.end())
        if (Status status = append_general(*pattern, *blocks, {from, valences.end()}, list);
            !status)
          return status;
    }
    for (const int n : single)
      if (Status status = append_single(*pattern, n, list); !status) return status;
    return Done{};
  }

 private:
  /// In a star, weights of stages at regular vertices are numbers, which no name may change.
  [[nodiscard]] Status check_stages() const {
    if (!scheme_.stages) return Done{};
    const int regular = regular_valence(RuleKind::vertex, scheme_.split->lattice);
    const Result<const RuleCase*> pair =
        scheme::applicable_case(scheme_, RuleKind::vertex, regular);
    if (!pair) return pair.error();
    if (*pair == nullptr) return scheme::missing_rule(scheme_, RuleKind::vertex, regular);
    spectrum::SymbolicWeights weights(scheme_, kept_, regular);
    for (const Weight& weight : (*pair)->weights) {
      const Result<number::Symbolic> value =
          weights.plain({RuleKind::vertex, &weight, 1, false, false});
      if (!value) return value.error();
      if (!value->is_rational())
        return Error{fmt::format(
            "what two averagings make on {}s depends on a parameter, of "
            "which there are no formulas: '{}'",
            scheme::lattice_name(scheme_.split->lattice), weight.value.expression.text())};
    }
    return Done{};
  }

  Status append_general(const spectrum::SectorPattern& pattern,
                        const spectrum::BlockFormulas& blocks, const std::vector<int>& valences,
                        std::vector<ValenceFormulas>& list) const {
    ValenceFormulas formulas{{}, pattern.rings, {}};
    for (const int valence : valences) {
      if (formulas.valences.empty() || *formulas.valences.back().last != valence - 1)
        formulas.valences.push_back({valence, valence});
      formulas.valences.back().last = valence;
    }
    if (formulas.valences.back().last == kLargestGuardedValence)
      formulas.valences.back().last.reset();
    const int special = blocks.highest_harmonic();
    for (int omega = 0; omega <= special + 1; ++omega) {
      const bool general = omega > special;
      const spectrum::SymbolicFrequency frequency =
          general
              ? spectrum::SymbolicFrequency{std::nullopt, number::Polynomial(number::whole_number(
                                                              kept_.frequency))}
              : spectrum::SymbolicFrequency{omega, omega};
      Result<FrequencyFormulas> found = blocks.eigenvalues(frequency);
      if (!found) return found.error();
      found->frequency = omega;
      found->and_above = general;
      formulas.frequencies.push_back(std::move(*found));
    }
    list.push_back(std::move(formulas));
    return Done{};
  }

  Status append_single(const spectrum::SectorPattern& pattern, int n,
                       std::vector<ValenceFormulas>& list) const {
    spectrum::SymbolicWeights weights(scheme_, kept_, n);
    const Result<spectrum::BlockFormulas> blocks =
        spectrum::BlockFormulas::make(pattern, weights, kept_.unknown);
    if (!blocks) return blocks.error();
    ValenceFormulas formulas{{{n, n}}, pattern.rings, {}};
    for (int omega = 0; omega <= n / 2; ++omega) {
      Result<FrequencyFormulas> found = blocks->eigenvalues({omega, omega});
      if (!found) return found.error();
      found->frequency = omega;
      formulas.frequencies.push_back(std::move(*found));
    }
    list.push_back(std::move(formulas));
    return Done{};
  }

  const Scheme& scheme_;
  const spectrum::NamesKept& kept_;
  int rings_;
};

/// Whether `name` is in the definition, or in that of a name in it.
bool depends_on(const Scheme& scheme, const Formula& formula, const std::string& name) {
  const std::vector<std::string>& names = formula.expression.names();
  return std::any_of(names.begin(), names.end(), [&](const std::string& used) {
    if (used == name) return true;
    for (const auto& [let, value] : scheme.lets)
      if (let == used) return depends_on(scheme, value, name);
    for (const Parameter& parameter : scheme.parameters)
      if (parameter.name == used) return depends_on(scheme, parameter.value, name);
    return false;
  });
}

/// The first of these that the scheme does not use itself.
std::string free_name(const Scheme& scheme, const std::vector<std::string>& candidates) {
  for (const std::string& name : candidates) {
    const auto is_taken = [&](const auto& one) { return one.name == name; };
    const bool let = std::any_of(scheme.lets.begin(), scheme.lets.end(),
                                 [&](const auto& one) { return one.first == name; });
    if (!let && std::none_of(scheme.parameters.begin(), scheme.parameters.end(), is_taken))
      return name;
  }
  return candidates.back();
}

spectrum::NamesKept names_kept(const Scheme& scheme, const std::set<std::string>& evaluated) {
  spectrum::NamesKept kept;
  kept.frequency = free_name(scheme, {"omega", "frequency", "frequency_"});
  kept.unknown = free_name(scheme, {"lambda", "mu", "eigenvalue", "eigenvalue_"});
  for (const Parameter& parameter : scheme.parameters) {
    if (evaluated.count(parameter.name) > 0) continue;
    kept.parameters.insert(parameter.name);
    if (depends_on(scheme, parameter.value, "n")) kept.depending_on_n.insert(parameter.name);
  }
  return kept;
}

/// Lets that are one number at each valence, but not the same at all; without q, which no file has
/// (lattice_schemes.h).
std::set<std::string> lets_of_n(const Scheme& scheme) {
  std::set<std::string> found;
  for (const auto& [let, value] : scheme.lets)
    if (let != scheme::kQuads && depends_on(scheme, value, "n") && !depends_on(scheme, value, "k"))
      found.insert(let);
  return found;
}

/// Parameters by the names that they have in regular rules.
std::vector<RegularName> regular_names(const Scheme& scheme, const spectrum::NamesKept& kept) {
  std::set<int> valences;
  for (int i = 0; i < kRuleKinds; ++i)
    if (const auto kind = static_cast<RuleKind>(i); rule_has_valence(kind))
      valences.insert(regular_valence(kind, scheme.split->lattice));
  std::vector<RegularName> names;
  for (const std::string& parameter : kept.depending_on_n)
    for (const int n : valences)
      names.push_back({spectrum::regular_name(parameter, n), parameter, n});
  return names;
}

/// Numbers for n, omega and the parameters, at which formulas are compared.
class Sample {
 public:
  Sample(const Scheme& scheme, const spectrum::NamesKept& kept, int n, int omega)
      : scope_(scheme, n, std::nullopt) {
    double shift = 0;
    const auto give = [&](const std::string& name, const Formula& value, int at) {
      scheme::Scope<double> there(scheme, at, std::nullopt);
      const Result<double> number = there(value);
      scope_.give(name, (number ? *number : 0) + (shift += 1e-3));
    };
    for (const Parameter& parameter : scheme.parameters)
      if (kept.parameters.count(parameter.name) > 0) give(parameter.name, parameter.value, n);
    for (const RegularName& regular : regular_names(scheme, kept))
      for (const Parameter& parameter : scheme.parameters)
        if (parameter.name == regular.parameter) give(regular.name, parameter.value, regular.n);
    scope_.give(kept.frequency, omega);
  }

  /// NaN where the formula is no real number.
  [[nodiscard]] double value(const std::string& text) {
    const Result<Expression> expression = Expression::parse(text);
    const Result<double> number = expression ? scope_(Formula{*expression, {}}) : Result(0.0);
    return expression && number ? *number : std::nan("");
  }

 private:
  scheme::Scope<double> scope_;
};

constexpr int kSamples = 2;

Sample sample(const Scheme& scheme, const spectrum::NamesKept& kept,
              const ValenceFormulas& formulas, const FrequencyFormulas& frequency, int number) {
  const ValenceSpan span = formulas.valences.back();
  const int n = std::min(span.last.value_or(kLargestGuardedValence), span.first + 4 + 3 * number);
  const int omega = std::max(frequency.frequency, frequency.and_above ? std::min(2, n / 2) : 0);
  return {scheme, kept, n, omega};
}

void sort(const Scheme& scheme, const spectrum::NamesKept& kept, const ValenceFormulas& formulas,
          FrequencyFormulas& frequency) {
  Sample at = sample(scheme, kept, formulas, frequency, 0);
  const auto rank = [&](const EigenFormula& one) {
    const double value = at.value(one.root.text);
    return std::pair(one.ring, std::isnan(value) ? 0 : -std::abs(value));
  };
  std::vector<std::pair<std::pair<int, double>, EigenFormula>> ranked;
  ranked.reserve(frequency.eigenvalues.size());
  for (EigenFormula& one : frequency.eigenvalues) ranked.emplace_back(rank(one), std::move(one));
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::transform(ranked.begin(), ranked.end(), frequency.eigenvalues.begin(),
                 [](auto& one) { return std::move(one.second); });
}

/// Formulas for all valences, of those names kept.
Result<std::vector<ValenceFormulas>> all_formulas(const Scheme& scheme,
                                                  const spectrum::NamesKept& kept, int rings) {
  std::map<spectrum::CenterCases, std::vector<int>> valences;
  std::optional<Error> missing;
  for (int n = scheme::kSmallestValence; n <= kLargestGuardedValence; ++n) {
    const Result<spectrum::CenterCases> cases = spectrum::center_cases(scheme, n);
    if (cases)
      valences[*cases].push_back(n);
    else if (!missing)
      missing = cases.error();
  }
  if (valences.empty()) return *missing;
  const CaseFormulas formulas(scheme, kept, rings);
  std::vector<ValenceFormulas> result;
  for (const auto& [cases, list] : valences)
    if (Status status = formulas.append(cases, list, result); !status) return status.error();
  std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
    return a.valences.front().first < b.valences.front().first;
  });
  for (ValenceFormulas& at : result)
    for (FrequencyFormulas& frequency : at.frequencies) sort(scheme, kept, at, frequency);
  return result;
}

/// The formula among `others` that has the value of `one` at all samples.
const EigenFormula* same_value(const EigenFormula& one, const FrequencyFormulas& others,
                               std::vector<Sample>& samples) {
  for (const EigenFormula& other : others.eigenvalues) {
    const bool same =
        other.ring == one.ring && std::all_of(samples.begin(), samples.end(), [&](Sample& at) {
          return std::abs(at.value(one.root.text) - at.value(other.root.text)) < 1e-12;
        });
    if (same) return &other;
  }
  return nullptr;
}

void append_by_lets(const Scheme& scheme, const spectrum::NamesKept& kept,
                    std::vector<ValenceFormulas>& formulas,
                    const std::vector<ValenceFormulas>& by_lets) {
  if (formulas.size() != by_lets.size()) return;
  for (std::size_t i = 0; i < formulas.size(); ++i) {
    auto& frequencies = formulas[i].frequencies;
    if (frequencies.size() != by_lets[i].frequencies.size()) continue;
    for (std::size_t omega = 0; omega < frequencies.size(); ++omega) {
      std::vector<Sample> samples;
      samples.reserve(kSamples);
      for (int number = 0; number < kSamples; ++number)
        samples.push_back(sample(scheme, kept, formulas[i], frequencies[omega], number));
      for (EigenFormula& one : frequencies[omega].eigenvalues) {
        const EigenFormula* other = same_value(one, by_lets[i].frequencies[omega], samples);
        if (other != nullptr && other->root.text.size() < one.root.text.size())
          one.by_lets = other->root;
      }
    }
  }
}

bool uses(const std::vector<ValenceFormulas>& formulas, const std::string& name) {
  const auto in = [&](const ClosedRoot& root) {
    const Result<Expression> expression = Expression::parse(root.text);
    return expression && expression->column_of(name) > 0;
  };
  for (const ValenceFormulas& at : formulas)
    for (const FrequencyFormulas& frequency : at.frequencies) {
      for (const EigenFormula& one : frequency.eigenvalues)
        if (in(one.root) || (one.by_lets && in(*one.by_lets))) return true;
      for (const EigenEquation& one : frequency.left)
        if (in(one.polynomial)) return true;
    }
  return false;
}

}  // namespace

Result<EigenFormulas> eigen_formulas(const Scheme& scheme, const std::set<std::string>& evaluated,
                                     int rings) {
  const spectrum::NamesKept kept = names_kept(scheme, evaluated);
  Result<std::vector<ValenceFormulas>> formulas = all_formulas(scheme, kept, rings);
  spectrum::NamesKept with_lets = kept;
  with_lets.lets = lets_of_n(scheme);
  if (!with_lets.lets.empty()) {
    // a let may have no formula (n % 2), and then stays a name
    const Result<std::vector<ValenceFormulas>> by_lets = all_formulas(scheme, with_lets, rings);
    if (by_lets && formulas)
      append_by_lets(scheme, kept, *formulas, *by_lets);
    else if (by_lets)
      formulas = by_lets;
  }
  if (!formulas) return formulas.error();
  EigenFormulas result{std::move(*formulas), {}, kept.frequency, kept.unknown};
  for (RegularName& name : regular_names(scheme, kept))
    if (uses(result.valences, name.name)) result.regular_names.push_back(std::move(name));
  return result;
}

}  // namespace limn
