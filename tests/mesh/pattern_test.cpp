#include "limn/mesh/pattern.h"

#include <gtest/gtest.h>

#include "random_mesh.h"

namespace limn::test {
namespace {

TEST(Pattern, IsFoundWhereTheMeshIsTheSame) {
  const Mesh small = mesh::star(Lattice::triangle, 5, 2);
  const Mesh large = mesh::star(Lattice::triangle, 5, 4);
  std::vector<Index> vertices;
  ASSERT_TRUE(
      mesh::Pattern(small, mesh::star_size(Lattice::triangle, 5, 1)).match(large, 0, vertices));
  for (Index v = 0; v < small.vertex_count(); ++v) EXPECT_EQ(vertices[v], v);
}

TEST(Pattern, DiffersWhereAnInnerVertexHasAnotherValence) {
  const mesh::Pattern pattern(mesh::star(Lattice::triangle, 6, 2),
                              mesh::star_size(Lattice::triangle, 6, 1));
  const Mesh mesh = mesh::star(Lattice::triangle, 5, 4);
  std::vector<Index> vertices;
  for (Index v = 0; v < mesh::star_size(Lattice::triangle, 5, 1); ++v)
    EXPECT_FALSE(pattern.match(mesh, mesh.halfedge_of_vertex(v), vertices)) << v;
  EXPECT_TRUE(pattern.match(mesh, mesh.halfedge_of_vertex(6), vertices));
  const mesh::Pattern ring(mesh::star(Lattice::triangle, 6, 1), 1);  // whatever the neighbours are
  EXPECT_TRUE(ring.match(mesh, mesh.halfedge_of_vertex(1), vertices));
}

TEST(Pattern, IsNotWoundTwiceRoundAVertex) {
  const Mesh mesh = tetrahedron();  // a walk round valence 3, made twice, is one round valence 6
  std::vector<Index> vertices;
  EXPECT_FALSE(mesh::Pattern(mesh::star(Lattice::triangle, 6, 1), 1).match(mesh, 0, vertices));
  EXPECT_TRUE(mesh::Pattern(mesh::star(Lattice::triangle, 3, 1), 1).match(mesh, 0, vertices));
}

TEST(Pattern, OfAFanNeedsABoundaryAndOfAStarNone) {
  const Mesh open = mesh::fan(Lattice::quad, 2, 3);
  const Mesh closed = mesh::torus(Lattice::quad, 6, 6);
  std::vector<Index> vertices;
  const mesh::Pattern edge(mesh::fan(Lattice::quad, 2, 1), 1);
  EXPECT_TRUE(edge.match(open, open.halfedge_of_vertex(0), vertices));
  EXPECT_FALSE(edge.match(closed, 0, vertices));
  EXPECT_FALSE(mesh::Pattern(mesh::star(Lattice::quad, 4, 1), 1).match(open, 0, vertices));
}

TEST(Pattern, WindsRoundASmallTorus) {
  const Mesh mesh = mesh::torus(Lattice::triangle, 3, 3);
  std::vector<Index> vertices;
  EXPECT_TRUE(
      mesh::Pattern(mesh::star(Lattice::triangle, 6, 3), mesh::star_size(Lattice::triangle, 6, 2))
          .match(mesh, 0, vertices));
}

}  // namespace
}  // namespace limn::test
