// Curvature of surfaces whose second derivatives jump: biquadratic splines.

#include <gtest/gtest.h>

#include <cmath>

#include "fast/fast_check.h"
#include "limn/limit/limit_points.h"
#include "limn/refine/refine.h"
#include "mesh/random_mesh.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

constexpr Index kSide = 6;

/// A torus that goes on for ever: heights over a plane, of which the middle is looked at.
std::vector<Point3> heights(unsigned seed) {
  std::vector<Point3> points = random_points(kSide * kSide, seed);
  for (Index j = 0; j < kSide; ++j)
    for (Index i = 0; i < kSide; ++i) {
      Point3& p = points[j * kSide + i];
      p = {i + 0.2 * p.x, j + 0.2 * p.y, p.z};
    }
  return points;
}

/// Of the piece of the biquadratic spline whose middle control point is `v`, in its middle: the
/// quadratic spline has the value (1 6 1)/8, slope (-1 0 1)/2 and second derivative (1 -2 1) there.
LimitPoints::Curvatures of_piece(const std::vector<Point3>& points, Index i, Index j) {
  constexpr double value[] = {0.125, 0.75, 0.125}, slope[] = {-0.5, 0, 0.5}, second[] = {1, -2, 1};
  const auto sum = [&](const double(&a)[3], const double(&b)[3]) {
    Point3 total;
    for (Index y = 0; y < 3; ++y)
      for (Index x = 0; x < 3; ++x)
        total = total + a[x] * b[y] * points[(j + y - 1) * kSide + i + x - 1];
    return total;
  };
  const Point3 u = sum(slope, value), v = sum(value, slope);
  const Point3 normal = cross(u, v);
  const double size = std::sqrt(dot(normal, normal));
  const double e = dot(u, u), f = dot(u, v), g = dot(v, v);
  const double l = dot(sum(second, value), normal) / size;
  const double m = dot(sum(slope, slope), normal) / size;
  const double n = dot(sum(value, second), normal) / size;
  const double area = e * g - f * f;
  const double mean = (e * n - 2 * f * m + g * l) / (2 * area);
  const double gauss = (l * n - m * m) / area;
  const double spread = std::sqrt(std::max(0.0, mean * mean - gauss));
  return {mean + spread, mean - spread};
}

TEST(LimitJumps, ABiquadraticSplineHasItsCurvatureAtRegularVertices) {
  const Scheme& scheme = shipped("doo-sabin");
  const Mesh mesh = mesh::torus(Lattice::quad, kSide, kSide);
  LimitOptions options;
  options.curvatures = true;
  for (const unsigned seed : {1U, 2U, 3U}) {
    const std::vector<Point3> points = heights(seed);
    const LimitPoints limit = approx_limit_points(scheme, mesh, points, options).value();
    for (Index j = 1; j + 1 < kSide; ++j)
      for (Index i = 1; i + 1 < kSide; ++i) {
        const Index v = j * kSide + i;
        const LimitPoints::Curvatures expected = of_piece(points, i, j);
        EXPECT_EQ(limit.no_curvature[v], NoCurvature::none);
        EXPECT_NEAR(limit.curvatures[v].largest, expected.largest, 1e-10) << i << ' ' << j;
        EXPECT_NEAR(limit.curvatures[v].smallest, expected.smallest, 1e-10) << i << ' ' << j;
      }
  }
}

// Where a face at the vertex is no quad, the pieces that meet in its limit have other second
// derivatives each. Round an irregular vertex from 5 faces on they grow, as a Jordan block says.
TEST(LimitJumps, WherePiecesMeetThereIsNoOneCurvature) {
  const Scheme& scheme = shipped("doo-sabin");
  LimitOptions options;
  options.curvatures = true;
  options.vertices = {0};
  for (const Index n : {3, 5, 7}) {
    const Mesh mesh = mesh::face_star(n, 5);  // vertex 0 is a corner of the face
    const std::vector<Point3> points = random_points(mesh.vertex_count(), 3);
    const LimitPoints limit = approx_limit_points(scheme, mesh, points, options).value();
    EXPECT_EQ(limit.no_curvature[0], NoCurvature::direction) << n;
    EXPECT_TRUE(std::isnan(limit.curvatures[0].largest));
    EXPECT_NEAR(dot(limit.normals[0], limit.normals[0]), 1, 1e-14);
  }
  for (const Index n : {5, 6, 9}) {
    const Mesh mesh = mesh::star(Lattice::quad, n, 4);
    const std::vector<Point3> points = random_points(mesh.vertex_count(), 3);
    EXPECT_EQ(approx_limit_points(scheme, mesh, points, options)->no_curvature[0],
              NoCurvature::unbounded);
  }
}

TEST(LimitJumps, ReasonsAreTold) {
  LimitOptions options;
  options.curvatures = true;
  const auto reasons = [&](const char* name, const Mesh& mesh) {
    return approx_limit_points(shipped(name), mesh, random_points(mesh.vertex_count(), 1), options)
        ->no_curvature;
  };
  const std::vector<NoCurvature> loop = reasons("loop", mesh::star(Lattice::triangle, 8, 4));
  EXPECT_EQ(loop.front(), NoCurvature::unbounded);
  EXPECT_EQ(loop.back(), NoCurvature::boundary);
  EXPECT_EQ(loop[1], NoCurvature::none);
  options.regular.bounded = Truth::no;
  for (const NoCurvature reason : reasons("loop", tetrahedron()))
    EXPECT_EQ(reason, NoCurvature::regular);
}

}  // namespace
}  // namespace limn::test
