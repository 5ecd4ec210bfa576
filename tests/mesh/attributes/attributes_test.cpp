#include "limn/mesh/attributes/attributes.h"

#include <gtest/gtest.h>

#include "limn/mesh/attributes/carried.h"
#include "limn/mesh/attributes/texture_mesh.h"
#include "limn/mesh/io/mesh_file.h"

namespace limn {
namespace {

MeshFile read(const std::string& obj) {
  return parse_mesh_file(obj, "obj", "a.obj", {.attributes = true}).value();
}

TEST(Attributes, FitAMeshOrNot) {
  const MeshFile file = read("v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\ng a\nf 1/1 2/1 3/1\n");
  EXPECT_TRUE(attributes_fit(file.attributes, file.polygons));
  MeshAttributes changed = file.attributes;
  changed.vertices[0].values.pop_back();
  EXPECT_FALSE(attributes_fit(changed, file.polygons));
  changed = file.attributes;
  changed.texture.of_corner[2] = 1;
  EXPECT_FALSE(attributes_fit(changed, file.polygons));
  changed = file.attributes;
  changed.of(LabelKind::group).of_face.push_back(0);
  EXPECT_FALSE(attributes_fit(changed, file.polygons));
}

// Two squares side by side, each with vertices of its own, as exporters write them.
const std::string kApart =
    "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nv 0 1 0 1 0 0\n"
    "v 1 0 0 0 1 0\nv 2 0 0 0 1 0\nv 2 1 0 0 1 0\nv 1 1 0 0 1 0\n";

TEST(Attributes, OfJoinedVerticesKeepSeamsWhereTextureCoordinatesDiffer) {
  // the lower end of the common edge has equal coordinates on both sides, the upper end has not
  const MeshFile file = read(kApart +
                             "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 1 0\nvt 2 0\nvt 2 1\nvt 1 3\n"
                             "g left\nf 1/1 2/2 3/3 4/4\ng right\nf 5/5 6/6 7/7 8/8\n");
  const mesh::Repaired repaired = mesh::repair(file.polygons, {.weld = 0.0}).value();
  const MeshAttributes welded = mesh::carried(file.attributes, repaired);
  ASSERT_TRUE(attributes_fit(welded, repaired.polygons));
  EXPECT_EQ(welded.texture.points.size(), 7U);
  EXPECT_EQ(welded.find("red")->values, (std::vector<double>{1, 1, 1, 1, 0, 0}));
  EXPECT_EQ(welded.of(LabelKind::group), file.attributes.of(LabelKind::group));
  for (std::size_t c = 0; c < 8; ++c)
    EXPECT_EQ(welded.texture.points[static_cast<std::size_t>(welded.texture.of_corner[c])],
              file.attributes.texture.points[c]);
  const Mesh mesh = Mesh::build(repaired.polygons).value();
  EXPECT_TRUE(mesh::has_seams(mesh, welded.texture));
}

TEST(Attributes, OfReversedFacesAndTrianglesFollowTheirCorners) {
  const MeshFile file = read(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n"
      "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 2 0\nvt 2 1\n"
      "usemtl a\nf 1/1 2/2 3/3 4/4\nusemtl b\nf 3/3 6/6 5/5 2/2\n");
  const mesh::Repaired repaired = mesh::repair(file.polygons, {.orient = true}).value();
  ASSERT_EQ(repaired.done.size(), 1U);
  const MeshAttributes oriented = mesh::carried(file.attributes, repaired);
  const mesh::Triangulation cut = mesh::triangulate(repaired.polygons).value();
  const MeshAttributes triangles = mesh::carried(oriented, cut);
  ASSERT_TRUE(attributes_fit(triangles, cut.polygons));
  // u and v were x and y
  for (std::size_t c = 0; c < cut.polygons.corners.size(); ++c) {
    const Point3 p = cut.polygons.positions[static_cast<std::size_t>(cut.polygons.corners[c])];
    const TexturePoint t =
        triangles.texture.points[static_cast<std::size_t>(triangles.texture.of_corner[c])];
    EXPECT_EQ(p, (Point3{t.u, t.v, 0}));
  }
  EXPECT_EQ(triangles.of(LabelKind::material).of_face, (std::vector<Index>{0, 0, 1, 1}));
}

TEST(Attributes, OfANewCornerAreThoseOfItsVertex) {
  // a triangle without area lies along the longer side of its neighbour, which repair cuts
  const MeshFile file = read(
      "v 0 0 0\nv 2 0 0\nv 1 2 0\nv 1 0 0\nv 1 -1 0\n"
      "vt 0 0\nvt 2 0\nvt 1 2\nvt 1 0\nvt 1 -1\n"
      "f 1/1 2/2 3/3\nf 2/2 1/1 4/4\nf 1/1 5/5 4/4\nf 4/4 5/5 2/2\n");
  const mesh::Repaired repaired =
      mesh::repair(file.polygons, mesh::RepairOptions::everything()).value();
  ASSERT_NE(std::find(repaired.corner_of.begin(), repaired.corner_of.end(), kNone),
            repaired.corner_of.end());
  const MeshAttributes mended = mesh::carried(file.attributes, repaired);
  ASSERT_TRUE(attributes_fit(mended, repaired.polygons));
  for (std::size_t c = 0; c < repaired.polygons.corners.size(); ++c) {
    const Point3 p =
        repaired.polygons.positions[static_cast<std::size_t>(repaired.polygons.corners[c])];
    ASSERT_NE(mended.texture.of_corner[c], kNone);
    const TexturePoint t =
        mended.texture.points[static_cast<std::size_t>(mended.texture.of_corner[c])];
    EXPECT_EQ(p, (Point3{t.u, t.v, 0}));
  }
}

}  // namespace
}  // namespace limn
