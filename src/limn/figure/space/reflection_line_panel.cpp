#include "limn/figure/space/reflection_line_panel.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "limn/base/parallel.h"
#include "limn/figure/chart/axes.h"
#include "limn/figure/space/scene_lines.h"
#include "limn/figure/space/surface_curves.h"

namespace limn::figure {
namespace {

constexpr double kShift = 0.02;  // of a reflection line by interpolation, in points
constexpr double kApart = 1;     // points between lines, at least

std::vector<DrawnCurves> drawn_lines(const std::vector<std::vector<SpaceCurve>>& lines,
                                     const RayCaster& rays, const FramePlacement& place) {
  std::vector<DrawnCurves> drawn(lines.size());
  base::parallel_for(
      std::size_t{0}, lines.size(),
      [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) drawn[i] = drawn_curves(lines[i], rays, place);
      },
      1);
  return drawn;
}

}  // namespace

Status check_lights(const SurfaceScene& scene, const LightLines& lights, double width) {
  const FramePlacement place =
      scene_placement(scene, "", {0, 0, width, scene_height(scene, "", width)});
  const MirroredLights mirror(lights, ParallelView(scene.azimuth, scene.elevation));
  double most = mirror.count();
  for (const SeenSurface& surface : seen_surfaces(scene)) {
    const double length = approx_line_length(surface, mirror);
    if (length > 0)
      most =
          std::min(most, mirror.count() * seen_area(surface) * place.scale() / (kApart * length));
  }
  most = std::max(std::floor(most), 1.0);
  if (most >= mirror.count()) return Done{};
  Error error;
  error.message = fmt::format(
      "{} light lines are too many: on a picture {:.0f} points wide their mirror images would be "
      "less than {:g} point apart",
      mirror.count(), width, kApart);
  error.hint = fmt::format("this surface shows at most {}", most);
  return error;
}

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
    for (const DrawnCurves& drawn : drawn_lines(reflection_lines(fine, mirror), *rays, place))
      canvas.stroke(path_of(drawn.visible), colour, {line_width, {}});
    if (outline) draw_outline(canvas, scene, s, *rays, place, 1.5 * line_width);
  }
  draw_scene_net(canvas, scene, *rays, place);
  draw_scene_marks(canvas, scene, *rays, place);
}

}  // namespace limn::figure
