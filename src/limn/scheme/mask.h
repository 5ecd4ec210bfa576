#pragma once
/// The regular mask: refining the regular lattice is new(m) = Σ_j a(m − M j) old(j), with m in the
/// refined lattice. A scheme can be given by it, or by its factors; rules for regular meshes
/// then follow from it.

#include <string>

#include "limn/base/truth.h"
#include "limn/mesh/split/split.h"
#include "limn/number/laurent.h"
#include "limn/scheme/scheme.h"

namespace limn {

// What the regular surface round a vertex lets the verdicts on the vertex say. regular/ finds it
// (regular/smoothness/regularity.h) and spectrum/ uses it; neither includes the
// other.

/// What is known of the regular lattice.
struct RegularPart {
  /// Whether curvature is bounded wherever the mesh is regular: yes: second differences over h² of
  /// every control net stay bounded, the limit surfaces are C^{1,1}; no: those of φ are not. Both
  /// proved. Undecided also where nobody looked.
  Truth bounded = Truth::undecided;
  /// What the answer rests on, or why there is none; one sentence without a full stop.
  std::string reason = "the regular lattice was not looked at";
  /// Whether the shifts of φ are proved to be stable, so that no wave on the control points has the
  /// limit 0. Where they are not, an eigenvector may have the surface 0, and its eigenvalue then
  /// refutes nothing. True where nobody looked.
  bool stable = true;
};

/// Coefficients a(k) by *twice* the offset k from the mask's centre, in the basis of the refined
/// lattice (mesh/split/split.h, mesh/lattice.h): even pairs for primal splits, odd pairs for
/// dual ones. They sum to |det M|, and to 1 over each coset of M Z².
struct Mask {
  Lattice lattice = Lattice::triangle;  ///< control and refined lattice alike
  LatticeMatrix dilation;               ///< M
  Laurent coefficients;                 ///< none of them 0
};

/// Whether old points stay where they are: on their coset the mask holds its centre alone, 1.
[[nodiscard]] bool interpolates(const Mask& mask);

}  // namespace limn
