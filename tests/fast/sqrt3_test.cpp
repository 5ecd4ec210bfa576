// The quick engine's family of √3 against the plain engine.

#include "fast/families.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

int expect_same_sqrt3(const Scheme& scheme, const Mesh& control, int levels, unsigned seed) {
  return expect_same(scheme, control, levels, seed, start_sqrt3);
}

TEST(Sqrt3Engine, IsThePlainEngineOnRegularBodies) {
  for (const Mesh& mesh : {tetrahedron(), icosahedron(), mesh::torus(Lattice::triangle, 3, 4)})
    for (int levels = 0; levels <= 5; ++levels) {
      SCOPED_TRACE(levels);
      EXPECT_EQ(expect_same_sqrt3(shipped("sqrt3"), mesh, levels, 5), 0);
    }
}

/// Every valence, in a disc whose boundary has corners and whose inner vertices touch it.
TEST(Sqrt3Engine, IsThePlainEngineRoundEveryValence) {
  for (const Index n : {3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 30})
    for (const Index rings : {1, 2})
      for (const int levels : {1, 2, 3, 4}) {
        SCOPED_TRACE(n);
        EXPECT_EQ(
            expect_same_sqrt3(shipped("sqrt3"), mesh::star(Lattice::triangle, n, rings), levels, 3),
            0);
        EXPECT_EQ(
            expect_same_sqrt3(shipped("sqrt3"), mesh::fan(Lattice::triangle, n, rings), levels, 4),
            0);
      }
  for (const Index faces : {1, 2, 3, 4})
    for (const Index rings : {1, 2})
      for (int levels = 0; levels <= 5; ++levels)
        expect_same_sqrt3(shipped("sqrt3"), mesh::fan(Lattice::triangle, faces, rings), levels, 6);
}

/// A triangle alone sees itself on all sides, until it has been cut.
TEST(Sqrt3Engine, LeavesStepsToThePlainEngineOnlyForLoneTriangles) {
  EXPECT_EQ(expect_same_sqrt3(shipped("sqrt3"), mesh::fan(Lattice::triangle, 1, 1), 5, 1), 2);
  EXPECT_EQ(expect_same_sqrt3(shipped("sqrt3"), mesh::fan(Lattice::triangle, 1, 2), 5, 1), 0);
  EXPECT_EQ(expect_same_sqrt3(shipped("sqrt3"), mesh::fan(Lattice::triangle, 2, 1), 5, 1), 0);
}

Scheme parsed(const std::string& rules) { return rules_on("sqrt3", rules); }

TEST(Sqrt3EngineRules, MayLookFar) {
  const Scheme scheme = parsed(kWideSqrt3);
  for (const Index n : {3, 5, 6, 7, 9})
    for (const Index rings : {1, 2, 3})
      for (const int levels : {4, 5}) {
        EXPECT_LE(expect_same_sqrt3(scheme, mesh::star(Lattice::triangle, n, rings), levels, 2), 3);
        // a triangle alone needs another two
        const int most = n - 2 == 1 && rings == 1 ? 4 : 3;
        EXPECT_LE(expect_same_sqrt3(scheme, mesh::fan(Lattice::triangle, n - 2, rings), levels, 2),
                  most);
      }
}

/// Along the boundary alone: past two corners.
TEST(Sqrt3EngineRules, MayLookFarAlongBoundaries) {
  const Scheme scheme = parsed(R"toml(extends = "sqrt3"
[roles."boundary.vertex"]
second = "vbv"

[roles."boundary.edge-end"]
second = "bvbv"

[boundary.vertex]
self = "1/2"
next = "3/16"
second = "1/16"

[boundary.edge-end]
near = "1/2"
far = "3/8"
beyond = "1/16"
second = "1/16"
)toml");
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    expect_same_sqrt3(scheme, RandomMesh(seed).triangles(), static_cast<int>(2 + seed % 4), seed);
  }
  for (const Index faces : {1, 2, 3, 4})
    for (const Index rings : {1, 2, 3})
      EXPECT_LE(expect_same_sqrt3(scheme, mesh::fan(Lattice::triangle, faces, rings), 5, 2),
                faces * rings == 1 ? 4 : 3);
}

/// The mesh and a triangle that touches nothing, which needs the finest grids.
Mesh with_lone_triangle(const Mesh& mesh) {
  const Index first = mesh.vertex_count();
  Faces faces = faces_of(polygons_of(mesh));
  faces.push_back({first + 2, first, first + 1});
  return must_build(first + 3, faces);
}

/// The plain engine may make an even or an odd number of steps; its vertices are found again.
TEST(Sqrt3EngineRules, MayLeaveStepsToThePlainEngine) {
  const Scheme far_vertices = parsed(
      "extends = \"sqrt3\"\n"
      "[vertex]\nself = \"1/2\"\nring = \"1/(4*n)\"\nacross = \"1/(4*n)\"\n");
  const Scheme far_faces =
      parsed("extends = \"sqrt3\"\n[face]\ncorner = \"1/4\"\nbeyond = \"1/12\"\n");
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = RandomMesh(seed).triangles();
    expect_same_sqrt3(far_vertices, mesh, 5, seed);
    expect_same_sqrt3(far_faces, mesh, 5, seed);
    const Mesh more = with_lone_triangle(mesh);
    if (mesh.face_count() == 0 || !is_simple(mesh)) continue;
    const int all = expect_same_sqrt3(shipped("sqrt3"), more, 5, seed) == 5 ? 5 : 0;
    EXPECT_EQ(expect_same_sqrt3(shipped("sqrt3"), more, 4, seed), all > 0 ? 4 : 2);
    EXPECT_EQ(expect_same_sqrt3(far_vertices, more, 5, seed), all > 0 ? 5 : 3);
    EXPECT_EQ(expect_same_sqrt3(far_faces, more, 5, seed), all > 0 ? 5 : 2);
  }
}

TEST(Sqrt3Engine, RefusesWhatThePlainEngineRefuses) {
  expect_same_sqrt3(shipped("sqrt3"), cube(), 2, 1);
  expect_same_sqrt3(shipped("sqrt3"), icosahedron(), -1, 1);
  expect_same_sqrt3(shipped("sqrt3"), icosahedron(), 40, 1);
  const Scheme closed = parsed("[vertex]\nself = 1\n[face]\ncorner = \"1/3\"\n");
  for (const int levels : {1, 2, 3}) {
    expect_same_sqrt3(closed, icosahedron(), levels, 1);
    expect_same_sqrt3(closed, mesh::fan(Lattice::triangle, 3, 2), levels, 1);
  }
  const Scheme partial = parsed(
      "extends = \"sqrt3\"\n[[vertex]]\nwhen = \"n < 25\"\nself = \"1/2\"\nring = \"1/(2*n)\"\n");
  for (const int levels : {1, 2, 3})
    for (const Index n : {12, 30}) {
      expect_same_sqrt3(partial, mesh::star(Lattice::triangle, n, 1), levels, 1);
      expect_same_sqrt3(partial, mesh::fan(Lattice::triangle, n, 1), levels, 1);
    }
}

}  // namespace
}  // namespace limn::test
