#include "limn/figure/space/light_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limn::figure {
namespace {

constexpr double kFirst = 0.5;  // the first line's angle from the eye, in distances of lines

}  // namespace

MirroredLights::MirroredLights(const LightLines& lights, const ParallelView& view)
    : count_(std::clamp(lights.count, 1, 10000)) {
  SpaceVector axis{};
  if (lights.direction) axis = normalised(view.seen(*lights.direction));
  if (axis == SpaceVector{}) axis = {1, 0, 0};
  for (const SpaceVector& towards : {SpaceVector{0, 0, 1}, SpaceVector{0, 1, 0}}) {
    const SpaceVector rest = sum(towards, axis, -dot(towards, axis));
    if (length(rest) < 1e-6) continue;
    first_ = normalised(rest);
    break;
  }
  second_ = cross(first_, axis);
}

double MirroredLights::turn(const SpaceVector& r) const {
  return count_ * std::atan2(dot(r, second_), dot(r, first_)) / (2 * std::numbers::pi) - kFirst;
}

MirroredLights::HalfPlane MirroredLights::half_plane(int line) const {
  const double angle = 2 * std::numbers::pi * (line + kFirst) / count_;
  const auto at = [&](double c, double s) { return sum(sum({}, first_, c), second_, s); };
  return {at(std::cos(angle), std::sin(angle)), at(-std::sin(angle), std::cos(angle))};
}

}  // namespace limn::figure
