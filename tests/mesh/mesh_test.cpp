#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "random_mesh.h"

namespace limn::test {
namespace {

// two triangles (0,1,2) (0,2,3): half-edges 2 and 3 are twins
Mesh::Arrays two_triangles() {
  Mesh::Arrays arrays;
  arrays.vertex_count = 4;
  arrays.edge_count = 5;
  arrays.degree = 3;
  arrays.origin = {0, 1, 2, 0, 2, 3};
  arrays.twin = {kNone, kNone, 3, 2, kNone, kNone};
  arrays.edge = {0, 1, 2, 2, 3, 4};
  return arrays;
}

TEST(Mesh, TellsTheTwoTriangles) {
  const Mesh mesh = Mesh::from_arrays(two_triangles());
  EXPECT_EQ(mesh.check(), "");
  EXPECT_EQ(mesh.face_count(), 2);
  EXPECT_EQ(mesh.valence(0), 3);
  EXPECT_EQ(mesh.valence(1), 2);
  EXPECT_EQ(mesh.halfedge_of_vertex(0), 0);  // on the boundary; 3 is not
  EXPECT_EQ(mesh.rotate(0), 3);
  EXPECT_EQ(mesh.rotate(3), kNone);
  EXPECT_EQ(mesh.halfedge_of_vertex(2), 4);
  EXPECT_TRUE(mesh.is_boundary_edge(0));
  EXPECT_FALSE(mesh.is_boundary_edge(2));
  EXPECT_TRUE(mesh.has_boundary());
}

TEST(Mesh, CheckNamesEachBrokenLaw) {
  auto arrays = two_triangles();
  arrays.twin[3] = kNone;
  EXPECT_EQ(Mesh::from_arrays(arrays).check(), "half-edge 2: twin is no involution");
  arrays = two_triangles();
  arrays.twin = {kNone, kNone, 4, kNone, 2, kNone};
  EXPECT_EQ(Mesh::from_arrays(arrays).check(), "half-edge 2: twin does not run the other way");
  arrays = two_triangles();
  arrays.edge[3] = 3;
  EXPECT_EQ(Mesh::from_arrays(arrays).check(), "half-edge 2: twin has another edge");
  arrays = two_triangles();
  arrays.edge[5] = 3;
  EXPECT_EQ(Mesh::from_arrays(arrays).check(), "edge 3 has a wrong number of half-edges");
  arrays = two_triangles();
  arrays.edge_count = 6;
  EXPECT_EQ(Mesh::from_arrays(arrays).check(), "edge 5 has no half-edge");
  arrays = two_triangles();
  arrays.twin[2] = arrays.twin[3] = kNone;
  arrays.edge = {0, 1, 2, 3, 4, 5};
  arrays.edge_count = 6;
  EXPECT_EQ(Mesh::from_arrays(arrays).check(),
            "vertex 0: its faces are not one fan from its half-edge");
  arrays = two_triangles();
  arrays.degree = 0;
  arrays.face_begin = {0, 2, 6};
  EXPECT_EQ(Mesh::from_arrays(arrays).check(), "face 0 has fewer than three corners");
}

TEST(Mesh, EqualDegreesAreFoundInOffsets) {
  auto arrays = two_triangles();
  arrays.degree = 0;
  arrays.face_begin = {0, 3, 6};
  EXPECT_EQ(Mesh::from_arrays(arrays).uniform_degree(), 3);
  EXPECT_EQ(must_build(5, {{0, 1, 2}, {0, 2, 3, 4}}).uniform_degree(), 0);
}

RC_GTEST_PROP(MeshLaws, TurnsAboutEveryVertex, (unsigned seed)) {
  const Mesh mesh = RandomMesh(seed).polygons();
  std::vector<Index> edges(static_cast<std::size_t>(mesh.vertex_count()), 0);
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e);
    ++edges[mesh.origin(h)];
    ++edges[mesh.target(h)];
  }
  Index most = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    RC_ASSERT(mesh.valence(v) == edges[v]);
    most = std::max(most, edges[v]);
  }
  RC_ASSERT(mesh.max_valence() == most);
  std::size_t degree = 0;
  for (const auto& face : faces_of(polygons_of(mesh))) degree = std::max(degree, face.size());
  RC_ASSERT(mesh.max_degree() == static_cast<Index>(degree));
}

}  // namespace
}  // namespace limn::test
