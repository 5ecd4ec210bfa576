#include "limn/figure/chart/map_panel.h"

#include <algorithm>
#include <limits>

#include "limn/figure/chart/colour_bar.h"
#include "limn/figure/chart/contour_labels.h"
#include "limn/figure/chart/region_plot.h"

namespace limn::figure {
namespace {

constexpr double kBarGap = 8;
const Stroke kOutline = {0.6, {}};
const Stroke kContour = {0.35, {}};

ColourScale scale_of(const MapPanel& panel) {
  const Range data = range_of(panel.values);
  const Range range = {panel.low.value_or(data.low), panel.high.value_or(data.high)};
  return colour_scale(range, data, panel.contours);
}

void draw_bands(Canvas& canvas, const RegionPlot& plot, const LevelSets& sets,
                const ColourScale& scale) {
  for (std::size_t i = 0; i < scale.colours.size(); ++i) {
    const double level = i == 0 ? -std::numeric_limits<double>::infinity() : scale.edges[i - 1];
    canvas.fill(plot.path(sets.superlevel_loops(level), true), scale.colours[i]);
  }
}

void draw_contours(Canvas& canvas, const RegionPlot& plot, const LevelSets& sets,
                   const ColourScale& scale, bool labels) {
  std::vector<ContourLine> lines;
  for (const Ticks::Tick& tick : scale.ticks.ticks) {
    const std::vector<Polyline> level = sets.contour_lines(tick.value);
    canvas.stroke(plot.path(level, false), grey(0), kContour);
    const auto band = std::upper_bound(scale.edges.begin(), scale.edges.end(), tick.value);
    const auto index = static_cast<std::size_t>(band - scale.edges.begin());
    for (const Polyline& line : level) {
      ContourLine& added = lines.emplace_back();
      added.label = tick.label;
      added.background = scale.colours[std::min(index, scale.colours.size() - 1)];
      for (const std::array<double, 2>& at : line) added.points.push_back(plot.point(at));
    }
  }
  if (labels) label_contours(canvas, lines, plot.box());
}

/// The edge of where the map has values.
void draw_outline(Canvas& canvas, const RegionPlot& plot, const LevelSets& sets) {
  const double everything = -std::numeric_limits<double>::infinity();
  canvas.stroke(plot.path(sets.superlevel_loops(everything), true), grey(0), kOutline);
}

}  // namespace

double MapPanel::height(double width) const {
  const RegionPlot plot(grid, x_label, y_label, axes);
  const double bar = std::max(kBarGap + colour_bar_width(scale_of(*this), value_label), side);
  const double inner = std::max(width - plot.left_margin() - bar, 1.0) * plot.aspect();
  return title_height(title) + std::min(inner, 1.5 * width) + plot.bottom_margin();
}

void MapPanel::draw(Canvas& canvas, const Box& box) const {
  RegionPlot plot(grid, x_label, y_label, axes);
  const ColourScale scale = scale_of(*this);
  const double bar = std::max(kBarGap + colour_bar_width(scale, value_label), side);
  const double top = title_height(title);
  plot.place({box.x, box.y + top, box.width - bar, box.height - top});
  const LevelSets sets(grid, values);
  draw_bands(canvas, plot, sets, scale);
  if (contours > 0) draw_contours(canvas, plot, sets, scale, contour_labels);
  draw_outline(canvas, plot, sets);
  plot.draw_axes(canvas);
  const Box& inner = plot.box();
  draw_title(canvas, title, inner.x, inner.right(), inner.y - top);
  draw_colour_bar(canvas, scale, value_label, inner.right() + kBarGap, inner.bottom(), inner.y);
}

}  // namespace limn::figure
