// That the meshes of the comparisons hold what the comparisons are about.

#include "control_meshes.h"

#include <gtest/gtest.h>

#include <set>

namespace limn::peers {
namespace {

struct Found {
  std::set<Index> inner_valences, boundary_valences, degrees;
};

Found found_in(const std::vector<ControlMesh>& meshes, bool closed) {
  Found found;
  for (const ControlMesh& control : meshes) {
    EXPECT_TRUE(is_plain(control.polygons)) << control.name;
    const Mesh mesh = Mesh::build(control.polygons).value();
    EXPECT_EQ(mesh.has_boundary(), !closed) << control.name;
    for (Index v = 0; v < mesh.vertex_count(); ++v)
      (mesh.is_boundary_vertex(v) ? found.boundary_valences : found.inner_valences)
          .insert(mesh.valence(v));
    for (Index f = 0; f < mesh.face_count(); ++f) found.degrees.insert(mesh.degree(f));
  }
  return found;
}

bool holds(const std::set<Index>& found, Index first, Index last) {
  for (; first <= last; ++first)
    if (found.count(first) == 0) return false;
  return true;
}

TEST(PeersControlMeshes, ClosedTrianglesHaveManyValences) {
  const Found found = found_in(closed_triangles(), true);
  EXPECT_TRUE(holds(found.inner_valences, 3, 12));
  EXPECT_EQ(found.degrees, std::set<Index>{3});
}

TEST(PeersControlMeshes, OpenTrianglesHaveManyValences) {
  const Found found = found_in(open_triangles(), false);
  EXPECT_TRUE(holds(found.inner_valences, 3, 9));
  EXPECT_TRUE(holds(found.boundary_valences, 2, 7));
  EXPECT_EQ(found.degrees, std::set<Index>{3});
}

TEST(PeersControlMeshes, ClosedPolygonsHaveManyValencesAndDegrees) {
  const Found found = found_in(closed_polygons(), true);
  EXPECT_TRUE(holds(found.inner_valences, 3, 8));
  EXPECT_TRUE(holds(found.degrees, 3, 9));
}

TEST(PeersControlMeshes, OpenPolygonsHaveManyValencesAndDegrees) {
  const Found found = found_in(open_polygons(), false);
  EXPECT_TRUE(holds(found.inner_valences, 3, 6));
  EXPECT_TRUE(holds(found.boundary_valences, 2, 6));
  EXPECT_TRUE(holds(found.degrees, 3, 8));
}

}  // namespace
}  // namespace limn::peers
