#include "limn/report/figure/surface_panel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "limn/report/figure/axes.h"

namespace limn {
namespace {

using Vector = std::array<double, 3>;

constexpr double kMargin = 3;

double title_height(const std::string& title) { return title.empty() ? 0 : kTitleHeight; }

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

bool finite(const Vector& a) {
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

/// Coordinates of the viewer: right, up and towards the eye.
struct View {
  Vector right, up, near;
  double z_scale;

  explicit View(const SurfacePanel& panel) : z_scale(panel.z_scale) {
    const double a = panel.azimuth * std::numbers::pi / 180;
    const double e = panel.elevation * std::numbers::pi / 180;
    right = {-std::sin(a), std::cos(a), 0};
    near = {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
    up = {-std::sin(e) * std::cos(a), -std::sin(e) * std::sin(a), std::cos(e)};
  }

  [[nodiscard]] Vector seen(const Vector& at) const {
    const Vector stretched = {at[0], at[1], z_scale * at[2]};
    return {dot(stretched, right), dot(stretched, up), dot(stretched, near)};
  }
};

std::vector<Vector> all_seen(const View& view, const std::vector<Vector>& points) {
  std::vector<Vector> result;
  result.reserve(points.size());
  for (const Vector& point : points) result.push_back(view.seen(point));
  return result;
}

/// A rectangle of the viewer's plane.
struct Extent {
  Range x, y;
};

/// Of all finite vertices; at least a little in each direction.
Extent extent(const SurfacePanel& panel) {
  const View view(panel);
  std::vector<double> xs, ys;
  for (const auto* points : {&panel.vertices, &panel.net_vertices}) {
    for (const Vector& point : *points) {
      if (!finite(point)) continue;
      const Vector seen = view.seen(point);
      xs.push_back(seen[0]);
      ys.push_back(seen[1]);
    }
  }
  Extent result{drawable(range_of(xs)), drawable(range_of(ys))};
  const double size = std::max(result.x.high - result.x.low, result.y.high - result.y.low);
  for (Range* range : {&result.x, &result.y})
    if (range->high - range->low < 1e-3 * size) range->low -= size / 2, range->high += size / 2;
  return result;
}

double aspect(const Extent& extent) {
  return (extent.y.high - extent.y.low) / (extent.x.high - extent.x.low);
}

/// Newell's normal of the polygon, of length 1, or 0 if the polygon has no area.
Vector normal_of(const std::vector<int>& face, const std::vector<Vector>& points) {
  Vector normal{};
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Vector &p = points[face[i]], &q = points[face[(i + 1) % face.size()]];
    for (std::size_t c = 0; c < 3; ++c)
      normal[c] += (p[(c + 1) % 3] - q[(c + 1) % 3]) * (p[(c + 2) % 3] + q[(c + 2) % 3]);
  }
  const double length = std::sqrt(dot(normal, normal));
  if (!(length > 0)) return {};
  for (double& coordinate : normal) coordinate /= length;
  return normal;
}

/// Lit from the left above the viewer; both sides alike. In the viewer's coordinates.
double lightness(Vector normal) {
  constexpr Vector light = {-0.45, 0.62, 0.643};
  if (normal[2] < 0)
    for (double& coordinate : normal) coordinate = -coordinate;
  return 0.56 + 0.40 * std::max(0.0, dot(normal, light));
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

/// From the viewer's plane to the page, in the middle of the box.
struct Placement {
  Extent extent;
  double scale, x, y;

  Placement(const Extent& of, const Box& box) : extent(of) {
    const double width = of.x.high - of.x.low, height = of.y.high - of.y.low;
    scale = std::min(box.width / width, box.height / height);
    x = box.x + (box.width - scale * width) / 2;
    y = box.bottom() - (box.height - scale * height) / 2;
  }
  [[nodiscard]] PagePoint operator()(const Vector& seen) const {
    return {x + scale * (seen[0] - extent.x.low), y - scale * (seen[1] - extent.y.low)};
  }
};

void draw_surface(Canvas& canvas, const SurfacePanel& panel, const Placement& place) {
  const std::vector<Vector> seen = all_seen(View(panel), panel.vertices);
  for (const Patch& patch : painters_order(panel, seen)) {
    const std::vector<int>& face = panel.faces[patch.face];
    std::vector<PagePoint> corners;
    corners.reserve(face.size());
    for (const int v : face) corners.push_back(place(seen[v]));
    const Path path = Path().polyline(corners, true);
    const Colour colour = grey(lightness(normal_of(face, seen)));
    canvas.fill(path, colour);
    canvas.stroke(path, panel.mesh_lines ? grey(0.35) : colour, {0.25, {}});
  }
}

void draw_net(Canvas& canvas, const SurfacePanel& panel, const Placement& place) {
  const std::vector<Vector> seen = all_seen(View(panel), panel.net_vertices);
  for (const auto& [i, j] : panel.net_edges)
    if (finite(seen[i]) && finite(seen[j]))
      canvas.stroke(Path::segment(place(seen[i]), place(seen[j])), grey(0), {0.6, {}});
  for (const Vector& vertex : seen)
    if (panel.net_points && finite(vertex)) canvas.fill(Path::disk(place(vertex), 1.5), grey(0));
}

}  // namespace

double SurfacePanel::height(double width) const {
  const double inner = std::max(width - 2 * kMargin, 1.0) * aspect(extent(*this));
  return title_height(title) + std::min(inner, 1.3 * width) + 2 * kMargin;
}

void SurfacePanel::draw(Canvas& canvas, const Box& box) const {
  const double top = title_height(title);
  const Placement place(extent(*this), {box.x + kMargin, box.y + top + kMargin,
                                        std::max(box.width - 2 * kMargin, 1.0),
                                        std::max(box.height - top - 2 * kMargin, 1.0)});
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

}  // namespace limn
