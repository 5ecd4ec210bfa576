#include "limn/figure/chart/level_sets.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <map>
#include <set>

#include "sample_fields.h"

namespace limn::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

using Point = std::array<double, 2>;

TEST(LevelSets, OfALinearFunctionAreHalvesOfTheRectangle) {
  const figure::TriangleGrid grid = rectangle_grid(7, 4, 3);
  const figure::LevelSets sets(grid, sampled(grid, [](double x, double) { return 2 * x + 1; }));
  for (double x = -0.5; x <= 7.5; x += 0.125) {
    const double inside = std::clamp(7 - x, 0.0, 7.0);
    const std::vector<figure::Polyline> loops = sets.superlevel_loops(2 * x + 1);
    EXPECT_NEAR(area_of(loops), 4 * inside, 1e-12) << x;
    EXPECT_EQ(loops.size(), x <= 6.9 ? 1u : 0u) << x;
    const std::vector<figure::Polyline> lines = sets.contour_lines(2 * x + 1);
    const bool crosses = x > 0 && x < 7;
    EXPECT_EQ(lines.size(), crosses ? 1u : 0u) << x;
    EXPECT_NEAR(length_of(lines), crosses ? 4 : 0, 1e-12) << x;
  }
}

/// The only corners of the region's boundary are its own nodes: all inner sides cancelled.
TEST(LevelSets, TheWholeRegionIsBoundedByItsOutline) {
  const figure::TriangleGrid grid = rectangle_grid(5, 3, 1);
  const std::vector<figure::Polyline> loops = figure::superlevel_loops(
      grid, sampled(grid, [](double x, double y) { return x * y; }), -kInfinity);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].size(), 16u);
  for (const auto& [x, y] : loops[0]) EXPECT_TRUE(x == 0 || x == 5 || y == 0 || y == 3);
  EXPECT_EQ(area_of(loops), 15);
}

TEST(LevelSets, ALevelThroughNodesHasNoDoubleCorners) {
  const figure::TriangleGrid grid = rectangle_grid(6, 6, 5);
  const figure::LevelSets sets(grid, sampled(grid, [](double x, double y) { return x + y; }));
  for (const double level : {1.0, 4.0, 6.0, 9.0}) {
    const std::vector<figure::Polyline> loops = sets.superlevel_loops(level);
    ASSERT_EQ(loops.size(), 1u);
    EXPECT_EQ(std::set<Point>(loops[0].begin(), loops[0].end()).size(), loops[0].size());
    const double cut = level <= 6 ? level * level / 2 : 36 - (12 - level) * (12 - level) / 2;
    EXPECT_NEAR(area_of(loops), 36 - cut, 1e-12);
  }
  EXPECT_TRUE(sets.superlevel_loops(12).empty());  // a single node
  EXPECT_NEAR(area_of(sets.superlevel_loops(0)), 36, 1e-12);
}

TEST(LevelSets, APlateauIsInsideItsOwnLevel) {
  const figure::TriangleGrid grid = rectangle_grid(6, 6, 2);
  const auto height = [](double x, double y) {
    return std::max(std::abs(x - 3), std::abs(y - 3)) <= 1 ? 1.0 : 0.0;
  };
  const figure::LevelSets sets(grid, sampled(grid, height));
  EXPECT_EQ(area_of(sets.superlevel_loops(1)), 4);
  EXPECT_EQ(length_of(sets.contour_lines(1)), 8);
  EXPECT_EQ(area_of(sets.superlevel_loops(0)), 36);
  EXPECT_TRUE(sets.contour_lines(0).empty());
  EXPECT_TRUE(sets.superlevel_loops(1.0000001).empty());
}

TEST(LevelSets, TrianglesAtValuesThatAreNotFiniteAreHoles) {
  for (const double hole : {kNan, kInfinity, -kInfinity}) {
    const figure::TriangleGrid grid = rectangle_grid(6, 6, 4);
    std::vector<double> values = sampled(grid, [](double x, double) { return x; });
    const int node = 3 * 7 + 3;  // (3, 3)
    values[node] = hole;
    double lost = 0;
    for (const auto& t : grid.triangles) lost += std::count(t.begin(), t.end(), node) * 0.5;
    const figure::LevelSets sets(grid, values);
    const std::vector<figure::Polyline> all = sets.superlevel_loops(-kInfinity);
    EXPECT_EQ(all.size(), 2u);  // the outline and the hole
    EXPECT_EQ(area_of(all), 36 - lost);
    EXPECT_EQ(sets.contour_lines(3).size(), 2u);  // on both sides of the hole
  }
  const figure::TriangleGrid grid = rectangle_grid(2, 2);
  const figure::LevelSets none(grid, std::vector<double>(9, kNan));
  EXPECT_TRUE(none.superlevel_loops(-kInfinity).empty());
  EXPECT_TRUE(none.contour_lines(0).empty());
}

TEST(LevelSets, ClockwiseTrianglesAreTurned) {
  figure::TriangleGrid grid = rectangle_grid(4, 4, 6);
  for (std::size_t t = 0; t < grid.triangles.size(); t += 3)
    std::swap(grid.triangles[t][0], grid.triangles[t][1]);
  const auto values = sampled(grid, [](double x, double) { return x; });
  EXPECT_NEAR(area_of(figure::superlevel_loops(grid, values, 1.5)), 10, 1e-12);
}

TEST(LevelSets, ValuesOfTheLargestDoublesKeepPointsFinite) {
  const figure::TriangleGrid grid = rectangle_grid(2, 1);
  const double huge = std::numeric_limits<double>::max();
  const auto values = sampled(grid, [&](double x, double) { return (x - 1) * huge; });
  EXPECT_NEAR(area_of(figure::superlevel_loops(grid, values, 0)), 1, 1e-12);
  EXPECT_NEAR(area_of(figure::superlevel_loops(grid, values, huge / 2)), 0.5, 1e-12);
}

/// Values from a small set, so that levels meet nodes and there are plateaus.
RC_GTEST_PROP(LevelSetsLaws, AreaIsTheSumOverTriangles, ()) {
  const int columns = *rc::gen::inRange(1, 7), rows = *rc::gen::inRange(1, 7);
  const figure::TriangleGrid grid = rectangle_grid(columns, rows, *rc::gen::arbitrary<unsigned>());
  const auto node = rc::gen::map(rc::gen::inRange(-4, 5), [](int i) { return i / 2.0; });
  const auto values = *rc::gen::container<std::vector<double>>(grid.nodes.size(), node);
  const figure::LevelSets sets(grid, values);
  double last = std::numeric_limits<double>::infinity();
  for (double level = -2.25; level <= 2.25; level += 0.25) {
    double expected = 0;
    for (const auto& [i, j, k] : grid.triangles)
      expected += share_above({values[i], values[j], values[k]}, level) / 2;
    const std::vector<figure::Polyline> loops = sets.superlevel_loops(level);
    const double area = area_of(loops);
    RC_ASSERT(std::abs(area - expected) < 1e-9);
    RC_ASSERT(area <= last + 1e-9);
    last = area;
    for (const figure::Polyline& loop : loops) RC_ASSERT(loop.size() >= 3u);
  }
}

/// No side of a loop runs back over another one, exactly: all that can cancel has.
RC_GTEST_PROP(LevelSetsLaws, NoSideIsThereInBothDirections, ()) {
  const figure::TriangleGrid grid = rectangle_grid(5, 5, *rc::gen::arbitrary<unsigned>());
  const auto values =
      *rc::gen::container<std::vector<int>>(grid.nodes.size(), rc::gen::inRange(0, 4));
  const figure::LevelSets sets(grid, std::vector<double>(values.begin(), values.end()));
  for (double level = 0; level <= 3; level += 0.5) {
    std::map<std::pair<Point, Point>, int> sides;
    for (const figure::Polyline& loop : sets.superlevel_loops(level))
      for (std::size_t i = 0; i < loop.size(); ++i) ++sides[{loop[i], loop[(i + 1) % loop.size()]}];
    for (const auto& [side, count] : sides) {
      RC_ASSERT(count == 1);
      RC_ASSERT(sides.count({side.second, side.first}) == 0u);
      RC_ASSERT(side.first != side.second);
    }
  }
}

/// The contour is the superlevel set's boundary less what lies on the rectangle's.
RC_GTEST_PROP(LevelSetsLaws, ContoursAreTheInnerBoundary, ()) {
  const figure::TriangleGrid grid = rectangle_grid(5, 4, *rc::gen::arbitrary<unsigned>());
  const auto values =
      *rc::gen::container<std::vector<int>>(grid.nodes.size(), rc::gen::inRange(0, 9));
  const figure::LevelSets sets(grid, std::vector<double>(values.begin(), values.end()));
  for (const double level : {0.3, 3.0, 4.7, 6.0}) {
    double inner = 0;
    for (figure::Polyline loop : sets.superlevel_loops(level)) {
      loop.push_back(loop.front());
      for (std::size_t i = 1; i < loop.size(); ++i) {
        const auto on = [&](int c, double x) { return loop[i][c] == x && loop[i - 1][c] == x; };
        if (!on(0, 0) && !on(0, 5) && !on(1, 0) && !on(1, 4))
          inner += length_of({{loop[i - 1], loop[i]}});
      }
    }
    RC_ASSERT(std::abs(length_of(sets.contour_lines(level)) - inner) < 1e-9);
  }
}

}  // namespace
}  // namespace limn::test
