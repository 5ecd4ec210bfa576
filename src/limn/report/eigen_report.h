#pragma once
/// Eigencomponents as text and JSON: `limn eigen`.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "limn/extraordinary/eigencomponents.h"

namespace limn {

/// {"valence", "rings", "blocks": [{"frequency", "matrix": rows of re or [re, im], "eigenvalues":
/// [{"value": [re, im], "modulus", "ring", "multiplicity", "jordan"}]}], "components": {"position",
/// "tangent", "cup", "saddle"}, "verdict": {"convergent", "c1_necessary", "bounded_curvature",
/// "cup", "saddle", "reasons"}}.
[[nodiscard]] nlohmann::ordered_json eigen_json(const FrequencyBlocks& blocks,
                                                const Eigencomponents& components);

/// The same without the blocks.
[[nodiscard]] nlohmann::ordered_json eigen_json(const Eigencomponents& components);

/// One valence: a line of components and verdicts, and its reasons below.
[[nodiscard]] std::string eigen_text(const Eigencomponents& components);
/// The heading of those lines.
[[nodiscard]] std::string eigen_heading();

}  // namespace limn
