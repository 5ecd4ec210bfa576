// The quick engine against the plain one, on every shipped scheme that it takes.

#include "limn/base/parallel.h"
#include "mesh/random_mesh.h"
#include "refine/fast_check.h"
#include "support/mutants.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

std::vector<std::string> quick_schemes() {
  std::vector<std::string> names;
  for (const std::string& name : shipped_schemes())
    if (has_fast_layout(*shipped(name).split)) names.push_back(name);
  return names;
}

class FastRefiner_ : public testing::TestWithParam<std::string> {};

TEST_P(FastRefiner_, IsThePlainEngineOnRegularBodies) {
  const Scheme& scheme = shipped(GetParam());
  for (const Mesh& mesh : {tetrahedron(), icosahedron(), torus(Lattice::triangle, 3, 4)})
    for (int levels = 0; levels <= 4; ++levels) {
      SCOPED_TRACE(levels);
      expect_same(scheme, mesh, levels, 5);
    }
}

TEST_P(FastRefiner_, IsThePlainEngineOnRandomMeshes) {
  const Scheme& scheme = shipped(GetParam());
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    expect_same(scheme, RandomMesh(seed).triangles(), static_cast<int>(1 + seed % 4), seed);
  }
}

/// Every valence, in a disc whose boundary has corners and whose inner vertices touch it.
TEST_P(FastRefiner_, IsThePlainEngineRoundEveryValence) {
  const Scheme& scheme = shipped(GetParam());
  for (const Index n : {3, 4, 5, 7, 8, 12, 30})
    for (const Index rings : {1, 2}) {
      SCOPED_TRACE(n);
      expect_same(scheme, star(Lattice::triangle, n, rings), 3, 3);
      expect_same(scheme, fan(Lattice::triangle, n, rings), 3, 4);
    }
  for (const Index faces : {1, 2}) expect_same(scheme, fan(Lattice::triangle, faces, 1), 4, 6);
}

/// How many first steps are left to the plain engine: only as many as rules look far.
TEST_P(FastRefiner_, LeavesFewStepsToThePlainEngine) {
  const Scheme& scheme = shipped(GetParam());
  const bool wide = scheme.rule(RuleKind::edge_end) && scheme.name.find("loop-7") != 0;
  for (const Mesh& mesh :
       {icosahedron(), fan(Lattice::triangle, 4, 2), fan(Lattice::triangle, 1, 2)})
    EXPECT_LE(expect_same(scheme, mesh, 3, 1), 1) << wide;
}

INSTANTIATE_TEST_SUITE_P(Schemes, FastRefiner_, testing::ValuesIn(quick_schemes()),
                         [](const auto& info) { return test_name(info.param); });

}  // namespace
}  // namespace limn::test
