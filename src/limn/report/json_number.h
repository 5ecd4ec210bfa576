#pragma once
/// Numbers in JSON.

#include <cmath>

#include <nlohmann/json.hpp>

namespace limn {

/// The number, or null where it is none that JSON has: infinite, or not a number.
[[nodiscard]] inline nlohmann::ordered_json finite(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
}

}  // namespace limn
