// Limit points by the quick engine, beside those that the plain way finds on the same refined mesh.

#include "limn/extraordinary/fast_limit.h"

#include <cmath>

#include "limn/extraordinary/limit_points.h"
#include "mesh/random_mesh.h"
#include "refine/fast_check.h"
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

/// Whether there is a quick limit; if so, it is compared.
template <class Real>
bool expect_same_limit(const Scheme& scheme, const Mesh& control, int levels, double tolerance) {
  const FastRefiner refiner = FastRefiner::make(scheme, control, levels).value();
  const std::vector<Point3> points = random_points(control.vertex_count(), 4);
  LimitOptions options;
  options.steps_made = levels;
  const auto found = approx_fast_limit(scheme, refiner);
  if (!found) {  // as of a vertex of two faces
    const auto plain = refine(scheme, control, points, levels).value();
    EXPECT_FALSE(approx_limit_points(scheme, plain.mesh, plain.values, options).ok());
    return false;
  }
  const auto& limit = *found;
  if (!limit) return false;
  const Refined<Point3> fine = refined(refiner, points);
  const LimitPoints expected = approx_limit_points(scheme, fine.mesh, fine.values, options).value();
  std::vector<Real> positions(3 * fine.values.size(), Real(7e7)), normals = positions;
  FastRefiner::Scratch<Real> scratch;
  refiner.evaluate_limit<Real>(*limit, as_numbers<Real>(points), positions, normals, scratch);
  const std::vector<Point3> p = as_points(positions), n = as_points(normals);
  for (std::size_t v = 0; v < p.size(); ++v) {
    EXPECT_LT(distance(p[v], expected.positions[v]), tolerance);
    EXPECT_LT(distance(n[v], expected.normals[v]), 1e3 * tolerance) << v;
  }
  return true;
}

class FastLimit : public testing::TestWithParam<std::string> {};

TEST_P(FastLimit, IsThePlainOne) {
  const Scheme& scheme = shipped(GetParam());
  int met = 0;
  for (unsigned seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    RandomMesh random(seed);
    const Mesh mesh =
        scheme.split->lattice == Lattice::triangle ? random.triangles() : random.polygons();
    const int levels = static_cast<int>(1 + seed % 3);
    if (expect_same_limit<double>(scheme, mesh, levels, 1e-11)) ++met;
    expect_same_limit<float>(scheme, mesh, levels, 1e-5);
  }
  RecordProperty("met", met);
}

INSTANTIATE_TEST_SUITE_P(Schemes, FastLimit,
                         testing::Values("loop", "optimal-low", "laplacian-loop", "butterfly",
                                         "catmull-clark"),
                         [](const auto& info) { return test_name(info.param); });

TEST(FastLimitOf, IsThereForLoopOnBodies) {
  for (const Mesh& mesh : {tetrahedron(), icosahedron(), torus(Lattice::triangle, 4, 5),
                           fan(Lattice::triangle, 5, 2), star(Lattice::triangle, 9, 2)})
    for (int levels = 0; levels <= 3; ++levels)
      EXPECT_TRUE(expect_same_limit<double>(shipped("loop"), mesh, levels, 1e-11));
  const Scheme& quads = shipped("catmull-clark");
  for (const Mesh& mesh : {cube(), icosahedron(), torus(Lattice::quad, 4, 5), band(5, 2)})
    for (int levels = 0; levels <= 3; ++levels)
      if (mesh.uniform_degree() == 4 || levels > 0)
        EXPECT_TRUE(expect_same_limit<double>(quads, mesh, levels, 1e-11));
  // at a corner of one face the normal is that face's
  EXPECT_TRUE(expect_same_limit<double>(quads, fan(Lattice::quad, 5, 2), 2, 1e-11));
  // tangents look round the neighbours there
  EXPECT_FALSE(expect_same_limit<double>(shipped("butterfly"), icosahedron(), 2, 1e-11));
}

}  // namespace
}  // namespace limn::test
