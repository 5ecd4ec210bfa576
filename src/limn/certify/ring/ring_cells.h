#pragma once
/// The characteristic map, cell by cell: its Jacobian's sign and the half-plane it lies in.
///
/// A ring of cells goes once round the vertex; its images under refinement fill the rest of the
/// surface up to the vertex, where the map is the same up to the eigenvalue. By rotation and mirror
/// half a sector of it suffices: cells (i, j) with i ≥ j ≥ 0.

#include <string>
#include <vector>

#include "limn/certify/lattice/contraction.h"
#include "limn/certify/ring/eigen_net.h"
#include "limn/certify/ring/quick_cells.h"

namespace limn::certify {

/// Half a sector of a ring: cells between `inner` and inner · s edges from the centre. Fails where
/// no ring has regular rules all round it.
struct RingCells {
  int inner = 0;
  std::vector<LatticeVector> cells;
};
[[nodiscard]] Result<RingCells> ring_cells(const CellMatrices& cells);

/// Signs of the Jacobian on cells of the map of one net.
class CellSigns {
 public:
  /// All must outlive it.
  CellSigns(const CellMatrices& cells, const Contraction& bounds);

  [[nodiscard]] Result<CellMap> map_on(EigenNet& net, LatticeVector cell) const;
  [[nodiscard]] CellMap part(const CellMap& map, std::size_t digit) const;
  /// Encloses the Jacobian on the cell, in its own units: its sign is that of the map.
  [[nodiscard]] number::Ball jacobian(const CellMap& map) const;
  /// Encloses the values on the cell.
  [[nodiscard]] NetPoint values(const CellMap& map) const;
  /// The same in double precision.
  [[nodiscard]] const QuickCells& quick() const { return quick_; }

 private:
  struct Entry {
    std::size_t column;
    number::Ball value;
  };
  using Row = std::vector<Entry>;

  [[nodiscard]] CellMap::Coordinate part(const CellMap::Coordinate& map, std::size_t digit) const;
  static Row sparse(const std::vector<Rational>& row);
  static number::Ball dot(const Row& row, const std::vector<number::Ball>& x);
  static double error(const std::vector<double>& bound, const std::vector<number::Ball>& residual);

  const CellMatrices& cells_;
  const Contraction& bounds_;
  std::vector<std::vector<Row>> residual_;
  std::vector<std::array<Row, 2>> gradient_;
  std::vector<Row> value_;
  std::vector<std::array<number::Ball, 2>> origin_;  // of a part, in its cell
  std::vector<number::Ball> inverse_sizes_;
  number::Ball inverse_scale_;
  QuickCells quick_;
};

}  // namespace limn::certify
