#pragma once
/// The part of reference_step.h that is of schemes which cut triangles' edges in three.

#include <optional>
#include <string>
#include <vector>

#include "limn/mesh/split/split.h"

namespace limn::test {

[[nodiscard]] bool has_ternary_reference(const std::string& scheme);

/// As reference_step. Precondition: has_ternary_reference(scheme).
[[nodiscard]] std::vector<double> ternary_reference_step(const std::string& scheme,
                                                         std::optional<double> parameter,
                                                         const Mesh& mesh, const Births& births,
                                                         const std::vector<double>& old);

}  // namespace limn::test
