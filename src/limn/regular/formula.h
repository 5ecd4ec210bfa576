#pragma once
/// Magnitudes of signal and artifacts as closed formulas, derived from the mask [ADS Tables 1-3].

#include <string>
#include <vector>

#include "limn/number/notation.h"
#include "limn/scheme/mask.h"

namespace limn::regular {

/// What the names in the formulas mean, one definition a line. Phases t1, t2 (and t3 = -t1-t2 on
/// triangles) are per refined edge; c1 = cos t1, …, c12 = cos(t1 - t2), ….
[[nodiscard]] std::vector<std::string> formula_names(const Mask& mask, number::Notation notation);

/// The signal's magnitude and those of the artifacts, in the order of dual_cosets, after one
/// step. Precondition: the mask is point-symmetric.
[[nodiscard]] std::vector<std::string> step_formulas(const Mask& mask, number::Notation notation);

/// The same in the limit, at the points of the first refined lattice. Fails where limit_stencil
/// does.
[[nodiscard]] Result<std::vector<std::string>> limit_formulas(const Mask& mask,
                                                              number::Notation notation);

/// What the components are called: α, β, … in the order of the formulas ("alpha" or "\alpha").
[[nodiscard]] std::string component_name(int component, number::Notation notation);

}  // namespace limn::regular
