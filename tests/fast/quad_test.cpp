// The quick engine on quads: how many steps it leaves to the plain one, on any polygons.

#include "fast/families.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

void expect_same_everywhere(const Scheme& scheme, unsigned seeds, Index most_plain) {
  const auto check = [&](const Mesh& mesh, int levels, unsigned seed) {
    const bool quads = mesh.uniform_degree() == 4 || mesh.face_count() == 0;
    const int plain = expect_same(scheme, mesh, levels, seed);
    EXPECT_GE(plain, quads || levels == 0 ? 0 : 1);
    if (mesh.face_count() > 0) EXPECT_LE(plain, std::min(levels, most_plain + (quads ? 0 : 1)));
  };
  for (const Mesh& mesh : {cube(), mesh::torus(Lattice::quad, 3, 4), tetrahedron(), icosahedron()})
    for (int levels = 0; levels <= 4; ++levels) check(mesh, levels, 5);
  for (unsigned seed = 0; seed < seeds; ++seed) {
    SCOPED_TRACE(seed);
    check(RandomMesh(seed).polygons(), static_cast<int>(seed % 5), seed);
    check(random_quads(seed), static_cast<int>(1 + seed % 4), seed);
  }
  for (const Index n : {3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 30})
    for (const Index rings : {1, 2, 3}) {
      SCOPED_TRACE(n);
      check(mesh::star(Lattice::quad, n, rings), 3, 3);
      check(mesh::fan(Lattice::quad, n, rings), 3, 4);
      check(mesh::face_star(n, rings), 3, 4);
    }
  for (const Index faces : {1, 2, 3})
    for (const Index rings : {1, 2, 3}) check(mesh::fan(Lattice::quad, faces, rings), 4, 6);
  check(mesh::fan(Lattice::quad, 1, 1), 5, 1);
}

TEST(FastQuads, AreThePlainEngines) { expect_same_everywhere(shipped("catmull-clark"), 200, 0); }

Scheme parsed(const std::string& rules) { return rules_on("quad-dyadic", rules); }

TEST(FastQuadRules, MayLookFar) {
  for (const char* rules : {kWideQuads, kFourPoint, kFaces})
    expect_same_everywhere(parsed(std::string(rules) + kQuadBoundary), 40, 2);
}

/// Rules of the boundary that look farther than those inside: along it, past a vertex of any number
/// of faces, and across faces whose other side may lie on the boundary.
TEST(FastQuadRules, MayLookFarFromTheBoundary) {
  const std::string base = "extends = \"catmull-clark\"\n";
  const std::string inward = R"toml(
[roles."boundary.edge"]
inner = "evefev"

[boundary.edge]
end = "5/8"
inner = "-1/8"
)toml";
  const std::string along = R"toml(
[boundary.edge]
end = "9/16"
beyond = "-1/16"
)toml";
  for (const std::string& rules : {along, inward}) {
    const Scheme scheme = parsed(base + rules);
    expect_same_everywhere(scheme, 80, 2);
    EXPECT_EQ(expect_same(scheme, band(5, 1), 3, 1), 1);
    EXPECT_LE(expect_same(scheme, band(5, 2), 3, 1), 1);
  }
}

/// Where the end's rule applies at regular vertices, an edge depends on whether an end is on the
/// boundary, however near its stencil stays.
TEST(FastQuadRules, MayDependOnAnEdgesEnds) {
  for (const std::string rule :
       {"when = \"n == 4\"\nself = \"1/2\"\nring = \"1/(2*n) + cos(2*pi*k/n)/12\"\n",
        "when = \"n < 5\"\nself = 1\n"})
    expect_same_everywhere(parsed("extends = \"catmull-clark\"\n[[edge-end]]\n" + rule), 40, 1);
}

TEST(FastQuads, AreRefusedAsByThePlainEngine) {
  const Scheme closed =
      parsed("[face]\ncorner=\"1/n\"\n[vertex]\nself = 1\n[edge]\nend = \"1/2\"\n");
  expect_same(closed, cube(), 2, 1);
  EXPECT_EQ(expect_same(closed, mesh::fan(Lattice::quad, 3, 2), 2, 1), -1);
  EXPECT_EQ(expect_same(shipped("box-spline-quad"), cube(), 2, 1), -1);
  EXPECT_EQ(expect_same(shipped("catmull-clark"), cube(), 40, 1), -1);
  EXPECT_EQ(expect_same(shipped("catmull-clark"), icosahedron(), 14, 1), -1);
}

/// Then the plain engine makes all steps, in the quick one's numbers.
TEST(FastQuads, AreLeftWhereNoTableWouldDo) {
  const std::string straight = "efev";
  std::string far;
  for (int i = 0; i < 6; ++i) far += straight;
  const Scheme scheme = parsed("extends = \"catmull-clark\"\n[roles.edge]\nfar = \"" + far +
                               "\"\n[edge]\nend = \"1/4\"\nface = \"3/16\"\nfar = \"1/16\"\n");
  for (const Mesh& mesh : {cube(), icosahedron(), mesh::torus(Lattice::quad, 9, 3)})
    for (const int levels : {1, 2, 3}) EXPECT_EQ(expect_same(scheme, mesh, levels, 1), levels);
  EXPECT_EQ(expect_same(shipped("catmull-clark"), mesh::star(Lattice::quad, 1001, 1), 2, 1), 2);
  EXPECT_EQ(expect_same(shipped("catmull-clark"), mesh::star(Lattice::quad, 1000, 1), 2, 1), 0);
}

TEST(FastQuads, MayBeNone) {
  for (const Index vertices : {0, 3}) {
    const Mesh mesh = must_build(vertices, {});
    EXPECT_EQ(expect_same(shipped("catmull-clark"), mesh, 3, 1), 3);
  }
}

}  // namespace
}  // namespace limn::test
