#include "limn/figure/space/surface_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "limn/figure/chart/axes.h"

namespace limn::figure {
namespace {

constexpr double kMargin = 3;
constexpr double kLargest = 1e100;  // so that products of coordinates stay finite

}  // namespace

bool placeable(const SpaceVector& a) {
  return std::all_of(a.begin(), a.end(), [](double x) { return std::abs(x) <= kLargest; });
}

void scale_to_draw(SurfaceScene& scene) {
  constexpr double usual = 1e60;
  double largest = 0;
  const auto for_each = [&scene](const auto& use) {
    for (SmoothSurface& surface : scene.surfaces) use(surface.vertices);
    use(scene.net.vertices);
    for (SceneMarks& marks : scene.marks) {
      for (std::vector<SpaceVector>& curve : marks.curves) use(curve);
      use(marks.points);
    }
    if (scene.frame) {
      std::vector<SpaceVector> corners = {scene.frame->low, scene.frame->high};
      use(corners);
      *scene.frame = {corners[0], corners[1]};
    }
  };
  for_each([&](const std::vector<SpaceVector>& points) {
    for (const SpaceVector& point : points)
      for (const double x : point)
        if (std::isfinite(x)) largest = std::max(largest, std::abs(x));
  });
  if (largest == 0 || (1 / usual <= largest && largest <= usual)) return;
  const int shift = -std::ilogb(largest);
  for_each([&](std::vector<SpaceVector>& points) {
    for (SpaceVector& point : points)
      for (double& x : point) x = std::ldexp(x, shift);
  });
}

SeenSurface seen_surface(const SmoothSurface& surface, const ParallelView& view) {
  const std::size_t count = std::min(surface.vertices.size(), surface.normals.size());
  SeenSurface seen;
  seen.vertices.resize(count);
  seen.normals.resize(count);
  for (std::size_t v = 0; v < count; ++v) {
    if (!placeable(surface.vertices[v]) || !placeable(surface.normals[v])) continue;
    seen.vertices[v] = view.seen(surface.vertices[v]);
    seen.normals[v] = view.seen(normalised(surface.normals[v]));
  }
  const auto drawable = [&](int v) {
    return v >= 0 && static_cast<std::size_t>(v) < count && seen.normals[v] != SpaceVector{};
  };
  std::copy_if(surface.triangles.begin(), surface.triangles.end(),
               std::back_inserter(seen.triangles), [&](const std::array<int, 3>& triangle) {
                 return std::all_of(triangle.begin(), triangle.end(), drawable);
               });
  return seen;
}

std::optional<SeenBox> seen_box(const std::vector<SeenSurface>& surfaces) {
  SeenBox box;
  box.low.fill(std::numeric_limits<double>::infinity());
  box.high.fill(-box.low[0]);
  for (const SeenSurface& surface : surfaces)
    for (const std::array<int, 3>& triangle : surface.triangles)
      for (const int v : triangle)
        for (std::size_t c = 0; c < 3; ++c) {
          box.low[c] = std::min(box.low[c], surface.vertices[v][c]);
          box.high[c] = std::max(box.high[c], surface.vertices[v][c]);
        }
  if (!(box.low[0] <= box.high[0])) return std::nullopt;
  const SpaceVector sides = sum(box.high, box.low, -1);
  box.longest = *std::max_element(sides.begin(), sides.end());
  return box;
}

std::vector<SeenSurface> seen_surfaces(const SurfaceScene& scene) {
  const ParallelView view(scene.azimuth, scene.elevation);
  std::vector<SeenSurface> seen;
  seen.reserve(scene.surfaces.size());
  for (const SmoothSurface& surface : scene.surfaces) seen.push_back(seen_surface(surface, view));
  return seen;
}

ViewFrame frame_of(const SurfaceScene& scene) {
  if (scene.seen_frame) return *scene.seen_frame;
  const ParallelView view(scene.azimuth, scene.elevation);
  std::vector<SpaceVector> points;
  const auto add = [&](const SpaceVector& point) {
    if (placeable(point)) points.push_back(view.seen(point));
  };
  if (scene.frame) {
    const std::array box = {scene.frame->low, scene.frame->high};
    for (std::size_t corner = 0; corner < 8; ++corner)
      add({box[corner & 1][0], box[corner >> 1 & 1][1], box[corner >> 2][2]});
    return frame_of(points);
  }
  for (const SmoothSurface& surface : scene.surfaces)
    for (const SpaceVector& vertex : surface.vertices) add(vertex);
  for (const SpaceVector& vertex : scene.net.vertices) add(vertex);
  return frame_of(points);
}

double scene_height(const SurfaceScene& scene, const std::string& title, double width) {
  const double inner = std::max(width - 2 * kMargin, 1.0) * frame_of(scene).aspect();
  return title_height(title, 0) + std::min(inner, 1.3 * width) + 2 * kMargin;
}

FramePlacement scene_placement(const SurfaceScene& scene, const std::string& title,
                               const Box& box) {
  const double top = title_height(title, 0);
  return {frame_of(scene),
          {box.x + kMargin, box.y + top + kMargin, std::max(box.width - 2 * kMargin, 1.0),
           std::max(box.height - top - 2 * kMargin, 1.0)}};
}

}  // namespace limn::figure
