#include <gtest/gtest.h>

#include "limn/mesh/io/mesh_file.h"
#include "mesh/io/mesh_samples.h"

namespace limn {
namespace {

Polygons parse(std::string_view text) {
  Result<Polygons> mesh = parse_mesh(text, "stl", "test.stl");
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

TEST(Stl, ZerosOfBothSignsStayApart) {
  const Polygons mesh = parse(
      "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\nfacet normal 0 0 1\nouter loop\nvertex -0 0 0\nvertex 0 1 0\nvertex 1 0 0\n"
      "endloop\nendfacet\nendsolid\n");
  EXPECT_EQ(mesh.vertex_count(), 4);
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
