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

TEST(Obj, SaysWhatIsLeftOutOncePerKindAndCounted) {
  Warnings warnings;
  parse(
      "mtllib a.mtl\no thing\ng a b\ns off\nusemtl red\n"
      "vt 0 0\nvt 1 0\nvn 0 0 1\nv 0 0 0 0.5 0.5 0.5\nv 1 0 0 0.5 0.5 0.5 1\nv 0 1 0 1\n"
      "v 0 0 1 2\nl 1 2\nl 2 3\np 1\ncurv 0 1 1 2\nusemtl blue\nf 1/1/1 2/2/1 3/2/1\n"
      "t crease 2/1/0 0 1 4.0\nt corner 1/1/0 3 10\n",
      &warnings);
  std::vector<std::string> said;
  for (const Error& warning : warnings) said.push_back(warning.text());
  EXPECT_EQ(said,
            (std::vector<std::string>{
                "test.obj:1:1: left out: names of material files ('mtllib'), 1 line",
                "test.obj:2:1: left out: object names ('o'), 1 line",
                "test.obj:3:1: left out: groups ('g'), 1 line",
                "test.obj:4:1: left out: smoothing groups ('s'), 1 line",
                "test.obj:5:1: left out: materials of faces ('usemtl'), 2 lines",
                "test.obj:6:1: left out: texture coordinates ('vt'), 2 lines",
                "test.obj:8:1: left out: normals ('vn'), 1 line",
                "test.obj:9:1: left out: vertex colours, 2 vertices",
                "test.obj:12:1: left out: weights w other than 1, 1 vertex",
                "test.obj:13:1: left out: lines ('l'), 2 lines",
                "test.obj:15:1: left out: points ('p'), 1 line",
                "test.obj:16:1: left out: statements 'curv', 1 line",
                "test.obj:19:1: left out: sharp edges and corners, and other tags of OpenSubdiv "
                "('t'), 2 lines"}));
}

TEST(Obj, AThousandKindsOfNoiseAreNotAThousandNotes) {
  std::string noise = kSquare + "f 1 2 3 4\n";
  for (int k = 0; k < 1000; ++k) noise += "word" + std::to_string(k) + " 1 2 3\n";
  const Result<MeshFile> file = parse_mesh_file(noise, "obj", "test.obj");
  ASSERT_TRUE(file.ok());
  EXPECT_LT(file->left_out.size(), 30u);
  std::size_t lines = 0;
  for (const LeftOut& kind : file->left_out) lines += kind.count;
  EXPECT_EQ(lines, 1000u);
}

TEST(Obj, ABackslashWithBlanksBehindItContinues) {
  const Polygons plain = parse(kSquare + "f 1 2 3 4\n");
  for (const std::string blank : {" ", "\t", "  \t "}) {
    for (const std::string end : {"\n", "\r\n", "\r"}) {
      const std::string join = "\\" + blank + end;
      EXPECT_EQ(parse(kSquare + "f 1 2 " + join + "3 4\n"), plain);
      EXPECT_EQ(parse(kSquare + "f 1 2" + join + join + " 3 4\n"), plain);
      EXPECT_EQ(parse(kSquare + "vt 0 " + join + "0\nf 1 2 3 4\n"), plain);
    }
  }
}

TEST(Obj, ANameThatEndsInABackslashSwallowsNoLine) {
  const std::string faces = "f 1 2 3\nf 1 3 4\n";
  const Polygons plain = parse(kSquare + faces);
  for (const std::string name :
       {"usemtl A\\", "usemtl C:\\materials\\", "mtllib ..\\a\\ ", "g a \\", "o \\", "s \\"}) {
    EXPECT_EQ(parse(kSquare + name + "\n" + faces), plain) << name;
    EXPECT_EQ(parse(kSquare + name + "\r\n" + faces), plain) << name;
    EXPECT_EQ(parse(kSquare + "f 1 2 3\n" + name + "\n  f 1 3 4\n"), plain) << name;
    EXPECT_EQ(parse(name + "\n" + kSquare + faces), plain) << name;
  }
  // Before what begins no statement it continues, as in a long list of groups.
  EXPECT_EQ(parse(kSquare + "g a \\\nb c\n" + faces), plain);
}

TEST(Obj, KnowsTheLinesOfVerticesAndFaces) {
  const Result<MeshFile> file =
      parse_mesh_file("# a\nv 0 0 0\nv 1 0 0\n\nv 0 \\\n1 0\nf 1 2 \\\n3\nf 3 2 1\n", "obj", "x");
  ASSERT_TRUE(file.ok());
  EXPECT_EQ(file->source.first, 1);
  EXPECT_EQ(file->source.vertex_lines, (std::vector<int>{2, 3, 5}));
  EXPECT_EQ(file->source.face_lines, (std::vector<int>{7, 9}));
}

TEST(Obj, ReadsTheSharedMeshesIfTheyAreThere) {
  const char* variable = std::getenv("LIMN_SHARED_MESHES");
  if (variable == nullptr) GTEST_SKIP() << "LIMN_SHARED_MESHES names no folder";
  const std::filesystem::path folder = variable;
  ASSERT_TRUE(std::filesystem::is_directory(folder)) << folder;
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

TEST(Obj, PaddingAtTheEndIsNoStatement) {
  const Polygons plain = parse(kSquare + "f 1 2 3 4\n");
  for (const std::string& padding :
       {std::string("\x1a"), std::string(3, '\0'), std::string("\0\n", 2)})
    EXPECT_EQ(parse(kSquare + "f 1 2 3 4\n" + padding), plain);
  EXPECT_FALSE(parse_mesh(kSquare + std::string("\0\n", 2) + "f 1 2 3 4\n", "obj", "").ok());
}

TEST(Obj, NumbersOfOldLibrariesThatAreNoneAreNoNumbersAndComments) {
  for (const std::string word : {"1.#IND", "-1.#INF00", "1.#QNAN", "1.#SNAN0"}) {
    const Result<Polygons> mesh =
        parse_mesh("v 0 0 0\nv 1 0 0\nv 0 1 " + word + "\nf 1 2 3\n", "obj", "");
    ASSERT_FALSE(mesh.ok()) << word;
    EXPECT_EQ(mesh.error().message, "a coordinate is '" + word + "', expected a finite number");
    EXPECT_EQ(mesh.error().line, 3);
  }
  EXPECT_EQ(parse("v 0 0 0\nv 1 0 0\nv 0 1 1.#in\nf 1 2 3#INF\n"),
            parse("v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n"));
}

}  // namespace
}  // namespace limn
