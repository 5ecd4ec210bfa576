#include "limn/mesh/surface_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "limn/base/parallel.h"

namespace limn {
namespace {

constexpr double kPi = 3.14159265358979323846;

double length(const Point3& a) { return std::sqrt(dot(a, a)); }

void add_face(Polygons& mesh, std::initializer_list<Index> corners) {
  mesh.corners.insert(mesh.corners.end(), corners);
  mesh.face_begin.push_back(static_cast<Index>(mesh.corners.size()));
}

/// Rings of latitude; poles are single vertices.
Polygons sphere(double radius, Point3 centre, int rings) {
  Polygons mesh;
  const int round = 2 * rings;
  mesh.positions.push_back(centre + Point3{0, 0, radius});
  for (int i = 1; i < rings; ++i)
    for (int j = 0; j < round; ++j) {
      const double u = kPi * i / rings, v = 2 * kPi * j / round;
      mesh.positions.push_back(centre + radius * Point3{std::sin(u) * std::cos(v),
                                                        std::sin(u) * std::sin(v), std::cos(u)});
    }
  mesh.positions.push_back(centre + Point3{0, 0, -radius});
  const auto at = [&](int i, int j) { return 1 + (i - 1) * round + j % round; };
  for (int j = 0; j < round; ++j) add_face(mesh, {0, at(1, j), at(1, j + 1)});
  for (int i = 1; i + 1 < rings; ++i)
    for (int j = 0; j < round; ++j)
      add_face(mesh, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  const Index south = mesh.vertex_count() - 1;
  for (int j = 0; j < round; ++j) add_face(mesh, {south, at(rings - 1, j + 1), at(rings - 1, j)});
  return mesh;
}

/// A square in cells × cells quads, at that height; its far edge lies `slope` higher.
Polygons sheet(double side, double height, int cells, double slope = 0) {
  Polygons mesh;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i)
      mesh.positions.push_back({side * i / cells, side * j / cells, height + slope * i / cells});
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const Index v = j * (cells + 1) + i;
      add_face(mesh, {v, v + 1, v + cells + 2, v + cells + 1});
    }
  return mesh;
}

Polygons random_triangles(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> place(-1, 1), side(-.3, .3);
  Polygons mesh;
  for (Index f = 0; f < count; ++f) {
    const Point3 corner = {place(random), place(random), place(random)};
    for (int c = 0; c < 3; ++c)
      mesh.positions.push_back(corner + Point3{side(random), side(random), side(random)});
    add_face(mesh, {3 * f, 3 * f + 1, 3 * f + 2});
  }
  return mesh;
}

/// Least distance to many points of the triangle: too large by at most `step` · longest side.
double sampled_distance(const Polygons& mesh, const Point3& p, int step) {
  double least = std::numeric_limits<double>::infinity();
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index* const v = &mesh.corners[mesh.face_begin[f]];
    for (int i = 0; i <= step; ++i)
      for (int j = 0; i + j <= step; ++j) {
        const Point3 at = double(i) / step * mesh.positions[v[0]] +
                          double(j) / step * mesh.positions[v[1]] +
                          double(step - i - j) / step * mesh.positions[v[2]];
        least = std::min(least, length(at - p));
      }
  }
  return least;
}

TEST(SurfaceDistance, ParallelSquaresAreApartByTheirOffset) {
  const mesh::SurfaceDistance apart =
      *mesh::approx_surface_distance(sheet(2, 0, 7), sheet(2, .25, 3));
  EXPECT_DOUBLE_EQ(apart.largest, .25);
  EXPECT_NEAR(apart.mean, .25, 1e-15);
  EXPECT_DOUBLE_EQ(apart.diagonal, std::sqrt(4 + 4 + .0625));
  EXPECT_EQ(apart.where[0].z, 0);
  EXPECT_EQ(apart.where[1].z, .25);
  EXPECT_EQ(apart.where[0].x, apart.where[1].x);
  EXPECT_EQ(apart.from_a.size(), 64U);
  EXPECT_EQ(apart.from_b.size(), 16U);
}

TEST(SurfaceDistance, TheMeanIsByArea) {
  // a square of side 1 against the part of side 2 that it covers: the larger one sticks out
  const Polygons small = sheet(1, 0, 40), large = sheet(2, 0, 80);
  const mesh::SurfaceDistance apart = *mesh::approx_surface_distance(small, large);
  EXPECT_NEAR(apart.largest, std::sqrt(2), 1e-14);
  EXPECT_EQ(*std::max_element(apart.from_a.begin(), apart.from_a.end()), 0);
  // over the larger: 2 strips of mean 1/2 and area 1, and a square of mean distance to a corner
  const double corner = (std::sqrt(2) + std::asinh(1)) / 3;
  EXPECT_NEAR(apart.mean, (1 + corner) / 5, 2e-4);
}

TEST(SurfaceDistance, ConcentricSpheresAreApartByTheDifferenceOfRadii) {
  double last = 0;
  for (const int rings : {8, 16, 32}) {
    const mesh::SurfaceDistance apart = *mesh::approx_surface_distance(
        sphere(1, {1, 2, 3}, rings), sphere(1.25, {1, 2, 3}, 2 * rings));
    // a chord lies below its arc by h²/8
    const double off = std::abs(apart.mean - .25);
    EXPECT_LT(off, 1.25 * std::pow(kPi / rings, 2) / 4);
    EXPECT_NEAR(apart.largest, .25, 1.25 * std::pow(kPi / rings, 2) / 4);
    if (last > 0) EXPECT_NEAR(last / off, 4, .8);
    last = off;
  }
}

TEST(SurfaceDistance, IsWhatManyPointsOfEveryTriangleGive) {
  std::mt19937 random(7);
  constexpr int kStep = 60;
  for (int trial = 0; trial < 4; ++trial) {
    const Polygons a = random_triangles(random, 13), b = random_triangles(random, 9);
    const mesh::SurfaceDistance apart = *mesh::approx_surface_distance(a, b);
    double largest = 0;
    for (const auto& [from, to, distances] :
         {std::tuple{&a, &b, &apart.from_a}, std::tuple{&b, &a, &apart.from_b}})
      for (Index v = 0; v < from->vertex_count(); ++v) {
        const double sampled = sampled_distance(*to, from->positions[v], kStep);
        EXPECT_LE((*distances)[v], sampled + 1e-15);
        EXPECT_NEAR((*distances)[v], sampled, 1.1 / kStep);
        largest = std::max(largest, (*distances)[v]);
      }
    EXPECT_DOUBLE_EQ(apart.largest, largest);
    EXPECT_NEAR(length(apart.where[0] - apart.where[1]), largest, 1e-15);
  }
}

TEST(SurfaceDistance, VanishesBetweenASurfaceAndItself) {
  const Polygons ball = sphere(1, {}, 12);
  const mesh::SurfaceDistance none = *mesh::approx_surface_distance(ball, ball);
  EXPECT_LT(none.largest, 1e-15);
  EXPECT_LT(none.mean, 1e-16);
}

TEST(SurfaceDistance, IsSymmetricToTheLastBitOnAnyNumberOfThreads) {
  std::mt19937 random(3);
  for (const bool symmetric : {false, true}) {  // of spheres many gaps are of one size
    const Polygons a = symmetric ? sphere(1, {}, 20) : random_triangles(random, 300);
    const Polygons b = symmetric ? sphere(2, {}, 20) : random_triangles(random, 200);
    const mesh::SurfaceDistance one = *mesh::approx_surface_distance(a, b);
    const mesh::SurfaceDistance other = *mesh::approx_surface_distance(b, a);
    EXPECT_EQ(one.largest, other.largest);
    EXPECT_EQ(one.mean, other.mean);
    EXPECT_EQ(one.diagonal, other.diagonal);
    EXPECT_EQ(one.where[0], other.where[1]);
    EXPECT_EQ(one.where[1], other.where[0]);
    EXPECT_EQ(one.from_a, other.from_b);
    EXPECT_EQ(one.from_b, other.from_a);
    set_thread_limit(1);
    const mesh::SurfaceDistance alone = *mesh::approx_surface_distance(a, b);
    set_thread_limit(0);
    EXPECT_EQ(one.mean, alone.mean);
    EXPECT_EQ(one.where, alone.where);
    EXPECT_EQ(one.from_a, alone.from_a);
  }
}

TEST(SurfaceDistance, GrowsWithTheSurfaces) {
  const mesh::SurfaceDistance plain =
      *mesh::approx_surface_distance(sheet(1, 0, 5), sheet(1, .1, 5, .3));
  for (const double scale : {0x1p-600, 0x1p+600}) {
    Polygons a = sheet(1, 0, 5), b = sheet(1, .1, 5, .3);
    for (Point3& p : a.positions) p = scale * p;
    for (Point3& p : b.positions) p = scale * p;
    const mesh::SurfaceDistance scaled = *mesh::approx_surface_distance(a, b);
    EXPECT_EQ(scaled.largest, scale * plain.largest);
    EXPECT_EQ(scaled.mean, scale * plain.mean);
  }
}

TEST(SurfaceDistance, TakesTrianglesWithoutAnArea) {
  Polygons needle;  // beside a proper triangle far away
  needle.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 9, 0}, {1, 9, 0}, {0, 9, 1}, {5, 5, 5}};
  add_face(needle, {0, 1, 2});
  add_face(needle, {0, 0, 0});
  add_face(needle, {3, 4, 5});
  const mesh::SurfaceDistance apart = *mesh::approx_surface_distance(sheet(.5, 1, 2), needle);
  EXPECT_DOUBLE_EQ(apart.from_a[1], 1);
  EXPECT_TRUE(std::isnan(apart.from_b[6]));  // of no face
  EXPECT_TRUE(std::isfinite(apart.mean));
}

TEST(SurfaceDistance, RefusesWhatIsNoSurface) {
  const Polygons good = sheet(1, 0, 2);
  const auto refused = [&](const Polygons& bad, const std::string& part) {
    for (const bool first : {true, false}) {
      const auto apart = first ? mesh::approx_surface_distance(bad, good)
                               : mesh::approx_surface_distance(good, bad);
      ASSERT_FALSE(apart);
      EXPECT_NE(apart.error().message.find(part), std::string::npos) << apart.error().message;
      EXPECT_NE(apart.error().message.find(first ? "first" : "second"), std::string::npos);
    }
  };
  refused({}, "no area");
  Polygons bad = good;
  bad.positions[3].y = std::nan("");
  refused(bad, "not finite at vertex 3");
  bad.positions[3].y = std::numeric_limits<double>::infinity();
  refused(bad, "not finite at vertex 3");
  bad = good;
  bad.corners[1] = 9;
  refused(bad, "no vertex: 9");
  bad = good;
  for (Point3& p : bad.positions) p = {1, 1, 1};
  refused(bad, "no area");
}

}  // namespace
}  // namespace limn
