#include "limn/figure/space/scene_lines.h"

#include <algorithm>

#include "limn/figure/chart/axes.h"
#include "limn/figure/figure.h"
#include "limn/figure/space/surface_curves.h"

namespace limn::figure {
namespace {

constexpr Colour kSeen = {0.10, 0.12, 0.16}, kHidden = {0.10, 0.12, 0.16, 0.4};
constexpr double kDot = 1.4;
// An outline runs along edges and so not quite where the surface turns away.
constexpr double kOutlineDepth = 1e-3;
// Marks lie on the surfaces.
constexpr double kMarkDepth = 1e-4;
const Stroke kSeenStroke = {0.7, {}};
const Stroke kHiddenStroke = {0.45, {1.4, 1.8}};

}  // namespace

Path path_of(const std::vector<Polyline>& lines) {
  Path path;
  for (const Polyline& line : lines) path.polyline(line);
  return path;
}

void draw_outline(Canvas& canvas, const SurfaceScene& scene, std::size_t index,
                  const RayCaster& rays, const FramePlacement& place, double width) {
  const DrawnCurves drawn =
      drawn_curves(outlines(rays.surfaces()[index]), rays, place, kOutlineDepth);
  canvas.stroke(path_of(drawn.visible), scene.surfaces[index].line_colour, {width, {}});
}

void draw_scene_net(Canvas& canvas, const SurfaceScene& scene, const RayCaster& rays,
                    const FramePlacement& place) {
  const ParallelView view(scene.azimuth, scene.elevation);
  std::vector<SpaceVector> seen;
  seen.reserve(scene.net.vertices.size());
  for (const SpaceVector& vertex : scene.net.vertices) seen.push_back(view.seen(vertex));
  const auto drawable = [&](int v) {
    return v >= 0 && static_cast<std::size_t>(v) < seen.size() && placeable(seen[v]);
  };
  std::vector<SpaceCurve> edges;
  for (const auto& [i, j] : scene.net.edges)
    if (drawable(i) && drawable(j)) edges.push_back({seen[i], seen[j]});
  const DrawnCurves drawn = drawn_curves(edges, rays, place);
  canvas.stroke(path_of(drawn.hidden), kHidden, kHiddenStroke);
  canvas.stroke(path_of(drawn.visible), kSeen, kSeenStroke);
  for (const SpaceVector& vertex : seen)
    if (scene.net.points && placeable(vertex))
      canvas.fill(Path::disk(place.page(vertex), kDot), rays.hides(vertex) ? kHidden : kSeen);
}

double dot_radius(const SceneMarks& marks) { return 1 + marks.stroke.width; }

void draw_scene_marks(Canvas& canvas, const SurfaceScene& scene, const RayCaster& rays,
                      const FramePlacement& place) {
  const ParallelView view(scene.azimuth, scene.elevation);
  for (const SceneMarks& marks : scene.marks) {
    std::vector<SpaceCurve> curves;
    for (const std::vector<SpaceVector>& curve : marks.curves) {
      if (!std::all_of(curve.begin(), curve.end(), placeable)) continue;
      SpaceCurve& seen = curves.emplace_back();
      for (const SpaceVector& point : curve) seen.push_back(view.seen(point));
    }
    canvas.stroke(path_of(drawn_curves(curves, rays, place, kMarkDepth).visible), marks.colour,
                  marks.stroke);
    for (const SpaceVector& point : marks.points)
      if (placeable(point) && !rays.hides(view.seen(point), kMarkDepth))
        canvas.fill(Path::disk(place.page(view.seen(point)), dot_radius(marks)), marks.colour);
  }
}

void draw_scene_note(Canvas& canvas, const FramePlacement& place, const Error& error) {
  const Box& box = place.box();
  canvas.stroke(Path::rectangle(box), grey(0.7));
  const TextStyle style = {.size = kLabelSize, .align = Align::centre};
  double y = box.y + box.height / 2;
  for (const std::string& line : broken_lines(error.text(), 0.9 * box.width, style)) {
    canvas.text({box.x + box.width / 2, y}, line, style);
    y += 1.3 * kLabelSize;
  }
}

}  // namespace limn::figure
