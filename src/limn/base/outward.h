#pragma once
/// Bounds as decimal digits: six of them behind the point, never on the wrong side.

#include <cmath>
#include <string>

namespace limn {

namespace detail {
/// `millionths` / 10⁶ without zeros at the end.
[[nodiscard]] inline std::string millionths_text(double millionths) {
  const bool negative = millionths < 0;
  const auto size = static_cast<long long>(std::abs(millionths));
  std::string digits = std::to_string(size % 1'000'000);
  digits.insert(0, 6 - digits.size(), '0');
  while (!digits.empty() && digits.back() == '0') digits.pop_back();
  std::string text = (negative ? "-" : "") + std::to_string(size / 1'000'000);
  return digits.empty() ? text : text + "." + digits;
}
}  // namespace detail

/// A lower bound of sizes below 10⁹: "1.999999" for 2 - 10⁻⁹, "3" for 3.
[[nodiscard]] inline std::string rounded_down(double value) {
  return detail::millionths_text(std::floor(value * 1e6));
}
/// An upper bound likewise.
[[nodiscard]] inline std::string rounded_up(double value) {
  return detail::millionths_text(std::ceil(value * 1e6));
}

}  // namespace limn
