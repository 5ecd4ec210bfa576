#pragma once
/// Regularity on the regular lattice as text and JSON: `limn regularity`.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "limn/regular/smoothness/regularity.h"

namespace limn::report {

/// {"scheme", "holder": {"lower", "upper": number or null, "exact": closed form or null,
/// "attained": true, false or null (undecided), "attained_reason", "logarithm": p or null,
/// "logarithm_sharp": true, false or null}, "c0", "c1", "c2": "yes|no|undecided",
/// "smoothness": [the verdicts of C0, C1, C2 and, as long as the one before is yes, C3, …],
/// "sum_rules", "reproduction", "stable": {"verdict", "reason"}, "proofs": {"c0": {"reason",
/// "power", "norm": both null where no norm below 1 was found}, …}, "time_ended": whether the time
/// budget ended the search, "joint_spectral_radius":
/// {"lower", "upper", "exact", "product": [[digit]], "eigenvalue": "p/q" or null, "blocks":
/// [{"size", "lower", "upper", "vertices", "irreducible", "bounded", "below"}]}}. Attained and
/// logarithm: `Attainment`; bounded and below: `JointSpectralRadius::Block`.
[[nodiscard]] nlohmann::ordered_json regularity_json(const std::string& name,
                                                     const Regularity& regularity);

/// For people: verdicts with their reasons, the bracket and what made it.
[[nodiscard]] std::string regularity_text(const std::string& name, const Regularity& regularity);

/// "3", "log2(3) = 1.584963", "[1.229383, 1.232984]", "at least 4": brackets are rounded outwards.
[[nodiscard]] std::string to_string(const HolderBracket& bracket);

}  // namespace limn::report
