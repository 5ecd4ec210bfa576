#include "limn/figure/chart/region_plot.h"

#include <algorithm>
#include <cmath>

namespace limn::figure {
namespace {

constexpr double kAxisGap = 3;  // between the region and its axes
constexpr int kTicks = 4;

/// The coordinate's range over the nodes of triangles; with equal ends, about 1 long.
Range extent(const TriangleGrid& grid, int coordinate) {
  std::vector<double> values;
  for (const std::array<int, 3>& triangle : grid.triangles)
    for (const int node : triangle) values.push_back(grid.nodes[node][coordinate]);
  const Range range = range_of(values);
  return range.low < range.high ? range : Range{range.low - 0.5, range.low + 0.5};
}

/// Leaves out corners that lie within a hundredth of a point of the line that remains.
std::vector<PagePoint> simplified(const std::vector<PagePoint>& points) {
  constexpr double tolerance = 0.01;
  constexpr std::size_t longest = 40;  // corners left out in a row; bounds the cost
  if (points.size() < 3) return points;
  const auto far_from = [](const PagePoint& p, const PagePoint& a, const PagePoint& b) {
    const double x = b[0] - a[0], y = b[1] - a[1];
    const double length = x * x + y * y;
    double t = length > 0 ? ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / length : 0;
    t = std::clamp(t, 0.0, 1.0);
    return std::hypot(p[0] - a[0] - t * x, p[1] - a[1] - t * y) > tolerance;
  };
  std::vector<PagePoint> result{points.front()};
  std::size_t kept = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    bool needed = i - kept >= longest;
    for (std::size_t k = kept + 1; k <= i && !needed; ++k)
      needed = far_from(points[k], points[kept], points[i + 1]);
    if (!needed) continue;
    result.push_back(points[i]);
    kept = i;
  }
  result.push_back(points.back());
  return result;
}

}  // namespace

RegionPlot::RegionPlot(const TriangleGrid& grid, const std::string& x_label,
                       const std::string& y_label, bool axes)
    : x_(extent(grid, 0), x_label, kTicks), y_(extent(grid, 1), y_label, kTicks), axes_(axes) {}

double RegionPlot::left_margin() const { return axes_ ? kAxisGap + y_.width_as_y() : 1; }

double RegionPlot::bottom_margin() const { return axes_ ? kAxisGap + x_.height_as_x() : 1; }

double RegionPlot::aspect() const {
  return (y_.range().high - y_.range().low) / (x_.range().high - x_.range().low);
}

void RegionPlot::place(const Box& box) {
  const double width = std::max(box.width - left_margin(), 1.0);
  const double height = std::max(box.height - bottom_margin(), 1.0);
  box_.width = std::min(width, height / aspect());
  box_.height = box_.width * aspect();
  box_.x = box.x + left_margin() + (width - box_.width) / 2;
  box_.y = box.y;
}

PagePoint RegionPlot::point(const std::array<double, 2>& at) const {
  return {box_.x + x_.fraction(at[0]) * box_.width,
          box_.bottom() - y_.fraction(at[1]) * box_.height};
}

Path RegionPlot::path(const std::vector<Polyline>& lines, bool closed) const {
  Path path;
  for (const Polyline& line : lines) {
    std::vector<PagePoint> points;
    points.reserve(line.size());
    for (const std::array<double, 2>& at : line) points.push_back(point(at));
    path.polyline(simplified(points), closed);
  }
  return path;
}

void RegionPlot::draw_axes(Canvas& canvas) const {
  if (!axes_) return;
  x_.draw_as_x(canvas, box_.x, box_.right(), box_.bottom() + kAxisGap);
  y_.draw_as_y(canvas, box_.x - kAxisGap, box_.bottom(), box_.y);
}

}  // namespace limn::figure
