#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "random_mesh.h"

namespace limn::test {
namespace {

Error refusal(Index vertices, const Faces& faces) {
  Result<Mesh> built = Mesh::build(make_polygons(vertices, faces));
  if (built.ok()) return Error{};
  EXPECT_FALSE(built.error().hint.empty());
  return built.error();
}

TEST(MeshBuild, RefusesAVertexOutOfRange) {
  EXPECT_EQ(refusal(3, {{0, 1, 2}, {2, 1, 3}}).message,
            "corner 2 of face 1 is vertex 3, but the vertices are 0 to 2");
  EXPECT_EQ(refusal(3, {{0, -1, 2}}).message,
            "corner 1 of face 0 is vertex -1, but the vertices are 0 to 2");
  EXPECT_NE(refusal(0, {{0, 1, 2}})
                .message.find("corner 0 of face 0 is vertex 0, but there are no vertices"),
            std::string::npos);
}

TEST(MeshBuild, RefusesDegenerateFaces) {
  EXPECT_EQ(refusal(3, {{0, 1, 2}, {0, 1}}).message,
            "face 1 has 2 corners, but a face needs at least 3");
  EXPECT_EQ(refusal(3, {{}}).message, "face 0 has 0 corners, but a face needs at least 3");
  EXPECT_EQ(refusal(4, {{0, 1, 2, 1}}).message, "face 0 meets vertex 1 twice");
}

TEST(MeshBuild, RefusesBadOffsets) {
  Polygons bad = make_polygons(3, {{0, 1, 2}});
  bad.face_begin.back() = 4;
  EXPECT_FALSE(Mesh::build(bad));
  bad.face_begin = {0, 9, 3};  // 9 points past the corners, and must not be followed
  EXPECT_FALSE(Mesh::build(bad));
  bad.face_begin = {};
  EXPECT_FALSE(Mesh::build(bad));
}

TEST(MeshBuild, RefusesAnEdgeInThreeFaces) {
  EXPECT_EQ(refusal(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}).message,
            "the edge between vertices 0 and 1 lies in 3 faces (0, 1 and 2), but on a surface it "
            "lies in at most 2");
}

TEST(MeshBuild, RefusesAFlippedNeighbour) {
  EXPECT_EQ(refusal(4, {{0, 1, 2}, {1, 2, 3}}).message,
            "faces 0 and 1 both run from vertex 1 to vertex 2: one of them is flipped");
  // a Möbius band cannot be turned round; it is refused for the same reason
  EXPECT_NE(refusal(6, {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 3, 0, 5}}).message.find("flipped"),
            std::string::npos);
}

TEST(MeshBuild, RefusesABowTie) {
  EXPECT_EQ(refusal(5, {{0, 1, 2}, {0, 3, 4}}).message,
            "the faces round vertex 0 form more than one fan (faces 0 apart from 1): the surface "
            "only touches itself there");
  // two closed surfaces that share a vertex: both fans close
  Faces two = faces_of(polygons_of(tetrahedron()));
  for (auto face : faces_of(polygons_of(tetrahedron()))) {
    for (Index& v : face) v = v == 0 ? 0 : v + 3;
    two.push_back(face);
  }
  EXPECT_NE(refusal(7, two).message.find("round vertex 0"), std::string::npos);
  // a closed and an open one
  two.erase(two.begin() + 2);
  two.erase(two.begin());
  EXPECT_NE(refusal(7, two).message.find("round vertex 0"), std::string::npos);
}

TEST(MeshBuild, WarnsOnceOfIsolatedVertices) {
  Warnings warnings;
  const Mesh mesh = Mesh::build(make_polygons(6, {{1, 2, 4}}), &warnings).value();
  EXPECT_EQ(mesh.vertex_count(), 6);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].message, "3 vertices belong to no face (0, 3 and 5)");
  EXPECT_TRUE(mesh.is_isolated(0));
  EXPECT_FALSE(mesh.is_boundary_vertex(0));
  EXPECT_EQ(mesh.valence(0), 0);
  warnings.clear();
  ASSERT_TRUE(Mesh::build(make_polygons(4, {{1, 2, 0}}), &warnings));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0].message, "vertex 3 belongs to no face");
  warnings.clear();
  ASSERT_TRUE(Mesh::build(make_polygons(3, {{1, 2, 0}}), &warnings));
  EXPECT_TRUE(warnings.empty());
}

TEST(MeshBuild, TakesAnEmptyMesh) {
  const Mesh mesh = Mesh::build(Polygons{}).value();
  EXPECT_EQ(mesh.check(), "");
  EXPECT_EQ(mesh.face_count() + mesh.edge_count() + mesh.vertex_count(), 0);
  EXPECT_EQ(mesh.uniform_degree(), 0);
  EXPECT_FALSE(mesh.has_boundary());
}

TEST(MeshBuild, KnowsTheCube) {
  const Mesh mesh = cube();
  EXPECT_EQ(mesh.edge_count(), 12);
  EXPECT_EQ(mesh.uniform_degree(), 4);
  EXPECT_EQ(mesh.max_valence(), 3);
  EXPECT_FALSE(mesh.has_boundary());
  EXPECT_EQ(euler_characteristic(mesh), 2);
}

TEST(MeshBuild, HoldsHighValenceInLinearTime) {
  const Index n = 20000;  // quadratic matching at the pole would take minutes
  const Mesh mesh = mesh::star(Lattice::triangle, n, 1);
  EXPECT_EQ(mesh.valence(0), n);
  EXPECT_EQ(mesh.max_valence(), n);
}

RC_GTEST_PROP(MeshBuildLaws, AgreesWithAMapOfEdges, (unsigned seed)) {
  const Mesh mesh = RandomMesh(seed).polygons();
  RC_ASSERT(mesh.check() == "");
  std::map<std::pair<Index, Index>, Index> by_ends;
  for (Index h = 0; h < mesh.halfedge_count(); ++h) by_ends[{mesh.origin(h), mesh.target(h)}] = h;
  for (Index h = 0; h < mesh.halfedge_count(); ++h) {
    const auto found = by_ends.find({mesh.target(h), mesh.origin(h)});
    RC_ASSERT(mesh.twin(h) == (found == by_ends.end() ? kNone : found->second));
  }
}

RC_GTEST_PROP(MeshBuildLaws, KeepsPolygonsAsGiven, (unsigned seed)) {
  const Polygons polygons = polygons_of(RandomMesh(seed).polygons());
  const Mesh mesh = Mesh::build(polygons).value();
  RC_ASSERT(mesh.polygons(polygons.positions) == polygons);
}

RC_GTEST_PROP(MeshBuildLaws, RefusesOneFlippedFaceAndOneCopiedFace,
              (unsigned seed, unsigned pick)) {
  const Mesh mesh = RandomMesh(seed).polygons();
  const Faces faces = faces_of(polygons_of(mesh));
  const std::size_t f = pick % faces.size();
  bool alone = true;
  for (Index h = mesh.face_begin(static_cast<Index>(f));
       h < mesh.face_begin(static_cast<Index>(f) + 1); ++h)
    alone = alone && mesh.twin(h) == kNone;
  Faces flipped = faces;
  std::reverse(flipped[f].begin(), flipped[f].end());
  RC_ASSERT(Mesh::build(make_polygons(mesh.vertex_count(), flipped)).ok() == alone);
  Faces copied = faces;
  copied.push_back(faces[f]);
  RC_ASSERT(!Mesh::build(make_polygons(mesh.vertex_count(), copied)).ok());
}

}  // namespace
}  // namespace limn::test
