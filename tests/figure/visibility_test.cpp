#include "limn/figure/space/visibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "limn/figure/space/space_curves.h"
#include "sample_surfaces.h"

namespace limn::test {
namespace {

const figure::ParallelView kFromX(0, 0);  // right, up and near are y, z and x

figure::SeenSurface seen(const figure::SmoothSurface& surface) {
  return figure::seen_surface(surface, kFromX);
}

class Rays : public testing::Test {
 protected:
  void SetUp() override {
    if (!figure::rays_available()) GTEST_SKIP() << "built without Embree";
  }
};

/// Triangles anywhere in the cube [−1, 1]³.
figure::SmoothSurface soup(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  figure::SmoothSurface surface;
  for (int v = 0; v < 3 * count; ++v) {
    surface.vertices.push_back({any(random), any(random), any(random)});
    surface.normals.push_back({0, 0, 1});
    if (v % 3 == 2) surface.triangles.push_back({v - 2, v - 1, v});
  }
  return surface;
}

struct Met {
  double depth = -std::numeric_limits<double>::infinity();
  std::size_t triangle = 0;
  double margin = 1;  ///< least barycentric coordinate, or distance of a triangle missed by little
};

/// By solving for the place on each triangle.
Met met_by_force(const figure::SeenSurface& surface, double x, double y) {
  Met met;
  double closest = 1;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [i, j, k] = surface.triangles[t];
    const figure::SpaceVector &a = surface.vertices[i], &b = surface.vertices[j],
                              &c = surface.vertices[k];
    const double det = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    const double u = ((x - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (y - a[1])) / det;
    const double v = ((b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1])) / det;
    const double least = std::min({u, v, 1 - u - v});
    closest = std::min(closest, std::abs(least));
    const double depth = a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2]);
    if (least >= 0 && depth > met.depth) met = {depth, t, 1};
  }
  met.margin = closest;
  return met;
}

TEST_F(Rays, MeetWhatForceMeets) {
  const figure::SeenSurface surface = seen(soup(60, 1));
  const figure::RayCaster rays = figure::RayCaster::over({surface}).value();
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-1.2, 1.2);
  int met_count = 0, missed = 0;
  for (int i = 0; i < 4000; ++i) {
    const double x = any(random), y = any(random);
    const Met met = met_by_force(surface, x, y);
    if (met.margin < 1e-4) continue;  // of an edge that single precision cannot tell
    const std::optional<figure::RayHit> hit = rays.first_hit(x, y);
    ASSERT_EQ(hit.has_value(), std::isfinite(met.depth));
    if (!hit) {
      ++missed;
      continue;
    }
    ++met_count;
    ASSERT_EQ(hit->triangle, met.triangle);
    ASSERT_NEAR(hit->depth, met.depth, 1e-9);
    figure::SpaceVector at{};
    for (std::size_t c = 0; c < 3; ++c)
      at = figure::sum(at, surface.vertices[surface.triangles[hit->triangle][c]], hit->weights[c]);
    ASSERT_NEAR(at[0], x, 1e-9);
    ASSERT_NEAR(at[1], y, 1e-9);
    EXPECT_FALSE(rays.hides({x, y, met.depth}));
    EXPECT_TRUE(rays.hides({x, y, met.depth - 1e-3}));
  }
  EXPECT_GT(met_count, 1000);
  EXPECT_GT(missed, 100);
}

/// No ray goes through between the triangles of a sphere, even along its edges.
TEST_F(Rays, LeaveNoGaps) {
  const figure::RayCaster rays = figure::RayCaster::over({seen(sphere(16))}).value();
  for (int i = -90; i <= 90; ++i) {
    for (int j = -90; j <= 90; ++j) {
      const double x = i * 0.01, y = j * 0.01;
      if (std::hypot(x, y) > 0.95) continue;
      const std::optional<figure::RayHit> hit = rays.first_hit(x, y);
      ASSERT_TRUE(hit.has_value()) << x << ' ' << y;
      EXPECT_NEAR(hit->depth, std::sqrt(1 - x * x - y * y), 0.05);
    }
  }
}

/// Rays through vertices, which several triangles hold alike, find the same one in any order.
TEST_F(Rays, DoNotDependOnTheOrderOfTriangles) {
  const figure::SeenSurface surface =
      figure::seen_surface(torus(60, 0.4), figure::ParallelView(0, 90));
  figure::SeenSurface shuffled = surface;
  std::mt19937 random(4);
  std::shuffle(shuffled.triangles.begin(), shuffled.triangles.end(), random);
  const figure::RayCaster rays = figure::RayCaster::over({surface}).value();
  const figure::RayCaster others = figure::RayCaster::over({shuffled}).value();
  int met = 0, different = 0;
  for (const figure::SpaceVector& vertex : surface.vertices) {
    const auto hit = rays.first_hit(vertex[0], vertex[1]);
    const auto other = others.first_hit(vertex[0], vertex[1]);
    ASSERT_EQ(hit.has_value(), other.has_value());
    if (!hit) continue;
    ++met;
    if (surface.triangles[hit->triangle] != shuffled.triangles[other->triangle]) ++different;
  }
  EXPECT_GT(met, 7000);
  EXPECT_EQ(different, 0);
}

TEST_F(Rays, ShowTheEarlierOfEqualSurfaces) {
  const figure::SmoothSurface surface = saddle(10);
  figure::SmoothSurface nearer = surface;
  for (figure::SpaceVector& vertex : nearer.vertices) vertex[0] += 0.1;
  const figure::RayCaster rays =
      figure::RayCaster::over({seen(surface), seen(surface), seen(nearer), figure::SeenSurface{}})
          .value();
  const figure::RayCaster equal =
      figure::RayCaster::over({figure::SeenSurface{}, seen(surface), seen(surface)}).value();
  int met = 0;
  for (double y = -0.94; y < 1; y += 0.06) {
    for (double z = -0.4; z < 0.4; z += 0.03) {
      const std::optional<figure::RayHit> hit = rays.first_hit(y, z), other = equal.first_hit(y, z);
      if (!hit || !other) continue;
      EXPECT_EQ(hit->surface, 2u);
      EXPECT_EQ(other->surface, 1u);
      ++met;
    }
  }
  EXPECT_GT(met, 100);
}

/// A square plate before a segment that is longer: both ends are seen, to 1/100 of a point.
TEST_F(Rays, CutLinesWhereTheyAreHidden) {
  const figure::SmoothSurface plate = sampled_surface(3, 3, [](double s, double t) -> SurfacePoint {
    return {{0, s - 0.5, t - 0.5}, {1, 0, 0}};
  });
  const figure::RayCaster rays = figure::RayCaster::over({seen(plate)}).value();
  const figure::FramePlacement place({{-1, 1}, {-1, 1}}, {0, 0, 200, 200});
  const figure::SpaceCurve behind = {{-0.9, 0.1, -1}, {0.0, 0.1, -1}, {0.9, 0.1, -1}};
  const figure::DrawnCurves drawn = figure::drawn_curves({behind}, rays, place);
  ASSERT_EQ(drawn.visible.size(), 2u);
  ASSERT_EQ(drawn.hidden.size(), 1u);
  EXPECT_NEAR(drawn.visible[0].back()[0], 50, 0.01);
  EXPECT_NEAR(drawn.visible[1].front()[0], 150, 0.01);
  EXPECT_EQ(drawn.visible[0].back(), drawn.hidden[0].front());
  EXPECT_EQ(drawn.hidden[0].size(), 2u);  // its middle point is on the line
  for (const double depth : {1.0, 0.0}) {
    const figure::SpaceCurve before = {{-0.9, 0.1, depth}, {0.9, 0.1, depth}};
    const figure::DrawnCurves whole = figure::drawn_curves({before}, rays, place);
    EXPECT_EQ(whole.visible.size(), 1u);
    EXPECT_TRUE(whole.hidden.empty());
  }
}

/// A strip of 1/10 point before the line is none that an eye could see.
TEST_F(Rays, CutNoSpecksOutOfLines) {
  const auto strip = [](double width) {
    return sampled_surface(1, 1, [width](double s, double t) -> SurfacePoint {
      return {{0, width * (s - 0.5), t - 0.5}, {1, 0, 0}};
    });
  };
  const figure::FramePlacement place({{-1, 1}, {-1, 1}}, {0, 0, 200, 200});
  figure::SpaceCurve line;
  for (int i = -500; i <= 500; ++i) line.push_back({i * 0.0005, 0.1, -0.2});
  for (const double width : {0.001, 0.01}) {
    const figure::RayCaster rays = figure::RayCaster::over({seen(strip(width))}).value();
    const figure::DrawnCurves drawn =
        figure::drawn_curves({line, figure::SpaceCurve(3, line[0])}, rays, place);
    EXPECT_EQ(drawn.visible.size(), width < 0.002 ? 1u : 2u);
    EXPECT_EQ(drawn.hidden.size(), width < 0.002 ? 0u : 1u);
  }
}

TEST_F(Rays, MeetNothingWhereThereIsNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  figure::SmoothSurface bad = sphere(4);
  for (figure::SpaceVector& vertex : bad.vertices) vertex[1] = nan;
  for (const auto& surfaces : {std::vector<figure::SeenSurface>{},
                               {figure::SeenSurface{}},
                               {seen(bad)},
                               {seen(figure::SmoothSurface{})}}) {
    const Result<figure::RayCaster> rays = figure::RayCaster::over(surfaces);
    ASSERT_TRUE(rays.ok());
    EXPECT_FALSE(rays->first_hit(0, 0).has_value());
    EXPECT_FALSE(rays->hides({0, 0, -10}));
  }
  EXPECT_FALSE(figure::RayCaster::over({seen(sphere(4))})->first_hit(nan, 0).has_value());
}

TEST(RaysWithoutEmbree, AreAnError) {
  if (figure::rays_available()) GTEST_SKIP() << "built with Embree";
  const Result<figure::RayCaster> rays = figure::RayCaster::over({seen(sphere(4))});
  ASSERT_FALSE(rays.ok());
  EXPECT_NE(rays.error().text().find("casts no rays"), std::string::npos);
}

TEST(SeenSurface, LeavesOutWhatCannotBeDrawn) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  figure::SmoothSurface surface;
  surface.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {nan, 0, 0}, {1, 1, 1}, {0, 1e200, 0}};
  surface.normals = {{0, 0, 2}, {0, 0, 5}, {0, 0, 1}, {0, 0, 1}, {0, 0, 0}, {0, 0, 1}};
  surface.triangles = {{0, 1, 2}, {0, 1, 3},  {0, 1, 4}, {0, 1, 5},
                       {0, 1, 6}, {-1, 1, 2}, {2, 1, 0}};
  EXPECT_EQ(seen(surface).triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}, {2, 1, 0}}));
  surface.normals[1] = {0, infinity, 0};
  EXPECT_TRUE(seen(surface).triangles.empty());
  surface.normals.pop_back();
  surface.normals.resize(2);
  EXPECT_TRUE(seen(surface).triangles.empty());
}

TEST(ParallelView, TurnsSpace) {
  const figure::ParallelView view(30, 40);
  const figure::SpaceVector a = {0.3, -1, 2}, b = {1, 0.5, 0.25};
  EXPECT_NEAR(figure::dot(view.seen(a), view.seen(b)), figure::dot(a, b), 1e-14);
  const figure::SpaceVector turned = figure::cross(view.seen(a), view.seen(b)),
                            same = view.seen(figure::cross(a, b));
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(turned[c], same[c], 1e-14);
  EXPECT_NEAR(view.seen({0, 0, 1})[0], 0, 1e-15);  // up is up
  EXPECT_GT(view.seen({0, 0, 1})[1], 0);
  const figure::FramePlacement place({{-1, 3}, {0, 1}}, {10, 20, 100, 100});
  EXPECT_NEAR(place.page({-1, 0, 7})[0], 10, 1e-12);
  EXPECT_NEAR(place.page({3, 0.5, 7})[1], 70, 1e-12);
  EXPECT_NEAR(place.seen(place.page({0.3, 0.4, 0}))[1], 0.4, 1e-14);
}

}  // namespace
}  // namespace limn::test
