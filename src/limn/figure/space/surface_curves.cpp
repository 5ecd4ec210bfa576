#include "limn/figure/space/surface_curves.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "limn/base/parallel.h"

namespace limn::figure {
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

/// The pieces of light lines in a surface's triangles. What belongs to a vertex is found once.
class MirrorPieces {
 public:
  MirrorPieces(const SeenSurface& surface, const MirroredLights& lights)
      : surface_(surface), count_(lights.count()) {
    mirrored_.reserve(surface.normals.size());
    turns_.reserve(surface.normals.size());
    for (const SpaceVector& normal : surface.normals) {
      mirrored_.push_back(mirrored(normal));
      turns_.push_back(lights.turn(mirrored_.back()));
    }
  }

  /// By how many lines the second and the third corner are beyond the first, the short way round.
  [[nodiscard]] std::array<double, 2> turns(const std::array<int, 3>& triangle) const {
    const double first = turns_[triangle[0]];
    return {std::remainder(turns_[triangle[1]] - first, count_),
            std::remainder(turns_[triangle[2]] - first, count_)};
  }

  /// All lines that may have a piece in the triangle: [first, second), modulo their number.
  [[nodiscard]] std::array<long, 2> lines(const std::array<int, 3>& triangle) const {
    const auto [second, third] = turns(triangle);
    const auto [low, high] = std::minmax({0.0, second, third});
    if (high - low > kAlmost * count_ / 2) return {0, count_};  // L may go through it
    const double first = turns_[triangle[0]];
    return {std::lround(std::ceil(first + low - kSlack)),
            std::lround(std::floor(first + high + kSlack)) + 1};
  }

  void add(const std::array<int, 3>& triangle, const MirroredLights::HalfPlane& half_plane,
           std::vector<SpaceSegment>& segments) const {
    CornerValues values{};
    int inside = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const SpaceVector& r = mirrored_[triangle[c]];
      values.across[c] = dot(r, half_plane.across);
      values.along[c] = dot(r, half_plane.along);
      inside += values.across[c] >= 0 ? 1 : 0;
    }
    if (inside % 3 == 0) return;
    // The corner that is alone on its side.
    std::size_t apex = 0;
    while ((values.across[apex] >= 0) != (inside == 1)) ++apex;
    Crossing a = crossing(surface_, triangle, values, apex, (apex + 1) % 3);
    Crossing b = crossing(surface_, triangle, values, apex, (apex + 2) % 3);
    const auto fresh = -1 - static_cast<long long>(segments.size());
    if (cut_at_axis(a, b, fresh)) segments.push_back({a.name, b.name, a.at, b.at});
  }

 private:
  static constexpr double kAlmost = 0.999, kSlack = 1e-6;

  const SeenSurface& surface_;
  int count_;
  std::vector<SpaceVector> mirrored_;
  std::vector<double> turns_;
};

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
  const MirrorPieces pieces(surface, lights);
  std::vector<SpaceSegment> segments;
  for (const std::array<int, 3>& triangle : surface.triangles)
    pieces.add(triangle, lights.half_plane(line), segments);
  return joined(segments);
}

std::vector<std::vector<SpaceCurve>> reflection_lines(const SeenSurface& surface,
                                                      const MirroredLights& lights) {
  const MirrorPieces pieces(surface, lights);
  const auto count = static_cast<std::size_t>(lights.count());
  std::vector<MirroredLights::HalfPlane> half_planes;
  half_planes.reserve(count);
  for (int line = 0; line < lights.count(); ++line) half_planes.push_back(lights.half_plane(line));
  std::vector<std::vector<SpaceSegment>> segments(count);
  for (const std::array<int, 3>& triangle : surface.triangles) {
    const auto [first, end] = pieces.lines(triangle);
    for (long line = first; line < end; ++line) {
      const auto k =
          static_cast<std::size_t>((line % lights.count() + lights.count()) % lights.count());
      pieces.add(triangle, half_planes[k], segments[k]);
    }
  }
  std::vector<std::vector<SpaceCurve>> curves(count);
  base::parallel_for(
      std::size_t{0}, count,
      [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) curves[k] = joined(segments[k]);
      },
      8);
  return curves;
}

double approx_line_length(const SeenSurface& surface, const MirroredLights& lights) {
  const MirrorPieces pieces(surface, lights);
  double total = 0;
  for (const std::array<int, 3>& triangle : surface.triangles) {
    // the area times the length of the gradient of how many lines one has passed
    const auto [second, third] = pieces.turns(triangle);
    const SpaceVector& corner = surface.vertices[triangle[0]];
    const SpaceVector one = sum(surface.vertices[triangle[1]], corner, -1),
                      other = sum(surface.vertices[triangle[2]], corner, -1);
    total += std::hypot(second * other[0] - third * one[0], second * other[1] - third * one[1]) / 2;
  }
  return total;
}

double seen_area(const SeenSurface& surface) {
  double total = 0;
  for (const std::array<int, 3>& triangle : surface.triangles) {
    const SpaceVector& corner = surface.vertices[triangle[0]];
    total += std::abs(cross(sum(surface.vertices[triangle[1]], corner, -1),
                            sum(surface.vertices[triangle[2]], corner, -1))[2]) /
             2;
  }
  return total;
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

}  // namespace limn::figure
