#include "limn/figure/space/shaded_panel.h"

#include <algorithm>
#include <cmath>

#include "limn/figure/chart/axes.h"
#include "limn/figure/chart/colour_bar.h"
#include "limn/figure/space/scene_lines.h"
#include "limn/figure/space/shading.h"

namespace limn::figure {
namespace {

constexpr double kOutline = 0.5;  // points; bright stripes would end nowhere without it
constexpr double kValuesGap = 4, kValuesWidth = 0.7;  // of the panel's width
constexpr int kValueTicks = 4;
constexpr double kSurfaceRow = 11, kSwatch = 7, kSwatchGap = 4;
constexpr TextStyle kLegend = {.size = kTickSize, .vertical = VerticalAlign::middle};

constexpr double kMostSidePixels = 8000;  // a side

/// An image's place on the page, and its size in pixels.
struct ImagePlace {
  Box box;
  int width, height;
};

/// Of the file's own pixels, if it has such, so that cairo copies them.
ImagePlace image_place(const Canvas& canvas, const Box& box, double resolution) {
  if (const double density = canvas.density(); density > 0) {
    const double left = std::floor(box.x * density), right = std::ceil(box.right() * density);
    const double top = std::floor(box.y * density), bottom = std::ceil(box.bottom() * density);
    if (right - left <= kMostSidePixels && bottom - top <= kMostSidePixels)
      return {{left / density, top / density, (right - left) / density, (bottom - top) / density},
              static_cast<int>(right - left),
              static_cast<int>(bottom - top)};
  }
  const double density = resolution >= 1 ? std::min(resolution, 2400.0) : 1;
  const auto pixels = [density](double points) {
    return static_cast<int>(std::clamp(std::round(points * density / 72), 1.0, kMostSidePixels));
  };
  return {box, pixels(box.width), pixels(box.height)};
}

bool has_values(const ShadedPanel& panel) {
  return panel.values && !panel.scene.surfaces.empty() &&
         panel.values->values.size() == panel.scene.surfaces.front().vertices.size();
}

ColourScale scale_of(const SurfaceValues& values) {
  const Range data = range_of(values.values);
  return colour_scale({values.low.value_or(data.low), values.high.value_or(data.high)}, data,
                      kValueTicks);
}

struct LegendRow {
  Colour colour;
  std::string name;
  const SceneMarks* marks = nullptr;  ///< drawn as these are; null: a swatch
};

/// The surfaces that have a name, and what ties look like.
std::vector<LegendRow> legend_of(const ShadedPanel& panel) {
  std::vector<LegendRow> rows;
  for (std::size_t s = 0; s < std::min(panel.names.size(), panel.scene.surfaces.size()); ++s)
    if (!panel.names[s].empty()) rows.push_back({panel.scene.surfaces[s].colour, panel.names[s]});
  if (panel.ties && !panel.ties->name.empty())
    rows.push_back({panel.ties->colour, panel.ties->name});
  for (const SceneMarks& marks : panel.scene.marks)
    if (!marks.name.empty()) rows.push_back({marks.colour, marks.name, &marks});
  return rows;
}

double bar_height(const ShadedPanel& panel) {
  if (!has_values(panel)) return 0;
  return kValuesGap + lying_colour_bar_height(scale_of(*panel.values), panel.values->label);
}

double legend_height(const ShadedPanel& panel) {
  return kSurfaceRow * static_cast<double>(legend_of(panel).size());
}

void draw_sign(Canvas& canvas, const LegendRow& row, double x, double y) {
  const Box swatch = {x, y - kSwatch / 2, kSwatch, kSwatch};
  if (row.marks == nullptr) {
    canvas.fill(Path::rectangle(swatch), row.colour);
    canvas.stroke(Path::rectangle(swatch), grey(0.3), {0.4, {}});
    return;
  }
  constexpr double reach = 4;  // to the left, so that dashes are seen
  if (row.marks->curves.empty())
    canvas.fill(Path::disk({x + kSwatch / 2, y}, dot_radius(*row.marks)), row.colour);
  else
    canvas.stroke(Path::segment({x - reach, y}, {x + kSwatch, y}), row.colour, row.marks->stroke);
}

/// Centred below the picture, in the last points of the box.
void draw_legend(Canvas& canvas, const ShadedPanel& panel, const Box& box) {
  const std::vector<LegendRow> rows = legend_of(panel);
  double width = 0;
  for (const LegendRow& row : rows)
    width = std::max(width, kSwatch + kSwatchGap + text_width(row.name, kLegend));
  const double x = box.x + std::max(box.width - width, 0.0) / 2;
  double y = box.bottom() - legend_height(panel) + kSurfaceRow / 2;
  for (const LegendRow& row : rows) {
    draw_sign(canvas, row, x, y);
    canvas.text({x + kSwatch + kSwatchGap, y}, row.name, kLegend);
    y += kSurfaceRow;
  }
}

/// Above the legend.
void draw_bar(Canvas& canvas, const ShadedPanel& panel, const Box& box) {
  if (!has_values(panel)) return;
  const double inset = box.width * (1 - kValuesWidth) / 2;
  draw_lying_colour_bar(canvas, scale_of(*panel.values), panel.values->label, box.x + inset,
                        box.right() - inset,
                        box.bottom() - legend_height(panel) - bar_height(panel) + kValuesGap);
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
  if (panel.ties) shading.tie = panel.ties->colour;
  if (panel.texture && !panel.scene.surfaces.empty()) {
    const SmoothSurface& first = panel.scene.surfaces.front();
    const TextureLook& look = *panel.texture;
    if (first.texture.size() == first.vertices.size())
      shading.texture = TextureColours{first.texture, look.squares, look.colours, look.image};
  }
  return shading;
}

bool has_lines(const ShadedPanel& panel) {
  return panel.stripes || panel.outlines || !panel.scene.net.edges.empty() ||
         !panel.scene.marks.empty() ||
         (panel.scene.net.points && !panel.scene.net.vertices.empty());
}

void draw_lines(Canvas& canvas, const ShadedPanel& panel, const RayCaster& rays,
                const FramePlacement& place) {
  for (std::size_t s = 0; panel.stripes && s < panel.scene.surfaces.size(); ++s)
    draw_outline(canvas, panel.scene, s, rays, place, kOutline);
  if (panel.outlines) draw_outlines(canvas, panel.scene, place);
  draw_scene_net(canvas, panel.scene, rays, place);
  draw_scene_marks(canvas, panel.scene, rays, place);
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
  std::vector<SeenSurface> seen = seen_surfaces(scene);
  const ImagePlace image = image_place(canvas, place.box(), resolution);
  Image pixels =
      shaded_image(seen, {place, image.box, image.width, image.height}, shading_of(*this));
  if (has_lines(*this)) {
    const Result<RayCaster> rays = RayCaster::over(std::move(seen));
    if (!rays) return draw_scene_note(canvas, place, rays.error());
    canvas.image(std::move(pixels), image.box);
    draw_lines(canvas, *this, *rays, place);
  } else {
    canvas.image(std::move(pixels), image.box);
  }
  draw_bar(canvas, *this, box);
  draw_legend(canvas, *this, box);
}

}  // namespace limn::figure
