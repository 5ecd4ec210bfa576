#pragma once
/// Eigenvectors, limit and tangent stencils as text and JSON: `limn eigen --vectors`.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "limn/spectrum/eigencomponents.h"

namespace limn::report {

/// Adds to eigen_json's object (report/eigen/eigen_report.h): "orbits" [{"ring", "angle" in
/// sectors}]; in every block "vectors" [{"value", "right": [vector …], "left": [vector …]}], a
/// vector being its amplitudes (re or [re, im]), the centre first in block 0; and "spatial"
/// {"position", "tangent", "cup", "saddle"}, each {"right": [values …], "left": [weights …]} at the
/// star's vertices, numbered as in mesh/lattice.h. "left" of position is the limit stencil, that of
/// tangent the two tangent stencils.
void add_vectors_json(const FrequencyBlocks& blocks, const Eigencomponents& components,
                      nlohmann::ordered_json& json);

/// Amplitudes of position, tangent, cup and saddle, a line for each orbit: of the eigenvector, and
/// of the stencil that measures it (its weight at each of the n points is that amplitude over n,
/// times 2 cos and 2 sin of ω times the angle where ω > 0).
[[nodiscard]] std::string vectors_text(const FrequencyBlocks& blocks,
                                       const Eigencomponents& components);

}  // namespace limn::report
