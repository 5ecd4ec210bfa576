#include "limn/mesh/rings.h"

#include <gtest/gtest.h>

#include "mesh/random_mesh.h"

namespace limn::test {
namespace {

TEST(MeshRings, AreWhatTurningMeets) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Mesh mesh = RandomMesh(seed).polygons();
    const std::vector<Index> counts = mesh::valences(mesh);
    ASSERT_EQ(std::ssize(counts), mesh.vertex_count());
    const mesh::Rings all = mesh::rings(mesh, counts);
    ASSERT_EQ(std::ssize(all.begin), mesh.vertex_count() + 1);
    EXPECT_EQ(all.begin.back(), mesh.halfedge_count());
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      EXPECT_EQ(counts[v], mesh.valence(v));
      Index h = mesh.halfedge_of_vertex(v);
      for (Index at = all.begin[v]; at < all.begin[v + 1]; ++at, h = mesh.rotate(h)) {
        EXPECT_EQ(all.halfedges[at], h);
        EXPECT_EQ(all.targets[at], mesh.target(h));
        EXPECT_EQ(all.place[h], at);
      }
      if (!mesh.is_isolated(v))
        EXPECT_EQ(h, mesh.is_boundary_vertex(v) ? kNone : mesh.halfedge_of_vertex(v));
    }
  }
}

}  // namespace
}  // namespace limn::test
