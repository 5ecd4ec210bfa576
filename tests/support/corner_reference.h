#pragma once
/// Schemes whose faces have rules seen from extraordinary corners, typed a second time.

#include <optional>
#include <string>
#include <vector>

#include "limn/mesh/split/split.h"

namespace limn::test {

[[nodiscard]] bool has_corner_reference(const std::string& scheme);

/// As `reference_step`, of kobbelt-quad (its parameter w), sqrt3-interpolating and
/// catmull-clark-bounded.
[[nodiscard]] std::vector<double> corner_reference_step(const std::string& scheme,
                                                        std::optional<double> parameter,
                                                        const Mesh& mesh, const Births& births,
                                                        const std::vector<double>& old);

}  // namespace limn::test
