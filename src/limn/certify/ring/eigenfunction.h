#pragma once
/// The surface whose control net is an eigenvector of a frequency, on the ring of cells.

#include "limn/certify/blocks/valence_balls.h"
#include "limn/certify/ring/ring_cells.h"

namespace limn::certify {

/// An eigenvector's net and what it is evaluated with. `balls` and `cells` must outlive it.
struct EigenMap {
  /// `pair`: of balls.block(frequency).
  EigenMap(const ValenceBalls& balls, const CellMatrices& cells, int frequency,
           const EnclosedPair& pair);
  EigenMap(const EigenMap&) = delete;

  ValenceBalls::WholeVector whole;
  Phase<number::Ball> phase;
  EigenNet net;
};

/// Shows that eigenvectors are effective: that their surfaces are not 0 everywhere [Peters, Reif
/// 2008 §4]. References must outlive it.
class Effective {
 public:
  Effective(const ValenceBalls& balls, const CellMatrices& cells, const CellSigns& signs)
      : balls_(balls), cells_(cells), signs_(signs) {}

  /// Whether the surface of `pair` is shown to be other than 0 somewhere on the ring: cells are cut
  /// twice at most.
  [[nodiscard]] bool is_shown(int frequency, const EnclosedPair& pair) const;
  /// The same of the one eigenvector of an eigenvalue near `value`, where that is simple in its
  /// block.
  [[nodiscard]] bool is_shown(int frequency, double value) const;

 private:
  const ValenceBalls& balls_;
  const CellMatrices& cells_;
  const CellSigns& signs_;
};

}  // namespace limn::certify
