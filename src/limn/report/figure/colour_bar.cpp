#include "limn/report/figure/colour_bar.h"

#include <algorithm>
#include <cmath>

#include "limn/report/figure/colour_map.h"

namespace limn {
namespace {

constexpr double kBarWidth = 7;
constexpr double kNumberGap = 1.5;
constexpr double kLabelGap = 3;
constexpr double kLighten = 0.12;  // black lines must show on the darkest band
constexpr int kBandsPerTick = 4;

struct BarNumber {
  double value;
  std::string label;
};

/// The ticks, and ≤ or ≥ at a clamped end in place of a tick that is near it. `clearance`: the
/// distance in values that two numbers need.
std::vector<BarNumber> numbers(const ColourScale& scale, double clearance) {
  const double unit = std::pow(10.0, scale.ticks.exponent);
  const auto near_end = [&](double value) {
    return (scale.low_clamped && value - scale.range.low < clearance) ||
           (scale.high_clamped && scale.range.high - value < clearance);
  };
  std::vector<BarNumber> result;
  if (scale.low_clamped)
    result.push_back({scale.range.low, "≤ " + number_label(scale.range.low / unit)});
  for (const Ticks::Tick& tick : scale.ticks.ticks)
    if (!near_end(tick.value)) result.push_back({tick.value, tick.label});
  if (scale.high_clamped)
    result.push_back({scale.range.high, "≥ " + number_label(scale.range.high / unit)});
  return result;
}

double widest(const std::vector<BarNumber>& all) {
  double width = 0;
  for (const BarNumber& number : all)
    width = std::max(width, text_width(number.label, {.size = kTickSize}));
  return width;
}

std::string full_label(const ColourScale& scale, const std::string& label) {
  if (scale.ticks.factor.empty()) return label;
  return label.empty() ? scale.ticks.factor : label + "  (" + scale.ticks.factor + ")";
}

}  // namespace

ColourScale colour_scale(Range range, Range data, int count) {
  ColourScale scale;
  scale.range = drawable(range);
  scale.ticks = linear_ticks(scale.range, std::max(count, 2));
  scale.low_clamped = data.low < scale.range.low;
  scale.high_clamped = data.high > scale.range.high;
  const auto& ticks = scale.ticks.ticks;
  const double size = scale.range.high - scale.range.low;
  const double step = ticks.size() < 2 ? size : ticks[1].value - ticks[0].value;
  const double origin = ticks.empty() ? scale.range.low : ticks[0].value;
  // Between two ticks, the edge at a tick is that very number.
  for (int i = -kBandsPerTick; i <= static_cast<int>(ticks.size()) * kBandsPerTick; ++i) {
    const bool tick = i >= 0 && i % kBandsPerTick == 0;
    const auto index = static_cast<std::size_t>(i / kBandsPerTick);
    const double edge =
        tick && index < ticks.size() ? ticks[index].value : origin + i * step / kBandsPerTick;
    if (edge > scale.range.low && edge < scale.range.high) scale.edges.push_back(edge);
  }
  for (std::size_t i = 0; i <= scale.edges.size(); ++i) {
    const double low = i == 0 ? scale.range.low : scale.edges[i - 1];
    const double high = i == scale.edges.size() ? scale.range.high : scale.edges[i];
    const double middle = (low / 2 + high / 2 - scale.range.low) / size;
    scale.colours.push_back(lightened(viridis(middle), kLighten));
  }
  return scale;
}

double colour_bar_width(const ColourScale& scale, const std::string& label) {
  // The widest possible numbers: those without regard to clearance.
  const double width = kBarWidth + kTickLength + kNumberGap + widest(numbers(scale, 0));
  return full_label(scale, label).empty() ? width : width + kLabelGap + kLabelSize;
}

void draw_colour_bar(Canvas& canvas, const ColourScale& scale, const std::string& label, double x,
                     double bottom, double top) {
  const double size = scale.range.high - scale.range.low;
  const auto at = [&](double value) {
    return bottom + (value - scale.range.low) / size * (top - bottom);
  };
  for (std::size_t i = 0; i < scale.colours.size(); ++i) {
    const double from = i == 0 ? bottom : at(scale.edges[i - 1]);
    canvas.fill(Path::rectangle({x, top, kBarWidth, from - top}), scale.colours[i]);
  }
  canvas.stroke(Path::rectangle({x, top, kBarWidth, bottom - top}), grey(0), {0.5, {}});
  const double right = x + kBarWidth;
  const std::vector<BarNumber> all = numbers(scale, 1.2 * kTickSize / (bottom - top) * size);
  for (const BarNumber& number : all) {
    const double y = at(number.value);
    canvas.stroke(Path::segment({right, y}, {right + kTickLength, y}), grey(0), {0.5, {}});
    canvas.text({right + kTickLength + kNumberGap, y}, number.label,
                {.size = kTickSize, .vertical = VerticalAlign::middle});
  }
  canvas.text(
      {right + kTickLength + kNumberGap + widest(all) + kLabelGap, (bottom + top) / 2},
      full_label(scale, label),
      {.size = kLabelSize, .align = Align::centre, .vertical = VerticalAlign::top, .angle = 90});
}

}  // namespace limn
