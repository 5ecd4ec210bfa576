// Limits, normals and curvatures are those of the shape, whatever the size of the model.

#include <gtest/gtest.h>

#include <cmath>

#include "fast/fast_limit_check.h"
#include "limn/limit/limit_points.h"
#include "limn/refine/refine.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

constexpr int kLevels = 3;

std::vector<Point3> times(double scale, std::vector<Point3> points) {
  for (Point3& p : points) p = scale * p;
  return points;
}

LimitPoints plain_limit(const Scheme& scheme, const Mesh& mesh, const std::vector<Point3>& points) {
  const auto fine = refine::refine(scheme, mesh, points, kLevels).value();
  LimitOptions options;
  options.steps_made = kLevels;
  options.curvatures = true;
  return approx_limit_points(scheme, fine.mesh, fine.values, options).value();
}

template <class Real>
std::pair<std::vector<Point3>, std::vector<Point3>> quick_limit(
    const FastRefiner& refiner, const FastRefiner::Limit& limit,
    const std::vector<Point3>& control) {
  std::vector<Real> positions(3 * static_cast<std::size_t>(refiner.vertex_count()));
  std::vector<Real> normals = positions;
  FastRefiner::Scratch<Real> scratch;
  refiner.evaluate_limit<Real>(limit, as_numbers<Real>(control), positions, normals, scratch);
  return {as_points(positions), as_points(normals)};
}

Mesh sample(const Scheme& scheme, unsigned seed) {
  RandomMesh random(seed);
  return scheme.split->lattice == Lattice::triangle ? random.triangles() : random.polygons();
}

double length(const Point3& a) { return std::hypot(a.x, a.y, a.z); }

class LimitAtAnySize : public testing::TestWithParam<std::string> {};

TEST_P(LimitAtAnySize, IsThatOfTheShapeInThePlainEngine) {
  const Scheme& scheme = shipped(GetParam());
  const Mesh mesh = scheme.split->lattice == Lattice::triangle ? icosahedron() : cube();
  const auto points = random_points(mesh.vertex_count(), 7);
  const LimitPoints expected = plain_limit(scheme, mesh, points);
  for (const double scale : {1e-300, 1e-200, 1e-80, 1e-20, 1e20, 1e100, 1e200, 1e300}) {
    SCOPED_TRACE(scale);
    const LimitPoints found = plain_limit(scheme, mesh, times(scale, points));
    for (std::size_t v = 0; v < found.positions.size(); ++v) {
      EXPECT_LT(distance((1 / scale) * found.positions[v], expected.positions[v]), 1e-13) << v;
      EXPECT_NEAR(length(found.normals[v]), 1, 1e-14) << v;
      EXPECT_LT(distance(found.normals[v], expected.normals[v]), 1e-9) << v;
      const double largest = expected.curvatures[v].largest;
      EXPECT_EQ(std::isnan(found.curvatures[v].largest), std::isnan(largest)) << v;
      if (!std::isnan(largest))
        EXPECT_NEAR(scale * found.curvatures[v].largest, largest, 1e-8 * (1 + std::abs(largest)));
    }
  }
}

TEST_P(LimitAtAnySize, IsThatOfTheShapeInTheQuickEngine) {
  const Scheme& scheme = shipped(GetParam());
  int found = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const Mesh mesh = sample(scheme, seed);
    const FastRefiner refiner = FastRefiner::make(scheme, mesh, kLevels).value();
    const auto limit = approx_fast_limit(scheme, refiner);
    if (!limit || !*limit) continue;
    ++found;
    const auto points = random_points(mesh.vertex_count(), seed);
    const auto [positions, normals] = quick_limit<double>(refiner, **limit, points);
    for (const double scale : {1e-300, 1e-200, 1e-80, 1e-20, 1e20, 1e100, 1e200, 1e300}) {
      SCOPED_TRACE(scale);
      const auto [p, n] = quick_limit<double>(refiner, **limit, times(scale, points));
      for (std::size_t v = 0; v < p.size(); ++v) {
        EXPECT_LT(distance((1 / scale) * p[v], positions[v]), 1e-13) << v;
        EXPECT_LT(distance(n[v], normals[v]), 1e-8) << v;
      }
    }
    const auto [low, low_normals] = quick_limit<float>(refiner, **limit, points);
    for (const double exponent : {-100, -60, -30, 30, 60, 120}) {  // of 2: all but the same bits
      SCOPED_TRACE(exponent);
      const double scale = std::exp2(exponent);
      const auto [p, n] = quick_limit<float>(refiner, **limit, times(scale, points));
      for (std::size_t v = 0; v < p.size(); ++v) {
        EXPECT_LT(distance((1 / scale) * p[v], low[v]), 1e-6) << v;
        EXPECT_LT(distance(n[v], low_normals[v]), 1e-5) << v;
      }
    }
  }
  EXPECT_GT(found, 0);
}

// Points that are one have no normals, whatever rounding makes of them.
TEST_P(LimitAtAnySize, HasNoNormalWhereAllPointsAreOne) {
  const Scheme& scheme = shipped(GetParam());
  int found = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const Mesh mesh = sample(scheme, seed);
    const FastRefiner refiner = FastRefiner::make(scheme, mesh, kLevels).value();
    const auto limit = approx_fast_limit(scheme, refiner);
    if (!limit || !*limit) continue;
    ++found;
    for (const double scale : {1e-300, 1e-30, 1.0, 1e30, 1e300}) {
      SCOPED_TRACE(scale);
      const std::vector<Point3> points(static_cast<std::size_t>(mesh.vertex_count()),
                                       scale * Point3{0.1, 0.7, -0.3});
      for (const Point3& n : quick_limit<double>(refiner, **limit, points).second)
        EXPECT_EQ(n, Point3{});
      if (std::abs(std::log10(scale)) < 31)
        for (const Point3& n : quick_limit<float>(refiner, **limit, points).second)
          EXPECT_EQ(n, Point3{});
      for (const Point3& n : plain_limit(scheme, mesh, points).normals) EXPECT_EQ(n, Point3{});
    }
  }
  EXPECT_GT(found, 0);
}

// … nor have those of a line.
TEST_P(LimitAtAnySize, HasNoNormalOnALine) {
  const Scheme& scheme = shipped(GetParam());
  const Mesh mesh = scheme.split->lattice == Lattice::triangle ? icosahedron() : cube();
  const FastRefiner refiner = FastRefiner::make(scheme, mesh, kLevels).value();
  const auto limit = approx_fast_limit(scheme, refiner).value();
  ASSERT_TRUE(limit);
  for (const double scale : {1e-200, 1.0, 1e200}) {
    SCOPED_TRACE(scale);
    std::vector<Point3> points;
    for (const Point3& p : random_points(mesh.vertex_count(), 3))
      points.push_back(scale * p.x * Point3{0.3, 1.1, -0.7});
    for (const Point3& n : quick_limit<double>(refiner, *limit, points).second)
      EXPECT_EQ(n, Point3{});
    for (const Point3& n : plain_limit(scheme, mesh, points).normals) EXPECT_EQ(n, Point3{});
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, LimitAtAnySize,
                         testing::Values("loop", "butterfly", "sqrt3", "catmull-clark",
                                         "doo-sabin"),
                         [](const auto& info) { return test_name(info.param); });

// A small part of a large model has its own size.
TEST(LimitAtAnySizeOf, PartsOfAModel) {
  const Scheme& scheme = shipped("loop");
  Polygons both = mesh::torus(Lattice::triangle, 4, 5).polygons(random_points(20, 1));
  const Index count = both.vertex_count(), corners = static_cast<Index>(both.corners.size());
  for (Index v = 0; v < count; ++v) both.positions.push_back(1e-120 * both.positions[v]);
  for (Index i = 0; i < corners; ++i) {
    both.corners.push_back(both.corners[i] + count);
    if (i % 3 == 2) both.face_begin.push_back(static_cast<Index>(both.corners.size()));
  }
  const FastRefiner refiner = FastRefiner::make(scheme, Mesh::build(both).value(), kLevels).value();
  const FastLimitMesh found =
      approx_fast_limit_mesh(scheme, refiner, both.positions).value().value();
  for (Index v = 0; v < count; ++v)
    EXPECT_LT(distance(found.normals[v], found.normals[v + count]), 1e-9) << v;
  for (const Point3& n : found.normals) EXPECT_NEAR(length(n), 1, 1e-12);
}

}  // namespace
}  // namespace limn::test
