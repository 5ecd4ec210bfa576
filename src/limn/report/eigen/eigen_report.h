#pragma once
/// Eigencomponents as text and JSON: `limn eigen`.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "limn/spectrum/eigencomponents.h"

namespace limn::report {

/// {"valence", "rings", "blocks": [{"frequency", "matrix": rows of re or [re, im], "eigenvalues":
/// [{"value": [re, im], "modulus", "ring", "multiplicity", "jordan"}]}], "components": {"position",
/// "tangent", "cup", "saddle"}, "verdict": {"convergent", "c1_necessary", "curvature_necessary",
/// "regular_part": {"bounded", "reason"}, "bounded_curvature", "cup", "saddle", "reasons"}}. Of the
/// verdict (spectrum/eigencomponents.h): names in "necessary" are conditions that a C1
/// surface, or bounded curvature, needs and that do not suffice; "regular_part" is what the regular
/// lattice allows; "bounded_curvature" takes in both, and says what holds if the surface is C1;
/// "cup" and "saddle" compare their eigenvalues with tangent²: "flat" less, "bounded" equal,
/// "unbounded" greater.
[[nodiscard]] nlohmann::ordered_json eigen_json(const FrequencyBlocks& blocks,
                                                const Eigencomponents& components);

/// The same without the blocks.
[[nodiscard]] nlohmann::ordered_json eigen_json(const Eigencomponents& components);

/// {"bounded": "yes", "no" or "undecided", "reason"}
[[nodiscard]] nlohmann::ordered_json regular_part_json(const RegularPart& part);

/// One valence: a line of components and verdicts, and its reasons below.
[[nodiscard]] std::string eigen_text(const Eigencomponents& components);
/// The heading of those lines.
[[nodiscard]] std::string eigen_heading();
/// A line on the regular lattice.
[[nodiscard]] std::string regular_part_text(const RegularPart& part);
/// What the columns say and what they do not.
[[nodiscard]] std::string eigen_legend();

}  // namespace limn::report
