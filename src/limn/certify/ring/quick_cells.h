#pragma once
/// CellSigns in double precision, all errors bounded: what a proof looks at first, since most parts
/// of most cells are decided by it.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "limn/certify/lattice/contraction.h"
#include "limn/certify/ring/cell_map.h"
#include "limn/certify/ring/double_ball.h"

namespace limn::certify {

class QuickCells {
 public:
  struct Coordinate {
    DoubleBall origin;
    std::array<DoubleBall, 2> gradient;
    Eigen::VectorXd residual;  ///< over its sizes, as CellMap's
    double error = 0;          ///< of each entry of `residual`, at most
  };
  /// The map on a cell or a part of it.
  struct Map {
    Coordinate u, v;
  };
  struct Values {
    DoubleBall u, v;
  };

  QuickCells(const CellMatrices& cells, const Contraction& bounds);

  /// Holds all maps that `map` holds.
  [[nodiscard]] Map map_of(const CellMap& map) const;
  [[nodiscard]] Map part(const Map& map, std::size_t digit) const;
  /// Encloses the Jacobian on the cell, in its own units.
  [[nodiscard]] DoubleBall jacobian(const Map& map) const;
  /// Encloses the values on the cell.
  [[nodiscard]] Values values(const Map& map) const;
  /// Whether rounding is so small a part of what the enclosures are wide by that balls of a higher
  /// precision would hardly tell more.
  [[nodiscard]] bool is_sharp(const Map& map) const;

 private:
  /// The rows of one digit: the value, both gradients, the residuals.
  struct Digit {
    Eigen::MatrixXd rows;
    std::array<double, 3> norms;  // of the first three rows: sums of sizes, rounded up
    double residual_norm;         // of the others: the largest sum
    std::array<DoubleBall, 2> origin;
  };

  [[nodiscard]] Coordinate part(const Coordinate& map, const Digit& digit) const;
  static DoubleBall wide(const DoubleBall& middle, const Eigen::VectorXd& bound,
                         const Coordinate& map);

  bool dual_;
  DoubleBall inverse_scale_;
  std::vector<Digit> digits_;
  std::array<Eigen::VectorXd, 2> gradient_bounds_;
  Eigen::VectorXd value_bounds_;
};

}  // namespace limn::certify
