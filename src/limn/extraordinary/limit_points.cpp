#include "limn/extraordinary/limit_points.h"

#include <cmath>
#include <limits>
#include <numeric>

#include "limn/extraordinary/limit_kinds.h"
#include "limn/refine/refine_values.h"

namespace limn {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Point3 normalized(const Point3& a) {
  const double length = std::sqrt(dot(a, a));
  return length > 0 ? (1 / length) * a : Point3{};
}

/// The sum of the faces' normals round a vertex, or that of one face, by their areas.
Point3 normal_of_faces(const Mesh& mesh, const std::vector<Point3>& values, Index start,
                       bool face) {
  Point3 sum;
  Index h = start;
  do {
    const Index last = face ? h : mesh.prev(h);
    const Point3 from = values[mesh.origin(face ? mesh.prev(h) : h)];
    sum = sum + (face ? cross(values[mesh.origin(h)] - from, values[mesh.target(h)] - from)
                      : cross(values[mesh.target(h)] - from, values[mesh.origin(last)] - from));
    h = face ? mesh.next(h) : mesh.rotate(h);
  } while (h != kNone && h != start);
  return normalized(sum);
}

Point3 weighted(const std::vector<double>& weights, const std::vector<Index>& vertices,
                const std::vector<Point3>& values) {
  Point3 sum;
  for (std::size_t i = 0; i < weights.size(); ++i) add_scaled(sum, weights[i], values[vertices[i]]);
  return sum;
}

/// t1 × t2 as a unit vector; zero where rounding of the points is all there is to it.
Point3 normal_of(const Point3& t1, const Point3& t2, const std::vector<Index>& vertices,
                 const std::vector<Point3>& values) {
  double size = 0;
  for (const Index v : vertices)
    size = std::max({size, std::abs(values[v].x), std::abs(values[v].y), std::abs(values[v].z)});
  const Point3 normal = cross(t1, t2);
  const double rounding = 1e-14 * size * std::sqrt(dot(t1, t1) + dot(t2, t2));
  return dot(normal, normal) > rounding * rounding ? normalized(normal) : Point3{};
}

/// Principal curvatures of u t1 + v t2 + cup (u² + v²) + saddle1 (u² − v²) + saddle2 2uv at 0.
LimitPoints::Curvatures principal(const Point3& t1, const Point3& t2, const Point3& cup,
                                  const Point3& saddle1, const Point3& saddle2) {
  const Point3 normal = normalized(cross(t1, t2));
  Eigen::Matrix2d first;
  Eigen::Matrix2d second;
  first << dot(t1, t1), dot(t1, t2), dot(t1, t2), dot(t2, t2);
  const double c = 2 * dot(normal, cup);
  const double s = 2 * dot(normal, saddle1);
  const double m = 2 * dot(normal, saddle2);
  second << c + s, m, m, c - s;
  if (!(first.determinant() > 0)) return {kNaN, kNaN};
  const Eigen::Vector2d values =
      Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d>(second, first).eigenvalues();
  return {values(1), values(0)};
}

void apply(const LimitKind& kind, const Mesh& mesh, const std::vector<Point3>& values, Index start,
           bool dual, const std::vector<Index>& vertices, Index result, LimitPoints& out) {
  out.positions[result] = weighted(kind.limit.position, vertices, values);
  const Point3 t1 = weighted(kind.limit.first_tangent, vertices, values);
  const Point3 t2 = weighted(kind.limit.second_tangent, vertices, values);
  out.normals[result] = kind.limit.first_tangent.empty()
                            ? normal_of_faces(mesh, values, start, dual)
                            : normal_of(t1, t2, vertices, values);
  if (!kind.curvature) return;
  out.curvatures[result] = principal(t1, t2, weighted(kind.curvature->cup, vertices, values),
                                     weighted(kind.curvature->first_saddle, vertices, values),
                                     weighted(kind.curvature->second_saddle, vertices, values));
}

}  // namespace

Result<LimitPoints> approx_limit_points(const Scheme& scheme, const Mesh& mesh,
                                        const std::vector<Point3>& values,
                                        const LimitOptions& options) {
  LimitPoints out;
  out.positions.resize(values.size());
  out.normals.resize(values.size());
  if (options.curvatures) out.curvatures.assign(values.size(), {kNaN, kNaN});
  std::vector<Index> vertices = options.vertices;
  if (vertices.empty()) {
    vertices.resize(values.size());
    std::iota(vertices.begin(), vertices.end(), 0);
  }
  for (const Index v : vertices)
    if (mesh.is_isolated(v)) out.positions[v] = values[v];
  LimitKinds kinds(scheme, options.curvatures && options.regular.bounded != Truth::no);
  const bool dual = scheme.split->births_corners;
  const Status status =
      for_each_limit(scheme, kinds, mesh, values, vertices, options,
                     [&](const LimitKind& kind, const Mesh& at, const std::vector<Point3>& points,
                         Index start, const std::vector<Index>& neighbourhood, Index vertex) {
                       apply(kind, at, points, start, dual, neighbourhood, vertex, out);
                     });
  if (!status) return status.error();
  return out;
}

}  // namespace limn
