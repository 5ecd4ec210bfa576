#include "limn/report/figure/surface_curves.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace limn {
namespace {

constexpr int kMostCuts = 6;

/// An edge's name: its vertices, the smaller first. A vertex is named as an edge to itself.
long long name_of(int i, int j) {
  return static_cast<long long>(std::min(i, j)) << 32 | std::max(i, j);
}

/// Towards the mirrored light, of length 1.
SpaceVector mirrored(const SpaceVector& normal) {
  return normalised(MirroredLights::mirrored(normal));
}

/// The middles of edges that must be cut, as new vertices of the surface.
class Middles {
 public:
  Middles(SeenSurface& surface, double tolerance) : surface_(surface), tolerance_(tolerance) {}

  /// −1: the edge stays.
  [[nodiscard]] int of(int i, int j) {
    const auto [at, is_new] = middles_.try_emplace(name_of(i, j), -1);
    if (is_new && bends(i, j)) at->second = add(i, j);
    return at->second;
  }

 private:
  [[nodiscard]] bool bends(int i, int j) const {
    const SpaceVector &n = surface_.normals[i], &m = surface_.normals[j];
    const SpaceVector middle = normalised(sum(n, m));
    if (middle == SpaceVector{}) return false;
    const SpaceVector a = mirrored(n), b = mirrored(m);
    const double change = length(sum(b, a, -1));
    const double bend = length(sum(mirrored(middle), between(a, b, 0.5), -1));
    const SpaceVector edge = sum(surface_.vertices[j], surface_.vertices[i], -1);
    return bend * std::hypot(edge[0], edge[1]) > tolerance_ * change;
  }

  [[nodiscard]] int add(int i, int j) {
    surface_.vertices.push_back(between(surface_.vertices[i], surface_.vertices[j], 0.5));
    surface_.normals.push_back(between(surface_.normals[i], surface_.normals[j], 0.5));
    return static_cast<int>(surface_.vertices.size()) - 1;
  }

  SeenSurface& surface_;
  double tolerance_;
  std::unordered_map<long long, int> middles_;
};

/// The triangle cut at the middles of some of its edges; middle[c] is opposite to corner c.
void add_cut(std::vector<std::array<int, 3>>& result, std::array<int, 3> t, std::array<int, 3> m) {
  const auto cuts = std::count_if(m.begin(), m.end(), [](int middle) { return middle >= 0; });
  // Turned so that the one edge cut, or the one not cut, is opposite to the first corner.
  for (int turns = 0; turns < 2 && cuts % 3 != 0 && (m[0] >= 0) != (cuts == 1); ++turns) {
    std::rotate(t.begin(), t.begin() + 1, t.end());
    std::rotate(m.begin(), m.begin() + 1, m.end());
  }
  if (cuts == 0) {
    result.push_back(t);
  } else if (cuts == 1) {
    result.insert(result.end(), {{t[0], t[1], m[0]}, {t[0], m[0], t[2]}});
  } else {
    result.push_back({t[0], m[2], m[1]});
    if (cuts == 2)
      result.insert(result.end(), {{m[2], t[1], t[2]}, {m[2], t[2], m[1]}});
    else
      result.insert(result.end(), {{m[2], t[1], m[0]}, {m[1], m[0], t[2]}, {m[0], m[1], m[2]}});
  }
}

/// Where the values change their sign on the edge between two vertices.
struct Crossing {
  long long name;
  SpaceVector at;
  double along;  ///< > 0 on the light line's side of L
};

/// Values of a light line's half-plane at the corners of a triangle: r · across and r · along.
struct CornerValues {
  std::array<double, 3> across, along;
};

Crossing crossing(const SeenSurface& surface, const std::array<int, 3>& triangle,
                  const CornerValues& values, std::size_t a, std::size_t b) {
  if (triangle[a] > triangle[b]) std::swap(a, b);  // the same point from either side of the edge
  const double t = values.across[a] / (values.across[a] - values.across[b]);
  const int i = triangle[a], j = triangle[b];
  return {name_of(i, j), between(surface.vertices[i], surface.vertices[j], t),
          values.along[a] + t * (values.along[b] - values.along[a])};
}

/// Cuts off what is beyond L; `fresh` names the new end. False: nothing is left.
bool cut_at_axis(Crossing& a, Crossing& b, long long fresh) {
  if (!(a.along > 0) && !(b.along > 0)) return false;
  if (a.along > 0 && b.along > 0) return true;
  Crossing& beyond = a.along > 0 ? b : a;
  beyond.at = between(a.at, b.at, a.along / (a.along - b.along));
  beyond.name = fresh;
  return true;
}

bool towards_viewer(const SeenSurface& surface, const std::array<int, 3>& triangle) {
  const SpaceVector &a = surface.vertices[triangle[0]], &b = surface.vertices[triangle[1]],
                    &c = surface.vertices[triangle[2]];
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0;
}

}  // namespace

SeenSurface refined_for_mirror(SeenSurface surface, double tolerance) {
  for (int cut = 0; cut < kMostCuts; ++cut) {
    Middles middles(surface, tolerance);
    std::vector<std::array<int, 3>> triangles;
    triangles.reserve(surface.triangles.size());
    for (const std::array<int, 3>& t : surface.triangles)
      add_cut(triangles, t,
              {middles.of(t[1], t[2]), middles.of(t[2], t[0]), middles.of(t[0], t[1])});
    const bool done = triangles.size() == surface.triangles.size();
    surface.triangles = std::move(triangles);
    if (done) break;
  }
  return surface;
}

std::vector<SpaceCurve> reflection_line(const SeenSurface& surface, const MirroredLights& lights,
                                        int line) {
  const auto [along, across] = lights.half_plane(line);
  std::vector<SpaceSegment> segments;
  long long fresh = -1;
  for (const std::array<int, 3>& triangle : surface.triangles) {
    CornerValues values{};
    int inside = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const SpaceVector r = mirrored(surface.normals[triangle[c]]);
      values.across[c] = dot(r, across);
      values.along[c] = dot(r, along);
      inside += values.across[c] >= 0 ? 1 : 0;
    }
    if (inside % 3 == 0) continue;
    // The corner that is alone on its side.
    std::size_t apex = 0;
    while ((values.across[apex] >= 0) != (inside == 1)) ++apex;
    Crossing a = crossing(surface, triangle, values, apex, (apex + 1) % 3);
    Crossing b = crossing(surface, triangle, values, apex, (apex + 2) % 3);
    if (!cut_at_axis(a, b, fresh--)) continue;
    segments.push_back({a.name, b.name, a.at, b.at});
  }
  return joined(segments);
}

std::vector<SpaceCurve> outlines(const SeenSurface& surface) {
  struct Side {
    long long edge;
    bool towards;
  };
  std::vector<Side> sides;
  sides.reserve(3 * surface.triangles.size());
  for (const std::array<int, 3>& triangle : surface.triangles) {
    const bool towards = towards_viewer(surface, triangle);
    for (std::size_t c = 0; c < 3; ++c) {
      const int i = triangle[c], j = triangle[(c + 1) % 3];
      sides.push_back({name_of(i, j), towards});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::pair(a.edge, a.towards) < std::pair(b.edge, b.towards);
  });
  std::vector<SpaceSegment> segments;
  for (std::size_t k = 0; k < sides.size();) {
    std::size_t end = k + 1;
    while (end < sides.size() && sides[end].edge == sides[k].edge) ++end;
    if (end == k + 1 || sides[k].towards != sides[end - 1].towards) {
      const auto i = static_cast<int>(sides[k].edge >> 32);
      const auto j = static_cast<int>(sides[k].edge & 0xffffffff);
      segments.push_back({name_of(i, i), name_of(j, j), surface.vertices[i], surface.vertices[j]});
    }
    k = end;
  }
  return joined(segments);
}

}  // namespace limn
