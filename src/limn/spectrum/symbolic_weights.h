#pragma once
/// The named weights of a star (sector_pattern.h) as formulas. Private to eigen_formula and
/// certify/range_rules.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "limn/number/symbolic.h"
#include "limn/scheme/check.h"
#include "limn/spectrum/sector_pattern.h"

namespace limn::spectrum {

/// The weights w(k), k = 0 … n-1, of a repeated role, as w(k) = Σ harmonics[m] cos(2πmk/n) plus
/// Σ half_harmonics[m] cos(2πm(k + 1/2)/n) plus first[j] at k = j plus last[j] at k = n-j. So their
/// Fourier sums have closed forms for every n.
struct RepeatedWeight {
  std::map<int, number::Symbolic> harmonics, half_harmonics;
  std::map<int, number::Symbolic> first, last;
};

/// Which names of the scheme stay names.
struct NamesKept {
  std::set<std::string> parameters;
  std::set<std::string> lets;  ///< in the rules of the centre
  /// Those parameters that depend on n: where a regular rule has one at its own n, that is another
  /// number and has another name.
  std::set<std::string> depending_on_n;
  std::string frequency, unknown;  ///< what these are called
};
[[nodiscard]] std::string regular_name(const std::string& name, int n);

/// Evaluates weights where n is an indeterminate or a number. Scheme and names must outlive it.
class SymbolicWeights {
 public:
  /// n: an indeterminate, for all n from `least_valence` on.
  SymbolicWeights(const Scheme& scheme, const NamesKept& kept);
  /// One n.
  SymbolicWeights(const Scheme& scheme, const NamesKept& kept, int n);

  SymbolicWeights(const SymbolicWeights&) = delete;
  SymbolicWeights& operator=(const SymbolicWeights&) = delete;

  [[nodiscard]] const number::Symbolic& n() const { return n_; }
  /// From where on all that was evaluated so far holds.
  [[nodiscard]] int least_valence() const { return least_valence_; }

  /// Precondition: not repeated. Fails where the weight is no such formula.
  [[nodiscard]] Result<number::Symbolic> plain(const NamedWeight& name);
  /// Precondition: repeated. Fails also where there is no such sum.
  [[nodiscard]] Result<RepeatedWeight> repeated(const NamedWeight& name);

 private:
  [[nodiscard]] Result<number::Symbolic> value(const NamedWeight& name,
                                               const std::optional<number::Symbolic>& n,
                                               const std::optional<number::Symbolic>& k) const;
  [[nodiscard]] Result<RepeatedWeight> one_by_one(const NamedWeight& name) const;
  [[nodiscard]] Result<RepeatedWeight> of_every_valence(const NamedWeight& name);
  [[nodiscard]] Result<RepeatedWeight> of_every_valence(const NamedWeight& name, bool halves);
  void hold_from(const Rational& bound);

  const Scheme& scheme_;
  const NamesKept& kept_;
  std::optional<int> number_;
  number::Symbolic n_;
  int least_valence_ = scheme::kSmallestValence;
};

}  // namespace limn::spectrum
