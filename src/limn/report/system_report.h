#pragma once
/// Solutions of several requirements for several names, as text, JSON and a scheme file: `limn
/// tune` with more than one --free or --require.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "limn/tune/solve_system.h"

namespace limn::report {

/// {"valence", "searched": [[low, high], …], "starts", "solutions": [{"values": {name: number},
/// "exact": {name: "p/q", a formula in n, or null}, "residual", "holds": true, false or null,
/// "reason", "components", "verdict"}], "reason"}; components and verdict as in tune_json.
[[nodiscard]] nlohmann::ordered_json system_json(const tune::FreedNames& names,
                                                 const tune::SystemSolutions& solutions);
/// A line for each solution with its components and verdicts, and below it one for each name.
[[nodiscard]] std::string system_text(const tune::FreedNames& names,
                                      const tune::SystemSolutions& solutions);
[[nodiscard]] std::string system_heading();

/// For each name a formula in n that has its value at all valences, where one is recognised
/// (closed_form.h): of the first solutions that hold. Nothing where a valence has none.
[[nodiscard]] std::vector<std::optional<std::string>> common_forms(
    const tune::FreedNames& names, const std::vector<tune::SystemSolutions>& solutions);

/// A scheme file that extends `extends` and has the first solution that holds at each valence, as
/// cases of n: as formula or fraction where these were recognised, else as that of the double. What
/// else it says, and when it fails, is as of tuned_scheme_text.
[[nodiscard]] Result<std::string> tuned_system_text(
    const tune::FreedNames& names, const std::vector<Requirement>& requirements,
    const std::vector<tune::SystemSolutions>& solutions, const std::string& extends);

}  // namespace limn::report
