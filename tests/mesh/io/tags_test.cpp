#include <gtest/gtest.h>

#include "limn/mesh/io/mesh_file.h"

namespace limn {
namespace {

const std::string kSquares =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nf 1 2 3 4\nf 2 5 6 3\n";  // 8 lines

SharpnessTags read(const std::string& lines) {
  const Result<MeshFile> file = parse_mesh_file(kSquares + lines, "obj", "a.obj");
  EXPECT_TRUE(file.ok()) << (file ? "" : file.error().text());
  return file ? file->tags : SharpnessTags{};
}

std::string fault(const std::string& lines) {
  const Result<MeshFile> file = parse_mesh_file(kSquares + lines, "obj", "a.obj");
  return file ? "" : file.error().text();
}

TEST(ObjTags, AreReadWithTheirLines) {
  const SharpnessTags tags = read(
      "t crease 3/2/0 0 1 2 0.5 10\nt corner 2/1/0 0 3 2.5\nt interpolateboundary 1/0/0 2\n"
      "t hole 1/0/0 1\nt creasemethod 0/0/1 chaikin\nt smoothtriangles 0/0/1 smooth\n");
  EXPECT_EQ(tags.file, "a.obj");
  ASSERT_EQ(tags.creases.size(), 1U);
  EXPECT_EQ(tags.creases[0].vertices, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(tags.creases[0].sharpness, (std::vector<double>{0.5, 10}));
  EXPECT_EQ(tags.creases[0].line, 9);
  ASSERT_EQ(tags.corners.size(), 2U);
  EXPECT_EQ(tags.corners[1].vertex, 3);
  EXPECT_EQ(tags.corners[1].sharpness, 2.5);
  EXPECT_EQ(tags.corners[1].line, 10);
  EXPECT_EQ(tags.boundary, BoundaryMode::edge_only);
  ASSERT_EQ(tags.holes.size(), 1U);
  EXPECT_EQ(tags.holes[0].face, 1);
  EXPECT_EQ(tags.method, CreaseMethod::chaikin);
  EXPECT_EQ(tags.smooth_triangles, true);
  EXPECT_EQ(read("t interpolateboundary 1/0/0 0\n").boundary, BoundaryMode::none);
  EXPECT_EQ(read("t interpolateboundary 1/0/0 1\n").boundary, BoundaryMode::edge_and_corner);
  EXPECT_EQ(read("t creasemethod 0/0/1 normal\n").method, CreaseMethod::uniform);
  EXPECT_TRUE(read("").empty());
}

TEST(ObjTags, ThatAreFaultyAreRefusedWithTheirPlace) {
  EXPECT_EQ(fault("t\n"), "a.obj:9:2: expected the name of a tag");
  EXPECT_EQ(fault("t crease 2/1 0 1 2\n"),
            "a.obj:9:10: expected the numbers of integers, decimals and words of the tag, as "
            "2/1/0, found '2/1'");
  EXPECT_EQ(fault("t crease 1/1/0 0 2\n"),
            "a.obj:9:1: a crease of 1 vertices, expected two or more");
  EXPECT_EQ(fault("t crease 4/2/0 0 1 2 3 1 1\n"),
            "a.obj:9:1: the tag has 2 decimals, expected one sharpness or 3");
  EXPECT_EQ(fault("t crease 2/1/0 0 1 -2\n"), "a.obj:9:1: a sharpness of -2, expected 0 or more");
  EXPECT_EQ(fault("t corner 1/1/0 -1 2\n"),
            "a.obj:9:16: expected a number of 0 or more, found '-1'");
  EXPECT_EQ(fault("t corner 1/1/0 1 2 3\n"),
            "a.obj:9:20: the tag has more than its 1/1/0 arguments");
  EXPECT_EQ(fault("t interpolateboundary 1/0/0 3\n"),
            "a.obj:9:1: expected 0 (none), 1 (edges and corners) or 2 (edges) for "
            "interpolateboundary");
  EXPECT_NE(fault("t corner 1/1/0 1 nan\n"), "");
  EXPECT_NE(fault("t corner 1/1/0 1\n"), "");
  EXPECT_NE(fault("t creasemethod 0/0/1 other\n"), "");
  EXPECT_NE(fault("t smoothtriangles 1/0/0 1\n"), "");
}

TEST(ObjTags, OfOtherNamesAreLeftOut) {
  const Result<MeshFile> file =
      parse_mesh_file(kSquares + "t facevaryinginterpolateboundary 1/0/0 1\n", "obj", "a.obj");
  ASSERT_TRUE(file.ok());
  ASSERT_EQ(file->left_out.size(), 1U);
  EXPECT_EQ(file->left_out[0].what, "tags 'facevaryinginterpolateboundary' ('t')");
}

TEST(ObjTags, AreWrittenSoThatTheyReadBack) {
  SharpnessTags tags;
  tags.creases = {{{0, 1}, {1.0 / 3}, 0}, {{1, 2}, {10}, 0}};
  tags.corners = {{5, 2, 0}};
  tags.holes = {{1, 0}};
  tags.boundary = BoundaryMode::edge_and_corner;
  tags.method = CreaseMethod::chaikin;
  tags.smooth_triangles = true;
  WriteOptions options;
  options.tags = tags;
  const Polygons mesh = parse_mesh_file(kSquares, "obj", "a.obj").value().polygons;
  const MeshFile again =
      parse_mesh_file(format_mesh("obj", mesh, options).value(), "obj", "b.obj").value();
  ASSERT_EQ(again.tags.creases.size(), 2U);
  EXPECT_EQ(again.tags.creases[0].sharpness, tags.creases[0].sharpness);
  EXPECT_EQ(again.tags.creases[1].vertices, tags.creases[1].vertices);
  ASSERT_EQ(again.tags.corners.size(), 1U);
  EXPECT_EQ(again.tags.corners[0].vertex, 5);
  ASSERT_EQ(again.tags.holes.size(), 1U);
  EXPECT_EQ(again.tags.boundary, tags.boundary);
  EXPECT_EQ(again.tags.method, tags.method);
  EXPECT_EQ(again.tags.smooth_triangles, true);
  EXPECT_TRUE(lost_tags("OBJ", tags).empty());
  EXPECT_EQ(lost_tags("ply", tags).creases.size(), 0U);
  EXPECT_EQ(lost_tags("ply", tags).corners.size(), 1U);
  EXPECT_EQ(lost_tags("off", tags).creases.size(), 2U);
}

// --- edges in PLY -------------------------------------------------------------------------------

std::string ply(const std::string& edges) {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
         "property double z\nelement face 1\nproperty list uchar int vertex_indices\n"
         "element edge 2\nproperty uchar red\nproperty int vertex1\nproperty int vertex2\n"
         "property float sharpness\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n" +
         edges;
}

TEST(PlyEdges, HaveASharpness) {
  const MeshFile file = parse_mesh_file(ply("9 0 1 2.5\n9 1 2 0\n"), "ply", "a.ply").value();
  ASSERT_EQ(file.tags.creases.size(), 1U);  // the other is smooth
  EXPECT_EQ(file.tags.creases[0].vertices, (std::vector<Index>{0, 1}));
  EXPECT_EQ(file.tags.creases[0].sharpness, std::vector<double>{2.5});
  EXPECT_EQ(file.tags.creases[0].line, 19);
  Warnings notes;
  EXPECT_TRUE(parse_mesh(ply("9 0 1 2.5\n9 1 2 0\n"), "ply", "a.ply", &notes).ok());
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].message, "left out: the sharpness of edges, 1 edge");
}

TEST(PlyEdges, ThatAreFaultyAreRefused) {
  const auto fault = [](const std::string& edges) {
    const Result<MeshFile> file = parse_mesh_file(ply(edges), "ply", "a.ply");
    return file ? "" : file.error().text();
  };
  EXPECT_NE(fault("9 0 3 2.5\n9 1 2 0\n").find("a.ply:19:5: vertex index 3 is out of range"),
            std::string::npos);
  EXPECT_NE(fault("9 0 1 -1\n9 1 2 0\n").find("a.ply:19:7: a sharpness below 0"),
            std::string::npos);
}

TEST(PlyEdges, AreWrittenSoThatTheyReadBack) {
  WriteOptions options;
  options.tags.creases = {{{0, 1}, {1.0 / 3}, 0}, {{2, 1}, {10}, 0}};
  const Polygons mesh = parse_mesh_file(kSquares, "obj", "a.obj").value().polygons;
  const MeshFile again =
      parse_mesh_file(format_mesh("ply", mesh, options).value(), "ply", "b.ply").value();
  EXPECT_EQ(again.polygons, mesh);
  ASSERT_EQ(again.tags.creases.size(), 2U);
  EXPECT_EQ(again.tags.creases[0].sharpness, options.tags.creases[0].sharpness);
  EXPECT_EQ(again.tags.creases[1].vertices, options.tags.creases[1].vertices);
}

}  // namespace
}  // namespace limn
