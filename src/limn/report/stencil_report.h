#pragma once
/// Drawings of the stencils of a scheme's rules.

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limn/figure/figure.h"
#include "limn/study/rule_picture.h"

namespace limn::report {

/// One drawing a case in letters, compact: a weight stands where its vertex is, that of a face's
/// new vertex after "F", "." is a vertex without one, and brackets hold what stands at the new
/// vertex.
[[nodiscard]] std::string stencils_text(const std::vector<study::RulePicture>& pictures);

/// A list with an object for each case: rule, when, valence, new (x and y), weights (at, weight,
/// face).
[[nodiscard]] nlohmann::ordered_json stencils_json(const std::vector<study::RulePicture>& pictures);

/// One panel a case: weights beside their vertices, the new vertex as a red dot, new vertices of
/// faces that are weighed in blue.
[[nodiscard]] figure::Figure stencils_figure(const std::string& scheme,
                                             const std::vector<study::RulePicture>& pictures);

}  // namespace limn::report
