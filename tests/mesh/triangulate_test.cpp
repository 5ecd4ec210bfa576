/// Polygons cut into triangles: random simple polygons of several kinds, and what cannot be cut
/// well.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>

#include "limn/mesh/mesh.h"
#include "limn/mesh/polygon/triangulate.h"
#include "random_mesh.h"

namespace limn::test {
namespace {

double norm(Point3 p) { return std::sqrt(dot(p, p)); }

Point3 vector_area_of(const std::vector<Point3>& points) {
  Point3 sum;
  for (std::size_t k = 0; k < points.size(); ++k)
    sum = sum + 0.5 * cross(points[k] - points[0], points[(k + 1) % points.size()] - points[0]);
  return sum;
}

Polygons one_face(const std::vector<Point3>& points) {
  Polygons mesh;
  mesh.positions = points;
  for (Index v = 0; v < mesh.vertex_count(); ++v) mesh.corners.push_back(v);
  mesh.face_begin.push_back(mesh.vertex_count());
  return mesh;
}

std::vector<Point3> corners_of(const Polygons& mesh, Index face) {
  std::vector<Point3> points;
  for (Index c = mesh.face_begin[face]; c < mesh.face_begin[face + 1]; ++c)
    points.push_back(mesh.positions[static_cast<std::size_t>(mesh.corners[c])]);
  return points;
}

struct Seen {
  double total = 0;   ///< of the areas, each as it is
  double least = 0;   ///< the least of the triangles, seen along the polygon's normal
  double wanted = 0;  ///< the polygon's
  std::size_t count = 0, gave_up = 0;
};

/// What the triangles of one polygon are; the triangles fit together and have the polygon as their
/// boundary.
Seen cut(const std::vector<Point3>& points) {
  const Polygons mesh = one_face(points);
  const mesh::Triangulation result = mesh::triangulate(mesh).value();
  const Point3 area = vector_area_of(points);
  Seen seen{0, HUGE_VAL, norm(area), 0, result.gave_up.size()};
  for (Index f = 0; f < result.polygons.face_count(); ++f) {
    const Point3 part = vector_area_of(corners_of(result.polygons, f));
    seen.total += norm(part);
    seen.least = std::min(seen.least, dot(part, area) / seen.wanted);
    ++seen.count;
  }
  const Mesh built = Mesh::build(result.polygons).value();
  EXPECT_EQ(built.edge_count(), static_cast<Index>(2 * points.size()) - 3);
  EXPECT_EQ(euler_characteristic(built), 1);
  return seen;
}

/// That the triangles tile the polygon.
void expect_tiled(const std::vector<Point3>& points, double tolerance = 1e-12) {
  const Seen seen = cut(points);
  EXPECT_EQ(seen.count, points.size() - 2);
  EXPECT_EQ(seen.gave_up, 0U);
  EXPECT_GT(seen.least, 0);
  EXPECT_NEAR(seen.total, seen.wanted, tolerance * seen.wanted);
}

/// A turn and a shift in space, of points of a plane.
std::vector<Point3> placed(const std::vector<mesh::Point2>& points, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Point3 u{normal(random), normal(random), normal(random)};
  Point3 v{normal(random), normal(random), normal(random)};
  u = (1 / norm(u)) * u;
  v = v - dot(u, v) * u;
  v = (1 / norm(v)) * v;
  const Point3 origin{normal(random), normal(random), normal(random)};
  std::vector<Point3> result;
  result.reserve(points.size());
  for (const mesh::Point2& p : points) result.push_back(origin + p.x * u + p.y * v);
  return result;
}
std::vector<Point3> flat(const std::vector<mesh::Point2>& points) {
  std::vector<Point3> result;
  result.reserve(points.size());
  for (const mesh::Point2& p : points) result.push_back({p.x, p.y, 0.5});
  return result;
}

/// A star-shaped polygon: any radii at sorted angles.
std::vector<mesh::Point2> star_shaped(std::mt19937& random, int corners) {
  std::uniform_real_distribution<double> radius(0.05, 1), jitter(0, 0.9);
  std::vector<mesh::Point2> points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * (k + jitter(random)) / corners, r = radius(random);
    points.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return points;
}

/// The outline of cells of a square grid that form a tree: with many collinear corners, and places
/// where it touches itself. Its area is the number of cells.
std::vector<mesh::Point2> tree_of_cells(std::mt19937& random, int wanted) {
  using Cell = std::pair<int, int>;
  const Cell steps[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  const auto neighbours = [&](const std::set<Cell>& cells, Cell c) {
    int count = 0;
    for (const Cell& d : steps) count += cells.count({c.first + d.first, c.second + d.second}) > 0;
    return count;
  };
  std::set<Cell> cells{{0, 0}};
  std::vector<Cell> list{{0, 0}};
  for (int tries = 0; tries < 20 * wanted && static_cast<int>(list.size()) < wanted; ++tries) {
    Cell c = list[random() % list.size()];
    const Cell d = steps[random() % 4];
    c = {c.first + d.first, c.second + d.second};
    if (cells.count(c) > 0 || neighbours(cells, c) != 1) continue;
    cells.insert(c);
    list.push_back(c);
  }
  // Round the tree with the cells on the left: at a side of a cell, the next is met by turning
  // right first within the tree.
  std::vector<mesh::Point2> outline;
  Cell at = *std::min_element(list.begin(), list.end(), [](Cell a, Cell b) {
    return std::pair(a.second, a.first) < std::pair(b.second, b.first);
  });
  const Cell start = at;
  int side = 0;  // below, on the right, above, on the left of the cell: walked counterclockwise
  const Cell outward[4] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  const Cell corner[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  do {
    outline.push_back({static_cast<double>(at.first + corner[side].first),
                       static_cast<double>(at.second + corner[side].second)});
    side = (side + 1) % 4;
    for (;;) {  // into the neighbour on this side, and on along its side before this one
      const Cell beyond{at.first + outward[side].first, at.second + outward[side].second};
      if (cells.count(beyond) == 0) break;
      at = beyond;
      side = (side + 3) % 4;
    }
  } while (at != start || side != 0);
  return outline;
}

/// A comb: teeth whose tips lie in the gaps of another comb, for long thin ears.
std::vector<mesh::Point2> comb(int teeth) {
  std::vector<mesh::Point2> points;
  for (int k = 0; k < teeth; ++k) {
    points.push_back({static_cast<double>(k), 0});
    points.push_back({k + 0.5, 1000});
  }
  points.push_back({static_cast<double>(teeth), 0});
  points.push_back({static_cast<double>(teeth), -1});
  points.push_back({0, -1});
  std::reverse(points.begin(), points.end());
  return points;
}

std::vector<mesh::Point2> spiral(int corners) {
  std::vector<mesh::Point2> outer, inner;
  for (int k = 0; k < corners / 2; ++k) {
    const double angle = 40 * std::numbers::pi * k / corners, r = 3 + angle;
    outer.push_back({r * std::cos(angle), r * std::sin(angle)});
    inner.push_back({(r - 2) * std::cos(angle), (r - 2) * std::sin(angle)});
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return outer;
}

TEST(Triangulate, AConcaveQuadIsCutAtItsReflexCorner) {
  // from the first corner the areas would be 8 and -4
  const Polygons mesh = one_face({{0, 4, 0}, {0, 0, 0}, {4, 0, 0}, {1, 1, 0}});
  const mesh::Triangulation result = mesh::triangulate(mesh).value();
  EXPECT_TRUE(result.gave_up.empty());
  expect_tiled(mesh.positions);
  EXPECT_NEAR(cut(mesh.positions).total, 4, 1e-15);
  for (Index f = 0; f < 2; ++f)
    EXPECT_NEAR(vector_area_of(corners_of(result.polygons, f)).z, 2, 1e-15);
}

TEST(Triangulate, TwoFacesThatShareBothEdgesOfAVertexAreCutFromThere) {
  // the quads 0 1 2 3 and 2 1 0 4 meet along 0 1 2; their diagonals 0 2 would be one edge of four
  Polygons mesh;
  mesh.positions = {{0, 0, 0}, {1, 0.2, 0}, {2, 0, 0}, {1, 2, 0}, {1, -2, 0}};
  for (const std::vector<Index>& second : {std::vector<Index>{2, 1, 0, 4}, {0, 4, 2, 1}}) {
    mesh.corners = {0, 1, 2, 3};
    mesh.corners.insert(mesh.corners.end(), second.begin(), second.end());
    mesh.face_begin = {0, 4, 8};
    const Result<mesh::Triangulation> cut = mesh::triangulate(mesh);
    ASSERT_TRUE(cut.ok());
    EXPECT_EQ(cut->polygons.face_count(), 4);
    EXPECT_TRUE(Mesh::build(cut->polygons).ok());
  }
}

TEST(Triangulate, KeepsFansWhereTheyAreRight) {
  std::vector<Point3> round;
  round.reserve(9);
  for (int k = 0; k < 9; ++k) round.push_back({std::cos(0.7 * k), std::sin(0.7 * k), 0.1 * k});
  const mesh::Triangulation result = mesh::triangulate(one_face(round)).value();
  for (Index f = 0; f < 7; ++f)
    EXPECT_EQ(faces_of(result.polygons)[static_cast<std::size_t>(f)],
              (std::vector<Index>{0, f + 1, f + 2}));
}

RC_GTEST_PROP(TriangulateLaws, StarShapedPolygonsAreTiled, (unsigned seed)) {
  std::mt19937 random(seed);
  const std::vector<mesh::Point2> points = star_shaped(random, 4 + static_cast<int>(random() % 60));
  expect_tiled(flat(points));
  expect_tiled(placed(points, random));
  RC_ASSERT(!testing::Test::HasFailure());
}

RC_GTEST_PROP(TriangulateLaws, OutlinesOfCellsAreTiled, (unsigned seed)) {
  std::mt19937 random(seed);
  const std::vector<mesh::Point2> points =
      tree_of_cells(random, 2 + static_cast<int>(random() % 40));
  if (points.size() < 4) return;
  expect_tiled(flat(points));
  expect_tiled(placed(points, random), 1e-9);
  RC_ASSERT(!testing::Test::HasFailure());
}

RC_GTEST_PROP(TriangulateLaws, EveryStartAndBothDirections, (unsigned seed)) {
  std::mt19937 random(seed);
  std::vector<Point3> points = placed(star_shaped(random, 12), random);
  for (std::size_t k = 0; k < points.size(); ++k) {
    std::rotate(points.begin(), points.begin() + 1, points.end());
    expect_tiled(points);
  }
  std::reverse(points.begin(), points.end());
  expect_tiled(points);
  RC_ASSERT(!testing::Test::HasFailure());
}

RC_GTEST_PROP(TriangulateLaws, NearlyPlanarPolygonsAreTiledAsSeenInTheirPlane, (unsigned seed)) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> height(-0.05, 0.05);
  std::vector<Point3> points = flat(star_shaped(random, 20));
  for (Point3& p : points) p.z += height(random);
  const Seen seen = cut(points);
  RC_ASSERT(seen.gave_up == 0U);
  RC_ASSERT(seen.least > 0);
}

TEST(Triangulate, RepeatedAndCollinearCorners) {
  // a square with middles of its sides, one corner twice, started at a middle
  const std::vector<Point3> points = {{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {2, 2, 0},
                                      {1, 2, 0}, {0, 2, 0}, {0, 1, 0}, {0, 0, 0}};
  for (std::size_t start = 0; start < points.size(); ++start) {
    std::vector<Point3> turned = points;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(start), turned.end());
    const Seen seen = cut(turned);
    EXPECT_EQ(seen.gave_up, 0U);
    EXPECT_NEAR(seen.total, 4, 1e-14);
    EXPECT_EQ(seen.least, 0) << "the edge between the two equal corners lies in one triangle";
    int flat_ones = 0;
    const mesh::Triangulation result = mesh::triangulate(one_face(turned)).value();
    for (Index f = 0; f < result.polygons.face_count(); ++f)
      flat_ones += norm(vector_area_of(corners_of(result.polygons, f))) == 0;
    EXPECT_EQ(flat_ones, 1) << start;
  }
}

TEST(Triangulate, ASlitToAHoleIsNoCrossing) {
  const std::vector<Point3> points = {{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}, {0, 0, 0},
                                      {2, 2, 0}, {2, 4, 0}, {4, 4, 0}, {4, 2, 0}, {2, 2, 0}};
  for (std::size_t start = 0; start < points.size(); ++start) {
    std::vector<Point3> turned = points;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(start), turned.end());
    expect_tiled(turned);
    EXPECT_NEAR(cut(turned).total, 32, 1e-13);
  }
}

TEST(Triangulate, SaysWhereItGaveUp) {
  // a bow tie whose halves are not the same, a polygon on a line, one in a point, and a good one
  Polygons mesh = make_polygons(16, {{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10, 11}, {12, 13, 14, 15}});
  mesh.positions = {{0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {1, 2, 0}, {0, 0, 0}, {1, 1, 1},
                    {2, 2, 2}, {3, 3, 3}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1},
                    {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const mesh::Triangulation result = mesh::triangulate(mesh).value();
  EXPECT_EQ(result.gave_up, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(result.face_of, (std::vector<Index>{0, 0, 1, 1, 2, 2, 3, 3}));
  MeshSource source;
  source.file = "m.obj";
  source.first = 1;
  source.face_lines = {17, 18, 19, 20};
  const Warnings warnings = mesh::warnings_of(result, source);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].text(),
            "m.obj:17: 3 faces cross themselves or have no area (the first is 1): their triangles "
            "overlap or are degenerate (faces count from 1, as in the file)");
  EXPECT_EQ(mesh::source_of(result, source).file_faces, result.face_of);
}

TEST(Triangulate, AnyScaleAndPlace) {
  for (const double scale : {1e-300, 1e-150, 1.0, 1e150, 1e300}) {
    std::vector<Point3> points = {{0, 4, 1}, {0, 0, 1}, {4, 0, 1}, {1, 1, 1}};
    for (Point3& p : points) p = scale * p;
    const mesh::Triangulation result = mesh::triangulate(one_face(points)).value();
    EXPECT_TRUE(result.gave_up.empty()) << scale;
    EXPECT_EQ(faces_of(result.polygons)[0], (std::vector<Index>{3, 0, 1})) << scale;
  }
  std::vector<Point3> far = {{0, 4, 0}, {0, 0, 0}, {4, 0, 0}, {1, 1, 0}};
  for (Point3& p : far) p = p + Point3{1e12, -1e12, 3e11};
  expect_tiled(far);
}

TEST(Triangulate, RefusesWhatIsTooLargeBeforeItLooksAtIt) {
  Polygons huge;
  huge.face_begin = {0, 1000000000};  // 3 · (10^9 - 2) corners of triangles
  const Result<mesh::Triangulation> result = mesh::triangulate(huge);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().message, "2^31 - 1 corners or more");
  EXPECT_THROW((void)triangulated(huge), std::length_error);
  huge.face_begin = {0, 9, 3};
  EXPECT_FALSE(mesh::triangulate(huge).ok());
}

double seconds_to_cut(const std::vector<mesh::Point2>& points) {
  const Polygons mesh = one_face(flat(points));
  const auto start = std::chrono::steady_clock::now();
  const mesh::Triangulation result = mesh::triangulate(mesh).value();
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_TRUE(result.gave_up.empty());
  double total = 0;
  for (Index f = 0; f < result.polygons.face_count(); ++f)
    total += norm(vector_area_of(corners_of(result.polygons, f)));
  const double wanted = norm(vector_area_of(mesh.positions));
  EXPECT_NEAR(total, wanted, 1e-9 * wanted);
  return seconds;
}

TEST(Triangulate, LargePolygonsTakeNoTime) {
  std::mt19937 random(7);
  const int corners = 100000;
  EXPECT_LT(seconds_to_cut(star_shaped(random, corners)), 10);
  EXPECT_LT(seconds_to_cut(tree_of_cells(random, corners / 2)), 10);
  EXPECT_LT(seconds_to_cut(comb(corners / 2)), 10);
  EXPECT_LT(seconds_to_cut(spiral(corners)), 10);
}

}  // namespace
}  // namespace limn::test
