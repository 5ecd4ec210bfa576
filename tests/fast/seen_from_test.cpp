// The quick engine where new vertices of edges and faces have rules seen from extraordinary ends
// and corners, and at the boundary.

#include "fast/families.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

int expect_same_of(const Scheme& scheme, const Mesh& mesh, int levels, unsigned seed) {
  return expect_same(scheme, mesh, levels, seed, start_of(*scheme.split));
}

/// Over stars, fans and random meshes; at some of them the engine makes steps itself.
void expect_same_everywhere(const Scheme& scheme, int most_levels) {
  SCOPED_TRACE(scheme.name);
  const bool triangles = scheme.split->lattice == Lattice::triangle;
  int quick = 0;
  const auto check = [&](const Mesh& mesh, int levels, unsigned seed) {
    const int plain = expect_same_of(scheme, mesh, levels, seed);
    if (plain >= 0) quick += levels - plain;
  };
  for (const Index n : {3, 4, 5, 6, 7, 9})
    for (const Index rings : {1, 2, 3}) {
      check(mesh::star(scheme.split->lattice, n, rings), most_levels, 3);
      check(mesh::fan(scheme.split->lattice, n - 2, rings), most_levels, 4);
    }
  check(triangles ? icosahedron() : cube(), most_levels, 5);
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const int levels = static_cast<int>(1 + seed % 4);
    check(triangles ? RandomMesh(seed).triangles() : random_quads(seed), levels, seed);
  }
  EXPECT_GT(quick, 0);
}

TEST(FastSeenFrom, IsThePlainEngines) {
  for (const char* name : {"kobbelt-quad", "sqrt3-interpolating", "catmull-clark-bounded"})
    expect_same_everywhere(shipped(name), 4);
}

/// Cases that apply at regular corners, too: a face depends on which corners are on the boundary.
TEST(FastSeenFrom, MayBeTakenAtRegularCorners) {
  for (const std::string rule :
       {"when = \"n == 4\"\nself = \"1/2\"\nring = \"1/(2*n) + cos(pi*(2*k + 1)/n)/12\"\n",
        "when = \"n < 5\"\nself = 1\n"})
    expect_same_everywhere(
        rules_on("quad-dyadic", "extends = \"catmull-clark\"\n[[face-end]]\n" + rule), 3);
  for (const std::string rule :
       {"when = \"n == 6\"\nself = \"1/2\"\nring = \"1/(2*n)\"\n", "when = \"n < 7\"\nself = 1\n"})
    expect_same_everywhere(rules_on("sqrt3", "extends = \"sqrt3\"\n[[face-end]]\n" + rule), 4);
}

TEST(FastSeenFrom, MayBeSeenFromTheBoundary) {
  const std::string spoke =
      "[[boundary.spoke]]\nself = \"1/2 - 1/(4*n)\"\nfar = \"1/4 + 1/(4*n)\"\nwing = \"1/8\"\n";
  const std::string end =
      "[[boundary.edge-end]]\nwhen = \"n != 4\"\nnear = \"1/2 + 1/(4*n)\"\nfar = \"1/2 - "
      "1/(4*n)\"\n";
  for (const std::string& rule : {spoke, end, spoke + end}) {
    expect_same_everywhere(rules_on("triangle-dyadic", "extends = \"loop\"\n" + rule), 3);
    expect_same_everywhere(rules_on("quad-dyadic", "extends = \"catmull-clark\"\n" + rule), 3);
  }
  expect_same_everywhere(
      rules_on("sqrt3",
               "extends = \"sqrt3\"\n[[boundary.edge-end]]\nnear = \"1 - 1/n\"\nfar = \"1/n\"\n"),
      4);
}

}  // namespace
}  // namespace limn::test
