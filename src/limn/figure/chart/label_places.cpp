#include "limn/figure/chart/label_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace limn::figure {
namespace {

constexpr int kDirections = 24;
constexpr double kNearest = 2, kFarthest = 16, kStep = 1;  // between anchor and label, in points
constexpr double kClear = 0.8;                             // about a label

bool overlap(const Box& a, const Box& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

/// How bad it is to put a label there; 0: it hides nothing.
double hidden(const Box& label, const LabelSurroundings& around, const std::vector<Box>& placed) {
  constexpr double kOutside = 100, kOther = 4, kDot = 2, kLine = 1;
  double sum = 0;
  const Box& within = around.within;
  if (label.x < within.x || label.right() > within.right() || label.y < within.y ||
      label.bottom() > within.bottom())
    sum += kOutside;
  for (const auto& line : around.lines)
    if (crosses(line, label)) sum += kLine;
  for (const LabelSurroundings::Dot& dot : around.dots) {
    const double x = std::clamp(dot.at[0], label.x, label.right());
    const double y = std::clamp(dot.at[1], label.y, label.bottom());
    if (std::hypot(dot.at[0] - x, dot.at[1] - y) < dot.radius) sum += kDot;
  }
  for (const Box& other : placed)
    if (overlap(label, other)) sum += kOther;
  return sum;
}

/// The box whose middle lies in this direction, `distance` clear of the anchor.
Box box_at(const LabelWish& wish, double angle, double distance) {
  const double width = wish.width + 2 * kClear, height = wish.height + 2 * kClear;
  const double c = std::cos(angle), s = std::sin(angle);
  const double reach = std::min(std::abs(c) > 0 ? width / 2 / std::abs(c) : 1e9,
                                std::abs(s) > 0 ? height / 2 / std::abs(s) : 1e9);
  const double x = wish.anchor[0] + c * (reach + distance);
  const double y = wish.anchor[1] - s * (reach + distance);
  return {x - width / 2, y - height / 2, width, height};
}

}  // namespace

bool crosses(const std::array<PagePoint, 2>& segment, const Box& box) {
  double from = 0, to = 1;  // the part of the segment that is inside, clipped side by side
  const double low[2] = {box.x, box.y}, high[2] = {box.right(), box.bottom()};
  for (std::size_t i = 0; i < 2; ++i) {
    const double start = segment[0][i], step = segment[1][i] - start;
    if (step == 0) {
      if (start <= low[i] || start >= high[i]) return false;
      continue;
    }
    const double a = (low[i] - start) / step, b = (high[i] - start) / step;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return from < to;
}

std::vector<PagePoint> label_places(const std::vector<LabelWish>& labels,
                                    const LabelSurroundings& around) {
  std::vector<Box> placed;
  std::vector<PagePoint> middles;
  for (const LabelWish& wish : labels) {
    Box best;
    double least = std::numeric_limits<double>::infinity();
    for (double distance = kNearest; distance <= kFarthest && least > 0; distance += kStep)
      for (int k = 0; k < kDirections && least > 0; ++k) {
        // up and to the right first
        const double angle = std::numbers::pi / 4 + 2 * std::numbers::pi * k / kDirections;
        const Box box = box_at(wish, angle, distance);
        const double now = hidden(box, around, placed);
        if (now < least) {
          least = now;
          best = box;
        }
      }
    placed.push_back(best);
    middles.push_back({best.x + best.width / 2, best.y + best.height / 2});
  }
  return middles;
}

}  // namespace limn::figure
