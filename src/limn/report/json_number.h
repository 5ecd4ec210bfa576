#pragma once
/// Numbers in JSON.

#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>

namespace limn::report {

/// The number, or null where it is none that JSON has: infinite, or not a number.
[[nodiscard]] inline nlohmann::ordered_json finite(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
}

/// The number, or null where there is none.
[[nodiscard]] inline nlohmann::ordered_json number_json(const std::optional<double>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

}  // namespace limn::report
