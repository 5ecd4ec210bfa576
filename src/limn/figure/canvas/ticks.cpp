#include "limn/figure/canvas/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn::figure {
namespace {

/// U+2212 for a leading hyphen.
std::string with_minus(std::string text) {
  if (text.starts_with('-')) text.replace(0, 1, "−");
  return text;
}

std::string power_label(int exponent) {
  return with_minus(std::to_string(exponent)).insert(0, "10^{") + "}";
}

/// number · 10^exponent, rounded once for small exponents.
double scaled(double number, int exponent) {
  return exponent < 0 ? number / std::pow(10.0, -exponent) : number * std::pow(10.0, exponent);
}

/// Spacing of round numbers: mantissa · 10^exponent.
struct Step {
  double mantissa = 1;
  int exponent = 0;
};

Step round_step(Range range, int count) {
  const double raw = (range.high / 2 - range.low / 2) / std::max(count, 1) * 2;
  Step step;
  step.exponent = static_cast<int>(std::floor(std::log10(raw)));
  const double part = raw / std::pow(10.0, step.exponent);
  // The nearest by ratio.
  for (const double mantissa : {2.0, 2.5, 5.0, 10.0})
    if (part * part > mantissa * step.mantissa) step.mantissa = mantissa;
  if (step.mantissa == 10) step = {1, step.exponent + 1};
  return step;
}

/// The same, but whole.
Step whole_step(Step step) {
  if (step.exponent < 0) return {1, 0};
  if (step.exponent == 0 && step.mantissa == 2.5) return {2, 0};
  return step;
}

/// The multiples of the step within the range, as multiples.
std::vector<double> multiples(Range range, const Step& step) {
  const double size = scaled(step.mantissa, step.exponent);
  const double slack = 1e-9;
  std::vector<double> result;
  const double first = std::ceil(range.low / size - slack);
  const double last = std::floor(range.high / size + slack);
  for (double n = first; n <= last; ++n) result.push_back(n);
  return result;
}

double value_of(double multiple, const Step& step) {
  return scaled(multiple * step.mantissa, step.exponent);
}

}  // namespace

Range range_of(const std::vector<double>& values) {
  const double infinity = std::numeric_limits<double>::infinity();
  Range range{infinity, -infinity};
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
  return range.low <= range.high ? range : Range{};
}

Range drawable(Range range) {
  constexpr double largest = 1e300;  // so that sums and differences stay finite
  if (std::isnan(range.low) || std::isnan(range.high)) return {};
  range.low = std::clamp(range.low, -largest, largest);
  range.high = std::clamp(range.high, -largest, largest);
  if (range.low > range.high) std::swap(range.low, range.high);
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  if (size < 1e-290) return {-1, 1};
  if (range.high - range.low > 1e-9 * size) return range;
  const double middle = range.low / 2 + range.high / 2;
  return {middle - size / 2, middle + size / 2};
}

std::vector<double> round_levels(Range range, int count) {
  range = drawable(range);
  const Step step = round_step(range, count);
  std::vector<double> levels = multiples(range, step);
  for (double& level : levels) level = value_of(level, step);
  return levels;
}

Ticks linear_ticks(Range range, int count, bool whole) {
  range = drawable(range);
  const Step step = whole ? whole_step(round_step(range, count)) : round_step(range, count);
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  const int magnitude = static_cast<int>(std::floor(std::log10(largest)));
  Ticks result;
  if (magnitude >= 5 || magnitude <= -4) {
    result.exponent = magnitude;
    result.factor = "×" + power_label(magnitude);
  }
  const int exponent = step.exponent - result.exponent;
  const int decimals = std::max(0, (step.mantissa == 2.5 ? 1 : 0) - exponent);
  for (const double n : multiples(range, step)) {
    const double shown = n == 0 ? 0 : scaled(n * step.mantissa, exponent);
    result.ticks.push_back(
        {value_of(n, step), with_minus(fmt::format("{:.{}f}", shown, decimals))});
  }
  return result;
}

Ticks logarithmic_ticks(Range range, int count) {
  const double slack = 1e-9;
  const int first = static_cast<int>(std::ceil(std::log10(range.low) - slack));
  const int last = static_cast<int>(std::floor(std::log10(range.high) + slack));
  if (last <= first) return linear_ticks(range, count);
  const int stride = (last - first) / std::max(count, 1) + 1;
  Ticks result;
  for (int e = first; e <= last; ++e) {
    const bool labelled = (e % stride + stride) % stride == 0;
    if (labelled)
      result.ticks.push_back({std::pow(10.0, e), power_label(e)});
    else
      result.minor.push_back(std::pow(10.0, e));
  }
  for (int e = first - 1; stride == 1 && last - first <= 8 && e <= last; ++e) {
    for (int digit = 2; digit <= 9; ++digit) {
      const double value = scaled(digit, e);
      if (value >= range.low && value <= range.high) result.minor.push_back(value);
    }
  }
  return result;
}

std::string number_label(double value, int digits) {
  if (value == 0) return "0";
  const std::string text = fmt::format("{:.{}g}", value, digits);
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return with_minus(text);
  return with_minus(text.substr(0, e)) + "·" + power_label(std::stoi(text.substr(e + 1)));
}

}  // namespace limn::figure
