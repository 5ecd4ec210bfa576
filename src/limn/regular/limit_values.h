#pragma once
/// Values of the basis function φ of a mask, φ(x) = Σ a(k) φ(Mx - k), at lattice points: a
/// fixed vector of the transition matrix. With these values as weights the limit position of a
/// control point is found from its neighbours: they are the limit stencil, the dominant left
/// eigenvector of the subdivision matrix [ADS §2.4].
///
/// The inner products ⟨φ, φ(·-j)⟩ are such values too: of the function φ⋆φ(-·), which the
/// autocorrelation of the mask refines.

#include <map>

#include "limn/scheme/mask.h"

namespace limn::regular {

/// The symmetries S of φ about its centre among the lattice's, φ∘S = φ: where a∘S = a, and M S M⁻¹
/// is another such. A group; the identity alone where the mask's do not form one.
[[nodiscard]] std::vector<LatticeMatrix> symmetries(const Mask& mask);

/// The limit stencil exactly, by twice the offset from the control point (even pairs); sums
/// to 1. Fails where the mask has none: where no value, or more than one, is fixed by it
/// (discontinuous φ), and where more than 80 different values would have to be found.
[[nodiscard]] Result<Laurent> limit_stencil(const Mask& mask);

/// The same in double precision, by offset. Fails as above, where more than 1450 different values
/// would have to be found (before any work), and where the scheme does not converge: another
/// eigenvalue of the transition matrix is greater than 1, or, on data with the mask's symmetries,
/// not less than 1.
[[nodiscard]] Result<std::map<LatticeVector, double>> approx_limit_stencil(const Mask& mask);

/// ⟨φ, φ(·-j)⟩ for φ with integral 1, by j in the control lattice, per area of a control cell;
/// they sum to 1. Fails as above.
[[nodiscard]] Result<std::map<LatticeVector, double>> approx_inner_products(const Mask& mask);

/// The mask that refines φ⋆φ(-·): Σ_i a(i) a(i+k) / |det M|.
[[nodiscard]] Mask autocorrelation(const Mask& mask);

}  // namespace limn::regular
