#include "limn/figure/chart/chart_panel.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "limn/figure/canvas/colour_map.h"
#include "limn/figure/chart/axes.h"
#include "limn/figure/chart/label_places.h"

namespace limn::figure {
namespace {

constexpr double kRightMargin = 8;  // half of a number at the end of the x axis
constexpr double kLegendRow = 10.5, kLegendGap = 10, kSampleWidth = 16, kSampleGap = 3;
constexpr double kMarker = 1.4;        // radius of the first
constexpr double kMarkerGrowth = 0.9;  // from one to the next
constexpr double kMarkerLine = 0.7;
constexpr int kMarkers = 5;
constexpr double kLegendSize = 7.5;
constexpr double kPointLabelSize = 6.5;
constexpr double kPadding = 0.04;  // of a linear axis, beyond the data

int style_of(const ChartPanel& panel, std::size_t index) {
  return std::max(0, panel.series[index].style.value_or(static_cast<int>(index)));
}

/// The range of the coordinate of all points that can be shown, or what the caller wants.
Range axis_range(const ChartPanel& panel, bool vertical) {
  const bool logarithmic = vertical ? panel.log_y : panel.log_x;
  std::vector<double> shown;
  for (const ChartPanel::Series& series : panel.series)
    for (const double value : vertical ? series.y : series.x)
      if (!logarithmic || value > 0) shown.push_back(value);
  Range range = range_of(shown);
  const std::optional<double>& low = vertical ? panel.y_low : panel.x_low;
  const std::optional<double>& high = vertical ? panel.y_high : panel.x_high;
  if (!logarithmic) range = drawable(range);
  const bool scattered = std::any_of(panel.series.begin(), panel.series.end(),
                                     [](const ChartPanel::Series& one) { return !one.line; });
  if ((vertical || scattered) && !logarithmic) {
    const double padding = kPadding * (range.high - range.low);
    range = {range.low - padding, range.high + padding};
  }
  if (vertical && logarithmic && range.low > 0) range = {range.low / 1.3, range.high * 1.3};
  return {low.value_or(range.low), high.value_or(range.high)};
}

/// Whether all x are whole and not all one.
bool counts_along_x(const ChartPanel& panel) {
  std::vector<double> all;
  for (const ChartPanel::Series& series : panel.series)
    all.insert(all.end(), series.x.begin(), series.x.end());
  const Range range = range_of(all);
  return range.high > range.low && range.high < 1e9 && range.low > -1e9 &&
         std::all_of(all.begin(), all.end(),
                     [](double x) { return !std::isfinite(x) || x == std::round(x); });
}

Axis axis(const ChartPanel& panel, bool vertical) {
  const bool logarithmic = vertical ? panel.log_y : panel.log_x;
  const Axis::Kind kind = logarithmic                          ? Axis::Kind::logarithmic
                          : !vertical && counts_along_x(panel) ? Axis::Kind::whole
                                                               : Axis::Kind::linear;
  return {axis_range(panel, vertical), vertical ? panel.y_label : panel.x_label, 5, kind};
}

/// Dot, ring, square, triangle, diamond: each goes round the one before.
void draw_marker(Canvas& canvas, PagePoint at, int style) {
  const int kind = style % kMarkers;
  const double r = kMarker + kMarkerGrowth * kind;
  const Colour colour = series_colour(style);
  if (kind == 0) return canvas.fill(Path::disk(at, r), colour);
  if (kind == 1) return canvas.stroke(Path::disk(at, r), colour, {kMarkerLine, {}});
  std::vector<PagePoint> corners;
  const auto corner = [&](double x, double y) { corners.push_back({at[0] + x, at[1] - y}); };
  if (kind == 2) {
    for (const auto& [x, y] : {PagePoint{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      corner(0.8 * r * x, 0.8 * r * y);
  } else if (kind == 3) {
    for (const auto& [x, y] : {PagePoint{-1.1, -0.65}, {1.1, -0.65}, {0, 1.25}})
      corner(r * x, r * y);
  } else {
    for (const auto& [x, y] : {PagePoint{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) corner(r * x, r * y);
  }
  canvas.stroke(Path().polyline(corners, true), colour, {kMarkerLine, {}});
}

/// The named series and their places: columns of equal width, as many as fit into `width`.
struct Legend {
  std::vector<std::size_t> series;
  std::size_t columns = 1;
  double entry = 0;  ///< width of the widest

  [[nodiscard]] double width() const {
    return static_cast<double>(columns) * (entry + kLegendGap) - kLegendGap;
  }
  [[nodiscard]] double height() const {
    const std::size_t rows = (series.size() + columns - 1) / columns;
    return rows == 0 ? 0 : kLegendRow * static_cast<double>(rows) + 3;
  }
};

Legend legend_of(const ChartPanel& panel, double width) {
  Legend legend;
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    const std::string& name = panel.series[i].name;
    if (name.empty()) continue;
    legend.series.push_back(i);
    const double entry = kSampleWidth + kSampleGap + text_width(name, {.size = kLegendSize});
    legend.entry = std::max(legend.entry, entry);
  }
  const double fit = std::floor((width + kLegendGap) / (legend.entry + kLegendGap));
  const auto most = static_cast<double>(std::max<std::size_t>(legend.series.size(), 1));
  legend.columns = static_cast<std::size_t>(std::clamp(fit, 1.0, most));
  return legend;
}

Stroke line_stroke(int style) { return {0.9, series_dash(style)}; }

void draw_legend(Canvas& canvas, const ChartPanel& panel, const Legend& legend, double left,
                 double top) {
  for (std::size_t k = 0; k < legend.series.size(); ++k) {
    const ChartPanel::Series& series = panel.series[legend.series[k]];
    const int style = style_of(panel, legend.series[k]);
    const double x = left + static_cast<double>(k % legend.columns) * (legend.entry + kLegendGap);
    const auto row = static_cast<double>(k / legend.columns);  // NOLINT(bugprone-integer-division)
    const double y = top + (row + 0.5) * kLegendRow;
    if (series.line)
      canvas.stroke(Path::segment({x, y}, {x + kSampleWidth, y}), series_colour(style),
                    line_stroke(style));
    if (series.markers) draw_marker(canvas, {x + kSampleWidth / 2, y}, style);
    canvas.text({x + kSampleWidth + kSampleGap, y}, series.name,
                {.size = kLegendSize, .vertical = VerticalAlign::middle});
  }
}

/// The plot's axes and where they lie on the page.
struct Plot {
  Axis x, y;
  Box box;

  /// Where a point is shown; nothing for one that the axes cannot show.
  [[nodiscard]] std::optional<PagePoint> at(double px, double py) const {
    const double fx = x.fraction(px), fy = y.fraction(py);
    if (!std::isfinite(fx) || !std::isfinite(fy)) return std::nullopt;
    // Far outside the plot, a point need not be exact.
    const auto shown = [](double fraction) { return std::clamp(fraction, -1e3, 1e3); };
    return PagePoint{box.x + shown(fx) * box.width, box.bottom() - shown(fy) * box.height};
  }
};

void draw_series(Canvas& canvas, const ChartPanel::Series& series, int style, const Plot& plot) {
  std::vector<PagePoint> run;
  const auto flush = [&] {
    if (series.line) canvas.stroke(Path().polyline(run), series_colour(style), line_stroke(style));
    run.clear();
  };
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    const std::optional<PagePoint> at = plot.at(series.x[i], series.y[i]);
    if (!at) {
      flush();
      continue;
    }
    run.push_back(*at);
    if (series.markers) draw_marker(canvas, run.back(), style);
  }
  flush();
}

/// The labels of all series, each near its point and off all points and lines.
void draw_point_labels(Canvas& canvas, const ChartPanel& panel, const Plot& plot) {
  LabelSurroundings around{.within = plot.box};
  std::vector<LabelWish> wishes;
  std::vector<std::pair<std::string, Colour>> texts;
  for (std::size_t s = 0; s < panel.series.size(); ++s) {
    const ChartPanel::Series& series = panel.series[s];
    std::optional<PagePoint> before;
    for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
      const std::optional<PagePoint> at = plot.at(series.x[i], series.y[i]);
      if (at) around.dots.push_back({*at, kMarker + kMarkers * kMarkerGrowth});
      if (at && before && series.line) around.lines.push_back({*before, *at});
      before = at;
      if (!at || i >= series.labels.size() || series.labels[i].empty()) continue;
      const double width = text_width(series.labels[i], {.size = kPointLabelSize});
      wishes.push_back({*at, width, kPointLabelSize});
      texts.emplace_back(series.labels[i], series_colour(style_of(panel, s)));
    }
  }
  const std::vector<PagePoint> middles = label_places(wishes, around);
  for (std::size_t i = 0; i < middles.size(); ++i)
    canvas.text(middles[i], texts[i].first,
                {.size = kPointLabelSize,
                 .align = Align::centre,
                 .vertical = VerticalAlign::middle,
                 .colour = texts[i].second});
}

void draw_grid(Canvas& canvas, const Axis& y_axis, const Box& plot) {
  for (const Ticks::Tick& tick : y_axis.ticks_within(plot.height, true).ticks) {
    const double y = plot.bottom() - y_axis.fraction(tick.value) * plot.height;
    canvas.stroke(Path::segment({plot.x, y}, {plot.right(), y}), grey(0.88), {0.4, {}});
  }
}

}  // namespace

double ChartPanel::height(double width) const {
  const double plot = std::max(width - axis(*this, true).width_as_y() - kRightMargin, 1.0);
  return title_height(title) + legend_of(*this, width).height() + plot * aspect +
         axis(*this, false).height_as_x();
}

void ChartPanel::draw(Canvas& canvas, const Box& box) const {
  const Legend legend = legend_of(*this, box.width);
  Plot plot{axis(*this, false), axis(*this, true), {}};
  Box& inside = plot.box;
  inside.x = box.x + plot.y.width_as_y();
  inside.width = std::max(box.right() - kRightMargin - inside.x, 1.0);
  inside.y = box.y + title_height(title) + legend.height();
  inside.height = std::max(box.bottom() - plot.x.height_as_x() - inside.y, 1.0);
  draw_title(canvas, title, inside.x, inside.right(), box.y);
  const double centred = inside.x + (inside.width - legend.width()) / 2;
  const double left = std::clamp(centred, box.x, std::max(box.x, box.right() - legend.width()));
  draw_legend(canvas, *this, legend, left, box.y + title_height(title));
  draw_grid(canvas, plot.y, inside);
  // Markers at the border stay whole.
  constexpr double kOver = kMarker + kMarkers * kMarkerGrowth;
  canvas.begin_clip(Path::rectangle(
      {inside.x - kOver, inside.y - kOver, inside.width + 2 * kOver, inside.height + 2 * kOver}));
  for (std::size_t i = 0; i < series.size(); ++i)
    draw_series(canvas, series[i], style_of(*this, i), plot);
  canvas.end_clip();
  draw_point_labels(canvas, *this, plot);
  plot.x.draw_as_x(canvas, inside.x, inside.right(), inside.bottom());
  plot.y.draw_as_y(canvas, inside.x, inside.bottom(), inside.y);
}

}  // namespace limn::figure
