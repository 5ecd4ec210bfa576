#include "limn/spectrum/symbolic_weights.h"

#include <algorithm>

#include <fmt/core.h>

#include "limn/number/polynomial_text.h"
#include "limn/scheme/check.h"
#include "limn/scheme/scope.h"

namespace limn::spectrum {
namespace {

Error no_sum(const NamedWeight& name, const std::string& why) {
  const Place& place = name.weight->value.place;
  return {fmt::format("the weights of '{}' have no closed Fourier sum over k: {}",
                      name.weight->role, why),
          "sums of cos(2*pi*k/n), its multiples and terms such as (k == 0) have, or of "
          "cos(pi*(2*k + 1)/n) in place of it",
          place.file, place.line, place.column};
}

/// The largest integer that is not above q.
int floor_of(const Rational& q) {
  const Integer above = numerator(q);
  const Integer below = denominator(q);
  Integer quotient = above / below;
  if (quotient * below > above) --quotient;
  return quotient.convert_to<int>();
}

/// Positions near k = 0 and near k = n that comparisons treat apart.
struct Apart {
  int first = 0;  ///< k = 0 … first-1
  int last = 0;   ///< k = n-1 … n-last
  bool bounded = true;

  /// k + c > 0 or n - k + c > 0 was supposed.
  void suppose(const number::Polynomial& positive) {
    constexpr int kMost = 50;
    Rational constant = 0;
    bool from_start = false;
    for (const auto& [monomial, coefficient] : positive.terms()) {
      if (monomial.empty()) constant = coefficient;
      if (!monomial.empty() && monomial.front().first->name == "k") from_start = coefficient > 0;
    }
    if (-constant > kMost) {
      bounded = false;
    } else if (constant <= 0 && from_start) {
      first = std::max(first, floor_of(-constant) + 1);
    } else if (constant < 0) {
      last = std::max(last, floor_of(-constant));
    }
  }
};

/// Σ harmonics[m] cos(πm halves/n)
Result<number::Symbolic> harmonic_sum(const std::map<int, number::Symbolic>& harmonics, int halves,
                                      const number::Symbolic& n) {
  Result<number::Symbolic> sum = number::Symbolic(0);
  for (const auto& [m, coefficient] : harmonics) {
    Result<number::Symbolic> angle =
        number::Symbolic::divide(number::Symbolic(number::Polynomial(number::pi_indeterminate()) *
                                                  number::Polynomial(m * halves)),
                                 n);
    if (angle) angle = number::symbolic_cos(*angle);
    if (angle) angle = number::Symbolic::multiply(*angle, coefficient);
    if (angle && sum) angle = number::Symbolic::add(*sum, *angle);
    if (!angle) return angle;
    sum = angle;
  }
  return sum;
}

/// At k = j; of j < 0, at k = n + j.
Result<number::Symbolic> harmonic_at(const RepeatedWeight& weight, int j,
                                     const number::Symbolic& n) {
  const Result<number::Symbolic> whole = harmonic_sum(weight.harmonics, 2 * j, n);
  if (!whole) return whole;
  const Result<number::Symbolic> half = harmonic_sum(weight.half_harmonics, 2 * j + 1, n);
  return half ? number::Symbolic::add(*whole, *half) : half;
}

/// What `weight` at position j (negative: from n down) has beyond its harmonics.
Result<number::Symbolic> beyond_harmonics(const RepeatedWeight& weight,
                                          const Result<number::Symbolic>& value, int j,
                                          const number::Symbolic& n) {
  if (!value) return value;
  const Result<number::Symbolic> harmonic = harmonic_at(weight, j, n);
  if (!harmonic) return harmonic.error();
  return number::Symbolic::add(*value, harmonic->negated());
}

}  // namespace

std::string regular_name(const std::string& name, int n) { return fmt::format("{}_{}", name, n); }

SymbolicWeights::SymbolicWeights(const Scheme& scheme, const NamesKept& kept)
    : scheme_(scheme), kept_(kept) {
  n_ = number::Polynomial(number::whole_number("n", [this](const number::Polynomial& positive) {
    for (const auto& [monomial, coefficient] : positive.terms())
      if (monomial.empty()) hold_from(-coefficient);
  }));
}

SymbolicWeights::SymbolicWeights(const Scheme& scheme, const NamesKept& kept, int n)
    : scheme_(scheme), kept_(kept), number_(n), n_(n) {}

void SymbolicWeights::hold_from(const Rational& bound) {
  constexpr int kBeyondAll = 1000;  // valences that are looked at
  least_valence_ = bound > kBeyondAll ? std::max(least_valence_, kBeyondAll)
                                      : std::max(least_valence_, floor_of(bound) + 1);
}

Result<number::Symbolic> SymbolicWeights::value(const NamedWeight& name,
                                                const std::optional<number::Symbolic>& n,
                                                const std::optional<number::Symbolic>& k) const {
  scheme::Scope<number::Symbolic> scope(scheme_, std::nullopt, std::nullopt);
  if (n) scope.give("n", *n);
  if (k) scope.give("k", *k);
  if (!name.regular)
    for (const std::string& let : kept_.lets)
      scope.give(let, number::Polynomial(number::variable(let)));
  for (const std::string& one : kept_.parameters) {
    const bool regular = name.regular && kept_.depending_on_n.count(one) > 0;
    if (regular && *name.regular == 0) continue;  // an edge has no n; the error will say so
    scope.give(one, number::Polynomial(
                        number::variable(regular ? regular_name(one, *name.regular) : one)));
  }
  const Result<number::Symbolic> found = scope(name.weight->value);
  if (!found) return found.error();
  return number::Symbolic::multiply(*found, number::Polynomial(name.share));
}

Result<number::Symbolic> SymbolicWeights::plain(const NamedWeight& name) {
  if (!name.regular) return value(name, n_, std::nullopt);
  std::optional<number::Symbolic> n;
  std::optional<number::Symbolic> k;
  if (rule_has_valence(name.kind)) n = number::Symbolic(*name.regular);
  if (name.k) k = number::Symbolic(*name.k);
  return value(name, n, k);
}

Result<RepeatedWeight> SymbolicWeights::repeated(const NamedWeight& name) {
  return number_ ? one_by_one(name) : of_every_valence(name);
}

Result<RepeatedWeight> SymbolicWeights::one_by_one(const NamedWeight& name) const {
  const int n = *number_;
  RepeatedWeight result;
  for (int k = 0; k < n; ++k) {
    Result<number::Symbolic> weight = value(name, n_, number::Symbolic(k));
    if (!weight) return weight.error();
    if (2 * k == n) {  // half of it on either side, so that both come alike
      weight = number::Symbolic::multiply(*weight, number::Polynomial(Rational(1, 2)));
      if (!weight) return weight.error();
      result.first.emplace(k, *weight);
      result.last.emplace(k, *weight);
    } else if (2 * k < n) {
      result.first.emplace(k, *weight);
    } else {
      result.last.emplace(n - k, *weight);
    }
  }
  return result;
}

Result<RepeatedWeight> SymbolicWeights::of_every_valence(const NamedWeight& name) {
  const int least = least_valence_;
  Result<RepeatedWeight> whole = of_every_valence(name, false);
  if (whole) return whole;
  least_valence_ = least;
  Result<RepeatedWeight> halves = of_every_valence(name, true);
  return halves ? halves : whole;
}

/// `halves`: as cosines of multiples of k + 1/2.
Result<RepeatedWeight> SymbolicWeights::of_every_valence(const NamedWeight& name, bool halves) {
  Apart apart;
  const number::Indeterminate k = number::whole_number(
      "k", [&](const number::Polynomial& positive) { apart.suppose(positive); });
  const number::Polynomial place =
      halves ? number::Polynomial(k) - number::Polynomial(Rational(1, 2)) : number::Polynomial(k);
  const Result<number::Symbolic> amid = value(name, n_, number::Symbolic(place));
  if (!amid) return amid.error();
  if (!apart.bounded) return no_sum(name, "a comparison treats too many k apart");

  RepeatedWeight result;
  const number::Indeterminate cosine = number::cosine_indeterminate(
      1, number::product({{k, 1}}, number::power(n_.numerator().terms().begin()->first, -1)));
  const std::map<int, number::Polynomial> powers = amid->numerator().powers_of(cosine);
  const bool plain = std::none_of(powers.begin(), powers.end(),
                                  [](const auto& one) { return one.second.depends_on("k"); });
  if (!plain || amid->denominator().depends_on("k") ||
      (!powers.empty() && powers.begin()->first < 0))
    return no_sum(name, "amid k = 0 … n-1 it is " +
                            number::sum_text(amid->numerator(), number::Notation::text));
  int highest = 0;
  for (const auto& [j, coefficient] : number::chebyshev_coefficients(amid->numerator(), cosine)) {
    if (j % 2 != 0) return no_sum(name, "cos(pi*k/n) has not n for its period");
    const Result<number::Symbolic> harmonic =
        number::Symbolic::divide(coefficient, amid->denominator());
    if (!harmonic) return harmonic.error();
    (halves ? result.half_harmonics : result.harmonics).emplace(j / 2, *harmonic);
    highest = std::max(highest, j / 2);
  }
  for (int j = 0; j < apart.first; ++j) {
    const Result<number::Symbolic> rest =
        beyond_harmonics(result, value(name, n_, number::Symbolic(j)), j, n_);
    if (!rest) return rest.error();
    result.first.emplace(j, *rest);
  }
  // comparisons at k = n-j suppose n so large that these and the first ones lie apart
  for (int j = 1; j <= apart.last; ++j) {
    const Result<number::Symbolic> position = number::Symbolic::add(n_, -j);
    if (!position) return position.error();
    const Result<number::Symbolic> rest =
        beyond_harmonics(result, value(name, n_, *position), -j, n_);
    if (!rest) return rest.error();
    result.last.emplace(j, *rest);
  }
  hold_from(2 * highest);  // of omega ≤ n/2 only omega = m then meets cos(2πmk/n)
  return result;
}

}  // namespace limn::spectrum
