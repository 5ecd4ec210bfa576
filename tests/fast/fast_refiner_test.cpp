// The refiner itself, and what is special on triangles.

#include "fast/families.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

std::vector<std::string> quick_schemes() {
  std::vector<std::string> names;
  for (const std::string& name : shipped_schemes())
    if (shipped(name).split->name == "triangle-dyadic") names.push_back(name);
  return names;
}

class FastEngine : public testing::TestWithParam<std::string> {};

/// The plain engine makes the first step only where rules look past a control edge.
TEST_P(FastEngine, LeavesAtMostOneStepToThePlainEngine) {
  const Scheme& scheme = shipped(GetParam());
  for (const Mesh& mesh :
       {icosahedron(), mesh::star(Lattice::triangle, 6, 2), mesh::fan(Lattice::triangle, 1, 2)})
    EXPECT_LE(expect_same(scheme, mesh, 3, 1), 1);
}

INSTANTIATE_TEST_SUITE_P(Schemes, FastEngine, testing::ValuesIn(quick_schemes()),
                         [](const auto& info) { return test_name(info.param); });

Scheme parsed(const std::string& rules) { return rules_on("triangle-dyadic", rules); }

TEST(FastEngineRules, MayLookFar) {
  const Scheme scheme = parsed(kWideTriangles);
  for (const Index n : {3, 5, 6, 7, 9})
    for (const Index rings : {1, 2, 3}) {
      EXPECT_LT(expect_same(scheme, mesh::star(Lattice::triangle, n, rings), 4, 2), 4);
      EXPECT_LT(expect_same(scheme, mesh::fan(Lattice::triangle, n - 2, rings), 4, 2), 4);
    }
}

/// Where the end's rule applies at regular vertices, an edge depends on whether an end is on the
/// boundary, however near its stencil stays.
TEST(FastEngineRules, MayDependOnAnEdgesEnds) {
  for (const std::string rule :
       {"when = \"n == 6\"\nself = \"1/2\"\nring = \"1/(2*n) + cos(2*pi*k/n)/12\"\n",
        "when = \"n < 7\"\nself = 1\n"}) {
    const Scheme scheme = parsed("extends = \"loop\"\n[[edge-end]]\n" + rule);
    for (unsigned seed = 0; seed < 30; ++seed)
      expect_same(scheme, RandomMesh(seed).triangles(), static_cast<int>(1 + seed % 4), seed);
    for (const Index faces : {1, 2, 3, 4, 6})
      EXPECT_LT(expect_same(scheme, mesh::fan(Lattice::triangle, faces, 2), 3, 2), 3);
  }
}

TEST(FastRefinerOf, EvaluatesOftenWithOneScratch) {
  const Mesh mesh = icosahedron();
  const FastRefiner refiner = FastRefiner::make(shipped("loop"), mesh, 4).value();
  FastRefiner::Scratch<float> scratch;
  for (unsigned seed = 0; seed < 3; ++seed) {
    const std::vector<Point3> points = random_points(mesh.vertex_count(), seed);
    std::vector<float> fine(3 * static_cast<std::size_t>(refiner.vertex_count()));
    refiner.evaluate<float>(as_numbers<float>(points), fine, scratch);
    EXPECT_EQ(fine, evaluate<float>(refiner, points));
  }
}

/// A not-a-number reaches the points whose stencils have it, and no others.
TEST(FastRefinerOf, PassesNotANumberOn) {
  const Mesh mesh = mesh::torus(Lattice::triangle, 9, 9);
  const Scheme& scheme = shipped("loop");
  std::vector<Point3> points = random_points(mesh.vertex_count(), 1);
  points[40].y = std::nan("");
  const FastRefiner refiner = FastRefiner::make(scheme, mesh, 2).value();
  const std::vector<Point3> quick = as_points(evaluate<double>(refiner, points));
  const auto plain = refine::refine(scheme, mesh, points, 2).value();
  const auto broken = [](const Point3& p) { return std::isnan(p.y); };
  EXPECT_EQ(std::count_if(quick.begin(), quick.end(), broken),
            std::count_if(plain.values.begin(), plain.values.end(), broken));
  EXPECT_TRUE(std::none_of(quick.begin(), quick.end(),
                           [](const Point3& p) { return std::isnan(p.x) || std::isnan(p.z); }));
}

TEST(FastRefinerOf, RefusesWhatThePlainEngineRefuses) {
  const Scheme& loop = shipped("loop");
  expect_same(loop, cube(), 2, 1);
  expect_same(loop, icosahedron(), -1, 1);
  expect_same(loop, icosahedron(), 40, 1);
  expect_same(shipped("box-spline-triangle"), tetrahedron(), 2, 1);
  const Scheme closed = parsed("[vertex]\nself = 1\n[edge]\nend = \"1/2\"\n");
  expect_same(closed, icosahedron(), 2, 1);
  expect_same(closed, mesh::fan(Lattice::triangle, 3, 2), 2, 1);
  EXPECT_FALSE(FastRefiner::make(loop, icosahedron(), 40).ok());
  EXPECT_FALSE(FastRefiner::make(closed, mesh::fan(Lattice::triangle, 3, 2), 2).ok());
}

TEST(FastRefine, IsTheRefinerInOneCall) {
  const Mesh mesh = RandomMesh(3).triangles();
  const std::vector<Point3> points = random_points(mesh.vertex_count(), 1);
  const Polygons polygons = fast_refine(shipped("loop"), mesh, points, 3).value();
  const FastRefiner refiner = FastRefiner::make(shipped("loop"), mesh, 3).value();
  EXPECT_EQ(polygons.positions, as_points(evaluate<double>(refiner, points)));
  std::vector<Index> corners(3 * static_cast<std::size_t>(refiner.face_count()));
  refiner.write_faces(corners);
  EXPECT_EQ(polygons.corners, corners);
  EXPECT_TRUE(Mesh::build(polygons).ok());
}

}  // namespace
}  // namespace limn::test
