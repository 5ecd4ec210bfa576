#include "limn/figure/chart/overlay_panel.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "limn/figure/canvas/colour_map.h"
#include "limn/figure/chart/region_plot.h"

namespace limn::figure {
namespace {

constexpr double kLayerRow = 11;
constexpr double kLayersGap = 5;
constexpr double kSwatchWidth = 22, kSwatchHeight = 6;
constexpr double kTotalAlpha = 0.62;  // of all fills of a layer, one upon the other

/// Red, green and blue that the colour-blind tell apart too.
Colour layer_colour(const OverlayPanel::Layer& layer, std::size_t index) {
  static constexpr Colour colours[] = {{0.84, 0.15, 0.08}, {0.0, 0.60, 0.30}, {0.05, 0.32, 0.80}};
  if (layer.colour) return *layer.colour;
  return index < 3 ? colours[index] : grey(0.35);
}

Range range_of_layer(const OverlayPanel::Layer& layer) {
  const Range data = range_of(layer.values);
  return drawable({layer.low.value_or(data.low), layer.high.value_or(data.high)});
}

/// The levels of a layer above the low end of its range.
std::vector<double> levels_of(const OverlayPanel::Layer& layer, int count) {
  const Range range = range_of_layer(layer);
  std::vector<double> levels = round_levels(range, std::max(count, 1));
  std::erase_if(levels, [&](double level) { return level <= range.low; });
  return levels;
}

/// The opacity of each of `count` fills that have kTotalAlpha together.
double fill_alpha(std::size_t count) {
  return 1 - std::pow(1 - kTotalAlpha, 1.0 / static_cast<double>(std::max<std::size_t>(count, 1)));
}

Colour translucent(Colour colour, double alpha) {
  colour.alpha = alpha;
  return colour;
}

Colour darkened(Colour colour) {
  return {0.75 * colour.red, 0.75 * colour.green, 0.75 * colour.blue, 1};
}

void draw_layers(Canvas& canvas, const RegionPlot& plot, const OverlayPanel& panel) {
  std::vector<LevelSets> sets;
  sets.reserve(panel.layers.size());
  for (const OverlayPanel::Layer& layer : panel.layers) sets.emplace_back(panel.grid, layer.values);
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const std::vector<double> levels = levels_of(panel.layers[i], panel.contours);
    const Colour colour = translucent(layer_colour(panel.layers[i], i), fill_alpha(levels.size()));
    for (const double level : levels)
      canvas.fill(plot.path(sets[i].superlevel_loops(level), true), colour);
  }
  for (std::size_t i = 0; i < sets.size(); ++i) {
    for (const double level : levels_of(panel.layers[i], panel.contours))
      canvas.stroke(plot.path(sets[i].contour_lines(level), false),
                    darkened(layer_colour(panel.layers[i], i)), {0.5, series_dash(0)});
  }
}

void draw_outline(Canvas& canvas, const RegionPlot& plot, const TriangleGrid& grid) {
  const LevelSets region(grid, std::vector<double>(grid.nodes.size(), 0.0));
  canvas.stroke(plot.path(region.superlevel_loops(0), true), grey(0), {0.6, {}});
}

/// "name: lines at 0.1, 0.2, …, 0.7"
std::string legend_text(const OverlayPanel::Layer& layer, int contours) {
  const Range range = range_of_layer(layer);
  const Ticks ticks = linear_ticks(range, std::max(contours, 1));
  std::vector<std::string> labels;
  for (const Ticks::Tick& tick : ticks.ticks)
    if (tick.value > range.low) labels.push_back(tick.label);
  std::string text = layer.name;
  if (labels.empty()) return text;
  text += ": " + labels.front();
  if (labels.size() > 1) text += ", " + labels[1];
  if (labels.size() > 3) text += ", …";
  if (labels.size() > 2) text += ", " + labels.back();
  if (!ticks.factor.empty()) text += " (" + ticks.factor + ")";
  return text;
}

/// A row for each layer, the first with its top at `y`; its swatch shows the nested fills.
void draw_legend(Canvas& canvas, const OverlayPanel& panel, double x, double y) {
  for (std::size_t i = 0; i < panel.layers.size(); ++i, y += kLayerRow) {
    const OverlayPanel::Layer& layer = panel.layers[i];
    const std::size_t count = levels_of(layer, panel.contours).size();
    const Colour colour = layer_colour(layer, i);
    const double top = y + (kLayerRow - kSwatchHeight) / 2;
    for (std::size_t k = 0; k < count; ++k) {
      const double skip = kSwatchWidth * static_cast<double>(k) / static_cast<double>(count);
      canvas.fill(Path::rectangle({x + skip, top, kSwatchWidth - skip, kSwatchHeight}),
                  translucent(colour, fill_alpha(count)));
    }
    canvas.stroke(Path::rectangle({x, top, kSwatchWidth, kSwatchHeight}), darkened(colour),
                  {0.5, {}});
    canvas.text({x + kSwatchWidth + 4, y + kLayerRow / 2}, legend_text(layer, panel.contours),
                {.size = kTickSize, .vertical = VerticalAlign::middle});
  }
}

double legend_width(const OverlayPanel& panel) {
  double width = 0;
  for (const OverlayPanel::Layer& layer : panel.layers)
    width = std::max(width, text_width(legend_text(layer, panel.contours), {.size = kTickSize}));
  return kSwatchWidth + 4 + width;
}

double legend_height(const OverlayPanel& panel) {
  return kLayersGap + kLayerRow * static_cast<double>(panel.layers.size());
}

}  // namespace

double OverlayPanel::height(double width) const {
  const RegionPlot plot(grid, x_label, y_label, axes);
  const double inner =
      std::max(width - plot.left_margin() - std::max(side, 1.0), 1.0) * plot.aspect();
  return title_height(title) + std::min(inner, 1.5 * width) + plot.bottom_margin() +
         legend_height(*this);
}

void OverlayPanel::draw(Canvas& canvas, const Box& box) const {
  RegionPlot plot(grid, x_label, y_label, axes);
  const double top = title_height(title), bottom = legend_height(*this);
  plot.place({box.x, box.y + top, box.width - std::max(side, 1.0), box.height - top - bottom});
  draw_layers(canvas, plot, *this);
  draw_outline(canvas, plot, grid);
  plot.draw_axes(canvas);
  const Box& inner = plot.box();
  draw_title(canvas, title, inner.x, inner.right(), inner.y - top);
  const double centred = (inner.x + inner.right() - legend_width(*this)) / 2;
  const double x = std::max(std::min(centred, box.right() - legend_width(*this)), box.x);
  draw_legend(canvas, *this, x, inner.bottom() + plot.bottom_margin() + kLayersGap);
}

}  // namespace limn::figure
