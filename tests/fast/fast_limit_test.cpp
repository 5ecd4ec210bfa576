// Limit points by the quick engine, beside those that the plain way finds on the same refined mesh.

#include "fast/fast_limit_check.h"
#include "mesh/random_mesh.h"
#include "support/mutants.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

enum class Quick { same, none, fails };

/// Whether there is a quick limit; if so, it is compared.
Quick quick_limit(const Scheme& scheme, const Mesh& control, int levels) {
  const FastRefiner refiner = FastRefiner::make(scheme, control, levels).value();
  const std::vector<Point3> points = random_points(control.vertex_count(), 4);
  LimitOptions options;
  options.steps_made = levels;
  const auto limit = approx_fast_limit(scheme, refiner);
  if (!limit) {  // as of a vertex of two faces
    const auto plain = refine::refine(scheme, control, points, levels).value();
    EXPECT_FALSE(approx_limit_points(scheme, plain.mesh, plain.values, options).ok());
    return Quick::fails;
  }
  if (!*limit) return Quick::none;
  const std::vector<Point3> values = as_points(evaluate<double>(refiner, points));
  const Mesh fine = Mesh::build(refined_polygons(refiner, values)).value();
  const LimitPoints expected = approx_limit_points(scheme, fine, values, options).value();
  expect_limit<double>(refiner, **limit, points, expected, 1e-11, 1e-8);
  expect_limit<float>(refiner, **limit, points, expected, 1e-5, 1e-2);
  return Quick::same;
}

bool expect_same_limit(const Scheme& scheme, const Mesh& control, int levels) {
  return quick_limit(scheme, control, levels) == Quick::same;
}

class FastLimit : public testing::TestWithParam<std::string> {};

/// … to the last digits: weights that sum to 1 still do so as the engine keeps them.
TEST_P(FastLimit, OfOnePointIsThatPoint) {
  const Scheme& scheme = shipped(GetParam());
  const Mesh mesh = mesh::torus(scheme.split->lattice, 4, 5);
  const std::vector<Point3> points(static_cast<std::size_t>(mesh.vertex_count()), {1, 2, 3});
  const FastRefiner refiner = FastRefiner::make(scheme, mesh, 3).value();
  const auto found = approx_fast_limit_mesh(scheme, refiner, points).value();
  if (!found) GTEST_SKIP() << "no quick limit at this level";
  for (const Point3& p : found->limit) {
    EXPECT_NEAR(p.x, 1, 1e-14);
    EXPECT_NEAR(p.z, 3, 1e-14);
  }
}

TEST_P(FastLimit, IsThePlainOne) {
  const Scheme& scheme = shipped(GetParam());
  for (unsigned seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    RandomMesh random(seed);
    const Mesh mesh =
        scheme.split->lattice == Lattice::triangle ? random.triangles() : random.polygons();
    const auto levels = static_cast<int>(seed % 4);
    const Quick found = quick_limit(scheme, mesh, levels);
    if (levels == 3) EXPECT_NE(found, Quick::none);
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, FastLimit,
                         testing::Values("loop", "optimal-low", "laplacian-loop", "loop-7-flat",
                                         "butterfly", "butterfly-modified", "laplacian-butterfly",
                                         "interpolating-loop", "catmull-clark"),
                         [](const auto& info) { return test_name(info.param); });

TEST(FastLimitOf, IsThereForLoopOnBodies) {
  for (const Mesh& mesh : {tetrahedron(), icosahedron(), mesh::torus(Lattice::triangle, 4, 5),
                           mesh::fan(Lattice::triangle, 5, 2), mesh::star(Lattice::triangle, 9, 2)})
    for (int levels = 0; levels <= 3; ++levels)
      EXPECT_TRUE(expect_same_limit(shipped("loop"), mesh, levels));
  const Scheme& quads = shipped("catmull-clark");
  for (const Mesh& mesh : {cube(), icosahedron(), mesh::torus(Lattice::quad, 4, 5), band(5, 2)})
    for (int levels = 0; levels <= 3; ++levels)
      if (mesh.uniform_degree() == 4 || levels > 0)
        EXPECT_TRUE(expect_same_limit(quads, mesh, levels));
  // at a boundary vertex of six faces the normal is the sum of theirs
  for (const int levels : {0, 2})
    EXPECT_TRUE(expect_same_limit(shipped("loop"), mesh::fan(Lattice::triangle, 6, 1), levels));
  // at a corner of one face the normal is that face's
  EXPECT_TRUE(expect_same_limit(quads, mesh::fan(Lattice::quad, 5, 2), 2));
}

/// Sums over two rings and more: zones reach into patches.
TEST(FastLimitOf, IsThereFromSmallLevelsOnWhereSumsLookFar) {
  for (const char* name : {"butterfly", "butterfly-modified", "laplacian-butterfly",
                           "interpolating-loop", "loop-7-flat"}) {
    SCOPED_TRACE(name);
    const Scheme& scheme = shipped(name);
    for (const Mesh& mesh : {icosahedron(), mesh::torus(Lattice::triangle, 4, 5)})
      for (const int levels : {2, 3}) EXPECT_TRUE(expect_same_limit(scheme, mesh, levels));
    EXPECT_TRUE(expect_same_limit(scheme, mesh::star(Lattice::triangle, 9, 2), 2));
    // round corners of one face the sides see each other
    for (const Index faces : {1, 2, 5, 7})
      EXPECT_TRUE(expect_same_limit(scheme, mesh::fan(Lattice::triangle, faces, 1), 3));
  }
}

/// Sides look across the quad that they share, and the boundary's edges beyond its corners.
TEST(FastLimitOf, IsThereForQuadsWhereRulesLookFarther) {
  int wide = 0;
  for (const RuleMutant& mutant : rule_mutants(shipped("catmull-clark"))) {
    if (mutant.change.find("new role opposite") == std::string::npos &&
        mutant.change.find("new role beyond") == std::string::npos)
      continue;
    SCOPED_TRACE(mutant.change);
    ++wide;
    for (const Mesh& mesh : {cube(), mesh::torus(Lattice::quad, 3, 4), band(5, 1),
                             mesh::fan(Lattice::quad, 1, 1), mesh::fan(Lattice::quad, 5, 1)})
      EXPECT_TRUE(expect_same_limit(mutant.scheme, mesh, 3));
  }
  EXPECT_EQ(wide, 4);
}

TEST(FastLimitOf, HasTheSameBitsOnOneThreadAndMany) {
  expect_same_limit_bits(shipped("butterfly-modified"), mesh::star(Lattice::triangle, 9, 3), 4);
}

}  // namespace
}  // namespace limn::test
