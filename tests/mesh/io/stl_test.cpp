#include <gtest/gtest.h>

#include "limn/mesh/io/mesh_file.h"
#include "limn/mesh/mesh.h"
#include "mesh/io/mesh_samples.h"

namespace limn {
namespace {

Polygons parse(std::string_view text, Warnings* warnings = nullptr) {
  Result<Polygons> mesh = parse_mesh(text, "stl", "test.stl", warnings);
  EXPECT_TRUE(mesh.ok()) << mesh.error().text();
  return mesh.ok() ? *mesh : Polygons{};
}

float float_at(const std::string& text, std::size_t at) {
  float value = 0;
  std::memcpy(&value, text.data() + at, sizeof(value));
  return value;
}

TEST(Stl, AsciiInAnyCaseAndLayoutMergesEqualCorners) {
  const Polygons mesh = parse(
      "SOLID two words\nFACET NORMAL nan nan nan\n OUTER LOOP\n  VERTEX 0 0 0\n  VERTEX 1 0 0\n"
      "  VERTEX 0 1 0\n ENDLOOP\nENDFACET\nendsolid two words\n"
      "solid\n\nfacet normal 0 0 1 outer loop vertex 1 0\n0 vertex 1 1 0 vertex 0 1 0 endloop "
      "endfacet\nendsolid");
  EXPECT_EQ(mesh.positions, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(mesh.corners, (std::vector<Index>{0, 1, 2, 1, 3, 2}));
  EXPECT_EQ(mesh.face_begin, (std::vector<Index>{0, 3, 6}));
}

TEST(Stl, ZerosOfBothSignsAreOnePlace) {
  const Polygons mesh = parse(
      "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 -0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\nfacet normal 0 0 1\nouter loop\nvertex -0 0 0\nvertex 0 1 0\nvertex 1 0 0\n"
      "endloop\nendfacet\nendsolid\n");
  EXPECT_EQ(mesh.vertex_count(), 3);
  for (const Point3& p : mesh.positions)
    for (const double x : {p.x, p.y, p.z}) EXPECT_FALSE(std::signbit(x));
}

/// Each corner of the cube's triangles has zeros of signs of its own.
TEST(Stl, ACubeWithNegativeZerosIsClosed) {
  std::string text = *format_mesh("stl", test::cube());
  for (std::size_t at = 84, k = 0; at + 50 <= text.size(); at += 50) {
    for (std::size_t corner = at + 12; corner < at + 48; corner += 4, ++k)
      if (float_at(text, corner) == 0 && k % 5 > 1) text[corner + 3] = '\x80';
  }
  const Polygons mesh = parse(text);
  EXPECT_EQ(mesh.vertex_count(), 8);
  const Result<Mesh> built = Mesh::build(mesh);
  ASSERT_TRUE(built.ok()) << built.error().text();
  EXPECT_FALSE(built->has_boundary());
}

std::string facet(const char* a, const char* b, const char* c) {
  return std::string(" facet normal 0 0 0\n  outer loop\n   vertex ") + a + "\n   vertex " + b +
         "\n   vertex " + c + "\n  endloop\n endfacet\n";
}

TEST(Stl, EndAndItsWordMayBeApart) {
  const std::string good = "solid t\n" + facet("0 0 0", "0 1 0", "1 0 0") + "endsolid t\n";
  const Polygons plain = parse(good);
  for (const std::string end : {"end solid t\n", "End Solid\n", "END SOLID a name with blanks",
                                "ENDSOLID", "end\nsolid t\n"})
    EXPECT_EQ(parse("solid t\n" + facet("0 0 0", "0 1 0", "1 0 0") + end), plain) << end;
  std::string apart = good;
  apart.replace(apart.find("endloop"), 7, "end loop");
  apart.replace(apart.find("endfacet"), 8, "END Facet");
  EXPECT_EQ(parse(apart), plain);
  EXPECT_FALSE(
      parse_mesh("solid t\n" + facet("0 0 0", "0 1 0", "1 0 0") + "end t\n", "stl", "").ok());
  // Two solids, of which one ends so; that they were two is not kept.
  Warnings warnings;
  EXPECT_EQ(
      parse("solid a b\n" + facet("0 0 0", "0 1 0", "1 0 0") + "end solid a b\nSOLID end solid\n" +
                facet("0 0 0", "1 0 0", "0 0 1") + "endsolid\n",
            &warnings)
          .face_count(),
      2);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].message, "left out: which facets form a solid, 2 solids");
}

TEST(Stl, DegenerateFacetsAreDroppedWithAWordAndFacetsKeepTheirNumbers) {
  const std::string text = "solid\n" + facet("9 9 9", "9 9 9", "8 8 8") +
                           facet("0 0 0", "0 1 0", "1 0 0") + facet("0 0 0", "1 0 0", "-0 0 -0") +
                           facet("0 0 0", "1 0 0", "0 0 1") + "endsolid\n";
  const Result<MeshFile> file = parse_mesh_file(text, "stl", "test.stl");
  ASSERT_TRUE(file.ok());
  EXPECT_EQ(file->polygons.vertex_count(), 4);  // the places of a dropped facet are no vertices
  EXPECT_EQ(file->polygons.corners, (std::vector<Index>{0, 1, 2, 0, 2, 3}));
  ASSERT_EQ(file->warnings.size(), 1u);
  EXPECT_EQ(
      file->warnings[0].text(),
      "test.stl:2: 2 facets dropped: two of their corners are one place (the first is facet 0, "
      "counted from 0)");
  EXPECT_EQ(file->source.file_faces, (std::vector<Index>{1, 3}));
  EXPECT_EQ(file->source.face_lines, (std::vector<int>{2, 9, 16, 23}));
  EXPECT_FALSE(
      parse_mesh("solid\n" + facet("0 0 0", "0 0 0", "1 0 0") + "endsolid\n", "stl", "").ok());
  // A sliver of three places is kept: without it there would be a crack.
  EXPECT_EQ(parse("solid\n" + facet("0 0 0", "1 0 0", "2 0 0") + "endsolid\n").face_count(), 1);
}

TEST(Stl, PaddingBehindBinaryDataIsAWarning) {
  const std::string text = *format_mesh("stl", test::cube());
  for (const std::string& padding : {std::string("\n"), std::string(512, '\0')}) {
    Warnings warnings;
    EXPECT_EQ(parse(text + padding, &warnings), parse(text));
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].message.find("padding"), std::string::npos);
  }
  EXPECT_FALSE(parse_mesh(text + "x", "stl", "").ok());
}

TEST(Stl, BinaryWithASolidHead) {
  std::string text = *format_mesh("stl", test::cube());
  EXPECT_NE(text.substr(0, 5), "solid");
  const Polygons mesh = parse(text);
  text.replace(0, 11, "solid model");
  EXPECT_EQ(parse(text), mesh);
  EXPECT_EQ(mesh.vertex_count(), 8);
  EXPECT_EQ(mesh.face_count(), 12);
}

TEST(Stl, WritesFansWithOutwardNormals) {
  const std::string text = *format_mesh("stl", test::cube());
  ASSERT_EQ(text.size(), 84u + 12 * 50);
  const float expected[6][3] = {{0, 0, -1}, {0, 0, 1}, {0, -1, 0},
                                {1, 0, 0},  {0, 1, 0}, {-1, 0, 0}};
  for (std::size_t triangle = 0; triangle < 12; ++triangle) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(float_at(text, 84 + 50 * triangle + 4 * axis), expected[triangle / 2][axis]);
    }
  }
  // The second triangle of the first quad 0 3 2 1 is 0 2 1.
  EXPECT_EQ(float_at(text, 84 + 50 + 12 + 12), 1);
  EXPECT_EQ(float_at(text, 84 + 50 + 12 + 16), 1);
}

TEST(Stl, ManyVerticesAreMergedOnce) {
  // A strip of quads: more vertices than the first table of the merger holds.
  Polygons strip;
  for (int k = 0; k <= 1000; ++k) {
    strip.positions.push_back({double(k), 0, 0});
    strip.positions.push_back({double(k), 1, 0});
  }
  for (Index k = 0; k < 1000; ++k) {
    for (const Index v : {2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1}) strip.corners.push_back(v);
    strip.face_begin.push_back(static_cast<Index>(strip.corners.size()));
  }
  const Polygons mesh = parse(*format_mesh("stl", strip));
  EXPECT_EQ(mesh.vertex_count(), 2002);
  EXPECT_EQ(mesh.face_count(), 2000);
}

}  // namespace
}  // namespace limn
