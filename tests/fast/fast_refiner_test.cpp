// The quick engine against the plain one, on every shipped triangle-dyadic scheme.

#include "fast/fast_check.h"
#include "mesh/random_mesh.h"
#include "support/mutants.h"
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

TEST_P(FastEngine, IsThePlainEngineOnRegularBodies) {
  const Scheme& scheme = shipped(GetParam());
  for (const Mesh& mesh : {tetrahedron(), icosahedron(), torus(Lattice::triangle, 3, 4)})
    for (int levels = 0; levels <= 4; ++levels) {
      SCOPED_TRACE(levels);
      expect_same(scheme, mesh, levels, 5);
    }
}

TEST_P(FastEngine, IsThePlainEngineOnRandomMeshes) {
  const Scheme& scheme = shipped(GetParam());
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    expect_same(scheme, RandomMesh(seed).triangles(), static_cast<int>(1 + seed % 4), seed);
  }
}

/// Every valence, in a disc whose boundary has corners and whose inner vertices touch it.
TEST_P(FastEngine, IsThePlainEngineRoundEveryValence) {
  const Scheme& scheme = shipped(GetParam());
  for (const Index n : {3, 4, 5, 7, 8, 12, 30})
    for (const Index rings : {1, 2}) {
      SCOPED_TRACE(n);
      expect_same(scheme, star(Lattice::triangle, n, rings), 3, 3);
      expect_same(scheme, fan(Lattice::triangle, n, rings), 3, 4);
    }
  for (const Index faces : {1, 2}) expect_same(scheme, fan(Lattice::triangle, faces, 1), 4, 6);
}

/// The plain engine makes the first step only where rules look past a control edge.
TEST_P(FastEngine, LeavesAtMostOneStepToThePlainEngine) {
  const Scheme& scheme = shipped(GetParam());
  for (const Mesh& mesh :
       {icosahedron(), star(Lattice::triangle, 6, 2), fan(Lattice::triangle, 1, 2)})
    EXPECT_LE(expect_same(scheme, mesh, 3, 1), 1);
}

INSTANTIATE_TEST_SUITE_P(Schemes, FastEngine, testing::ValuesIn(quick_schemes()),
                         [](const auto& info) { return test_name(info.param); });

Scheme parsed(const std::string& rules) { return rules_on("triangle-dyadic", rules); }

/// Rules that look as far as two rings, at edges' ends too, and differ by valence.
constexpr const char* kWide = R"toml(
[roles.vertex]
straight = "vefefev"

[roles.edge]
over = "evefefev"

[[vertex]]
when = "n == 5"
self = "1/2"
ring = "1/(4*n)"
across = "1/(4*n)"

[[vertex]]
self = "5/8 - 1/16"
ring = "3/(8*n)"
straight = "1/(16*n)"

[edge]
end = "7/16"
wing = "1/16"
outer = "1/64"
over = "-1/64"

[[edge-end]]
when = "n == 7 or n == 6"
self = "5/8"
ring = "(3/8)/n + cos(2*pi*k/n)/(2*n)"

[[boundary.vertex]]
when = "n < 4"
self = "7/8"
next = "1/16"

[[boundary.vertex]]
self = "3/4"
next = "1/8"

[boundary.edge]
end = "9/16"
beyond = "-1/16"
)toml";

TEST(FastEngineRules, MayLookFar) {
  const Scheme scheme = parsed(kWide);
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    expect_same(scheme, RandomMesh(seed).triangles(), static_cast<int>(1 + seed % 4), seed);
  }
  for (const Index n : {3, 5, 6, 7, 9})
    for (const Index rings : {1, 2, 3}) {
      EXPECT_LT(expect_same(scheme, star(Lattice::triangle, n, rings), 4, 2), 4);
      EXPECT_LT(expect_same(scheme, fan(Lattice::triangle, n - 2, rings), 4, 2), 4);
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
      EXPECT_LT(expect_same(scheme, fan(Lattice::triangle, faces, 2), 3, 2), 3);
  }
}

/// Whatever the weights: each mutant moves some of them.
TEST(FastEngineRules, MayHaveAnyWeights) {
  std::mt19937 random(7);
  for (const char* name : {"loop", "laplacian-butterfly", "loop-7-bounded"}) {
    std::vector<RuleMutant> mutants = rule_mutants(shipped(name));
    std::shuffle(mutants.begin(), mutants.end(), random);
    mutants.resize(std::min<std::size_t>(mutants.size(), 25));
    for (const RuleMutant& mutant : mutants) {
      SCOPED_TRACE(std::string(name) + ": " + mutant.change);
      expect_same(mutant.scheme, RandomMesh(random()).triangles(), 3, 1);
      expect_same(mutant.scheme, fan(Lattice::triangle, 7, 2), 2, 1);
    }
  }
}

TEST(FastRefinerOf, GivesTheSameBitsOnOneThreadAndMany) {
  for (const char* name : {"loop", "butterfly-modified"})
    for (const Mesh& mesh : {torus(Lattice::triangle, 40, 41), fan(Lattice::triangle, 9, 20)})
      expect_same_bits(shipped(name), mesh, 3);
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
  const Mesh mesh = torus(Lattice::triangle, 9, 9);
  const Scheme& scheme = shipped("loop");
  std::vector<Point3> points = random_points(mesh.vertex_count(), 1);
  points[40].y = std::nan("");
  const FastRefiner refiner = FastRefiner::make(scheme, mesh, 2).value();
  const std::vector<Point3> quick = as_points(evaluate<double>(refiner, points));
  const auto plain = refine(scheme, mesh, points, 2).value();
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
  expect_same(closed, fan(Lattice::triangle, 3, 2), 2, 1);
  EXPECT_FALSE(FastRefiner::make(loop, icosahedron(), 40).ok());
  EXPECT_FALSE(FastRefiner::make(closed, fan(Lattice::triangle, 3, 2), 2).ok());
}

TEST(FastRefinerOf, TakesMeshesWithoutFaces) {
  for (const char* name : {"loop", "catmull-clark", "sqrt3", "doo-sabin"})
    for (const Index vertices : {0, 3}) expect_to_stay(shipped(name), vertices);
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
