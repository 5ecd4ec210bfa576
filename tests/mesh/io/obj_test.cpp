#include <gtest/gtest.h>

#include "limn/mesh/io/mesh_file.h"
#include "mesh/io/mesh_samples.h"

namespace limn {
namespace {

Polygons parse(std::string_view text, Warnings* warnings = nullptr) {
  Result<Polygons> mesh = parse_mesh(text, "obj", "test.obj", warnings);
  EXPECT_TRUE(mesh.ok()) << mesh.error().text();
  return mesh.ok() ? *mesh : Polygons{};
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, AllIndexFormsMeanTheSame) {
  const std::vector<Index> corners = {0, 1, 2, 3};
  for (const std::string face :
       {"f 1 2 3 4", "f 1/1 2/2 3/3 4/4", "f 1//1 2//1 3//1 4//1", "f 1/1/1 2/2/1 3/3/1 4/4/1",
        "f -4 -3 -2 -1", "f -4/1 2 -2//7 4/", "  f\t1   2 3 4   # comment", "f 1 2 3 4#comment"}) {
    Warnings warnings;
    EXPECT_EQ(parse(kSquare + face + "\n", &warnings).corners, corners) << face;
    EXPECT_TRUE(warnings.empty()) << face;
  }
}

TEST(Obj, NegativeIndicesCountFromTheLineTheyStandOn) {
  const Polygons mesh = parse("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4 -2 -1\n");
  EXPECT_EQ(mesh.corners, (std::vector<Index>{0, 1, 2, 0, 2, 3}));
}

TEST(Obj, FacesMayComeBeforeTheirVertices) {
  EXPECT_EQ(parse("f 1 2 3\n" + kSquare).corners, (std::vector<Index>{0, 1, 2}));
}

TEST(Obj, LineEndsContinuationsAndByteOrderMark) {
  const Polygons plain = parse(kSquare + "f 1 2 3 4\n");
  EXPECT_EQ(parse("\xEF\xBB\xBF" + kSquare + "f 1 2 3 4"), plain);
  EXPECT_EQ(parse("v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nf 1 2 3 4\r\n"), plain);
  EXPECT_EQ(parse("v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3 4\r"), plain);
  EXPECT_EQ(parse("v 0 \\\n0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2\\\r\n3 \\\n  4\n"), plain);
  // A comment ends with its line, even one that ends with a backslash.
  EXPECT_EQ(parse("# C:\\meshes\\\n" + kSquare + "f 1 2 3 4 # \\\n"), plain);
  // What is left out is left out with its continuation.
  EXPECT_EQ(parse(kSquare + "l 1 2 \\\n3 4\nf 1 2 3 4\n"), plain);
}

TEST(Obj, KeepsUnusedAndCoincidentVerticesAndNGons) {
  const Polygons mesh = parse(
      "v 9 9 9\nv 0 0 0\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv -1 0 0\n"
      "f 2 4 5 6 7\nf 3 5 4\n");
  EXPECT_EQ(mesh.vertex_count(), 7);
  EXPECT_EQ(mesh.corners, (std::vector<Index>{1, 3, 4, 5, 6, 2, 4, 3}));
  EXPECT_EQ(mesh.face_begin, (std::vector<Index>{0, 5, 8}));
}

TEST(Obj, NumbersInAllForms) {
  const Polygons mesh = parse("v +1 .5 -2.\nv 1e-400 1E2 -0\nv 0.1 1e+3 4.9e-324\nf 1 2 3\n");
  EXPECT_EQ(mesh.positions[0], (Point3{1, 0.5, -2}));
  EXPECT_EQ(mesh.positions[1], (Point3{0, 100, 0}));  // an underflow is a zero
  EXPECT_TRUE(std::signbit(mesh.positions[1].z));
  EXPECT_EQ(mesh.positions[2], (Point3{0.1, 1000, 4.9e-324}));
}

TEST(Obj, OneWarningPerKindOfContentLeftOut) {
  Warnings warnings;
  parse(
      "mtllib a.mtl\no thing\ng a b\ns off\nusemtl red\n"
      "vt 0 0\nvt 1 0\nvn 0 0 1\nv 0 0 0 0.5 0.5 0.5\nv 1 0 0 0.5 0.5 0.5 1\nv 0 1 0 1\n"
      "v 0 0 1 2\nl 1 2\nl 2 3\np 1\ncurv 0 1 1 2\nf 1/1/1 2/2/1 3/2/1\n",
      &warnings);
  ASSERT_EQ(warnings.size(), 6u);
  EXPECT_EQ(warnings[0].text(),
            "test.obj:6:1: texture coordinates and normals are not refined yet");
  EXPECT_EQ(warnings[1].text(), "test.obj:9:1: vertex colours are left out");
  EXPECT_EQ(warnings[2].text(), "test.obj:12:1: the weight w of vertices is left out");
  EXPECT_EQ(warnings[3].text(), "test.obj:13:1: lines ('l') are left out");
  EXPECT_EQ(warnings[4].text(), "test.obj:15:1: points ('p') are left out");
  EXPECT_EQ(warnings[5].text(), "test.obj:16:1: statements of kind 'curv' are left out");
}

TEST(Obj, ReadsTheSharedMeshesIfTheyAreThere) {
  const char* variable = std::getenv("LIMN_SHARED_MESHES");
  const std::filesystem::path folder = variable != nullptr
                                           ? std::filesystem::path(variable)
                                           : test::source_dir() / "../shared/meshes";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "no " << folder;
  struct Known {
    const char* file;
    Index vertices, faces, corners;
  };
  for (const Known& known : {Known{"spot_control_mesh.obj", 188, 180, -1},
                             Known{"spot_quadrangulated.obj", 2930, 2928, 4 * 2928},
                             Known{"bigguyT.obj", 1452, 2900, 3 * 2900},
                             Known{"stanford-bunny.obj", 34834, 69451, 3 * 69451}}) {
    if (!std::filesystem::exists(folder / known.file)) continue;
    const Result<Polygons> mesh = read_mesh((folder / known.file).string());
    ASSERT_TRUE(mesh.ok()) << mesh.error().text();
    EXPECT_EQ(mesh->vertex_count(), known.vertices);
    EXPECT_EQ(mesh->face_count(), known.faces);
    if (known.corners >= 0) EXPECT_EQ(mesh->corners.size(), known.corners);
    for (const std::string extension : {"obj", "off", "ply"}) {
      const Result<Polygons> again = parse_mesh(*format_mesh(extension, *mesh), extension, "");
      ASSERT_TRUE(again.ok()) << again.error().text();
      EXPECT_TRUE(test::same_bits(*again, *mesh));
    }
  }
}

}  // namespace
}  // namespace limn
