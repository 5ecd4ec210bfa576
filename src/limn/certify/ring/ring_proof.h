#pragma once
/// What is shown of the characteristic map on a ring of cells, and the search for parts that are
/// small enough to show it.

#include "limn/base/budget.h"
#include "limn/certify/certificate/certificate.h"
#include "limn/certify/ring/ring_cells.h"

namespace limn::certify {

/// regular: the Jacobian is positive, and the image of half a sector lies on one side of a line
///   through the centre, so that the map winds once round it.
/// nowhere_zero: the map does not meet the centre (frequencies 2 …: it winds round it more often).
/// one_sign: the first coordinate is positive (frequency 0, whose map has but that one).
enum class RingGoal { regular, nowhere_zero, one_sign };

/// A ring with what its maps are evaluated with. All references must outlive it.
class RingProof {
 public:
  RingProof(const CellMatrices& cells, const CellSigns& signs, EigenNet& net,
            const Phase<number::Ball>& phase, RingGoal goal);

  struct Found {
    Answer answer = Answer::undecided;  ///< whether the goal is reached; refuted: for regular alone
    int inner = 0;
    std::vector<CellClaim> ring;
    std::optional<std::array<PartPlace, 2>> fold;
    std::string reason;  ///< undecided: where
  };
  /// Cuts cells until the goal is shown on all parts, at most `most_parts` of them and kDeepest
  /// times; where the surface is little more than C1, parts near lattice points are cut often.
  [[nodiscard]] Result<Found> search(int most_parts, const Stop& stop);

  /// Fails where these parts do not fill the ring or do not show the goal.
  [[nodiscard]] Status check(int inner, const std::vector<CellClaim>& ring);
  /// Fails where the Jacobian is not positive on the first and negative on the second.
  [[nodiscard]] Status check_fold(const std::array<PartPlace, 2>& fold, int inner);

  static constexpr std::size_t kDeepest = 100;

 private:
  struct Direction {
    number::Ball u, v;
  };
  /// What enclosures tell of a part: the Jacobian's sign, 0 unknown, and whether the goal is shown.
  struct Told {
    int sign = 0;
    bool shown = false;
  };
  [[nodiscard]] Status look(int inner);
  [[nodiscard]] Told told_by(const QuickCells::Map& map) const;
  [[nodiscard]] Told told_by(const CellMap& map) const;
  /// By double precision, and by balls where its rounding may be what does not tell; `map` is then
  /// made anew from these.
  [[nodiscard]] Result<Told> tell(QuickCells::Map& map, LatticeVector cell,
                                  const std::string& word);
  [[nodiscard]] Status check_parts(const CellClaim& claim);
  [[nodiscard]] Result<CellMap> map_of(LatticeVector cell, const std::string& word);

  const CellMatrices& cells_;
  const CellSigns& signs_;
  EigenNet& net_;
  const Phase<number::Ball>& phase_;
  RingGoal goal_;
  Direction direction_;  // in the middle of half a sector; its sign makes the map's positive
  DoubleBall direction_u_, direction_v_;
};

}  // namespace limn::certify
