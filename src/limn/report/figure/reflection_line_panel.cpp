#include "limn/report/figure/reflection_line_panel.h"

#include <algorithm>

#include "limn/report/figure/axes.h"
#include "limn/report/figure/scene_lines.h"
#include "limn/report/figure/surface_curves.h"

namespace limn {
namespace {

constexpr double kShift = 0.02;  // of a reflection line by interpolation, in points

}  // namespace

double ReflectionLinePanel::height(double width) const { return scene_height(scene, title, width); }

void ReflectionLinePanel::draw(Canvas& canvas, const Box& box) const {
  draw_title(canvas, title, box.x, box.right(), box.y);
  const FramePlacement place = scene_placement(scene, title, box);
  const Result<RayCaster> rays = RayCaster::over(seen_surfaces(scene));
  if (!rays) return draw_scene_note(canvas, place, rays.error());
  const MirroredLights mirror(lights, ParallelView(scene.azimuth, scene.elevation));
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    const SeenSurface& surface = rays->surfaces()[s];
    const Colour& colour = scene.surfaces[s].line_colour;
    const SeenSurface fine = refined_for_mirror(surface, kShift / place.scale());
    for (int line = 0; line < mirror.count(); ++line) {
      const DrawnCurves drawn = drawn_curves(reflection_line(fine, mirror, line), *rays, place);
      canvas.stroke(path_of(drawn.visible), colour, {line_width, {}});
    }
    if (outline) draw_outline(canvas, scene, s, *rays, place, 1.5 * line_width);
  }
  draw_scene_net(canvas, scene, *rays, place);
}

}  // namespace limn
