#pragma once
/// What a scheme is on the regular lattice: mask, factors, limit stencil, closed formulas of its
/// artifacts. For `limn show`.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "limn/scheme/mask.h"

namespace limn::report {

/// For people; several sections, each with its heading.
[[nodiscard]] std::string lattice_text(const Mask& mask);

/// {"mask": coefficients, "factors": {"stages", "directions": [{"step", "count"}], "kernel"},
/// "limit_stencil": coefficients or null, "formulas": {"names": […], "one_step": […], "limit": […]
/// or null} or null}. Coefficients: [{"twice_offset", "value"}], the value an exact string;
/// formulas: the signal, then the artifacts.
[[nodiscard]] nlohmann::ordered_json lattice_json(const Mask& mask);

/// A fragment for a paper: mask, factors, limit stencil and formulas (needs amsmath).
[[nodiscard]] std::string lattice_latex(const std::string& name, const Mask& mask);

/// "2 stages and a kernel", "direction (1, 0) 3 times".
[[nodiscard]] std::string factors_in_words(const Mask& mask);

}  // namespace limn::report
