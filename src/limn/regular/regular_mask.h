#pragma once
/// The regular mask of any scheme, read off its rules: linear forms are refined on a torus.

#include "limn/scheme/mask.h"

namespace limn {

/// The scheme's mask on the regular lattice, exactly. Weights at regular valence must come out
/// rational. Fails, with the reason, otherwise, and where a rule is missing.
/// Cost: one step on a torus of 16 × 16 vertices, in exact numbers; milliseconds.
[[nodiscard]] Result<Mask> regular_mask(const Scheme& scheme);

/// The mask as people print it: rows from the top, a hexagon on triangles, integers over a
/// common denominator. E.g. "1/16 ×" and the rows.
[[nodiscard]] std::string to_string(const Mask& mask);

// A mask as one refinement, smoothing stages and a kernel [ADS §2, §3.2].

/// mask = |det M| · stage^stages · Π direction^count · kernel, all symmetric about their centres
/// and of sum 1. A direction smooths along one step of the refined lattice, (1 + z^step)/2 for a
/// dyadic split and (1 + … + z^{(p-1) step})/p with p = arity(M) for others; a stage is the product
/// over the lattice's edge directions. No further direction divides the kernel.
struct Factorization {
  int stages = 0;                                         ///< whole smoothing stages
  std::vector<std::pair<LatticeVector, int>> directions;  ///< those that are no whole stage
  Laurent kernel;                                         ///< by twice the offset
};

/// The factors that divide the mask exactly over the rationals; the polynomial ring factors
/// uniquely, so their counts do not depend on the order. Directions with coordinates up to 2 are
/// tried.
[[nodiscard]] Factorization factor(const Mask& mask);

/// The product again: a mask's coefficients by twice the offset; lattice and dilation are
/// `shape`'s.
[[nodiscard]] Laurent expand(const Factorization& factors, const Mask& shape);

/// One smoothing stage, by twice the offset; sum 1.
[[nodiscard]] Laurent smoothing_stage(Lattice lattice, const LatticeMatrix& dilation);

}  // namespace limn
