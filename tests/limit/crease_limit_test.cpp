// Limit points of meshes with infinite creases, corners and darts.

#include "limn/limit/crease_limit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "limn/refine/refine.h"
#include "mesh/random_mesh.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

double distance(Point3 a, Point3 b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

Sharpness random_infinite(const Mesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  Sharpness sharpness;
  for (Index e = 0; e < mesh.edge_count(); ++e)
    sharpness.edges.push_back(random() % 4 == 0 ? kInfinitelySharp : 0);
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    sharpness.vertices.push_back(random() % 12 == 0 ? kInfinitelySharp : 0);
  return sharpness;
}

Result<std::vector<Point3>> limit_after(const Scheme& scheme, const Mesh& mesh,
                                        const std::vector<Point3>& points,
                                        const Sharpness& sharpness, int levels) {
  const auto fine = refine(scheme, mesh, points, levels, {}, sharpness);
  if (!fine) return fine.error();
  LimitOptions options;
  options.steps_made = levels;
  Result<LimitPoints> limit =
      approx_limit_points(scheme, fine->mesh, fine->values, fine->sharpness, options);
  if (!limit) return limit.error();
  return std::move(limit->positions);
}

class CreaseLimits : public ::testing::TestWithParam<std::string> {};

// The limit of a control vertex is that of its child.
TEST_P(CreaseLimits, DoNotDependOnTheLevel) {
  const Scheme& scheme = shipped(GetParam());
  int compared = 0;
  for (unsigned seed = 1; seed < 40 && compared < 4; ++seed) {
    const Mesh mesh =
        scheme.split->any_polygons ? RandomMesh(seed).polygons() : RandomMesh(seed).triangles();
    if (mesh.vertex_count() > 60) continue;
    std::vector<Point3> points;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (Index v = 0; v < mesh.vertex_count(); ++v)
      points.push_back({uniform(random), uniform(random), uniform(random)});
    const Sharpness sharpness = random_infinite(mesh, seed);
    const int step = scheme.split->boundary_rests() ? 2 : 1;
    const auto first = limit_after(scheme, mesh, points, sharpness, step);
    const auto second = limit_after(scheme, mesh, points, sharpness, 2 * step);
    if (!first || !second) continue;  // no rule for some boundary
    for (std::size_t v = 0; v < points.size(); ++v) {
      EXPECT_LT(distance((*first)[v], (*second)[v]), 1e-11)
          << GetParam() << ", seed " << seed << ", vertex " << v;
      if (sharpness.vertices[v] > 0) EXPECT_EQ((*first)[v], points[v]);
    }
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

INSTANTIATE_TEST_SUITE_P(Shipped, CreaseLimits,
                         ::testing::Values("loop", "catmull-clark", "butterfly", "optimal",
                                           "laplacian-loop", "laplacian-butterfly", "sqrt3",
                                           "four-eight"),
                         [](const auto& one) { return test_name(one.param); });

TEST(CreaseLimit, OfACubicCreaseIsThatOfItsSpline) {
  const Mesh mesh = torus(Lattice::quad, 5, 5);
  std::vector<Point3> points;
  std::mt19937 random(3);
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    points.push_back({static_cast<double>(random() % 100), static_cast<double>(random() % 100), 0});
  Sharpness sharpness;  // along the row 0 … 4
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e);
    sharpness.edges.push_back(mesh.origin(h) < 5 && mesh.target(h) < 5 ? kInfinitelySharp : 0);
  }
  const LimitPoints limit =
      approx_limit_points(shipped("catmull-clark"), mesh, points, sharpness).value();
  for (std::size_t v = 0; v < 5; ++v) {
    const Point3 expected =
        (1.0 / 6) * points[(v + 4) % 5] + (2.0 / 3) * points[v] + (1.0 / 6) * points[(v + 1) % 5];
    EXPECT_LT(distance(limit.positions[v], expected), 1e-12);
    EXPECT_EQ(limit.normals[v], Point3{});
  }
  EXPECT_NE(limit.normals[12], Point3{});
}

}  // namespace
}  // namespace limn::test
