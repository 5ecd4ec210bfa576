#include "limn/mesh/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>
#include <unsupported/Eigen/BVH>

#include "limn/base/parallel.h"
#include "limn/mesh/polygon/triangulate.h"

namespace limn::mesh {
namespace {

constexpr Index kGrain = 256;  // a query takes microseconds
constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

using Triangle = std::array<Point3, 3>;
using AlignedBox = Eigen::AlignedBox3d;

Eigen::Vector3d vector_of(const Point3& p) { return {p.x, p.y, p.z}; }

double length(const Point3& a) { return std::hypot(a.x, a.y, a.z); }

Point3 nearest_on_segment(const Point3& from, const Point3& to, const Point3& p) {
  const Point3 way = to - from;
  const double square = dot(way, way);
  if (!(square > 0)) return from;
  return from + std::clamp(dot(p - from, way) / square, 0.0, 1.0) * way;
}

/// Right for triangles without an area too.
Point3 nearest_on_triangle(const Triangle& t, const Point3& p) {
  const Point3 normal = cross(t[1] - t[0], t[2] - t[0]);
  const double square = dot(normal, normal);
  bool inside = square > 0;
  for (std::size_t c = 0; c < 3 && inside; ++c)
    inside = dot(cross(t[(c + 1) % 3] - t[c], p - t[c]), normal) >= 0;
  if (inside) return p - (dot(p - t[0], normal) / square) * normal;
  Point3 best = t[0];
  for (std::size_t c = 0; c < 3; ++c) {
    const Point3 near = nearest_on_segment(t[c], t[(c + 1) % 3], p);
    if (dot(near - p, near - p) < dot(best - p, best - p)) best = near;
  }
  return best;
}

/// A surface as its triangles, scaled.
struct FacetTree {
  std::vector<Triangle> triangles;
  std::vector<Point3> vertices;
  std::vector<double> weights;  // of the vertices: areas; negative without a face
  double area = 0;
  AlignedBox box;
};

Error refusal(const char* name, const std::string& what) {
  return {std::string("distance of surfaces: the ") + name + " " + what};
}

/// The largest coordinate of a corner, in size; or what is wrong with the corners.
Result<double> largest_coordinate(const Polygons& surface, const char* name) {
  double largest = 0;
  for (const Index v : surface.corners) {
    if (v < 0 || v >= surface.vertex_count())
      return refusal(name, "has a corner that is no vertex: " + std::to_string(v));
    const Point3& p = surface.positions[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return refusal(name, "is not finite at vertex " + std::to_string(v));
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return largest;
}

/// Of a surface cut into triangles.
FacetTree facets_of(const Polygons& cut, double scale) {
  FacetTree facets;
  facets.weights.assign(cut.positions.size(), -1);
  for (const Point3& p : cut.positions) facets.vertices.push_back(scale * p);
  for (Index f = 0; f < cut.face_count(); ++f) {
    const Index* const v = &cut.corners[cut.face_begin[f]];
    const Triangle t = {facets.vertices[v[0]], facets.vertices[v[1]], facets.vertices[v[2]]};
    const double third = length(cross(t[1] - t[0], t[2] - t[0])) / 6;
    for (std::size_t c = 0; c < 3; ++c) {
      double& weight = facets.weights[v[c]];
      weight = std::max(weight, 0.0) + third;
      facets.box.extend(vector_of(t[c]));
    }
    facets.area += 3 * third;
    facets.triangles.push_back(t);
  }
  return facets;
}

/// Triangles in a tree of boxes.
class NearestPoint {
 public:
  explicit NearestPoint(const std::vector<Triangle>& triangles) : triangles_(triangles) {
    std::vector<int> indices(triangles.size());
    std::iota(indices.begin(), indices.end(), 0);
    std::vector<AlignedBox> boxes;
    for (const Triangle& t : triangles) {
      AlignedBox box(vector_of(t[0]));
      boxes.push_back(box.extend(vector_of(t[1])).extend(vector_of(t[2])));
    }
    tree_.init(indices.begin(), indices.end(), boxes.begin(), boxes.end());
  }

  [[nodiscard]] Point3 operator()(const Point3& p) const {
    Search search{triangles_, p, vector_of(p)};
    Eigen::BVMinimize(tree_, search);
    return search.nearest;
  }

 private:
  using Tree = Eigen::KdBVH<double, 3, int>;

  /// What Eigen's search asks for, by its names: squared distances.
  // NOLINTBEGIN(readability-identifier-naming)
  struct Search {
    using Scalar = double;
    const std::vector<Triangle>& triangles;
    Point3 p;
    Eigen::Vector3d at;
    Point3 nearest = {};
    double least = std::numeric_limits<double>::infinity();

    [[nodiscard]] double minimumOnVolume(const AlignedBox& box) const {
      return box.squaredExteriorDistance(at);
    }
    double minimumOnObject(int triangle) {
      const Point3 near = nearest_on_triangle(triangles[triangle], p);
      const double square = dot(near - p, near - p);
      if (square < least) {
        least = square;
        nearest = near;
      }
      return square;
    }
  };
  // NOLINTEND(readability-identifier-naming)

  const std::vector<Triangle>& triangles_;
  Tree tree_;
};

/// A vertex and the nearest point of the other surface.
struct Gap {
  double size = -1;
  Point3 from = {}, to = {};

  /// Gaps of one size have an order too, so that `where` is the same either way round.
  friend bool operator<(const Gap& a, const Gap& b) {
    return std::tie(a.size, a.from.x, a.from.y, a.from.z) <
           std::tie(b.size, b.from.x, b.from.y, b.from.z);
  }
};

struct OneWay {
  std::vector<double> distances;  // of the vertices, scaled
  Gap largest;
  double integral = 0;  // of the distance over the surface
};

OneWay one_way(const FacetTree& from, const FacetTree& to) {
  const auto count = static_cast<Index>(from.vertices.size());
  OneWay way;
  way.distances.assign(from.vertices.size(), kNowhere);
  std::vector<Point3> nearest(from.vertices.size());
  const NearestPoint nearest_on(to.triangles);
  base::parallel_for(
      Index{0}, count,
      [&](Index first, Index last) {
        for (Index v = first; v < last; ++v) {
          if (from.weights[v] < 0) continue;
          nearest[v] = nearest_on(from.vertices[v]);
          way.distances[v] = length(nearest[v] - from.vertices[v]);
        }
      },
      kGrain);
  for (Index v = 0; v < count; ++v) {
    if (from.weights[v] < 0) continue;
    way.integral += from.weights[v] * way.distances[v];
    way.largest = std::max(way.largest, Gap{way.distances[v], from.vertices[v], nearest[v]});
  }
  return way;
}

std::vector<double> times(double scale, std::vector<double> values) {
  for (double& value : values) value *= scale;
  return values;
}

}  // namespace

Result<SurfaceDistance> approx_surface_distance(const Polygons& a, const Polygons& b) {
  const Result<double> largest_a = largest_coordinate(a, "first");
  if (!largest_a) return largest_a.error();
  const Result<double> largest_b = largest_coordinate(b, "second");
  if (!largest_b) return largest_b.error();
  // A power of two, so that squares neither overflow nor vanish and nothing is rounded.
  const double largest = std::max(*largest_a, *largest_b);
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;
  const double scale = std::ldexp(1.0, -exponent), back = std::ldexp(1.0, exponent);
  const Result<Triangulation> cut_a = triangulate(a), cut_b = triangulate(b);
  if (!cut_a) return refusal("first", "is too large: " + cut_a.error().message);
  if (!cut_b) return refusal("second", "is too large: " + cut_b.error().message);
  const FacetTree first = facets_of(cut_a->polygons, scale);
  const FacetTree second = facets_of(cut_b->polygons, scale);
  if (!(first.area > 0)) return refusal("first", "has no area");
  if (!(second.area > 0)) return refusal("second", "has no area");

  OneWay there = one_way(first, second), again = one_way(second, first);
  SurfaceDistance distance;
  const bool forth = again.largest < there.largest;
  const Gap& gap = forth ? there.largest : again.largest;
  distance.largest = back * gap.size;
  distance.where = {back * gap.from, back * gap.to};
  if (!forth) std::swap(distance.where[0], distance.where[1]);
  distance.mean = back * ((there.integral + again.integral) / (first.area + second.area));
  distance.diagonal = back * first.box.merged(second.box).diagonal().norm();
  distance.from_a = times(back, std::move(there.distances));
  distance.from_b = times(back, std::move(again.distances));
  return distance;
}

}  // namespace limn::mesh
