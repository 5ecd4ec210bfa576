#include "limn/figure/chart/surface_panel.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "limn/figure/canvas/parallel_view.h"
#include "limn/figure/chart/axes.h"

namespace limn::figure {
namespace {

using Vector = SpaceVector;

constexpr double kSurfaceMargin = 3;

/// The points in the viewer's coordinates, heights stretched.
std::vector<Vector> all_seen(const SurfacePanel& panel, const std::vector<Vector>& points) {
  const ParallelView view(panel.azimuth, panel.elevation);
  std::vector<Vector> result;
  result.reserve(points.size());
  for (const Vector& point : points)
    result.push_back(view.seen({point[0], point[1], panel.z_scale * point[2]}));
  return result;
}

ViewFrame frame(const SurfacePanel& panel) {
  std::vector<Vector> seen = all_seen(panel, panel.vertices);
  const std::vector<Vector> net = all_seen(panel, panel.net_vertices);
  seen.insert(seen.end(), net.begin(), net.end());
  return frame_of(seen);
}

/// Newell's normal of the polygon, of length 1, or 0 if the polygon has no area.
Vector normal_of(const std::vector<int>& face, const std::vector<Vector>& points) {
  Vector normal{};
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Vector &p = points[face[i]], &q = points[face[(i + 1) % face.size()]];
    for (std::size_t c = 0; c < 3; ++c)
      normal[c] += (p[(c + 1) % 3] - q[(c + 1) % 3]) * (p[(c + 2) % 3] + q[(c + 2) % 3]);
  }
  return normalised(normal);
}

/// Lit from the left above the viewer; both sides alike. In the viewer's coordinates.
double lightness(Vector normal) {
  if (normal[2] < 0)
    for (double& coordinate : normal) coordinate = -coordinate;
  return 0.56 + 0.40 * std::max(0.0, dot(normal, kLightFrom));
}

struct Patch {
  std::size_t face;
  double depth;
};

/// The faces that can be drawn, the farthest first.
std::vector<Patch> painters_order(const SurfacePanel& panel, const std::vector<Vector>& seen) {
  std::vector<Patch> patches;
  for (std::size_t f = 0; f < panel.faces.size(); ++f) {
    const std::vector<int>& face = panel.faces[f];
    double depth = 0;
    for (const int v : face)
      depth += finite(seen[v]) ? seen[v][2] : std::numeric_limits<double>::quiet_NaN();
    if (face.size() >= 3 && std::isfinite(depth))
      patches.push_back({f, depth / static_cast<double>(face.size())});
  }
  std::stable_sort(patches.begin(), patches.end(),
                   [](const Patch& a, const Patch& b) { return a.depth < b.depth; });
  return patches;
}

void draw_surface(Canvas& canvas, const SurfacePanel& panel, const FramePlacement& place) {
  const std::vector<Vector> seen = all_seen(panel, panel.vertices);
  for (const Patch& patch : painters_order(panel, seen)) {
    const std::vector<int>& face = panel.faces[patch.face];
    std::vector<PagePoint> corners;
    corners.reserve(face.size());
    for (const int v : face) corners.push_back(place.page(seen[v]));
    const Path path = Path().polyline(corners, true);
    const Colour colour = grey(lightness(normal_of(face, seen)));
    canvas.fill(path, colour);
    canvas.stroke(path, panel.mesh_lines ? grey(0.35) : colour, {0.25, {}});
  }
}

void draw_net(Canvas& canvas, const SurfacePanel& panel, const FramePlacement& place) {
  const std::vector<Vector> seen = all_seen(panel, panel.net_vertices);
  for (const auto& [i, j] : panel.net_edges)
    if (finite(seen[i]) && finite(seen[j]))
      canvas.stroke(Path::segment(place.page(seen[i]), place.page(seen[j])), grey(0), {0.6, {}});
  for (const Vector& vertex : seen)
    if (panel.net_points && finite(vertex))
      canvas.fill(Path::disk(place.page(vertex), 1.5), grey(0));
}

}  // namespace

double SurfacePanel::height(double width) const {
  const double inner = std::max(width - 2 * kSurfaceMargin, 1.0) * frame(*this).aspect();
  return title_height(title, 0) + std::min(inner, 1.3 * width) + 2 * kSurfaceMargin;
}

void SurfacePanel::draw(Canvas& canvas, const Box& box) const {
  const double top = title_height(title, 0);
  const FramePlacement place(frame(*this), {box.x + kSurfaceMargin, box.y + top + kSurfaceMargin,
                                            std::max(box.width - 2 * kSurfaceMargin, 1.0),
                                            std::max(box.height - top - 2 * kSurfaceMargin, 1.0)});
  draw_title(canvas, title, box.x, box.right(), box.y);
  draw_surface(canvas, *this, place);
  draw_net(canvas, *this, place);
}

SurfacePanel height_field(const TriangleGrid& grid, const std::vector<double>& z) {
  SurfacePanel panel;
  for (std::size_t i = 0; i < grid.nodes.size(); ++i)
    panel.vertices.push_back({grid.nodes[i][0], grid.nodes[i][1], z[i]});
  for (const std::array<int, 3>& triangle : grid.triangles)
    panel.faces.emplace_back(triangle.begin(), triangle.end());
  return panel;
}

}  // namespace limn::figure
