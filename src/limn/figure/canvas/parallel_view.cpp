#include "limn/figure/canvas/parallel_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limn::figure {

ParallelView::ParallelView(double azimuth, double elevation) {
  const double a = std::isfinite(azimuth) ? azimuth * std::numbers::pi / 180 : 0;
  const double e = std::isfinite(elevation) ? elevation * std::numbers::pi / 180 : 0;
  right_ = {-std::sin(a), std::cos(a), 0};
  near_ = {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
  up_ = {-std::sin(e) * std::cos(a), -std::sin(e) * std::sin(a), std::cos(e)};
}

ViewFrame frame_of(const std::vector<SpaceVector>& seen) {
  std::vector<double> xs, ys;
  for (const SpaceVector& point : seen) {
    if (!finite(point)) continue;
    xs.push_back(point[0]);
    ys.push_back(point[1]);
  }
  ViewFrame frame{drawable(range_of(xs)), drawable(range_of(ys))};
  const double size = std::max(frame.x.high - frame.x.low, frame.y.high - frame.y.low);
  for (Range* range : {&frame.x, &frame.y})
    if (range->high - range->low < 1e-3 * size) range->low -= size / 2, range->high += size / 2;
  return frame;
}

FramePlacement::FramePlacement(const ViewFrame& frame, const Box& box) : frame_(frame) {
  const double width = frame.x.high - frame.x.low, height = frame.y.high - frame.y.low;
  scale_ = std::min(box.width / width, box.height / height);
  box_ = {box.x + (box.width - scale_ * width) / 2, box.y + (box.height - scale_ * height) / 2,
          scale_ * width, scale_ * height};
}

}  // namespace limn::figure
