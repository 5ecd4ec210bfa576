#include "limn/report/figure/shaded_panel.h"

#include <algorithm>
#include <cmath>

#include "limn/report/figure/axes.h"
#include "limn/report/figure/colour_bar.h"
#include "limn/report/figure/scene_lines.h"
#include "limn/report/figure/shading.h"

namespace limn {
namespace {

constexpr double kOutline = 0.5;  // points; bright stripes would end nowhere without it
constexpr double kBarGap = 4, kBarWidth = 0.7;  // of the panel's width
constexpr int kTicks = 4;
constexpr double kLegendRow = 11, kSwatch = 7, kSwatchGap = 4;
constexpr TextStyle kLegend = {.size = kTickSize, .vertical = VerticalAlign::middle};

/// Pixels for a side of this many points.
int pixels(double points, double resolution) {
  return static_cast<int>(std::clamp(std::round(points * resolution / 72), 1.0, 8000.0));
}

bool has_values(const ShadedPanel& panel) {
  return panel.values && !panel.scene.surfaces.empty() &&
         panel.values->values.size() == panel.scene.surfaces.front().vertices.size();
}

ColourScale scale_of(const SurfaceValues& values) {
  const Range data = range_of(values.values);
  return colour_scale({values.low.value_or(data.low), values.high.value_or(data.high)}, data,
                      kTicks);
}

/// The surfaces that have a name.
std::vector<std::size_t> named_surfaces(const ShadedPanel& panel) {
  std::vector<std::size_t> named;
  for (std::size_t s = 0; s < std::min(panel.names.size(), panel.scene.surfaces.size()); ++s)
    if (!panel.names[s].empty()) named.push_back(s);
  return named;
}

double bar_height(const ShadedPanel& panel) {
  if (!has_values(panel)) return 0;
  return kBarGap + lying_colour_bar_height(scale_of(*panel.values), panel.values->label);
}

double legend_height(const ShadedPanel& panel) {
  return kLegendRow * static_cast<double>(named_surfaces(panel).size());
}

/// Centred below the picture, in the last points of the box.
void draw_legend(Canvas& canvas, const ShadedPanel& panel, const Box& box) {
  double width = 0;
  for (const std::size_t s : named_surfaces(panel))
    width = std::max(width, kSwatch + kSwatchGap + text_width(panel.names[s], kLegend));
  const double x = box.x + std::max(box.width - width, 0.0) / 2;
  double y = box.bottom() - legend_height(panel) + kLegendRow / 2;
  for (const std::size_t s : named_surfaces(panel)) {
    const Box swatch = {x, y - kSwatch / 2, kSwatch, kSwatch};
    canvas.fill(Path::rectangle(swatch), panel.scene.surfaces[s].colour);
    canvas.stroke(Path::rectangle(swatch), grey(0.3), {0.4, {}});
    canvas.text({x + kSwatch + kSwatchGap, y}, panel.names[s], kLegend);
    y += kLegendRow;
  }
}

/// Above the legend.
void draw_bar(Canvas& canvas, const ShadedPanel& panel, const Box& box) {
  if (!has_values(panel)) return;
  const double inset = box.width * (1 - kBarWidth) / 2;
  draw_lying_colour_bar(canvas, scale_of(*panel.values), panel.values->label, box.x + inset,
                        box.right() - inset,
                        box.bottom() - legend_height(panel) - bar_height(panel) + kBarGap);
}

/// Of each surface alone.
void draw_outlines(Canvas& canvas, const SurfaceScene& scene, const FramePlacement& place) {
  for (const SmoothSurface& surface : scene.surfaces) {
    const SurfaceScene alone = {
        .surfaces = {surface}, .azimuth = scene.azimuth, .elevation = scene.elevation};
    const Result<RayCaster> rays = RayCaster::over(seen_surfaces(alone));
    if (rays) draw_outline(canvas, alone, 0, *rays, place, kOutline);
  }
}

Shading shading_of(const ShadedPanel& panel) {
  Shading shading;
  for (const SmoothSurface& surface : panel.scene.surfaces)
    shading.colours.push_back(surface.colour);
  if (panel.stripes)
    shading.lights =
        MirroredLights(*panel.stripes, ParallelView(panel.scene.azimuth, panel.scene.elevation));
  if (has_values(panel))
    shading.first = ValueColours{panel.values->values, scale_of(*panel.values)};
  return shading;
}

}  // namespace

double ShadedPanel::height(double width) const {
  return scene_height(scene, title, width) + bar_height(*this) + legend_height(*this);
}

void ShadedPanel::draw(Canvas& canvas, const Box& box) const {
  draw_title(canvas, title, box.x, box.right(), box.y);
  const double below = bar_height(*this) + legend_height(*this);
  const FramePlacement place =
      scene_placement(scene, title, {box.x, box.y, box.width, std::max(box.height - below, 1.0)});
  const Result<RayCaster> rays = RayCaster::over(seen_surfaces(scene));
  if (!rays) return draw_scene_note(canvas, place, rays.error());
  const double density = resolution >= 1 ? std::min(resolution, 2400.0) : 1;
  canvas.image(shaded_image(*rays, place, shading_of(*this), pixels(place.box().width, density),
                            pixels(place.box().height, density)),
               place.box());
  for (std::size_t s = 0; stripes && s < scene.surfaces.size(); ++s)
    draw_outline(canvas, scene, s, *rays, place, kOutline);
  if (outlines) draw_outlines(canvas, scene, place);
  draw_scene_net(canvas, scene, *rays, place);
  draw_bar(canvas, *this, box);
  draw_legend(canvas, *this, box);
}

}  // namespace limn
