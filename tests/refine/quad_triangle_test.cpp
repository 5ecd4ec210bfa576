// Stam and Loop's scheme, for triangles and quads in one mesh: against lists of faces, against
// Loop's and Catmull and Clark's schemes where it is theirs, and what it is on either lattice.

#include <gtest/gtest.h>

#include <cmath>

#include "limn/refine/refine.h"
#include "limn/regular/regular_mask.h"
#include "limn/scheme/scope.h"
#include "mesh/random_mesh.h"
#include "support/quad_triangle_reference.h"
#include "support/random_points.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

const std::string kName = "quad-triangle";

void expect_near(const std::vector<Point3>& a, const std::vector<Point3>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT(distance(a[i], b[i]), 1e-13) << i;
}

std::vector<Point3> step(const Scheme& scheme, const Mesh& mesh,
                         const std::vector<Point3>& points) {
  const auto fine = refine::refine<Point3>(scheme, mesh, points, 1);
  EXPECT_TRUE(fine.ok()) << fine.error().text();
  return fine ? fine->values : std::vector<Point3>();
}

/// So many levels, by lists of faces.
void expect_as_reference(const Mesh& control, int levels, unsigned seed) {
  const Scheme& scheme = shipped(kName);
  const std::vector<Point3> points = random_points(control.vertex_count(), seed);
  const auto fine = refine::refine<Point3>(scheme, control, points, levels);
  ASSERT_TRUE(fine.ok()) << fine.error().text();
  for (double Point3::*which : {&Point3::x, &Point3::y, &Point3::z}) {
    std::vector<double> values;
    for (const Point3& p : points) values.push_back(p.*which);
    Mesh mesh = control;
    for (int level = 0; level < levels; ++level) {
      values = quad_triangle_reference_step(mesh, values);
      mesh = scheme.split->apply(mesh, level).mesh;
    }
    ASSERT_EQ(values.size(), fine->values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      ASSERT_NEAR(fine->values[i].*which, values[i], 1e-13) << seed << ' ' << i;
  }
}

TEST(QuadTriangle, IsTheStepOnListsOfFacesOnRandomMeshes) {
  Index seams = 0, open = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = RandomMesh(seed).mixed();
    expect_as_reference(mesh, 2, seed);
    seams += mesh.uniform_degree() == 0 ? 1 : 0;
    open += mesh.has_boundary() ? 1 : 0;
  }
  EXPECT_GT(seams, 20);
  EXPECT_GT(open, 5);
}

TEST(QuadTriangle, IsTheStepOnListsOfFacesOnSmallMeshes) {
  for (const Mesh& mesh : {tetrahedron(), cube(), icosahedron(), pillow(3), pillow(4), pillow(7)})
    expect_as_reference(mesh, 2, 1);
}

TEST(QuadTriangle, HasTheMasksOfLoopsAndCatmullAndClarksSchemes) {
  EXPECT_EQ(regular_mask(shipped(kName + "-on-triangles"))->coefficients,
            regular_mask(shipped("loop"))->coefficients);
  EXPECT_EQ(regular_mask(shipped(kName + "-on-quads"))->coefficients,
            regular_mask(shipped("catmull-clark"))->coefficients);
}

TEST(QuadTriangle, IsLoopsOrCatmullAndClarksWhereAllIsRegular) {
  const Mesh triangles = mesh::torus(Lattice::triangle, 5, 4),
             quads = mesh::torus(Lattice::quad, 5, 4);
  const std::vector<Point3> points = random_points(triangles.vertex_count(), 3);
  expect_near(step(shipped(kName), triangles, points), step(shipped("loop"), triangles, points));
  expect_near(step(shipped(kName), quads, points), step(shipped("catmull-clark"), quads, points));
}

/// On a mesh of one kind, whatever its valences.
TEST(QuadTriangle, IsWhatItIsOnEitherLattice) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    for (const auto& [end, mesh] : {std::pair{"-on-triangles", RandomMesh(seed).triangles()},
                                    {"-on-quads", random_quads(seed)}}) {
      const std::vector<Point3> points = random_points(mesh.vertex_count(), seed);
      const auto one = refine::refine<Point3>(shipped(kName), mesh, points, 2);
      const auto other = refine::refine<Point3>(shipped(kName + end), mesh, points, 2);
      ASSERT_TRUE(one.ok() && other.ok());
      EXPECT_EQ(one->values, other->values) << seed << end;
      EXPECT_EQ(snapshot(one->mesh), snapshot(other->mesh)) << seed << end;
    }
  }
}

/// One vertex at a time, from what it depends on alone.
TEST(QuadTriangle, GivesSomeVerticesAsItGivesAll) {
  const Scheme& scheme = shipped(kName);
  for (unsigned seed = 0; seed < 12; ++seed) {
    const Mesh mesh = RandomMesh(seed).mixed();
    const Births births = scheme.split->apply(mesh, 0).births;
    refine::RuleTables<double> tables(scheme);
    ASSERT_TRUE(tables.prepare(mesh, births).ok());
    const std::vector<Point3> points = random_points(mesh.vertex_count(), seed);
    const std::vector<Point3> all = refine::refine_values(scheme, mesh, births, tables, points);
    for (std::size_t i = 0; i < all.size(); i += 5) {
      const auto some = refine::refine_values_at(scheme, mesh, births, tables, points,
                                                 {static_cast<Index>(i), 0, static_cast<Index>(i)});
      EXPECT_EQ(some, (std::vector<Point3>{all[i], all[0], all[i]})) << seed << ' ' << i;
    }
  }
}

/// With their own weights at vertices of one kind, also extraordinary ones.
TEST(QuadTriangle, IsLoopsOrCatmullAndClarksWithTheirOwnWeights) {
  Scheme own = shipped(kName);
  ASSERT_TRUE(set_parameter(own, "own=1").ok());
  for (unsigned seed = 0; seed < 20; ++seed) {
    for (const auto& [name, mesh] :
         {std::pair{"loop", RandomMesh(seed).triangles()}, {"catmull-clark", random_quads(seed)}}) {
      const std::vector<Point3> points = random_points(mesh.vertex_count(), seed);
      const auto theirs = refine::refine<Point3>(shipped(name), mesh, points, 2);
      if (!theirs) continue;  // it has no rule at valence 2
      const auto ours = refine::refine<Point3>(own, mesh, points, 2);
      ASSERT_TRUE(ours.ok()) << ours.error().text();
      expect_near(ours->values, theirs->values);
    }
  }
}

/// Twice two averagings: the second pair smooths what the first has made.
TEST(QuadTriangle, MaySmoothTwice) {
  Scheme twice = shipped(kName);
  twice.stages->count = 4;
  const auto mask = [](const Scheme& scheme) { return regular_mask(scheme)->coefficients; };
  Scheme spline = shipped("b-spline-quad");
  ASSERT_TRUE(set_parameter(spline, "degree=5").ok());
  EXPECT_EQ(mask(scheme::lattice_schemes(twice)[1]), mask(spline));
  const Mesh mesh = RandomMesh(7).mixed();
  const std::vector<Point3> ones(static_cast<std::size_t>(mesh.vertex_count()), {1, 1, 1});
  for (const Point3& p : step(twice, mesh, ones)) EXPECT_LT(distance(p, {1, 1, 1}), 1e-14);
}

TEST(QuadTriangle, IsRefusedWhereOneLatticeIsAskedFor) {
  const Result<Mask> mask = regular_mask(shipped(kName));
  ASSERT_FALSE(mask.ok());
  EXPECT_NE(mask.error().message.find("no single lattice"), std::string::npos);
}

TEST(QuadTriangle, TakesNoSharpness) {
  const Status sharp =
      refine::check_takes_sharpness(shipped(kName), {{}, {kInfinitelySharp}, {}, {}});
  ASSERT_FALSE(sharp.ok());
  EXPECT_NE(sharp.error().message.find("sequence of averagings"), std::string::npos);
}

}  // namespace
}  // namespace limn::test
