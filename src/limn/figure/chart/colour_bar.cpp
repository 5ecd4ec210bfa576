#include "limn/figure/chart/colour_bar.h"

#include <algorithm>
#include <cmath>

#include "limn/figure/canvas/colour_map.h"

namespace limn::figure {
namespace {

constexpr double kBarWidth = 7;
constexpr double kBarNumberGap = 1.5;
constexpr double kBarLabelGap = 3;
constexpr double kLighten = 0.12;  // black lines must show on the darkest band
constexpr int kBandsPerTick = 4;

/// A labelled place of the bar.
struct BarNumber {
  double value;
  std::string label;
};

/// Of how many ticks one is labelled, so that labels are `clearance` (in values) apart.
int label_stride(const ColourScale& scale, double clearance) {
  const auto& ticks = scale.ticks.ticks;
  if (ticks.size() < 2) return 1;
  for (const int stride : {1, 2, 5, 10, 20})
    if (stride * (ticks[1].value - ticks[0].value) >= clearance) return stride;
  return 50;
}

/// A label for each tick or each few of them, and ≤ or ≥ at a clamped end in place of one that is
/// near it. `clearance`: the distance in values that two labels need.
std::vector<BarNumber> numbers(const ColourScale& scale, double clearance) {
  const double unit = std::pow(10.0, scale.ticks.exponent);
  const int stride = label_stride(scale, clearance);
  const auto& ticks = scale.ticks.ticks;
  const double step = ticks.size() < 2 ? 1 : ticks[1].value - ticks[0].value;
  const auto hidden = [&](double value) {
    return std::fmod(std::round(value / step), stride) != 0 ||
           (scale.low_clamped && value - scale.range.low < clearance) ||
           (scale.high_clamped && scale.range.high - value < clearance);
  };
  std::vector<BarNumber> result;
  if (scale.low_clamped)
    result.push_back({scale.range.low, "≤ " + number_label(scale.range.low / unit)});
  for (const Ticks::Tick& tick : ticks)
    if (!hidden(tick.value)) result.push_back({tick.value, tick.label});
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

/// Whether the range has both signs, and not one of them by rounding.
bool has_both_signs(Range range) {
  constexpr double kRounding = 1e-9;
  return range.low < -kRounding * range.high && range.high > -kRounding * range.low;
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
  scale.is_signed = has_both_signs(scale.range);
  const double most = std::max(std::abs(scale.range.low), std::abs(scale.range.high));
  for (std::size_t i = 0; i <= scale.edges.size(); ++i) {
    const double low = i == 0 ? scale.range.low : scale.edges[i - 1];
    const double high = i == scale.edges.size() ? scale.range.high : scale.edges[i];
    const double middle = low / 2 + high / 2;
    scale.colours.push_back(lightened(
        scale.is_signed ? diverging(middle / most) : viridis((middle - scale.range.low) / size),
        kLighten));
  }
  return scale;
}

Colour colour_of(const ColourScale& scale, double value) {
  if (!std::isfinite(value)) return grey(0.6);
  const auto band = std::upper_bound(scale.edges.begin(), scale.edges.end(), value);
  return scale.colours[static_cast<std::size_t>(band - scale.edges.begin())];
}

double colour_bar_width(const ColourScale& scale, const std::string& label) {
  // The widest possible numbers: those without regard to clearance.
  const double width = kBarWidth + kTickLength + kBarNumberGap + widest(numbers(scale, 0));
  return full_label(scale, label).empty() ? width : width + kBarLabelGap + kLabelSize;
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
  const std::vector<BarNumber> all = numbers(scale, 1.25 * kTickSize / (bottom - top) * size);
  const auto draw_tick = [&](double value, double length) {
    canvas.stroke(Path::segment({right, at(value)}, {right + length, at(value)}), grey(0), {});
  };
  for (const Ticks::Tick& tick : scale.ticks.ticks) draw_tick(tick.value, kTickLength * 0.6);
  for (const BarNumber& number : all) {
    draw_tick(number.value, kTickLength);
    canvas.text({right + kTickLength + kBarNumberGap, at(number.value)}, number.label,
                {.size = kTickSize, .vertical = VerticalAlign::middle});
  }
  canvas.text(
      {right + kTickLength + kBarNumberGap + widest(all) + kBarLabelGap, (bottom + top) / 2},
      full_label(scale, label),
      {.size = kLabelSize, .align = Align::centre, .vertical = VerticalAlign::top, .angle = 90});
}

double lying_colour_bar_height(const ColourScale& scale, const std::string& label) {
  const double height = kBarWidth + kTickLength + kBarNumberGap + kTickSize;
  return full_label(scale, label).empty() ? height : height + kBarLabelGap + kLabelSize;
}

void draw_lying_colour_bar(Canvas& canvas, const ColourScale& scale, const std::string& label,
                           double left, double right, double top) {
  const double size = scale.range.high - scale.range.low;
  const auto at = [&](double value) {
    return left + (value - scale.range.low) / size * (right - left);
  };
  for (std::size_t i = 0; i < scale.colours.size(); ++i) {
    const double from = i == 0 ? left : at(scale.edges[i - 1]);
    canvas.fill(Path::rectangle({from, top, right - from, kBarWidth}), scale.colours[i]);
  }
  canvas.stroke(Path::rectangle({left, top, right - left, kBarWidth}), grey(0), {0.5, {}});
  const double bottom = top + kBarWidth;
  const double clearance = widest(numbers(scale, 0)) + kTickSize;
  for (const BarNumber& number : numbers(scale, clearance / (right - left) * size)) {
    const double x = at(number.value);
    canvas.stroke(Path::segment({x, bottom}, {x, bottom + kTickLength}), grey(0), {});
    canvas.text({x, bottom + kTickLength + kBarNumberGap}, number.label,
                {.size = kTickSize, .align = Align::centre, .vertical = VerticalAlign::top});
  }
  canvas.text({(left + right) / 2, bottom + kTickLength + kBarNumberGap + kTickSize + kBarLabelGap},
              full_label(scale, label),
              {.size = kLabelSize, .align = Align::centre, .vertical = VerticalAlign::top});
}

}  // namespace limn::figure
