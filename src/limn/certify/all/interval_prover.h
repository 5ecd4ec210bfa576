#pragma once
/// One interval's part of a proof for all valences: shared by the search and the check, and private
/// to all_valences.

#include <string>

#include "limn/certify/all/range_proof.h"

namespace limn::certify {

/// Shows what is claimed of an interval or, searching, finds what can be claimed and fills it in.
/// A claim that was filled in is what the check shows again, without a search.
class IntervalProver {
 public:
  /// All must outlive it.
  IntervalProver(const CellMatrices& cells, const RangeRules& rules, const CellSigns& signs,
                 const RingCells& ring, bool searching);

  /// The enclosure of μ1. Fails with what is not shown.
  Result<number::Ball> show(ValenceInterval& claim) const;
  /// Of the turns in the interval, all eigenvalues that are not below `bound` are one, which falls
  /// as the turn grows.
  Status show(TurnInterval& claim, const number::Ball& bound) const;

  /// Searching: whether the proof is found at one t, cells being cut as often as it takes. From
  /// then on intervals' cells are cut that often, and a little more.
  bool show_at(const Rational& t);
  /// Parts of cells that were looked at.
  [[nodiscard]] long parts_seen() const { return parts_seen_; }
  /// A frequency of valence n, not 0 nor special, that seems to lead in place of frequency 1. A
  /// hint, in double precision.
  [[nodiscard]] std::optional<int> approx_rival(int n) const;

 private:
  Status fill(const number::BallMatrix& a, double& value, std::vector<double>& vector) const;
  [[nodiscard]] bool below(const number::BallMatrix& a, const number::Ball& bound,
                           int& squarings) const;
  Status show_special(const IntervalBlocks& blocks, const EnclosedPair& pair,
                      ValenceInterval& claim) const;
  Status show_constant(const IntervalBlocks& blocks, const EnclosedPair& pair,
                       ValenceInterval& claim) const;
  Status show_cup(const IntervalBlocks& blocks, const EnclosedPair& pair,
                  ValenceInterval& claim) const;
  Status show_ring(const IntervalBlocks& blocks, const EnclosedPair& pair,
                   ValenceInterval& claim) const;
  /// The parts of one cell.
  struct PartSearch {
    IntervalRing& ring;
    const std::vector<std::string>& claimed;
    std::size_t most_cuts;
    std::vector<std::string>& shown;
    long last_part;
  };
  bool show_part(PartSearch& search, const CellMap& map, const std::string& word) const;

  const CellMatrices& cells_;
  const RangeRules& rules_;
  const CellSigns& signs_;
  const RingCells& ring_;
  bool searching_;
  std::size_t most_cuts_;  // of a cell
  mutable long parts_seen_ = 0;
  mutable std::size_t hardest_ = 0;  // the last cell that was not decided: the first to try
};

}  // namespace limn::certify
