#pragma once
/// The control net of the characteristic map: an eigenvector of frequency 1 on all of the star, as
/// far out as a proof needs it.
///
/// Places are written in the basis of sector 0 (cell_matrices.h), the centre at 0; those of other
/// sectors are reached by turning across a spoke, as on the regular lattice.

#include <map>
#include <optional>

#include "limn/certify/blocks/real_blocks.h"
#include "limn/certify/blocks/spectral_bound.h"
#include "limn/certify/lattice/cell_matrices.h"

namespace limn::certify {

/// A place in sector 0, 1 or -1 with coordinates x > 0, y ≥ 0 (or both 0: the centre).
struct SectorPlace {
  int sector = 0;
  LatticeVector place{};
};
/// `place`, in any unit, turned into a sector it lies in; nothing farther round than one sector.
[[nodiscard]] std::optional<SectorPlace> turned_into_sector(Lattice lattice, LatticeVector place);

/// The ring of a control point in sector 0, and its number within the sector (may be negative:
/// before the first of the orbits).
[[nodiscard]] std::pair<int, int> ring_and_place(const CellMatrices& cells, LatticeVector j);

/// What one step's value at label k of the refined star's sector 0 weighs on the lattice, by the
/// mask.
[[nodiscard]] std::vector<std::pair<LatticeVector, Rational>> sources_of(const CellMatrices& cells,
                                                                         LatticeVector k);
/// Whether that value lies less than an edge (dual: half an edge) from the centre.
[[nodiscard]] bool is_near_center(const CellMatrices& cells, LatticeVector k);
/// How far a place is from the centre: the one-ring (dual: the face) ends at 1 (½) edges.
[[nodiscard]] int gauge(Lattice lattice, LatticeVector place);

struct NetPoint {
  number::Ball u, v;
};

class EigenNet {
 public:
  /// `pair`: eigenvalue of one step, eigenvector in the real basis without the centre. Points are
  /// in the coordinates (Re, Im/σ) of `phase`'s turns. `center`: the value there; other
  /// than 0 for frequency 0 alone. All must outlive the net.
  EigenNet(const CellMatrices& cells, const RealBasis& basis, const EnclosedPair& pair,
           const Phase<number::Ball>& phase, number::Ball center = 0);

  /// The control point j: at j, or j + (½, ½) (dual). Fails for places more than one sector
  /// away, but for the spoke that ends the second one of triangles, and where the mask does not
  /// reach outwards.
  [[nodiscard]] Result<NetPoint> at(LatticeVector j);

 private:
  [[nodiscard]] Result<NetPoint> in_sector(LatticeVector j, int depth);
  [[nodiscard]] NetPoint from_amplitude(std::size_t orbit) const;
  [[nodiscard]] Result<NetPoint> extended(LatticeVector j, int depth);
  [[nodiscard]] Result<NetPoint> at(LatticeVector j, int depth);

  const CellMatrices& cells_;
  const RealBasis& basis_;
  const EnclosedPair& pair_;
  const Phase<number::Ball>& phase_;
  number::Ball center_;
  Turn<number::Ball> factor_;  // 1/λ, turned back
  std::map<LatticeVector, NetPoint> known_;
};

}  // namespace limn::certify
