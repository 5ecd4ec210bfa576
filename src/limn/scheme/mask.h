#pragma once
/// The regular mask: refining the regular lattice is new(m) = Σ_j a(m − M j) old(j), with m in the
/// refined lattice. A scheme can be given by it, or by its factors; rules for regular meshes
/// then follow from it.

#include "limn/mesh/split/dilation.h"
#include "limn/number/laurent.h"
#include "limn/scheme/scheme.h"

namespace limn {

/// Coefficients a(k) by *twice* the offset k from the mask's centre, in the basis of the refined
/// lattice (mesh/split/dilation.h, mesh/lattice.h): even pairs for primal splits, odd pairs for
/// dual ones. They sum to |det M|, and to 1 over each coset of M Z².
struct Mask {
  Lattice lattice = Lattice::triangle;  ///< control and refined lattice alike
  LatticeMatrix dilation;               ///< M
  Laurent coefficients;                 ///< none of them 0
};

/// Whether old points stay where they are: on their coset the mask holds its centre alone, 1.
[[nodiscard]] bool interpolates(const Mask& mask);

}  // namespace limn
