#include "limn/figure/chart/axes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace limn::figure {
namespace {

constexpr double kNumberGap = 1.5;  // between a tick and its number
constexpr double kLabelGap = 2.5;   // between the numbers and the label
constexpr Colour kInk = {0, 0, 0, 1};
const Stroke kAxisStroke = {0.5, {}};

Range made_logarithmic(Range range) {
  constexpr double least = 1e-280, most = 1e280;  // so that linear ticks can be had too
  if (!(range.high > 0)) return {0.1, 1};
  range.high = std::clamp(range.high, 10 * least, most);
  if (!(range.low > 0)) range.low = range.high * 1e-12;
  range.low = std::clamp(range.low, least, range.high);
  if (range.high < range.low * 1.0001) return {range.low / 3, range.high * 3};
  return range;
}

}  // namespace

Axis::Axis(Range range, std::string label, int count, Kind kind)
    : range_(kind == Kind::logarithmic ? made_logarithmic(range) : drawable(range)),
      label_(std::move(label)),
      count_(count),
      kind_(kind),
      ticks_(ticks(count)) {}

Ticks Axis::ticks(int count) const {
  return kind_ == Kind::logarithmic ? logarithmic_ticks(range_, count)
                                    : linear_ticks(range_, count, kind_ == Kind::whole);
}

Ticks Axis::ticks_within(double length, bool upright) const {
  Ticks result = ticks_;
  for (int count = count_ - 1; count > 0 && result.ticks.size() > 1; --count) {
    const double share =
        std::abs(fraction(result.ticks[1].value) - fraction(result.ticks[0].value));
    const double needed = upright ? 1.3 * kTickSize : width_of_numbers(result) + 0.6 * kTickSize;
    if (share * length >= needed) break;
    result = ticks(count);
  }
  return result;
}

double Axis::fraction(double value) const {
  if (kind_ != Kind::logarithmic) return (value - range_.low) / (range_.high - range_.low);
  if (!(value > 0)) return std::numeric_limits<double>::quiet_NaN();
  return std::log(value / range_.low) / std::log(range_.high / range_.low);
}

std::string Axis::full_label() const {
  if (ticks_.factor.empty()) return label_;
  return label_.empty() ? ticks_.factor : label_ + "  (" + ticks_.factor + ")";
}

double width_of_numbers(const Ticks& ticks) {
  double widest = 0;
  for (const Ticks::Tick& tick : ticks.ticks)
    widest = std::max(widest, text_width(tick.label, {.size = kTickSize}));
  return widest;
}

double Axis::width_as_y() const {
  const double numbers = kTickLength + kNumberGap + width_of_numbers(ticks_);
  return full_label().empty() ? numbers : numbers + kLabelGap + kLabelSize;
}

double Axis::height_as_x() const {
  const double numbers = kTickLength + kNumberGap + kTickSize;
  return full_label().empty() ? numbers : numbers + kLabelGap + kLabelSize;
}

void Axis::draw_as_x(Canvas& canvas, double left, double right, double y) const {
  const Ticks ticks = ticks_within(right - left, false);
  const auto at = [&](double value) { return left + fraction(value) * (right - left); };
  canvas.stroke(Path::segment({left, y}, {right, y}), kInk, kAxisStroke);
  for (const double value : ticks.minor)
    canvas.stroke(Path::segment({at(value), y}, {at(value), y + kTickLength * 0.6}), kInk,
                  {0.35, {}});
  for (const Ticks::Tick& tick : ticks.ticks) {
    const double x = at(tick.value);
    canvas.stroke(Path::segment({x, y}, {x, y + kTickLength}), kInk, kAxisStroke);
    canvas.text({x, y + kTickLength + kNumberGap}, tick.label,
                {.size = kTickSize, .align = Align::centre, .vertical = VerticalAlign::top});
  }
  canvas.text({(left + right) / 2, y + kTickLength + kNumberGap + kTickSize + kLabelGap},
              full_label(),
              {.size = kLabelSize, .align = Align::centre, .vertical = VerticalAlign::top});
}

void Axis::draw_as_y(Canvas& canvas, double x, double bottom, double top) const {
  const Ticks ticks = ticks_within(bottom - top, true);
  const auto at = [&](double value) { return bottom + fraction(value) * (top - bottom); };
  canvas.stroke(Path::segment({x, bottom}, {x, top}), kInk, kAxisStroke);
  for (const double value : ticks.minor)
    canvas.stroke(Path::segment({x - kTickLength * 0.6, at(value)}, {x, at(value)}), kInk,
                  {0.35, {}});
  for (const Ticks::Tick& tick : ticks.ticks) {
    const double y = at(tick.value);
    canvas.stroke(Path::segment({x - kTickLength, y}, {x, y}), kInk, kAxisStroke);
    canvas.text({x - kTickLength - kNumberGap, y}, tick.label,
                {.size = kTickSize, .align = Align::right, .vertical = VerticalAlign::middle});
  }
  canvas.text(
      {x - kTickLength - kNumberGap - width_of_numbers(ticks) - kLabelGap, (bottom + top) / 2},
      full_label(),
      {.size = kLabelSize, .align = Align::centre, .vertical = VerticalAlign::bottom, .angle = 90});
}

void draw_title(Canvas& canvas, const std::string& title, double left, double right, double y) {
  canvas.text(
      {(left + right) / 2, y}, title,
      {.size = kTitleSize, .align = Align::centre, .vertical = VerticalAlign::top, .bold = true});
}

}  // namespace limn::figure
