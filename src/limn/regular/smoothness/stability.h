#pragma once
/// Whether the integer shifts of φ are stable: whether no wave on the control points has the limit
/// 0. For continuous φ that is so where the values of φ at the points of a lattice tell, for each
/// frequency, a sum other than 0.

#include <string>

#include "limn/base/truth.h"
#include "limn/scheme/mask.h"

namespace limn::regular {

struct Stability {
  Truth verdict = Truth::undecided;  ///< never no
  std::string reason;
};

/// Precondition: the scheme converges. Proved from the exact values of φ at Z² and M⁻¹Z²: the sums
/// Σ_k φ(k + s) e^{-iω·k} of the classes s, which do not all vanish at any ω (squares of the
/// frequency plane are cut until the slope of the sums, bounded, does not suffice to reach 0).
[[nodiscard]] Stability prove_stability(const Mask& mask);

}  // namespace limn::regular
