// The quick engine's family of √3 against the plain engine.

#include "fast/fast_check.h"
#include "support/mutants.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

/// The plain engine's meshes, and for each control face's first corner v the half-edge out of v on
/// the face's first edge (at odd levels, towards the middle of the small triangle there).
struct PlainLevels {
  PlainLevels(const Mesh& control, int levels) : mesh(control) {
    for (Index f = 0; f < control.face_count(); ++f) starts.push_back(3 * f);
    for (int step = 0; step < levels; ++step) {
      const SplitResult split = find_split("sqrt3")->apply(mesh, step);
      for (Index& h : starts)
        h = step % 2 == 0 ? turned_towards(split, mesh.face(h), mesh.origin(h)) : turned(split, h);
      mesh = split.mesh;
    }
  }

  /// The half-edge from v to the vertex born of face f.
  static Index turned_towards(const SplitResult& split, Index f, Index v) {
    const Births& births = split.births;
    if (!births.faces.empty())
      f = static_cast<Index>(std::find(births.faces.begin(), births.faces.end(), f) -
                             births.faces.begin());
    Index h = split.mesh.halfedge_of_vertex(v);
    while (split.mesh.target(h) != births.from_vertices + births.from_edges + f)
      h = split.mesh.rotate(h);
    return h;
  }

  /// Of the face on the right of h, which lies on the old edge; or the boundary edge.
  [[nodiscard]] Index turned(const SplitResult& split, Index h) const {
    const Index v = mesh.origin(h), right = mesh.twin(h);
    if (mesh.twin(mesh.next(right)) == kNone) return split.mesh.halfedge_of_vertex(v);
    return turned_towards(split, mesh.face(right), v);
  }

  Mesh mesh;
  std::vector<Index> starts;
};

/// The quick engine's faces of a control face begin at its first corner; at odd levels the first of
/// them ends with the way back there from its centroid.
Starts start_sqrt3(const Mesh& control, int levels, const Mesh& quick) {
  const PlainLevels plain(control, levels);
  const bool odd = levels % 2 != 0;
  Starts starts;
  for (Index f = 0; f < control.face_count(); ++f) {
    const Index first = 3 * f * (quick.face_count() / control.face_count()), h = plain.starts[f];
    starts.emplace_back(odd ? plain.mesh.twin(h) : h, odd ? first + 2 : first);
  }
  return starts;
}

int expect_same_sqrt3(const Scheme& scheme, const Mesh& control, int levels, unsigned seed) {
  return expect_same(scheme, control, levels, seed, start_sqrt3);
}

TEST(Sqrt3Engine, IsThePlainEngineOnRegularBodies) {
  for (const Mesh& mesh : {tetrahedron(), icosahedron(), torus(Lattice::triangle, 3, 4)})
    for (int levels = 0; levels <= 5; ++levels) {
      SCOPED_TRACE(levels);
      EXPECT_EQ(expect_same_sqrt3(shipped("sqrt3"), mesh, levels, 5), 0);
    }
}

TEST(Sqrt3Engine, IsThePlainEngineOnRandomMeshes) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    expect_same_sqrt3(shipped("sqrt3"), RandomMesh(seed).triangles(),
                      static_cast<int>(1 + seed % 5), seed);
  }
}

/// Every valence, in a disc whose boundary has corners and whose inner vertices touch it.
TEST(Sqrt3Engine, IsThePlainEngineRoundEveryValence) {
  for (const Index n : {3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 30})
    for (const Index rings : {1, 2})
      for (const int levels : {1, 2, 3, 4}) {
        SCOPED_TRACE(n);
        EXPECT_EQ(expect_same_sqrt3(shipped("sqrt3"), star(Lattice::triangle, n, rings), levels, 3),
                  0);
        EXPECT_EQ(expect_same_sqrt3(shipped("sqrt3"), fan(Lattice::triangle, n, rings), levels, 4),
                  0);
      }
  for (const Index faces : {1, 2, 3, 4})
    for (const Index rings : {1, 2})
      for (int levels = 0; levels <= 5; ++levels)
        expect_same_sqrt3(shipped("sqrt3"), fan(Lattice::triangle, faces, rings), levels, 6);
}

/// A triangle alone sees itself on all sides, until it has been cut.
TEST(Sqrt3Engine, LeavesStepsToThePlainEngineOnlyForLoneTriangles) {
  EXPECT_EQ(expect_same_sqrt3(shipped("sqrt3"), fan(Lattice::triangle, 1, 1), 5, 1), 2);
  EXPECT_EQ(expect_same_sqrt3(shipped("sqrt3"), fan(Lattice::triangle, 1, 2), 5, 1), 0);
  EXPECT_EQ(expect_same_sqrt3(shipped("sqrt3"), fan(Lattice::triangle, 2, 1), 5, 1), 0);
}

Scheme parsed(const std::string& rules) { return rules_on("sqrt3", rules); }

/// Rules that look as far as two rings, and differ by valence.
constexpr const char* kWide = R"toml(
[roles.vertex]
straight = "vefefev"

[roles.face]
outer = "fvev"

[[vertex]]
when = "n == 5"
self = "1/2"
ring = "1/(4*n)"
across = "1/(4*n)"

[[vertex]]
self = "5/8 - 1/16"
ring = "3/(8*n)"
straight = "1/(16*n)"

[face]
corner = "3/8"
beyond = "1/96"
outer = "-5/96"

[[boundary.vertex]]
when = "n < 4"
self = "7/8"
next = "1/16"

[[boundary.vertex]]
self = "3/4"
next = "1/8"

[boundary.edge-end]
near = "3/4"
far = "3/8"
beyond = "-1/8"
)toml";

TEST(Sqrt3EngineRules, MayLookFar) {
  const Scheme scheme = parsed(kWide);
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    expect_same_sqrt3(scheme, RandomMesh(seed).triangles(), static_cast<int>(1 + seed % 5), seed);
  }
  for (const Index n : {3, 5, 6, 7, 9})
    for (const Index rings : {1, 2, 3})
      for (const int levels : {4, 5}) {
        EXPECT_LE(expect_same_sqrt3(scheme, star(Lattice::triangle, n, rings), levels, 2), 3);
        // a triangle alone needs another two
        const int most = n - 2 == 1 && rings == 1 ? 4 : 3;
        EXPECT_LE(expect_same_sqrt3(scheme, fan(Lattice::triangle, n - 2, rings), levels, 2), most);
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
      EXPECT_LE(expect_same_sqrt3(scheme, fan(Lattice::triangle, faces, rings), 5, 2),
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

/// Whatever the weights: each mutant moves some of them, or gives a rule a role that it had not.
TEST(Sqrt3EngineRules, MayHaveAnyWeights) {
  unsigned seed = 0;
  for (const RuleMutant& mutant : rule_mutants(shipped("sqrt3"))) {
    SCOPED_TRACE(mutant.change);
    expect_same_sqrt3(mutant.scheme, RandomMesh(++seed).triangles(), 4, 1);
    expect_same_sqrt3(mutant.scheme, fan(Lattice::triangle, 7, 2), 3, 1);
    expect_same_sqrt3(mutant.scheme, fan(Lattice::triangle, 1, 2), 4, 1);
  }
  EXPECT_GT(seed, 20U);
}

TEST(Sqrt3Engine, GivesTheSameBitsOnOneThreadAndMany) {
  for (const Mesh& mesh : {torus(Lattice::triangle, 40, 41), fan(Lattice::triangle, 1, 20)})
    for (const int levels : {4, 5}) expect_same_bits(shipped("sqrt3"), mesh, levels);
}

TEST(Sqrt3Engine, RefusesWhatThePlainEngineRefuses) {
  expect_same_sqrt3(shipped("sqrt3"), cube(), 2, 1);
  expect_same_sqrt3(shipped("sqrt3"), icosahedron(), -1, 1);
  expect_same_sqrt3(shipped("sqrt3"), icosahedron(), 40, 1);
  const Scheme closed = parsed("[vertex]\nself = 1\n[face]\ncorner = \"1/3\"\n");
  for (const int levels : {1, 2, 3}) {
    expect_same_sqrt3(closed, icosahedron(), levels, 1);
    expect_same_sqrt3(closed, fan(Lattice::triangle, 3, 2), levels, 1);
  }
  const Scheme partial = parsed(
      "extends = \"sqrt3\"\n[[vertex]]\nwhen = \"n < 25\"\nself = \"1/2\"\nring = \"1/(2*n)\"\n");
  for (const int levels : {1, 2, 3})
    for (const Index n : {12, 30}) {
      expect_same_sqrt3(partial, star(Lattice::triangle, n, 1), levels, 1);
      expect_same_sqrt3(partial, fan(Lattice::triangle, n, 1), levels, 1);
    }
}

}  // namespace
}  // namespace limn::test
