#pragma once
/// Solved parameters and their ranges as text and JSON: `limn tune`.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "limn/tune/solve.h"

namespace limn::report {

/// {"valence", "searched": [low, high], "samples", "solutions": [{"value", "residual", "exact":
/// "p/q" or null, "double", "holds": true, false or null (undecided), "reason", "components",
/// "verdict":
/// {"c1_necessary", "regular_part", "bounded_curvature"}}], "throughout": [[low, high], …],
/// "reason"}; components and the verdict's words as in eigen_json.
[[nodiscard]] nlohmann::ordered_json tune_json(const ValenceSolutions& solutions);

/// {"valence", "searched", "samples", "closed", "undecided": whether some of it is, "parts":
/// [{"low", "high": {"value", "exact", "end_of_search", "reason"}}], "reason"}.
[[nodiscard]] nlohmann::ordered_json tune_json(const ValenceRange& range);

/// [[low, high], …]
[[nodiscard]] nlohmann::ordered_json intervals_json(const std::vector<Interval>& intervals);

/// {"components", "verdict"} of tune_json's solutions.
[[nodiscard]] nlohmann::ordered_json found_json(const Eigencomponents& found);
/// The columns of a solution's line but the last one.
[[nodiscard]] std::string found_text(int valence, const Eigencomponents& found, Truth holds);

/// A line for each solution: its value, components and verdicts; reasons below it. `name`: what was
/// freed.
[[nodiscard]] std::string tune_text(const std::string& name, const ValenceSolutions& solutions);
[[nodiscard]] std::string solution_heading(const std::string& name);

/// A line for each part of a range, and what ends it below.
[[nodiscard]] std::string tune_text(const std::string& name, const ValenceRange& range);
/// The line that says where a requirement holds at all valences together.
[[nodiscard]] std::string common_text(const std::string& name, const std::vector<Interval>& common);

}  // namespace limn::report
