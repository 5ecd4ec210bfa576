#include <gtest/gtest.h>

#include <algorithm>

#include "limn/mesh/io/mesh_file.h"
#include "mesh/io/mesh_samples.h"

namespace limn {
namespace {

Polygons parse(std::string_view text, Warnings* warnings = nullptr) {
  Result<Polygons> mesh = parse_mesh(text, "ply", "test.ply", warnings);
  EXPECT_TRUE(mesh.ok()) << mesh.error().text();
  return mesh.ok() ? *mesh : Polygons{};
}

/// The bytes of `value` in the byte order asked for (the tests run on little-endian machines).
template <class T>
std::string bytes(T value, bool big) {
  std::string text(sizeof(T), '\0');
  std::memcpy(text.data(), &value, sizeof(T));
  if (big) std::reverse(text.begin(), text.end());
  return text;
}

const Polygons kTriangle{{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}, {0, 3}, {0, 1, 2}};

/// A triangle with coordinates, list lengths and indices of the types given by name and type.
template <class X, class N, class I>
std::string triangle(const char* x, const char* n, const char* i, bool big, const char* list) {
  std::string text = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                     "_endian 1.0\ncomment of a test\nelement vertex 3\nproperty " + x +
                     " x\nproperty " + x + " y\nproperty " + x +
                     " z\nelement face 1\nproperty list " + n + " " + i + " " + list +
                     "\nend_header\n";
  for (const Point3& p : kTriangle.positions) {
    for (const double c : {p.x, p.y, p.z}) text += bytes(static_cast<X>(c), big);
  }
  text += bytes(static_cast<N>(3), big);
  for (const Index v : kTriangle.corners) text += bytes(static_cast<I>(v), big);
  return text;
}

TEST(Ply, AllTypesInBothByteOrders) {
  using std::int16_t, std::int32_t, std::int8_t, std::uint16_t, std::uint32_t, std::uint8_t;
  for (const bool big : {false, true}) {
    for (const char* list : {"vertex_indices", "vertex_index"}) {
      EXPECT_EQ(parse(triangle<float, uint8_t, int32_t>("float", "uchar", "int", big, list)),
                kTriangle);
      EXPECT_EQ(parse(triangle<double, int8_t, uint32_t>("double", "char", "uint", big, list)),
                kTriangle);
      EXPECT_EQ(parse(triangle<int16_t, uint16_t, uint8_t>("short", "ushort", "uchar", big, list)),
                kTriangle);
      EXPECT_EQ(parse(triangle<int32_t, int32_t, int16_t>("int32", "int32", "int16", big, list)),
                kTriangle);
      EXPECT_EQ(
          parse(triangle<uint8_t, uint32_t, uint16_t>("uint8", "uint32", "uint16", big, list)),
          kTriangle);
      EXPECT_EQ(parse(triangle<float, float, double>("float32", "float32", "float64", big, list)),
                kTriangle);
    }
  }
}

TEST(Ply, AsciiWithOtherContentInAnyOrder) {
  Warnings warnings;
  const Polygons mesh = parse(
      "ply\r\nformat ascii 1.0\r\ncomment made by hand\r\nobj_info none\r\n"
      "element face 1\r\nproperty uchar red\r\nproperty list uchar float texcoord\r\n"
      "property list int uint vertex_indices\r\n"
      "element edge 2\r\nproperty int vertex1\r\nproperty int vertex2\r\n"
      "element nothing 1000000000000\r\n"
      "element vertex 3\r\nproperty double quality\r\nproperty float z\r\nproperty float y\r\n"
      "property float x\r\nproperty float nx\r\nproperty uchar red\r\nproperty uchar green\r\n"
      "end_header\r\n"
      "255 2 0.5 0.5 3 0 1 2\r\n0 1\r\n1 2\r\n"
      "nan 0.1 0 0 1 7 7\r\n0 0 0 1 1 7 7\r\n\r\n0 0 2 0 1 7 7\r\n",
      &warnings);
  EXPECT_EQ(mesh.positions, (std::vector<Point3>{{0, 0, 0.1}, {1, 0, 0}, {0, 2, 0}}));
  EXPECT_EQ(mesh.corners, kTriangle.corners);
  std::vector<std::string> said;
  for (const Error& warning : warnings) said.push_back(warning.message);
  EXPECT_EQ(said, (std::vector<std::string>{
                      "left out: face colours, 1 face", "left out: texture coordinates, 1 face",
                      "left out: elements 'edge', 2 of them",
                      "left out: elements 'nothing', 1000000000000 of them",
                      "left out: the vertex property 'quality', 3 vertices",
                      "left out: normals, 3 vertices", "left out: vertex colours, 3 vertices"}));
  EXPECT_EQ(warnings[0].line, 6);
  EXPECT_EQ(warnings[0].column, 16);
}

TEST(Ply, BinarySkipsOtherContent) {
  std::string text =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
      "property list uchar short tags\nproperty float y\nproperty float z\n"
      "element patch 2\nproperty list ushort double knots\nproperty char kind\n"
      "element face 1\nproperty float area\nproperty list uchar int vertex_index\nend_header\n";
  for (int v = 0; v < 3; ++v) {
    const Point3 p = kTriangle.positions[v];
    text += bytes(static_cast<float>(p.x), false) + bytes(static_cast<std::uint8_t>(v), false);
    for (int k = 0; k < v; ++k) text += bytes(std::int16_t{77}, false);
    text += bytes(static_cast<float>(p.y), false) + bytes(static_cast<float>(p.z), false);
  }
  text += bytes(std::uint16_t{0}, false) + "a" + bytes(std::uint16_t{1}, false) +
          bytes(3.5, false) + "b";
  text += bytes(std::numeric_limits<float>::quiet_NaN(), false) + "\3";
  for (const Index v : kTriangle.corners) text += bytes(v, false);
  EXPECT_EQ(parse(text), kTriangle);
}

TEST(Ply, HeaderWithCarriageReturnsBeforeBinaryData) {
  std::string text =
      triangle<float, std::uint8_t, std::int32_t>("float", "uchar", "int", false, "vertex_indices");
  const std::size_t head = text.find("end_header\n") + 11;
  std::string with_cr;
  for (const char c : text.substr(0, head)) with_cr += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(parse(with_cr + text.substr(head)), kTriangle);
}

TEST(Ply, AfterAHeaderWithCarriageReturnsAloneALineFeedIsData) {
  std::string text =
      triangle<float, std::uint8_t, std::int32_t>("float", "uchar", "int", false, "vertex_indices");
  const std::size_t head = text.find("end_header\n") + 11;
  for (char& c : text) c = &c < text.data() + head && c == '\n' ? '\r' : c;
  EXPECT_EQ(parse(text), kTriangle);
  text[head] = '\n';  // the lowest byte of the first coordinate
  const Polygons mesh = parse(text);
  EXPECT_EQ(mesh.corners, kTriangle.corners);
  EXPECT_NEAR(mesh.positions[0].x, kTriangle.positions[0].x, 1e-5);
  EXPECT_NE(mesh.positions[0].x, kTriangle.positions[0].x);
}

const std::string kFourVertices =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kFourPoints = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

TEST(Ply, TriangleStripsTurnEveryOtherTriangle) {
  const std::string head =
      "ply\nformat ascii 1.0\n" + kFourVertices +
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
  const Polygons mesh = parse(head + kFourPoints + "9 0 2 1 3 -1 2 0 3 -1\n");
  EXPECT_EQ(mesh.corners, (std::vector<Index>{0, 2, 1, 1, 2, 3, 2, 0, 3}));
  // A repeated vertex turns the next triangle and makes none of its own.
  EXPECT_EQ(parse(head + kFourPoints + "6 0 1 2 2 1 3\n").corners,
            (std::vector<Index>{0, 1, 2, 1, 2, 3}));
  // -1 in a list of unsigned numbers.
  const std::string of_unsigned =
      "ply\nformat ascii 1.0\n" + kFourVertices +
      "element tristrips 1\nproperty list uint uint vertex_indices\nend_header\n" + kFourPoints;
  EXPECT_EQ(parse(of_unsigned + "7 0 2 1 4294967295 2 0 3\n").corners,
            (std::vector<Index>{0, 2, 1, 2, 0, 3}));
  EXPECT_FALSE(parse_mesh(of_unsigned + "7 0 2 1 4294967294 2 0 3\n", "ply", "").ok());
  // One triangle too few, an index out of range, no triangle at all.
  for (const std::string strip : {"3 0 1 7", "3 0 1 -2", "2 0 1", "4 0 1 -1 2", "-1"})
    EXPECT_FALSE(parse_mesh(head + kFourPoints + strip + "\n", "ply", "").ok()) << strip;
}

TEST(Ply, StripsInBinaryAndBesideFaces) {
  std::string text = "ply\nformat binary_big_endian 1.0\n" + kFourVertices +
                     "element face 1\nproperty list uchar int vertex_indices\n"
                     "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F})
    text += bytes(x, true);
  text += "\3";
  for (const Index v : {0, 2, 1}) text += bytes(v, true);
  for (const Index v : {7, 0, 1, 3, -1, 1, 2, 3}) text += bytes(v, true);
  EXPECT_EQ(parse(text).corners, (std::vector<Index>{0, 2, 1, 0, 1, 3, 1, 2, 3}));
  EXPECT_FALSE(parse_mesh(text.substr(0, text.size() - 1), "ply", "").ok());
}

TEST(Ply, PaddingBehindBinaryDataIsAWarning) {
  const std::string text = *format_mesh("ply", kTriangle);
  for (const std::string& padding :
       {std::string("\n"), std::string("\r\n"), std::string(7, '\0')}) {
    Warnings warnings;
    EXPECT_EQ(parse(text + padding, &warnings), kTriangle);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].message.find("padding after the data at byte"), std::string::npos);
  }
  EXPECT_FALSE(parse_mesh(text + "x", "ply", "").ok());
  EXPECT_FALSE(parse_mesh(text + "\n\1", "ply", "").ok());
}

TEST(Ply, AsciiElementsThatShareLinesOrCrossThem) {
  const std::string head = "ply\nformat ascii 1.0\n" + kFourVertices +
                           "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
  const Polygons plain = parse(head + kFourPoints + "3 0 1 2\n3 0 2 3\n");
  for (const std::string body : {"0 0 0 1 0 0 0 1 0 0 0 1\n3 0 1 2 3 0 2 3\n",
                                 "0 0 0 1 0 0\n0 1 0 0 0 1\n3 0 1 2\n3 0 2 3\n",
                                 "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2 3 0 2 3",
                                 "0\n0\n0\n1 0\n0 0 1 0 0 0 1 3\n0 1 2 3 0 2 3\n"}) {
    Warnings warnings;
    EXPECT_EQ(parse(head + body, &warnings), plain) << body;
    ASSERT_EQ(warnings.size(), 1u) << body;
    EXPECT_NE(warnings[0].message.find("word by word"), std::string::npos);
  }
  // What fits no better word by word is refused at the line that is wrong.
  const Result<Polygons> bad =
      parse_mesh(head + "0 0 0 1\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 2 3\n", "ply", "");
  ASSERT_FALSE(bad.ok());
  EXPECT_EQ(bad.error().line, 10);
}

TEST(Ply, WritesDoublesAndWideLists) {
  Polygons mesh = kTriangle;
  for (int degree : {255, 256, 1000}) {
    for (int k = 0; k < degree; ++k) mesh.corners.push_back(k % 3);
    mesh.face_begin.push_back(static_cast<Index>(mesh.corners.size()));
    const std::string text = *format_mesh("ply", mesh);
    const char* list = degree > 255 ? "property list int int vertex_indices\n"
                                    : "property list uchar int vertex_indices\n";
    EXPECT_NE(text.find(list), std::string::npos);
    EXPECT_NE(text.find("property double x\n"), std::string::npos);
    EXPECT_EQ(parse(text), mesh);
  }
}

TEST(Ply, AnElementOfNoneIsNotLeftOut) {
  Warnings warnings;
  EXPECT_EQ(parse("ply\nformat ascii 1.0\nelement edge 0\nproperty int a\n" + kFourVertices +
                      "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
                      kFourPoints + "3 0 1 2\n",
                  &warnings)
                .face_count(),
            1);
  EXPECT_TRUE(warnings.empty());
}

}  // namespace
}  // namespace limn
