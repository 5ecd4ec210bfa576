#pragma once
/// Bounds as decimal digits: six of them behind the point, never on the wrong side.

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>

namespace limn::base {

namespace detail {
inline constexpr double kMostMillionths = 9e15;  // all whole numbers below are doubles

/// A whole number with all its digits.
[[nodiscard]] inline std::string whole_text(double whole) {
  if (!std::isfinite(whole)) return whole > 0 ? "inf" : "-inf";
  std::string text(400, '\0');
  text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.0f", whole)));
  return text;
}

/// `millionths` / 10⁶ without zeros at the end. Precondition: below kMostMillionths.
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

/// A lower bound: "1.999999" for 2 - 10⁻⁹, "3" for 3; from 9·10⁹ on whole numbers.
[[nodiscard]] inline std::string rounded_down(double value) {
  if (!(std::abs(value) < detail::kMostMillionths / 1e6))
    return detail::whole_text(std::floor(value));
  return detail::millionths_text(std::floor(value * 1e6));
}
/// An upper bound likewise.
[[nodiscard]] inline std::string rounded_up(double value) {
  if (!(std::abs(value) < detail::kMostMillionths / 1e6))
    return detail::whole_text(std::ceil(value));
  return detail::millionths_text(std::ceil(value * 1e6));
}

}  // namespace limn::base
