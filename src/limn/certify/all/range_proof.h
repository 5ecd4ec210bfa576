#pragma once
/// What a proof for all valences rests on, interval by interval: shared by the search and the
/// check of all_valences.h, and private to them.

#include <optional>

#include "limn/certify/all/all_valences.h"
#include "limn/certify/all/range_rules.h"
#include "limn/certify/ring/ring_cells.h"

namespace limn::certify {

[[nodiscard]] number::Ball interval_ball(const Rational& begin, const Rational& end);
[[nodiscard]] number::BallMatrix transposed(const number::BallMatrix& a);

/// Frequencies 0, 1 and special ones for t in an interval.
class IntervalBlocks {
 public:
  /// `rules` must outlive it. Fails where weights cannot be enclosed.
  [[nodiscard]] static Result<IntervalBlocks> make(const RangeRules& rules, const Rational& begin,
                                                   const Rational& end);

  [[nodiscard]] const Phase<number::Ball>& turns() const { return turns_; }
  /// Of frequency 1.
  [[nodiscard]] const number::BallMatrix& tangent() const { return tangent_; }
  /// Frequency 0 without its eigenvalue 1.
  [[nodiscard]] const number::BallMatrix& constant() const { return constant_; }
  /// Of frequency 2 … rules.last_special().
  [[nodiscard]] Result<number::BallMatrix> special(int frequency) const;

  /// Whether the blocks of frequencies 0 and 1 are compared by `cup_gap`: they have the same
  /// orbits, and weights off the centre that do not depend on the frequency.
  [[nodiscard]] bool has_gap() const;
  /// The part of `constant()` on real parts, transposed, and that on imaginary parts.
  [[nodiscard]] number::BallMatrix cup_transposed() const;
  [[nodiscard]] number::BallMatrix odd() const;
  /// (μ1 - μ0)/t^p, p ≤ 2 so that it has a limit, where `left` is the eigenvector of
  /// cup_transposed() to μ0, and `tangent` that of tangent() to μ1: with yᵀA = μ0 yᵀ and Bx = μ1 x,
  /// (μ0 - μ1) yᵀx = yᵀ(A - B)x.
  [[nodiscard]] number::Ball cup_gap(const EnclosedPair& left, const EnclosedPair& tangent) const;

 private:
  explicit IntervalBlocks(const RangeRules& rules) : rules_(&rules) {}
  [[nodiscard]] std::vector<std::size_t> rows(bool real) const;

  const RangeRules* rules_;
  number::Ball t_, w_;
  Phase<number::Ball> turns_;
  number::BallMatrix tangent_, constant_;
  number::DenseMatrix<PowerBall> whole_constant_;
};

/// The block of frequencies without special weights for θ'² in an interval, and its derivative by
/// θ'².
struct TurnBlocks {
  number::BallMatrix block, slope;
};
[[nodiscard]] Result<TurnBlocks> turn_blocks(const RangeRules& rules, const Rational& begin,
                                             const Rational& end);
/// dλ/dw = yᵀ M' x/(yᵀ x): encloses it.
[[nodiscard]] number::Ball eigenvalue_slope(const TurnBlocks& blocks, const EnclosedPair& right,
                                            const EnclosedPair& left);

/// The characteristic map's ring on one interval.
class IntervalRing {
 public:
  /// All must outlive it.
  IntervalRing(const CellMatrices& cells, const CellSigns& signs, const RangeRules& rules,
               const IntervalBlocks& blocks, const EnclosedPair& pair);

  [[nodiscard]] Result<CellMap> map_on(LatticeVector cell);
  /// Signs of the Jacobian and of the map along the half-plane's middle. Nothing where a sign is
  /// not shown.
  struct Signs {
    bool jacobian_positive, ahead;
    friend bool operator==(const Signs&, const Signs&) = default;
  };
  [[nodiscard]] std::optional<Signs> signs_on(const CellMap& map) const;
  /// Whether signs_on(map) are those of all parts so far, of which there is at least one after it.
  [[nodiscard]] bool agrees(const CellMap& map);

 private:
  const CellSigns& signs_;
  EigenNet net_;
  Turn<number::Ball> middle_;
  std::optional<Signs> found_;
};

}  // namespace limn::certify
