#pragma once
/// Frequency blocks whose entries are formulas, and their eigenvalues. Private to eigen_formula.

#include <optional>
#include <vector>

#include "limn/spectrum/eigen_formula.h"
#include "limn/spectrum/symbolic_weights.h"

namespace limn::spectrum {

/// A rotational frequency: a number, or an indeterminate for all others.
struct SymbolicFrequency {
  std::optional<int> number;
  number::Symbolic value;
};

using SymbolicMatrix = std::vector<std::vector<number::Symbolic>>;

/// A pattern's terms as formulas. The pattern must outlive it.
class BlockFormulas {
 public:
  /// `unknown`: the name of the characteristic polynomial's variable. Fails where a weight is no
  /// formula.
  [[nodiscard]] static Result<BlockFormulas> make(const SectorPattern& pattern,
                                                  SymbolicWeights& weights,
                                                  const std::string& unknown);

  /// The highest harmonic of a repeated weight: frequencies up to it are special.
  [[nodiscard]] int highest_harmonic() const;

  /// Similar to the block of frequency_blocks.h: the points' phases within their sectors, a
  /// diagonal matrix, are left out. Phases are powers of one indeterminate, e^{iπω/n}.
  [[nodiscard]] Result<SymbolicMatrix> block(const SymbolicFrequency& frequency) const;

  /// The block's eigenvalues, ring by ring. Fails where the scheme has no mirror symmetry, and
  /// where a formula grows too large.
  [[nodiscard]] Result<FrequencyFormulas> eigenvalues(const SymbolicFrequency& frequency) const;

 private:
  BlockFormulas(const SectorPattern& pattern, number::Symbolic n, const std::string& unknown)
      : pattern_(pattern), n_(std::move(n)), unknown_(number::variable(unknown)) {}
  [[nodiscard]] Result<number::Symbolic> term_value(const SectorTerm& term,
                                                    const SymbolicFrequency& frequency) const;
  [[nodiscard]] int half_sectors(const SectorTerm& term) const;
  [[nodiscard]] Result<number::Symbolic> along(const SectorTerm& term,
                                               const SymbolicFrequency& frequency) const;

  const SectorPattern& pattern_;
  number::Symbolic n_;
  number::Indeterminate unknown_;
  std::vector<number::Symbolic> plain_;
  std::vector<RepeatedWeight> repeated_;
};

}  // namespace limn::spectrum
