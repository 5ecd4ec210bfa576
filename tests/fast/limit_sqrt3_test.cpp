// Limit points of √3 by the quick engine, beside those that the plain way finds on the same refined
// mesh.

#include <string>

#include "fast/fast_limit_check.h"
#include "support/mutants.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

TEST(FastLimitOfSqrt3, IsThePlainOneOnBodies) {
  const Scheme& scheme = shipped("sqrt3");
  for (const Mesh& mesh : {tetrahedron(), icosahedron(), mesh::torus(Lattice::triangle, 4, 5),
                           mesh::fan(Lattice::triangle, 5, 2), mesh::fan(Lattice::triangle, 1, 2),
                           mesh::fan(Lattice::triangle, 3, 3), mesh::star(Lattice::triangle, 9, 2)})
    for (int levels = 0; levels <= 5; ++levels)
      EXPECT_TRUE(expect_plain_limit(scheme, mesh, levels)) << levels;
  const Mesh lone = mesh::fan(Lattice::triangle, 1, 1);  // its centroid is near three corners
  for (int levels = 0; levels <= 5; ++levels)
    EXPECT_EQ(expect_plain_limit(scheme, lone, levels), levels != 1) << levels;
}

TEST(FastLimitOfSqrt3, IsThePlainOneOnRandomMeshes) {
  const Scheme& scheme = shipped("sqrt3");
  int met = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = RandomMesh(seed).triangles();
    if (expect_plain_limit(scheme, mesh, static_cast<int>(seed % 5), seed)) ++met;
  }
  EXPECT_GT(met, 30);
}

/// Valences and numbers of faces; of 6 faces at the boundary, no two eigenvectors lead.
TEST(FastLimitOfSqrt3, IsThePlainOneRoundEveryValence) {
  const Scheme& scheme = shipped("sqrt3");
  for (const Index n : {3, 4, 5, 6, 7, 8, 12, 30})
    for (const int levels : {2, 3})
      EXPECT_TRUE(expect_plain_limit(scheme, mesh::star(Lattice::triangle, n, 1), levels)) << n;
  for (const Index n : {1, 2, 3, 4, 5, 6, 7, 12})
    for (const int levels : {2, 3})
      EXPECT_TRUE(expect_plain_limit(scheme, mesh::fan(Lattice::triangle, n, 1), levels)) << n;
}

Scheme parsed(const std::string& rules) {
  const Result<Scheme> scheme =
      parse_scheme("split = \"sqrt3\"\nextends = \"sqrt3\"\n" + rules, "test.toml");
  EXPECT_TRUE(scheme.ok()) << (scheme ? "" : scheme.error().text());
  return *scheme;
}

/// Sums of two rings and three, which irregular vertices and boundaries change farther off: only
/// once these are so far apart is there a plan.
TEST(FastLimitOfSqrt3, IsThePlainOneOfWiderRules) {
  const Scheme vertices =
      parsed("[vertex]\nself = \"1/2\"\nring = \"7/(16*n)\"\nacross = \"1/(16*n)\"\n");
  const Scheme faces = parsed("[face]\ncorner = \"3/8\"\nbeyond = \"-1/24\"\n");
  for (int levels = 0; levels <= 4; ++levels) {
    EXPECT_EQ(expect_plain_limit(vertices, icosahedron(), levels), levels >= 4);
    EXPECT_EQ(expect_plain_limit(faces, icosahedron(), levels), levels >= 3);
  }
  for (const Mesh& mesh :
       {mesh::torus(Lattice::triangle, 3, 4), mesh::star(Lattice::triangle, 5, 1),
        mesh::fan(Lattice::triangle, 1, 2)}) {
    EXPECT_TRUE(expect_plain_limit(vertices, mesh, 5));
    EXPECT_TRUE(expect_plain_limit(faces, mesh, 4));
    EXPECT_TRUE(expect_plain_limit(faces, mesh, 5));
  }
  for (unsigned seed = 0; seed < 5; ++seed)
    expect_plain_limit(faces, RandomMesh(seed).triangles(), 3, seed);
}

/// Whatever the weights: each mutant moves some of them, or gives a rule a role that it had not.
TEST(FastLimitOfSqrt3, IsThePlainOneOfMutants) {
  int seed = 0;
  for (const RuleMutant& mutant : rule_mutants(shipped("sqrt3"))) {
    SCOPED_TRACE(mutant.change);
    const int levels = ++seed % 5;
    // no plan reads so far, nor boundary points that know the valence of an end
    const bool wider = mutant.change.find("new role") != std::string::npos ||
                       (mutant.change.find("boundary.edge-end") != std::string::npos &&
                        mutant.change.find("(n == ") != std::string::npos);
    for (const Mesh& mesh :
         {mesh::star(Lattice::triangle, 7, 1), mesh::fan(Lattice::triangle, 2, 1)})
      EXPECT_TRUE(expect_plain_limit(mutant.scheme, mesh, levels) || wider);
  }
  EXPECT_GT(seed, 20);
}

TEST(FastLimitOfSqrt3, GivesTheSameBitsOnOneThreadAndMany) {
  for (const int levels : {4, 5})
    expect_same_limit_bits(shipped("sqrt3"), mesh::fan(Lattice::triangle, 5, 12), levels);
}

}  // namespace
}  // namespace limn::test
