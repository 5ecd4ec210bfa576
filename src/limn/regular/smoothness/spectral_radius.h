#pragma once
/// A proved lower bound of the spectral radius of one rational matrix.

#include <optional>

#include "limn/base/budget.h"
#include "limn/regular/algebra/invariant_subspaces.h"

namespace limn::regular {

struct SpectralRadiusBound {
  double lower = 0;                    ///< ≤ the spectral radius, proved
  std::optional<Rational> eigenvalue;  ///< one of that modulus, where a leading one is rational
};

/// A rational leading eigenvalue is one exactly (the determinant vanishes); a real one is enclosed
/// to about 10⁻¹² by a sign of an exact determinant; else the traces of powers tell,
/// |tr Aᵐ| ≤ size · ρᵐ, and about 10⁻³ is lost. Traces alone are left where `stop` asks for an end.
[[nodiscard]] SpectralRadiusBound lower_spectral_radius(const RationalMatrix& a,
                                                        const Stop& stop = {});

}  // namespace limn::regular
