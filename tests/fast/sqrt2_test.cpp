// The quick engine on quad-sqrt2 against the plain engine: levels between full cycles, where faces
// are edges and boundary quads are halved; rules that look far; limit points.

#include "fast/families.h"
#include "fast/fast_limit_check.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

int expect_same_sqrt2(const Scheme& scheme, const Mesh& control, int levels, unsigned seed) {
  SCOPED_TRACE(testing::Message() << levels << " levels, seed " << seed);
  return expect_same(scheme, control, levels, seed, start_sqrt2);
}

/// None of a closed mesh of quads; along a boundary, of which the step from centres must be known
/// to be far, one cycle. Other polygons are quads after another.
TEST(Sqrt2Engine, LeavesWholeCyclesToThePlainEngine) {
  const Scheme& scheme = shipped("four-eight");
  const auto check = [&](const Mesh& mesh, int most) {
    for (int levels = 0; levels <= 6; ++levels) {
      const bool half = levels % 2 != 0 && (levels > 1 || mesh.uniform_degree() == 4);
      EXPECT_EQ(expect_same_sqrt2(scheme, mesh, levels, 5),
                std::min(half ? levels - 1 : levels, most));
    }
  };
  for (const Mesh& mesh : {cube(), mesh::torus(Lattice::quad, 3, 4)}) check(mesh, 0);
  for (const Mesh& mesh : {mesh::fan(Lattice::quad, 3, 2), mesh::star(Lattice::quad, 5, 2),
                           mesh::fan(Lattice::quad, 2, 3)})
    check(mesh, 2);
  check(icosahedron(), 2);
  for (const Mesh& mesh : {mesh::face_star(5, 2), mesh::fan(Lattice::triangle, 4, 2)})
    check(mesh, 4);
}

TEST(Sqrt2EngineRules, MayLookFar) {
  const Scheme scheme = rules_on("quad-sqrt2", kWideSqrt2);
  for (unsigned seed = 0; seed < 30; ++seed) {
    expect_same_sqrt2(scheme, random_quads(seed), static_cast<int>(2 + seed % 5), seed);
    expect_same_sqrt2(scheme, RandomMesh(seed).polygons(), static_cast<int>(2 + seed % 5), seed);
  }
}

TEST(FastLimitOfFourEight, IsThePlainOneOnBodies) {
  const Scheme& scheme = shipped("four-eight");
  for (const Mesh& mesh : {cube(), mesh::torus(Lattice::quad, 4, 5), mesh::fan(Lattice::quad, 3, 2),
                           mesh::fan(Lattice::quad, 1, 2), mesh::star(Lattice::quad, 7, 2)}) {
    int found = 0;
    for (int levels = 0; levels <= 7; ++levels)
      found += expect_plain_limit(scheme, mesh, levels) ? 1 : 0;
    EXPECT_GE(found, 2) << mesh.vertex_count();
  }
}

TEST(FastLimitOfFourEight, IsThePlainOneOnRandomMeshes) {
  const Scheme& scheme = shipped("four-eight");
  for (unsigned seed = 0; seed < 30; ++seed)
    expect_plain_limit(scheme, RandomMesh(seed).polygons(), static_cast<int>(2 + seed % 4), seed);
}

}  // namespace
}  // namespace limn::test
