#pragma once
/// A regular mask, cell by cell: how refinement maps the control values that a cell of the lattice
/// depends on to those of its parts. Exact; everything that certificates say of the regular surface
/// rests on these matrices.
///
/// Basis: that of a sector, along two neighbouring spokes of a star: s1 = e1 and s2 = e1 + e2 on
/// triangles (e2 on quads). Cell p is the parallelogram p + [0, 1]², for dual masks with the
/// control values at p + (½, ½) + Z². So many steps are taken at once, one or two, that the
/// dilation is a whole number s; the cell then has s² parts, p' = s p + digit, each a cell of the
/// refined lattice.
///
/// Values c on a cell's points are kept as their gradient g along the basis and their residuals
/// r(ω) = c(ω) - (c(0) + ω · g), g = (c(1,0) - c(0), c(0,1) - c(0)). A step maps
///   r' = residual[d] r,   g' = g/s + gradient[d] r,   c'(0) = c(0) + (d/s + shift) · g + value[d]
///   r
/// so that s^l g after l steps has a limit, the surface's gradient, if products of the
/// s·residual[d] tend to 0: the scheme is then C1 on the lattice [DynLevin2002; Reif1995].

#include <vector>

#include "limn/base/error.h"
#include "limn/base/rational.h"
#include "limn/scheme/mask.h"

namespace limn::certify {

/// Row by row.
using RationalRows = std::vector<std::vector<Rational>>;

struct CellMatrices {
  Lattice lattice = Lattice::triangle;
  bool dual = false;
  int scale = 2;  ///< s
  int steps = 1;  ///< of the scheme, that make one refinement by s
  /// Control values j of the refinement by s: c'(k) = Σ_j mask(k - s j) c(j), in the sector's
  /// basis.
  Laurent mask;
  /// One step, in the same basis: refined value m lies at dilation^-1 m, c'(m) = Σ_j one_mask(m -
  /// dilation j) c(j).
  Laurent one_mask;
  LatticeMatrix dilation;
  /// Whether a step turns the star by half a sector; and which m, times `label_divisor`, is
  /// labels k' of the refined star, k' in the basis of its turned sector.
  bool turns = false;
  LatticeMatrix labels;
  int label_divisor = 1;
  /// ω: what a cell depends on, relative to p; (0,0), (1,0), (0,1) first.
  std::vector<LatticeVector> points;
  /// Of points beyond the first three a size r^ that its residuals have at most for quadratic
  /// polynomials: residuals are divided by them before norms are taken.
  std::vector<Rational> sizes;
  Rational shift;  ///< of a part's origin, along both directions: 0, or -¼ (dual)
  /// digit (x, y) is number x + s y. Sizes (points-3)², 2 × (points-3), 1 × (points-3).
  std::vector<RationalRows> residual, gradient;
  std::vector<std::vector<Rational>> value;
  /// Where a refined value that a cell's parts need lies, relative to p, times `place_unit`; of the
  /// steps between, too. A rule anchored there must be regular for the matrices to hold.
  std::vector<LatticeVector> places;
  int place_unit = 2;
};

/// What is kept of a cell. cell: the points that it depends on. neighbours: those of the gradients
/// g of the eight cells round it, too: where products of their matrices contract, the gradients of
/// neighbouring cells have the same limits, which the cell by itself does not tell.
enum class CellExtent { cell, neighbours };

/// Fails where the mask's sum rules are of order 1 or less, where no one or two steps make a whole
/// dilation, and where a cell depends on more than 200 points.
[[nodiscard]] Result<CellMatrices> cell_matrices(const Mask& mask,
                                                 CellExtent extent = CellExtent::cell);

}  // namespace limn::certify
