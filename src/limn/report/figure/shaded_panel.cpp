#include "limn/report/figure/shaded_panel.h"

#include <algorithm>
#include <cmath>

#include "limn/report/figure/axes.h"
#include "limn/report/figure/scene_lines.h"
#include "limn/report/figure/shading.h"

namespace limn {
namespace {

constexpr double kOutline = 0.5;  // points; bright stripes would end nowhere without it

/// Pixels for a side of this many points.
int pixels(double points, double resolution) {
  return static_cast<int>(std::clamp(std::round(points * resolution / 72), 1.0, 8000.0));
}

}  // namespace

double ShadedPanel::height(double width) const { return scene_height(scene, title, width); }

void ShadedPanel::draw(Canvas& canvas, const Box& box) const {
  draw_title(canvas, title, box.x, box.right(), box.y);
  const FramePlacement place = scene_placement(scene, title, box);
  const Result<RayCaster> rays = RayCaster::over(seen_surfaces(scene));
  if (!rays) return draw_scene_note(canvas, place, rays.error());
  Shading shading;
  for (const SmoothSurface& surface : scene.surfaces) shading.colours.push_back(surface.colour);
  if (stripes)
    shading.lights = MirroredLights(*stripes, ParallelView(scene.azimuth, scene.elevation));
  const double density = resolution >= 1 ? std::min(resolution, 2400.0) : 1;
  canvas.image(shaded_image(*rays, place, shading, pixels(place.box().width, density),
                            pixels(place.box().height, density)),
               place.box());
  for (std::size_t s = 0; stripes && s < scene.surfaces.size(); ++s)
    draw_outline(canvas, scene, s, *rays, place, kOutline);
  draw_scene_net(canvas, scene, *rays, place);
}

}  // namespace limn
