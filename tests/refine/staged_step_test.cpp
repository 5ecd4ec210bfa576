// Steps that are sequences of averagings: their masks against the closed form of tensor B-splines,
// their values against lists of faces that are averaged one by one.

#include "limn/refine/staged_step.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "limn/refine/refine.h"
#include "limn/regular/regular_mask.h"
#include "mesh/random_mesh.h"
#include "support/averaging_reference.h"
#include "support/random_points.h"
#include "support/shipped.h"
#include "support/spline_scheme.h"

namespace limn::test {
namespace {

/// Closed, and every vertex extraordinary: an icosahedron with a triangle cut in three, so that
/// valences 3, 5 and 6 of triangles are neighbours.
Mesh crowded() {
  Faces faces = faces_of(polygons_of(icosahedron()));
  const std::vector<Index> cut = faces[0];
  const Index fresh = icosahedron().vertex_count();
  faces.erase(faces.begin());
  for (std::size_t k = 0; k < 3; ++k) faces.push_back({cut[k], cut[(k + 1) % 3], fresh});
  return must_build(fresh + 1, faces);
}

TEST(StagedStep, HasTheMaskOfTheTensorSpline) {
  for (int degree = 2; degree <= 9; ++degree) {
    const Result<Mask> mask = regular_mask(spline_of_degree(degree, degree % 2 == 0 ? "0" : "1/3"));
    ASSERT_TRUE(mask.ok()) << degree << ": " << mask.error().text();
    // 2^{-d} (d + 1 choose i) in either direction
    std::vector<Rational> row{Rational(2)};
    for (int i = 0; i <= degree; ++i) {
      row.emplace_back(0);
      for (std::size_t k = row.size() - 1; k > 0; --k) row[k] = (row[k] + row[k - 1]) / 2;
      row[0] = row[0] / 2;
    }
    ASSERT_EQ(row.size(), static_cast<std::size_t>(degree) + 2);
    Laurent expected;
    for (int i = 0; i <= degree + 1; ++i)
      for (int j = 0; j <= degree + 1; ++j)
        expected[{2 * i - degree - 1, 2 * j - degree - 1}] =
            row[static_cast<std::size_t>(i)] * row[static_cast<std::size_t>(j)];
    EXPECT_EQ(mask->coefficients, expected) << degree;
  }
}

TEST(StagedStep, IsDooAndSabinsOrCatmullAndClarksOnTheLattice) {
  for (const auto& [degree, name] : {std::pair{2, "doo-sabin"}, {3, "catmull-clark"}}) {
    const Scheme scheme = spline_of_degree(degree);
    EXPECT_EQ(scheme.split, shipped(name).split);
    EXPECT_EQ(regular_mask(scheme)->coefficients, regular_mask(shipped(name))->coefficients);
  }
}

std::vector<double> coordinate(const std::vector<Point3>& points, double Point3::*which) {
  std::vector<double> list;
  list.reserve(points.size());
  for (const Point3& p : points) list.push_back(p.*which);
  return list;
}

/// So many levels, by lists of faces.
void expect_same(const Mesh& control, int degree, int stam, int levels, unsigned seed) {
  const Scheme scheme = spline_of_degree(degree, std::to_string(stam));
  const std::vector<Point3> points = random_points(control.vertex_count(), seed);
  const auto fine = refine::refine<Point3>(scheme, control, points, levels);
  ASSERT_TRUE(fine.ok()) << fine.error().text();
  for (double Point3::*which : {&Point3::x, &Point3::y, &Point3::z}) {
    std::vector<double> values = coordinate(points, which);
    Mesh mesh = control;
    for (int level = 0; level < levels; ++level) {
      values = averaging_reference_step(degree, stam, mesh, values);
      mesh = scheme.split->apply(mesh, level).mesh;
    }
    ASSERT_EQ(values.size(), fine->values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      ASSERT_NEAR(fine->values[i].*which, values[i], 1e-13) << degree << ' ' << seed << ' ' << i;
  }
}

TEST(StagedStep, IsTheAveragesOneByOneOnRandomMeshes) {
  for (int degree = 2; degree <= 9; ++degree)
    for (unsigned seed = 0; seed < 25; ++seed) {
      SCOPED_TRACE(seed);
      expect_same(RandomMesh(seed).polygons(), degree, static_cast<int>(seed % 2), 2, seed);
    }
}

TEST(StagedStep, IsTheAveragesOneByOneWhereExtraordinaryVerticesAreNeighbours) {
  for (int degree = 2; degree <= 7; ++degree)
    for (const Mesh& mesh : {crowded(), tetrahedron(), cube(), icosahedron(), pillow(5)})
      for (const int stam : {0, 1})
        expect_same(mesh, degree, stam, 2, static_cast<unsigned>(degree));
}

/// On quads, boundaries included: [Stam2001, §3] chose the weights so.
TEST(StagedStep, IsCatmullAndClarksWithStamsWeights) {
  const Scheme scheme = spline_of_degree(3, "1");
  for (unsigned seed = 0; seed < 30; ++seed) {
    const Mesh mesh = random_quads(seed);
    const std::vector<Point3> points = random_points(mesh.vertex_count(), seed);
    const auto ours = refine::refine<Point3>(scheme, mesh, points, 2);
    const auto theirs = refine::refine<Point3>(shipped("catmull-clark"), mesh, points, 2);
    if (!theirs) continue;  // it has no rule at valence 2
    ASSERT_TRUE(ours.ok()) << ours.error().text();
    ASSERT_EQ(ours->values.size(), theirs->values.size());
    for (std::size_t i = 0; i < ours->values.size(); ++i)
      EXPECT_LT(distance(ours->values[i], theirs->values[i]), 1e-13) << seed << ' ' << i;
  }
}

/// One vertex at a time, from what it depends on alone.
TEST(StagedStep, GivesSomeVerticesAsItGivesAll) {
  for (int degree = 2; degree <= 7; ++degree)
    for (unsigned seed = 0; seed < 12; ++seed) {
      const Mesh mesh = RandomMesh(seed).polygons();
      const Scheme scheme = spline_of_degree(degree);
      const Births births = scheme.split->apply(mesh, 0).births;
      refine::RuleTables<double> tables(scheme);
      ASSERT_TRUE(tables.prepare(mesh, births).ok());
      const std::vector<Point3> points = random_points(mesh.vertex_count(), seed);
      const std::vector<Point3> all = refine::refine_values(scheme, mesh, births, tables, points);
      for (std::size_t i = 0; i < all.size(); i += 7) {
        const auto some =
            refine::refine_values_at(scheme, mesh, births, tables, points,
                                     {static_cast<Index>(i), 0, static_cast<Index>(i)});
        EXPECT_EQ(some, (std::vector<Point3>{all[i], all[0], all[i]})) << degree << ' ' << seed;
      }
    }
}

/// A boundary of odd degree is the uniform B-spline curve of its polygon, whatever is inside.
TEST(StagedStep, HasSplineCurvesForBoundaries) {
  const Mesh mesh = mesh::fan(Lattice::quad, 3, 3);
  for (const int degree : {3, 5, 7}) {
    const Scheme scheme = spline_of_degree(degree);
    const auto fine =
        refine::refine<Point3>(scheme, mesh, random_points(mesh.vertex_count(), 1), 1);
    ASSERT_TRUE(fine.ok());
    std::vector<Point3> polygon, curve;  // along the boundary
    const auto walk = [](const Mesh& along, const std::vector<Point3>& values,
                         std::vector<Point3>& list) {
      const Index first = along.halfedge_of_vertex(0);  // the centre lies on the boundary
      for (Index v = 0;;) {
        list.push_back(values[static_cast<std::size_t>(v)]);
        v = along.target(along.halfedge_of_vertex(v));
        if (v == along.origin(first)) break;
      }
    };
    walk(mesh, random_points(mesh.vertex_count(), 1), polygon);
    walk(fine->mesh, fine->values, curve);
    ASSERT_EQ(curve.size(), 2 * polygon.size());
    const std::size_t n = curve.size();
    std::vector<Point3> expected(n);  // Lane and Riesenfeld's: doubled, then averaged
    for (std::size_t i = 0; i < n; ++i) expected[i] = polygon[i / 2];
    for (int k = 0; k < degree; ++k) {
      std::vector<Point3> means(n);
      for (std::size_t i = 0; i < n; ++i) means[i] = 0.5 * (expected[i] + expected[(i + 1) % n]);
      expected = std::move(means);
    }
    // each mean lies half an edge on
    for (std::size_t i = 0; i < n; ++i)
      EXPECT_LT(
          distance(curve[(i + static_cast<std::size_t>(degree + 1) / 2 + n - 1) % n], expected[i]),
          1e-14)
          << degree << ' ' << i;
  }
}

TEST(StagedStep, FollowsItsParameter) {
  Scheme scheme = shipped("b-spline-quad");
  EXPECT_EQ(scheme.split->name, "quad-dyadic");
  EXPECT_EQ(scheme.stages->count, 2);
  ASSERT_TRUE(set_parameter(scheme, "degree=4").ok());
  EXPECT_EQ(scheme.split->name, "quad-dual");
  EXPECT_EQ(scheme.stages->count, 3);
  for (const auto& [assignment, fault] :
       {std::pair{"degree=5/2", "times = degree - 1, which is 3/2, is no number of averagings"},
        {"degree=10", "degree = 10 is above its range [2, 9]"},
        {"degree=1", "degree = 1 is below its range [2, 9]"},
        {"degree=n", "degree = n is above its range [2, 9] at n = 10"},
        {"degree=sqrt(5)", "times = degree - 1, which is about 1.23607, is no number"}}) {
    const Status status = set_parameter(scheme, assignment);
    ASSERT_FALSE(status.ok()) << assignment;
    EXPECT_NE(status.error().message.find(fault), std::string::npos) << status.error().text();
    EXPECT_EQ(scheme.stages->count, 3);  // nothing is changed
  }
}

TEST(StagedStep, RefusesWhatNeedsRules) {
  const Scheme scheme = spline_of_degree(3);
  const Status sharp = refine::check_takes_sharpness(scheme, {{}, {kInfinitelySharp}, {}, {}});
  ASSERT_FALSE(sharp.ok());
  EXPECT_NE(sharp.error().message.find("sequence of averagings"), std::string::npos);
}

}  // namespace
}  // namespace limn::test
