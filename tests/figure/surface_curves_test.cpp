#include "limn/figure/space/surface_curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <optional>
#include <random>
#include <set>

#include "limn/figure/space/reflection_line_panel.h"
#include "sample_fields.h"
#include "sample_surfaces.h"

namespace limn::test {
namespace {

constexpr double kPi = std::numbers::pi;
const figure::ParallelView kFromX(0, 0);         // right, up and near are y, z and x
const figure::ParallelView kFromAbove(-90, 90);  // right, up and near are x, y and z

double length_in_space(const std::vector<figure::SpaceCurve>& curves) {
  double result = 0;
  for (const figure::SpaceCurve& curve : curves)
    for (std::size_t i = 1; i < curve.size(); ++i)
      result += figure::length(figure::sum(curve[i], curve[i - 1], -1));
  return result;
}

/// On the unit sphere, with L to the right and light line θ from the eye upwards, the reflection
/// line is where, with y = ρ sin a and z = ρ cos a, (1 − x²) sin(2a − θ) + x² sin θ = 0: from
/// tan θ = r_y / r_z with r = 2 z (x, y, z) − (0, 0, 1).
TEST(ReflectionLine, OfASphereIsThatOfTheFormula) {
  const figure::SeenSurface surface = figure::seen_surface(sphere(120), kFromX);
  const figure::MirroredLights lights({}, kFromX);
  ASSERT_EQ(lights.count(), 48);
  for (int line = 0; line < 48; ++line) {
    const double theta = 2 * kPi * (line + 0.5) / 48;
    const std::vector<figure::SpaceCurve> curves = figure::reflection_line(surface, lights, line);
    ASSERT_FALSE(curves.empty());
    double highest = -1, farthest = 0;
    for (const figure::SpaceCurve& curve : curves) {
      for (const auto& [x, y, z] : curve) {
        const double a = std::atan2(y, z);
        ASSERT_NEAR((1 - x * x) * std::sin(2 * a - theta) + x * x * std::sin(theta), 0, 2e-3);
        ASSERT_GT((2 * z * y) * std::sin(theta) + (2 * z * z - 1) * std::cos(theta), -2e-3);
        if (std::abs(x) < 0.02 && z > 0) highest = std::max(highest, y);
        farthest = std::max(farthest, std::abs(x));
      }
    }
    // In the middle the normal halves the angle: y = sin(θ/2), of the light above the viewer.
    if (line < 23) EXPECT_NEAR(highest, std::sin(theta / 2), 2e-3) << line;
    EXPECT_GE(farthest, std::sqrt(0.5) - 1e-2);  // where the mirror shows L itself
  }
}

/// The lines in front of the sphere are seen and those behind are not.
TEST(ReflectionLine, OfASphereIsHiddenBehind) {
  if (!figure::rays_available()) GTEST_SKIP() << "built without Embree";
  const figure::SeenSurface surface = figure::seen_surface(sphere(60), kFromX);
  const figure::RayCaster rays = figure::RayCaster::over({surface}).value();
  const figure::FramePlacement place({{-1, 1}, {-1, 1}}, {0, 0, 400, 400});
  const figure::MirroredLights lights({.count = 20}, kFromX);
  for (int line = 0; line < 20; ++line) {
    const std::vector<figure::SpaceCurve> curves = figure::reflection_line(surface, lights, line);
    double before = 0, behind = 0;
    for (const figure::SpaceCurve& curve : curves) {
      for (std::size_t i = 1; i < curve.size(); ++i) {
        const figure::PagePoint a = place.page(curve[i - 1]), b = place.page(curve[i]);
        (curve[i - 1][2] + curve[i][2] > 0 ? before : behind) +=
            std::hypot(b[0] - a[0], b[1] - a[1]);
      }
    }
    const figure::DrawnCurves drawn = figure::drawn_curves(curves, rays, place);
    EXPECT_NEAR(length_of(drawn.visible), before, 0.01 * before + 2);
    EXPECT_NEAR(length_of(drawn.hidden), behind, 0.01 * behind + 2);
    EXPECT_GT(before, 100);
  }
}

/// z = s x + a y² + b max(x, 0)^p: C¹ across x = 0 for p = 2, C² for p = 3.
figure::SeenSurface join(double s, double a, double b, int p) {
  const auto field = [=](double x, double y) {
    const double m = std::max(x, 0.0);
    return figure::SpaceVector{s * x + a * y * y + b * std::pow(m, p),
                               s + b * p * std::pow(m, p - 1), 2 * a * y};
  };
  return figure::seen_surface(height_surface(160, field), kFromAbove);
}

/// Change of dy/dx at x = 0, from chords of length 0.05; none if the curve does not cross.
std::optional<std::array<double, 2>> kink(const figure::SpaceCurve& curve) {
  constexpr double h = 0.05;
  const auto y_at = [&](double x) -> std::optional<double> {
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const figure::SpaceVector &p = curve[i - 1], &q = curve[i];
      if ((p[0] <= x) != (q[0] <= x)) return p[1] + (x - p[0]) / (q[0] - p[0]) * (q[1] - p[1]);
    }
    return std::nullopt;
  };
  const auto left = y_at(-h), middle = y_at(0), right = y_at(h);
  if (!left || !middle || !right) return std::nullopt;
  return std::array{*middle, (*right - 2 * *middle + *left) / h};
}

/// A line is where T (1 − fx² − fy²) + 2 fy = 0, so dy/dx = T fx fxx / ((1 − T fy) fyy).
TEST(ReflectionLine, HasAKinkWhereCurvatureJumps) {
  constexpr double s = 0.5, a = 0.4, b = 0.4;
  const figure::MirroredLights lights({.count = 60}, kFromAbove);
  int met = 0;
  double largest = 0;
  for (int line = 0; line < 60; ++line) {
    for (const figure::SpaceCurve& curve :
         figure::reflection_line(join(s, a, b, 2), lights, line)) {
      const auto found = kink(curve);
      if (!found) continue;
      const auto [y, change] = *found;
      const double fy = 2 * a * y, t = -2 * fy / (1 - s * s - fy * fy);
      const double expected = t * s * (2 * b) / ((1 - t * fy) * 2 * a);
      EXPECT_NEAR(change, expected, 0.05 * std::abs(expected) + 0.01) << y;
      largest = std::max(largest, std::abs(change));
      ++met;
    }
    for (const figure::SpaceCurve& curve : figure::reflection_line(join(s, a, b, 3), lights, line))
      if (const auto found = kink(curve)) EXPECT_LT(std::abs((*found)[1]), 0.05);
  }
  EXPECT_GT(met, 15);
  EXPECT_GT(largest, 0.3);
}

/// How far the places of a coarse sphere's lines are from light lines by interpolated normals.
double worst_turn(const figure::SeenSurface& surface, const figure::SeenSurface& drawn) {
  const figure::RayCaster rays = figure::RayCaster::over({surface}).value();
  const figure::MirroredLights lights({.count = 12}, kFromX);
  double worst = 0;
  for (int line = 0; line < 12; ++line) {
    for (const figure::SpaceCurve& curve : figure::reflection_line(drawn, lights, line)) {
      for (const figure::SpaceVector& at : curve) {
        const auto hit = rays.first_hit(at[0], at[1]);
        if (!hit || std::hypot(at[0], at[1]) > 0.45 || std::abs(hit->depth - at[2]) > 1e-3)
          continue;
        figure::SpaceVector normal{};
        for (std::size_t c = 0; c < 3; ++c)
          normal = figure::sum(normal, surface.normals[surface.triangles[hit->triangle][c]],
                               hit->weights[c]);
        const double turn = lights.turn(figure::MirroredLights::mirrored(normal));
        worst = std::max(worst, std::abs(turn - std::round(turn)));
      }
    }
  }
  return worst;
}

TEST(ReflectionLine, OfCoarseTrianglesFollowsInterpolatedNormals) {
  if (!figure::rays_available()) GTEST_SKIP() << "built without Embree";
  const figure::SeenSurface coarse = figure::seen_surface(sphere(6), kFromX);
  const figure::SeenSurface fine = figure::refined_for_mirror(coarse, 3e-4);
  EXPECT_GT(fine.triangles.size(), 4 * coarse.triangles.size());
  EXPECT_GT(worst_turn(coarse, coarse), 0.1);
  EXPECT_LT(worst_turn(coarse, fine), 0.01);
}

TEST(ReflectionLine, RefinementKeepsASphereClosedAndItsArea) {
  const auto area = [](const figure::SeenSurface& surface) {
    double result = 0;
    for (const auto& [i, j, k] : surface.triangles) {
      const figure::SpaceVector& a = surface.vertices[i];
      result += figure::length(figure::cross(figure::sum(surface.vertices[j], a, -1),
                                             figure::sum(surface.vertices[k], a, -1))) /
                2;
    }
    return result;
  };
  const figure::SeenSurface coarse = figure::seen_surface(sphere(7), figure::ParallelView(20, 35));
  for (const double tolerance : {1e-1, 1e-2, 1e-3}) {
    const figure::SeenSurface fine = figure::refined_for_mirror(coarse, tolerance);
    EXPECT_NEAR(area(fine), area(coarse), 1e-9);
    std::set<std::pair<int, int>> sides;
    for (const std::array<int, 3>& t : fine.triangles)
      for (std::size_t c = 0; c < 3; ++c) EXPECT_TRUE(sides.emplace(t[c], t[(c + 1) % 3]).second);
    for (const auto& [i, j] : sides) EXPECT_TRUE(sides.contains({j, i}));
  }
}

/// On a plane the mirror shows one direction only; on a cylinder along L, straight lines.
TEST(ReflectionLine, OfSimpleSurfaces) {
  const figure::MirroredLights lights({.count = 30}, kFromAbove);
  const auto flat = [](double, double) { return figure::SpaceVector{0.0, 0.0, 0.0}; };
  const auto cylinder = [](double, double y) { return figure::SpaceVector{0.5 * y * y, 0.0, y}; };
  const figure::SeenSurface plane = figure::seen_surface(height_surface(8, flat), kFromAbove);
  const figure::SeenSurface tube = figure::seen_surface(height_surface(40, cylinder), kFromAbove);
  for (int line = 0; line < 30; ++line) {
    EXPECT_TRUE(figure::reflection_line(plane, lights, line).empty());
    for (const figure::SpaceCurve& curve : figure::reflection_line(tube, lights, line)) {
      EXPECT_NEAR(std::abs(curve.back()[0] - curve.front()[0]), 2, 1e-9);
      for (const figure::SpaceVector& at : curve) EXPECT_NEAR(at[1], curve.front()[1], 1e-9);
    }
  }
}

TEST(LightLines, AreOddlyGivenAndStillDrawn) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const figure::SpaceVector& direction :
       {figure::SpaceVector{0, 0, 0}, {nan, 0, 0}, {1e-300, 0, 0}, {0, 0, 1}}) {
    for (const int count : {-5, 0, 1, 1 << 30}) {
      const figure::MirroredLights lights({.direction = direction, .count = count}, kFromAbove);
      EXPECT_GE(lights.count(), 1);
      EXPECT_LE(lights.count(), 10000);
      const auto [along, across] = lights.half_plane(0);
      EXPECT_NEAR(figure::length(along), 1, 1e-12);
      EXPECT_NEAR(figure::length(across), 1, 1e-12);
      EXPECT_NEAR(lights.turn(along), 0, 1e-9 * lights.count());
    }
  }
}

/// The outline of a sphere is a great circle, of an open surface also its boundary.
TEST(Outlines, AreThoseOfTheShape) {
  const std::vector<figure::SpaceCurve> circle =
      figure::outlines(figure::seen_surface(sphere(60), kFromX));
  for (const figure::SpaceCurve& curve : circle)
    for (const figure::SpaceVector& at : curve) EXPECT_NEAR(std::hypot(at[0], at[1]), 1, 2e-3);
  const std::vector<figure::SpaceCurve> square =
      figure::outlines(figure::seen_surface(saddle(20), kFromAbove));
  ASSERT_EQ(square.size(), 1u);
  EXPECT_EQ(square[0].size(), 81u);
  EXPECT_EQ(square[0].front(), square[0].back());
}

TEST(Joined, MakesLongCurvesOfShuffledSegments) {
  std::vector<figure::SpaceSegment> segments;
  const auto add = [&](int i, int j) {
    segments.push_back({i, j, {double(i), 0, 0}, {double(j), 0, 0}});
    if ((i + j) % 4 == 1) std::swap(segments.back().from, segments.back().to);
    if ((i + j) % 4 == 1) std::swap(segments.back().a, segments.back().b);
  };
  for (int i = 0; i < 10; ++i) add(i, i + 1);                        // open
  for (int i = 0; i < 7; ++i) add(20 + i, 20 + (i + 1) % 7);         // closed
  for (int i = 0; i < 3; ++i) add(40, 41 + i), add(41 + i, 51 + i);  // three arms of a star
  const double total = 10 + 12 + (1 + 2 + 3) + 3 * 10;
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    std::shuffle(segments.begin(), segments.end(), random);
    std::vector<figure::SpaceCurve> curves = figure::joined(segments);
    std::vector<std::size_t> sizes;
    for (const figure::SpaceCurve& curve : curves) sizes.push_back(curve.size());
    std::sort(sizes.begin(), sizes.end());
    EXPECT_EQ(sizes, (std::vector<std::size_t>{3, 3, 3, 8, 11}));
    EXPECT_NEAR(length_in_space(curves), total, 1e-12);
  }
  EXPECT_TRUE(figure::joined({}).empty());
}

TEST(Simplified, StaysNear) {
  figure::Polyline line;
  for (int i = 0; i <= 1000; ++i) line.push_back({i * 0.1, 20 * std::sin(i * 0.02)});
  const figure::Polyline simple = figure::simplified(line, 0.05);
  EXPECT_LT(simple.size(), 150u);
  EXPECT_EQ(simple.front(), line.front());
  EXPECT_EQ(simple.back(), line.back());
  for (const auto& [x, y] : line) {
    double nearest = 1e9;
    for (std::size_t i = 1; i < simple.size(); ++i) {
      const auto [ax, ay] = simple[i - 1];
      const auto [bx, by] = simple[i];
      if (x < ax || x > bx) continue;
      const double off = std::abs((bx - ax) * (y - ay) - (by - ay) * (x - ax));
      nearest = std::min(nearest, off / std::hypot(bx - ax, by - ay));
    }
    EXPECT_LE(nearest, 0.05 + 1e-12);
  }
  EXPECT_EQ(figure::simplified({{0, 0}, {1, 0}, {2, 0}}, 0.01), (figure::Polyline{{0, 0}, {2, 0}}));
  EXPECT_EQ(figure::simplified({{0, 0}, {5, 5}, {0, 0}}, 0.01).size(), 3u);  // closed
}

/// Each line's curves among all lines' are those that it has alone.
TEST(ReflectionLines, OfAllLightsAreThoseOfEach) {
  for (const figure::SmoothSurface& shape : {torus(12, 0.4), saddle(7), sphere(9)}) {
    const figure::SeenSurface surface = figure::seen_surface(shape, figure::ParallelView(20, 35));
    for (const int count : {1, 2, 3, 48, 301}) {
      for (const std::optional<figure::SpaceVector>& direction :
           {std::optional<figure::SpaceVector>(),
            std::optional(figure::SpaceVector{0.3, 1, 0.5})}) {
        const figure::MirroredLights lights({.direction = direction, .count = count},
                                            figure::ParallelView(20, 35));
        const auto all = figure::reflection_lines(surface, lights);
        ASSERT_EQ(all.size(), static_cast<std::size_t>(count));
        for (int line = 0; line < count; ++line)
          ASSERT_EQ(all[static_cast<std::size_t>(line)],
                    figure::reflection_line(surface, lights, line))
              << count << ' ' << line;
      }
    }
  }
}

TEST(ReflectionLines, HaveAboutTheLengthThatIsForeseen) {
  for (const figure::SmoothSurface& shape : {torus(60, 0.4), saddle(30), sphere(40)}) {
    const figure::ParallelView view(20, 35);
    const figure::SeenSurface surface = figure::seen_surface(shape, view);
    const figure::MirroredLights lights({.count = 60}, view);
    double length = 0;
    for (const auto& line : figure::reflection_lines(surface, lights))
      for (const figure::SpaceCurve& curve : line)
        for (std::size_t i = 1; i < curve.size(); ++i)
          length += std::hypot(curve[i][0] - curve[i - 1][0], curve[i][1] - curve[i - 1][1]);
    EXPECT_NEAR(figure::approx_line_length(surface, lights), length, 0.08 * length);
    const figure::MirroredLights twice({.count = 120}, view);
    EXPECT_NEAR(figure::approx_line_length(surface, twice),
                2 * figure::approx_line_length(surface, lights), 1e-6 * length);
  }
  EXPECT_NEAR(figure::seen_area(figure::seen_surface(sphere(60), figure::ParallelView(0, 0))),
              2 * std::numbers::pi, 0.01);
}

TEST(ReflectionLines, AreRefusedWhereTheyCannotBeToldApart) {
  figure::SurfaceScene scene = {.surfaces = {sphere(40)}};
  EXPECT_TRUE(figure::check_lights(scene, {.count = 100}, 400).ok());
  const Status refused = figure::check_lights(scene, {.count = 10000}, 400);
  ASSERT_FALSE(refused.ok());
  const std::string hint = refused.error().hint;
  const int most = std::stoi(hint.substr(hint.rfind(' ') + 1));
  EXPECT_GT(most, 200);
  EXPECT_LT(most, 1000);
  EXPECT_TRUE(figure::check_lights(scene, {.count = most}, 400).ok());
  EXPECT_FALSE(figure::check_lights(scene, {.count = most + 1}, 400).ok());
  EXPECT_TRUE(figure::check_lights({}, {.count = 10000}, 400).ok());
}

}  // namespace
}  // namespace limn::test
