#include "limn/report/figure/region_plot.h"

#include <algorithm>

namespace limn {
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
  box_.y = box.y + (height - box_.height) / 2;
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
    path.polyline(points, closed);
  }
  return path;
}

void RegionPlot::draw_axes(Canvas& canvas) const {
  if (!axes_) return;
  x_.draw_as_x(canvas, box_.x, box_.right(), box_.bottom() + kAxisGap);
  y_.draw_as_y(canvas, box_.x - kAxisGap, box_.bottom(), box_.y);
}

}  // namespace limn
