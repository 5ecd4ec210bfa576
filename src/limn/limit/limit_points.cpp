#include "limn/limit/limit_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "limn/limit/limit_kinds.h"
#include "limn/mesh/unit_normal.h"
#include "limn/refine/refine_values.h"

namespace limn {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

using Tangent = std::array<double, 3>;

Tangent tangent_of(const Point3& p) { return {p.x, p.y, p.z}; }

/// The largest coordinate.
double size_of(const std::vector<Index>& vertices, const std::vector<Point3>& values) {
  double size = 0;
  for (const Index v : vertices)
    size = std::max({size, std::abs(values[v].x), std::abs(values[v].y), std::abs(values[v].z)});
  return size;
}

Point3 normal_of(std::span<const Tangent> tangents, double size) {
  const Tangent normal = mesh::unit_normal<double>(tangents, size);
  return {normal[0], normal[1], normal[2]};
}

/// The sum of the faces' normals round a vertex, or that of one face, by their areas.
Point3 normal_of_faces(const Mesh& mesh, const std::vector<Point3>& values, Index start, bool face,
                       double size) {
  std::vector<Tangent> chain;
  const Point3 from = values[mesh.origin(start)];
  const auto add = [&](Index v) { chain.push_back(tangent_of(values[v] - from)); };
  Index h = start;
  for (Index last = start; h != kNone;) {
    add(mesh.target(h));
    last = h;
    h = face ? mesh.next(h) : mesh.rotate(h);
    if (h == kNone) add(mesh.origin(mesh.prev(last)));
    if (h == start) {
      add(mesh.target(start));
      break;
    }
  }
  return normal_of(chain, size);
}

/// Principal curvatures of u t1 + v t2 + cup (u² + v²) + saddle1 (u² − v²) + saddle2 2uv at 0.
LimitPoints::Curvatures principal(const Point3& t1, const Point3& t2, const Point3& normal,
                                  const std::array<Point3, 3>& quadratics) {
  const std::array<double, 6> lengths{t1.x, t1.y, t1.z, t2.x, t2.y, t2.z};
  const int exponent = mesh::largest_exponent(lengths);
  if (exponent == mesh::kNoExponent || normal == Point3{}) return {kNaN, kNaN};
  // of the surface that is 2^exponent times as small
  const auto scaled = [&](const Point3& p) {
    return Point3{std::ldexp(p.x, -exponent), std::ldexp(p.y, -exponent),
                  std::ldexp(p.z, -exponent)};
  };
  const Point3 a = scaled(t1), b = scaled(t2);
  Eigen::Matrix2d first;
  Eigen::Matrix2d second;
  first << dot(a, a), dot(a, b), dot(a, b), dot(b, b);
  const double c = 2 * dot(normal, scaled(quadratics[0]));
  const double s = 2 * dot(normal, scaled(quadratics[1]));
  const double m = 2 * dot(normal, scaled(quadratics[2]));
  second << c + s, m, m, c - s;
  if (!(first.determinant() > 0) || !second.allFinite()) return {kNaN, kNaN};
  const Eigen::Vector2d values =
      Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d>(second, first).eigenvalues();
  return {std::ldexp(values(1), -exponent), std::ldexp(values(0), -exponent)};
}

using Spot = limit::LimitPlace<Point3>;

void take_limit(const Spot& at, bool dual, LimitPoints& out) {
  const LimitStencil& limit = at.kind.limit;
  limit::put(at, at.weighted(limit.position), out.positions);
  if (!limit.has_plane) return;
  const double size = size_of(at.neighbourhood, at.values);
  if (limit.first_tangent.empty()) {
    limit::put(at, normal_of_faces(at.mesh, at.values, at.start, dual, size), out.normals);
    return;
  }
  const std::array<Tangent, 2> tangents{tangent_of(at.weighted(limit.first_tangent)),
                                        tangent_of(at.weighted(limit.second_tangent))};
  limit::put(at, normal_of(tangents, size), out.normals);
}

/// Whether a sum is what rounding makes of 0.
bool vanishes(const std::vector<double>& weights, const Point3& sum, double size) {
  constexpr double kUnits = 64;  // of rounding, of the coordinates that a step or two made
  double scale = 0;
  for (const double weight : weights) scale += std::abs(weight);
  const double bound = kUnits * std::numeric_limits<double>::epsilon() * scale * size;
  return std::abs(sum.x) <= bound && std::abs(sum.y) <= bound && std::abs(sum.z) <= bound;
}

/// After the limit.
void take_curvature(const Spot& at, LimitPoints& out) {
  const auto none = [&](NoCurvature reason) { limit::put(at, reason, out.no_curvature); };
  if (!at.kind.curvature) return none(at.kind.no_curvature);
  const Point3& normal = out.normals[at.vertex];
  if (normal == Point3{}) return none(NoCurvature::no_normal);
  const LimitStencil& limit = at.kind.limit;
  const limit::CurvatureStencil& stencil = at.kind.curvature->stencil;
  const auto sum = [&](const std::vector<double>& weights) { return at.weighted(weights); };
  if (!stencil.jumps.empty()) {
    const double size = size_of(at.neighbourhood, at.values);
    for (const std::vector<double>& jump : stencil.jumps)
      if (!vanishes(jump, sum(jump), size)) return none(NoCurvature::direction);
  }
  const LimitPoints::Curvatures curvatures =
      principal(sum(limit.first_tangent), sum(limit.second_tangent), normal,
                {sum(stencil.cup), sum(stencil.first_saddle), sum(stencil.second_saddle)});
  limit::put(at, curvatures, out.curvatures);
  none(std::isnan(curvatures.largest) ? NoCurvature::too_large : NoCurvature::none);
}

}  // namespace

Result<LimitPoints> approx_limit_points(const Scheme& scheme, const Mesh& mesh,
                                        const std::vector<Point3>& values,
                                        const LimitOptions& options) {
  LimitPoints out;
  out.positions.resize(values.size());
  out.normals.resize(values.size());
  const bool bounded = options.regular.bounded != Truth::no;
  if (options.curvatures) {
    out.curvatures.assign(values.size(), {kNaN, kNaN});
    out.no_curvature.assign(values.size(),
                            bounded ? NoCurvature::not_regular : NoCurvature::regular);
  }
  std::vector<Index> vertices = options.vertices;
  if (vertices.empty()) {
    vertices.resize(values.size());
    std::iota(vertices.begin(), vertices.end(), 0);
  }
  for (const Index v : vertices)
    if (mesh.is_isolated(v)) {
      out.positions[v] = values[v];
      if (options.curvatures) out.no_curvature[v] = NoCurvature::no_limit;
    }
  limit::LimitKinds kinds(scheme, options.curvatures && bounded);
  const bool dual = scheme.split->is_dual();
  const auto limit = [&](const Spot& at) { take_limit(at, dual, out); };
  const auto curvature = [&](const Spot& at) {
    if (options.curvatures && bounded) take_curvature(at, out);
  };
  limit::LimitSearch<Point3, decltype(limit), decltype(curvature)> search(scheme, kinds, options,
                                                                          limit, curvature);
  const Status status =
      search.run(mesh, values, vertices, options.partial ? &out.refused : nullptr);
  if (!status) return status.error();
  for (const LimitPoints::Refused& one : out.refused) {
    out.positions[one.vertex] = values[one.vertex];
    if (options.curvatures) out.no_curvature[one.vertex] = NoCurvature::no_limit;
  }
  std::sort(out.refused.begin(), out.refused.end(),
            [](const auto& a, const auto& b) { return a.vertex < b.vertex; });
  return out;
}

}  // namespace limn
