// Limit points by the quick engine, beside those that the plain way finds on the same refined mesh.

#include "limn/extraordinary/fast_limit.h"
#include "limn/base/parallel.h"
#include "limn/extraordinary/limit_points.h"
#include "mesh/random_mesh.h"
#include "refine/fast_check.h"
#include "support/mutants.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

/// The refined mesh in the quick engine's order, and its points.
Refined<Point3> refined(const FastRefiner& refiner, const std::vector<Point3>& points) {
  Polygons polygons;
  polygons.positions = as_points(evaluate<double>(refiner, points));
  polygons.corners.resize(static_cast<std::size_t>(refiner.corner_count()));
  refiner.write_faces(polygons.corners);
  polygons.face_begin.resize(static_cast<std::size_t>(refiner.face_count()) + 1);
  refiner.write_face_begin(polygons.face_begin);
  return {Mesh::build(polygons).value(), polygons.positions};
}

template <class Real>
void expect_limit(const FastRefiner& refiner, const FastRefiner::Limit& limit,
                  const std::vector<Point3>& control, const LimitPoints& expected,
                  double tolerance) {
  const std::vector<Real> numbers = as_numbers<Real>(control);
  std::vector<Real> positions(3 * expected.positions.size(), Real(7e7)), normals = positions;
  FastRefiner::Scratch<Real> scratch;
  refiner.evaluate_limit<Real>(limit, numbers, positions, normals, scratch);
  const std::vector<Point3> p = as_points(positions), n = as_points(normals);
  for (std::size_t v = 0; v < p.size(); ++v) {
    EXPECT_LT(distance(p[v], expected.positions[v]), tolerance) << v;
    EXPECT_LT(distance(n[v], expected.normals[v]), 1e3 * tolerance) << v;
  }
}

enum class Quick { same, none, fails };

/// Whether there is a quick limit; if so, it is compared.
Quick quick_limit(const Scheme& scheme, const Mesh& control, int levels) {
  const FastRefiner refiner = FastRefiner::make(scheme, control, levels).value();
  const std::vector<Point3> points = random_points(control.vertex_count(), 4);
  LimitOptions options;
  options.steps_made = levels;
  const auto limit = approx_fast_limit(scheme, refiner);
  if (!limit) {  // as of a vertex of two faces
    const auto plain = refine(scheme, control, points, levels).value();
    EXPECT_FALSE(approx_limit_points(scheme, plain.mesh, plain.values, options).ok());
    return Quick::fails;
  }
  if (!*limit) return Quick::none;
  const Refined<Point3> fine = refined(refiner, points);
  const LimitPoints expected = approx_limit_points(scheme, fine.mesh, fine.values, options).value();
  expect_limit<double>(refiner, **limit, points, expected, 1e-11);
  expect_limit<float>(refiner, **limit, points, expected, 1e-5);
  return Quick::same;
}

bool expect_same_limit(const Scheme& scheme, const Mesh& control, int levels) {
  return quick_limit(scheme, control, levels) == Quick::same;
}

class FastLimit : public testing::TestWithParam<std::string> {};

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
  for (const Mesh& mesh : {tetrahedron(), icosahedron(), torus(Lattice::triangle, 4, 5),
                           fan(Lattice::triangle, 5, 2), star(Lattice::triangle, 9, 2)})
    for (int levels = 0; levels <= 3; ++levels)
      EXPECT_TRUE(expect_same_limit(shipped("loop"), mesh, levels));
  const Scheme& quads = shipped("catmull-clark");
  for (const Mesh& mesh : {cube(), icosahedron(), torus(Lattice::quad, 4, 5), band(5, 2)})
    for (int levels = 0; levels <= 3; ++levels)
      if (mesh.uniform_degree() == 4 || levels > 0)
        EXPECT_TRUE(expect_same_limit(quads, mesh, levels));
  // at a boundary vertex of six faces the normal is the sum of theirs
  for (const int levels : {0, 2})
    EXPECT_TRUE(expect_same_limit(shipped("loop"), fan(Lattice::triangle, 6, 1), levels));
  // at a corner of one face the normal is that face's
  EXPECT_TRUE(expect_same_limit(quads, fan(Lattice::quad, 5, 2), 2));
}

/// Sums over two rings and more: zones reach into patches.
TEST(FastLimitOf, IsThereFromSmallLevelsOnWhereSumsLookFar) {
  for (const char* name : {"butterfly", "butterfly-modified", "laplacian-butterfly",
                           "interpolating-loop", "loop-7-flat"}) {
    SCOPED_TRACE(name);
    const Scheme& scheme = shipped(name);
    for (const Mesh& mesh : {icosahedron(), torus(Lattice::triangle, 4, 5)})
      for (const int levels : {2, 3}) EXPECT_TRUE(expect_same_limit(scheme, mesh, levels));
    EXPECT_TRUE(expect_same_limit(scheme, star(Lattice::triangle, 9, 2), 2));
    // round corners of one face the sides see each other
    for (const Index faces : {1, 2, 5, 7})
      EXPECT_TRUE(expect_same_limit(scheme, fan(Lattice::triangle, faces, 1), 3));
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
    for (const Mesh& mesh : {cube(), torus(Lattice::quad, 3, 4), band(5, 1),
                             fan(Lattice::quad, 1, 1), fan(Lattice::quad, 5, 1)})
      EXPECT_TRUE(expect_same_limit(mutant.scheme, mesh, 3));
  }
  EXPECT_EQ(wide, 4);
}

TEST(FastLimitOf, HasTheSameBitsOnOneThreadAndMany) {
  const Mesh mesh = star(Lattice::triangle, 9, 3);
  const FastRefiner refiner = FastRefiner::make(shipped("butterfly-modified"), mesh, 4).value();
  const auto limit = approx_fast_limit(shipped("butterfly-modified"), refiner).value();
  ASSERT_TRUE(limit);
  const std::vector<float> points = as_numbers<float>(random_points(mesh.vertex_count(), 5));
  std::vector<std::vector<float>> found;
  for (const int threads : {1, 2, 5}) {
    set_thread_limit(threads);
    const auto numbers = 3 * static_cast<std::size_t>(refiner.vertex_count());
    std::vector<float>& positions = found.emplace_back(2 * numbers);
    FastRefiner::Scratch<float> scratch;
    refiner.evaluate_limit<float>(*limit, points, {positions.data(), numbers},
                                  {positions.data() + numbers, numbers}, scratch);
  }
  set_thread_limit(0);
  EXPECT_EQ(found[0], found[1]);
  EXPECT_EQ(found[0], found[2]);
}

}  // namespace
}  // namespace limn::test
