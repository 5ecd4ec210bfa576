// Attributes in mesh files: read, written, read again; and what is wrong with them.

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "limn/mesh/io/mesh_file.h"

namespace limn {
namespace {

Result<MeshFile> parse(const std::string& content, const std::string& extension) {
  return parse_mesh_file(content, extension, "a." + extension, {.attributes = true});
}

MeshFile read(const std::string& content, const std::string& extension) {
  Result<MeshFile> file = parse(content, extension);
  EXPECT_TRUE(file.ok()) << (file ? "" : file.error().text());
  if (!file) return {};
  EXPECT_TRUE(attributes_fit(file->attributes, file->polygons));
  return *std::move(file);
}

std::string fault(const std::string& content, const std::string& extension) {
  const Result<MeshFile> file = parse(content, extension);
  return file ? "" : file.error().text();
}

MeshFile again(const MeshFile& file, const std::string& extension) {
  WriteOptions options;
  options.attributes = file.attributes;
  return read(format_mesh(extension, file.polygons, options).value(), extension);
}

const std::string kVertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n";  // 6 lines

const std::string kTextured =
    "mtllib a file.mtl other.mtl\nmtllib more.mtl\n"
    "v 0 0 0 0.5 0.25 1\nv 1 0 0 0 0 0\nv 1 1 0 1 1 1\nv 0 1 0 0 1 0\nv 2 0 0 1 0 0\n"
    "v 2 1 0 0 0 1\n"
    "vt 0 0\nvt 0.3 0\nvt 0.3 1\nvt 0 1\nvt 0.5 0\nvt 1 0\nvt 1 1\nvt 0.5 1\n"
    "vn 0 0 1\n"
    "f 1/1/1 2/2/1 3/3/1\n"
    "o body\ng left side\nusemtl red paint#2  # a comment\ns 1\nf 1/1 3/3 4/4\n"
    "g right\nusemtl blue\ns off\nf -5/-4 -2/-3 -1/-2 -4/-1\n"
    "usemtl\nf 1 2 3\n";

TEST(ObjAttributes, AreReadAndWrittenAgain) {
  const MeshFile file = read(kTextured, "obj");
  const MeshAttributes& got = file.attributes;
  EXPECT_EQ(got.material_files, (std::vector<std::string>{"a file.mtl other.mtl", "more.mtl"}));
  EXPECT_EQ(got.find("green")->values, (std::vector<double>{0.25, 0, 1, 1, 0, 0}));
  EXPECT_EQ(got.texture.points.size(), 8U);
  EXPECT_EQ(got.texture.of_corner,
            (std::vector<Index>{0, 1, 2, 0, 2, 3, 4, 5, 6, 7, kNone, kNone, kNone}));
  EXPECT_EQ(got.of(LabelKind::object).of_face, (std::vector<Index>{kNone, 0, 0, 0}));
  EXPECT_EQ(got.of(LabelKind::group).names, (std::vector<std::string>{"left side", "right"}));
  EXPECT_EQ(got.of(LabelKind::material).names, (std::vector<std::string>{"red paint#2", "blue"}));
  EXPECT_EQ(got.of(LabelKind::material).of_face, (std::vector<Index>{kNone, 0, 1, kNone}));
  EXPECT_EQ(got.of(LabelKind::smoothing).names, (std::vector<std::string>{"1", "off"}));
  ASSERT_EQ(file.left_out.size(), 1U);  // normals
  EXPECT_EQ(file.left_out[0].what, "normals ('vn')");
  const MeshFile twice = again(file, "obj");
  EXPECT_EQ(twice.polygons, file.polygons);
  EXPECT_EQ(twice.attributes, got);
}

TEST(ObjAttributes, AreLeftOutUnlessAskedFor) {
  const MeshFile file = parse_mesh_file(kTextured, "obj", "a.obj").value();
  EXPECT_TRUE(file.attributes.empty());
  EXPECT_EQ(file.left_out.size(), 8U);
}

TEST(ObjAttributes, ThatAreFaultyAreRefusedWithLineAndRemedy) {
  const std::string none = "--attributes none";
  for (const auto& [lines, said] :
       {std::pair{"f 1/1 2/2 3/3\n", "a.obj:7:11: the texture point 3 is not there"},
        {"vt 0 0\nf 1/1 2/0 3/1\n",
         "a.obj:8:7: the corner '2/0' names a texture point that is not"},
        {"vt 0 0\nf 1/1 2/-2 3/1\n", "a.obj:8:7: the corner '2/-2' names a texture point"},
        {"vt 0 0\nf 1/1 2 3/1\n",
         "a.obj:8:1: 2 corners of the face have texture coordinates, of 3"},
        {"vt\nf 1 2 3\n", "a.obj:7:1: a texture point without coordinates"},
        {"vt 0 x\nf 1 2 3\n", "a.obj:7:6: expected a texture coordinate, found 'x'"},
        {"vt 0 nan\nf 1 2 3\n", "a.obj:7:6: a texture coordinate is 'nan'"},
        {"vt 0 0 0 0\nf 1 2 3\n", "a.obj:7:1: a texture point of more than three numbers"}}) {
    const std::string found = fault(kVertices + lines, "obj");
    EXPECT_EQ(found.find(said), 0U) << found;
  }
  EXPECT_NE(fault(kVertices + "f 1/9 2/9 3/9\n", "obj").find(none), std::string::npos);
}

TEST(ObjAttributes, ColoursOfSomeVerticesMakeTheOthersWhite) {
  const MeshFile file = read("v 0 0 0\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0 0 0 0 0.25\nf 1 2 3\n", "obj");
  EXPECT_EQ(file.attributes.find("red")->values, (std::vector<double>{1, 0.5, 0}));
  EXPECT_EQ(file.attributes.find("alpha")->values, (std::vector<double>{1, 1, 0.25}));
  ASSERT_EQ(file.warnings.size(), 1U);
  EXPECT_EQ(file.warnings[0].message, "1 vertex has no colour, while others have: taken as white");
}

TEST(ObjAttributes, ANameMayEndInABackslash) {
  const MeshFile file = read(kVertices + "usemtl C:\\paint\\\nf 1 2 3\n", "obj");
  EXPECT_EQ(file.attributes.of(LabelKind::material).names,
            (std::vector<std::string>{"C:\\paint\\"}));
}

const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
    "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
    "property float quality\nproperty short flag\nproperty float nx\n";
const std::string kPlyFaces = "element face 2\nproperty list uchar int vertex_indices\n";

TEST(PlyAttributes, AreReadAndWrittenWithTheirTypes) {
  const MeshFile file =
      read(kPly + "property double s\nproperty double t\n" + kPlyFaces +
               "end_header\n"
               "0 0 0 255 0 7 0.5 -3 1 0 0\n1 0 0 0 255 8 1.5 4 1 1 0\n1 1 0 0 0 9 2.5 5 1 1 1\n"
               "0 1 0 1 2 3 0.1 6 1 0 1\n2 0 0 1 1 1 1 1 1 2 0\n2 1 0 2 2 2 2 2 2 2 1\n"
               "4 0 1 2 3\n4 1 4 5 2\n",
           "ply");
  const MeshAttributes& got = file.attributes;
  ASSERT_EQ(got.vertices.size(), 5U);
  EXPECT_EQ(got.vertices[0].name, "red");
  EXPECT_EQ(got.vertices[0].type, NumberType::uint8);
  EXPECT_EQ(got.find("quality")->values[3], 0.1);
  EXPECT_EQ(got.find("flag")->type, NumberType::int16);
  EXPECT_EQ(got.find("flag")->values[0], -3);
  EXPECT_EQ(got.texture.of_corner, file.polygons.corners);
  ASSERT_EQ(file.left_out.size(), 1U);
  EXPECT_EQ(file.left_out[0].what, "normals");
  MeshAttributes expected = got;
  for (double& value : expected.vertices[3].values)
    value = static_cast<double>(static_cast<float>(value));
  const MeshFile twice = again(file, "ply");
  EXPECT_EQ(twice.polygons, file.polygons);
  EXPECT_EQ(twice.attributes, expected);
}

TEST(PlyAttributes, ValuesThatAreNotOfTheirTypeAreRefused) {
  const auto with = [](const char* red, const char* quality, const char* flag) {
    std::string text = kPly + kPlyFaces + "end_header\n0 0 0 255 0 7 0 -32768 0\n";
    text += fmt::format("1 0 0 {} 0 7 {} {} 0\n", red, quality, flag);
    for (int v = 2; v < 6; ++v) text += fmt::format("{} 1 0 0 0 7 0 32767 0\n", v);
    return text + "3 0 1 2\n3 3 4 5\n";
  };
  EXPECT_TRUE(parse(with("255.0", "1e38", "-3"), "ply").ok());
  EXPECT_TRUE(parse(with("0", "-1e-300", "0"), "ply").ok());
  for (const auto& [text, what] :
       {std::pair{with("256", "0", "0"), "red is '256', which is no uchar"},
        {with("-1", "0", "0"), "red is '-1', which is no uchar"},
        {with("0.5", "0", "0"), "red is '0.5', which is no uchar"},
        {with("0", "1e39", "0"), "quality is '1e39', which is no float"},
        {with("0", "0", "32768"), "flag is '32768', which is no short"}}) {
    const std::string said = fault(text, "ply");
    EXPECT_NE(said.find(what), std::string::npos) << said;
    EXPECT_NE(said.find(":17:"), std::string::npos) << said;
  }
}

TEST(PlyAttributes, WholeNumbersAreRoundedAndKeptInRange) {
  MeshFile file = read(kVertices + "f 1 2 3\n", "obj");
  file.attributes.vertices = {{"red", NumberType::uint8, {-3, 0.4, 0.6, 254.5, 255.4, 300}},
                              {"flag", NumberType::int16, {-40000, -1.5, 1.4, 0, 32767.4, 1e30}}};
  const MeshFile twice = again(file, "ply");
  EXPECT_EQ(twice.attributes.vertices[0].values, (std::vector<double>{0, 0, 1, 255, 255, 255}));
  EXPECT_EQ(twice.attributes.vertices[1].values,
            (std::vector<double>{-32768, -2, 1, 0, 32767, 32767}));
}

TEST(PlyAttributes, CornersOfFacesHaveTextureCoordinates) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
      "property float z\nelement face 3\nproperty list uchar float texcoord\n"
      "property list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n2 1 0\n";
  const MeshFile file =
      read(head + "8 0 0 .5 0 .5 1 0 1 4 0 1 2 3\n6 .5 0 1 0 1 1 3 1 4 5\n0 3 1 5 2\n", "ply");
  const TextureCoordinates& texture = file.attributes.texture;
  EXPECT_EQ(texture.type, NumberType::float32);
  // equal coordinates of one vertex are one point
  EXPECT_EQ(texture.of_corner, (std::vector<Index>{0, 1, 2, 3, 1, 4, 5, kNone, kNone, kNone}));
  const MeshFile twice = again(file, "ply");
  EXPECT_EQ(twice.attributes, file.attributes);
  EXPECT_NE(fault(head + "6 0 0 .5 0 .5 1 4 0 1 2 3\n0 3 1 4 5\n0 3 1 5 2\n", "ply")
                .find("a face of 4 corners has 6 texture coordinates, expected 8 or none"),
            std::string::npos);
}

TEST(GlbAttributes, AreWrittenAndReadAgain) {
  MeshFile file = read(kTextured, "obj");
  // triangles alone, so that faces stay
  file = read(
      "v 0 0 0 0.5 0.25 1\nv 1 0 0 0 0 0\nv 1 1 0 1 1 1\nv 0 1 0 0 1 0\n"
      "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 0.25\nvt 0.5 0.5\nvt 0 1\n"
      "f 1/1 2/2 3/3\nf 1/4 3/5 4/6\n",
      "obj");
  const MeshFile twice = again(file, "glb");
  EXPECT_EQ(twice.polygons.positions.size(), 6U);  // two more at the seam
  ASSERT_EQ(twice.polygons.corners.size(), 6U);
  for (std::size_t c = 0; c < 6; ++c) {
    const auto v = static_cast<std::size_t>(file.polygons.corners[c]);
    const auto w = static_cast<std::size_t>(twice.polygons.corners[c]);
    EXPECT_EQ(twice.polygons.positions[w], file.polygons.positions[v]);
    for (const char* name : {"red", "green", "blue"})
      EXPECT_EQ(twice.attributes.find(name)->values[w], file.attributes.find(name)->values[v]);
    const auto point = [c](const MeshFile& of) {
      return of.attributes.texture
          .points[static_cast<std::size_t>(of.attributes.texture.of_corner[c])];
    };
    EXPECT_EQ(point(twice), point(file));
  }
}

TEST(LostAttributes, AreNamed) {
  MeshAttributes attributes = read(kTextured, "obj").attributes;
  attributes.vertices.push_back({"heat", NumberType::float32, std::vector<double>(6, 1.0)});
  const auto lost = [&](const char* extension) { return lost_attributes(extension, attributes); };
  EXPECT_EQ(lost("obj"), (std::vector<std::string>{"the vertex property 'heat'"}));
  EXPECT_EQ(lost("ply"), (std::vector<std::string>{"object names", "groups", "materials",
                                                   "smoothing groups", "names of material files"}));
  EXPECT_EQ(lost("glb").size(), 6U);
  EXPECT_EQ(lost("stl").size(), 8U);
  for (const char* extension : {"obj", "ply", "glb", "off", "stl"})
    EXPECT_TRUE(lost_attributes(extension, kept_attributes(extension, attributes)).empty());
}

TEST(LostAttributes, NumbersThatAreNoneAreRefused) {
  MeshFile file = read(kTextured, "obj");
  file.attributes.vertices[0].values[2] = std::numeric_limits<double>::infinity();
  WriteOptions options;
  options.attributes = file.attributes;
  const auto written = format_mesh("obj", file.polygons, options);
  ASSERT_FALSE(written.ok());
  EXPECT_NE(written.error().text().find("the property 'red' of vertex 2 is inf"),
            std::string::npos);
}

}  // namespace
}  // namespace limn
