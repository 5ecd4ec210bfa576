// The quick engine on dual splits: against the plain engine.

#include "fast/families.h"
#include "limn/fast/families/grid_family.h"
#include "limn/fast/sites/stencil_tables.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

Scheme parsed(const std::string& rules) { return rules_on("quad-dual", rules); }

int expect_same_dual(const Scheme& scheme, const Mesh& control, int levels, unsigned seed) {
  return expect_same(scheme, control, levels, seed, start_dual);
}

TEST(FastDualTables, SeeHowFarRulesLook) {
  const auto tables = [&](const Scheme& scheme) {
    const std::vector<fast::StarShape> kinds{{Lattice::quad, 3}, {Lattice::quad, 4}};
    return fast::read_stencils(scheme, *fast::grid_cycle(*scheme.split), kinds, {true})
        .value()
        .front();
  };
  const fast::StencilTables near = tables(shipped("doo-sabin"));
  EXPECT_EQ(near.reach.rim, 1);
  EXPECT_EQ(near.reach.star_zone.size, 1);
  EXPECT_EQ(near.reach.star_rings, 2);
  EXPECT_EQ(near.reach.smallest_side, 4);
  EXPECT_EQ(near.interior[0].size(), 4U);
  EXPECT_EQ(near.stars.at(3).tables.front().rows.terms.size(), 9U);
  const fast::StencilTables wide = tables(parsed(kWideDual));
  EXPECT_GT(wide.reach.rim, 1);
  EXPECT_GT(wide.reach.star_zone.size, 1);
}

TEST(FastDual, IsThePlainEngineOnBodies) {
  for (const Scheme& scheme : {shipped("doo-sabin"), parsed(kNear)})
    for (const Mesh& mesh : bodies())
      for (int levels = 0; levels <= 5; ++levels) {
        SCOPED_TRACE(levels);
        const bool thin = mesh.max_valence() == 2;
        EXPECT_EQ(expect_same_dual(scheme, mesh, levels, 5), thin ? std::min(levels, 1) : 0);
      }
}

/// Every number of sides, of faces and of vertices.
TEST(FastDual, IsThePlainEngineRoundEveryCentre) {
  for (const Scheme& scheme : {shipped("doo-sabin"), parsed(kNear)})
    for (const Index n : {3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 30}) {
      SCOPED_TRACE(n);
      for (const Mesh& mesh : {mesh::star(Lattice::quad, n, 2), mesh::star(Lattice::triangle, n, 2),
                               mesh::face_star(n, 3), mesh::fan(Lattice::quad, n, 2)})
        EXPECT_EQ(expect_same_dual(scheme, mesh, 3, 3), 0);
    }
}

/// Beyond what has a table, and in meshes that do not grow.
TEST(FastDual, LeavesToThePlainEngineWhatItMust) {
  const Scheme& scheme = shipped("doo-sabin");
  EXPECT_EQ(expect_same_dual(scheme, mesh::fan(Lattice::quad, 1, 1), 2, 1), 2);
  for (const Index vertices : {0, 3})
    EXPECT_EQ(expect_same_dual(scheme, must_build(vertices, {}), 3, 1), 3);
  EXPECT_EQ(expect_same_dual(scheme, mesh::star(Lattice::triangle, 1001, 1), 2, 1), 2);
}

/// The plain engine makes the steps until centres are far enough apart, and no more.
TEST(FastDualRules, MayLookBeyondTheFace) {
  for (const char* rules : {kWideDual, kWider, kFar}) {
    const Scheme scheme = parsed(rules);
    // a mesh without inner edges does not grow; one of valence 2 is regular a step later
    const auto most = [&](const Mesh& mesh) {
      if (boundary_edges(mesh) == mesh.edge_count()) return 5;
      return (rules == kFar ? 3 : 2) + (mesh.has_boundary() || mesh.max_valence() > 2 ? 0 : 1);
    };
    for (unsigned seed = 0; seed < 60; ++seed) {
      SCOPED_TRACE(seed);
      const Mesh mesh = RandomMesh(seed).polygons();
      const auto levels = static_cast<int>(1 + seed % 5);
      EXPECT_GE(expect_same_dual(scheme, mesh, levels, seed), 0);
    }
    for (const Mesh& mesh : bodies())
      for (int levels = 0; levels <= 5; ++levels)
        EXPECT_LE(expect_same_dual(scheme, mesh, levels, 2), most(mesh));
    for (const Mesh& mesh : open_meshes())
      for (int levels = 0; levels <= 5; ++levels)
        EXPECT_LE(expect_same_dual(scheme, mesh, levels, 2), most(mesh));
  }
}

TEST(FastDualRules, MayLookFar) {
  const Scheme scheme = parsed(kFarther);
  for (const Mesh& mesh :
       {cube(), tetrahedron(), mesh::fan(Lattice::quad, 3, 2), mesh::star(Lattice::quad, 5, 1),
        mesh::face_star(3, 2), mesh::tree(Lattice::quad, 1)})
    for (int levels = 0; levels <= 5; ++levels)
      EXPECT_LE(expect_same_dual(scheme, mesh, levels, 2), 4);
}

TEST(FastDual, SaysWhereAllFacesAreQuads) {
  const Scheme& scheme = shipped("doo-sabin");
  const auto corners = [&](const Mesh& mesh, int levels) {
    return FastRefiner::make(scheme, mesh, levels).value().corners_per_face();
  };
  EXPECT_EQ(corners(mesh::torus(Lattice::quad, 4, 5), 3), 4);
  EXPECT_EQ(corners(mesh::star(Lattice::quad, 4, 2), 2), 4);
  EXPECT_EQ(corners(cube(), 1), 0);
  EXPECT_EQ(corners(mesh::torus(Lattice::triangle, 4, 5), 1), 0);
}

TEST(FastDual, RefusesWhatThePlainEngineRefuses) {
  const Scheme& scheme = shipped("doo-sabin");
  expect_same_dual(scheme, cube(), -1, 1);
  expect_same_dual(scheme, cube(), 40, 1);
  EXPECT_FALSE(FastRefiner::make(scheme, cube(), 40).ok());
  // found out when a mesh has such a face
  const Scheme small = parsed("[corner]\nself = \"1 + (n > 24)/8\"\n");
  expect_same_dual(small, mesh::face_star(30, 1), 2, 1);
  expect_same_dual(small, mesh::face_star(30, 2), 2, 1);
  expect_same_dual(small, mesh::star(Lattice::quad, 30, 2), 2, 1);
  EXPECT_FALSE(FastRefiner::make(small, mesh::face_star(30, 2), 2).ok());
}

}  // namespace
}  // namespace limn::test
