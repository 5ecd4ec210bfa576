/// glTF in: GLB and JSON, what nodes do with meshes, and what is refused.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <random>
#include <set>

#include <nlohmann/json.hpp>

#include "limn/mesh/io/mesh_file.h"
#include "limn/mesh/mesh_faults.h"
#include "mesh/io/mesh_samples.h"
#include "support/temporary_folder.h"

namespace limn {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
void put(std::string& bytes, std::initializer_list<T> values) {
  for (const T value : values) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    bytes.append(raw, sizeof(T));
  }
}

std::string base64(const std::string& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    unsigned bits = 0;
    for (std::size_t i = 0; i < 3; ++i)
      bits = bits << 8U | (k + i < bytes.size() ? static_cast<unsigned char>(bytes[k + i]) : 0U);
    for (std::size_t i = 0; i < 4; ++i)
      text += k + i <= bytes.size() ? digits[bits >> (18 - 6 * i) & 63U] : '=';
  }
  return text;
}

/// A file under construction: blocks of one buffer, each with its view and its accessor.
struct Maker {
  Json json = Json::parse(R"({"asset":{"version":"2.0"},"bufferViews":[],"accessors":[],
    "meshes":[],"buffers":[{}]})");
  std::string bytes;

  template <class T>
  std::size_t add(int component, const char* type, std::size_t count,
                  std::initializer_list<T> data) {
    while (bytes.size() % 4 != 0) bytes += '\0';
    const std::size_t begin = bytes.size();
    put(bytes, data);
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", bytes.size() - begin}});
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                 {"componentType", component},
                                 {"count", count},
                                 {"type", type}});
    return json["accessors"].size() - 1;
  }
  std::size_t quad() {  // four places of a unit square
    return add<float>(5126, "VEC3", 4, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  }
  Json& primitive(std::size_t positions) {
    json["meshes"].push_back({{"primitives", {{{"attributes", {{"POSITION", positions}}}}}}});
    return json["meshes"].back()["primitives"][0];
  }

  [[nodiscard]] std::string text() const {
    Json whole = json;
    whole["buffers"][0] = {{"byteLength", bytes.size()},
                           {"uri", "data:application/octet-stream;base64," + base64(bytes)}};
    return whole.dump();
  }
  [[nodiscard]] std::string glb() const {
    Json whole = json;
    whole["buffers"][0] = {{"byteLength", bytes.size()}};
    std::string text = whole.dump(), data = bytes;
    while (text.size() % 4 != 0) text += ' ';
    while (data.size() % 4 != 0) data += '\0';
    std::string file = "glTF";
    put<std::uint32_t>(file, {2, static_cast<std::uint32_t>(28 + text.size() + data.size()),
                              static_cast<std::uint32_t>(text.size()), 0x4E4F534A});
    file += text;
    put<std::uint32_t>(file, {static_cast<std::uint32_t>(data.size()), 0x004E4942});
    return file + data;
  }
};

Polygons must_read(const Maker& maker) {
  const Polygons by_text = parse_mesh(maker.text(), "gltf", "m.gltf").value();
  EXPECT_EQ(parse_mesh(maker.glb(), "glb", "m.glb").value(), by_text);
  EXPECT_EQ(parse_mesh_file(maker.glb(), "", "stdin").value().polygons, by_text);
  EXPECT_EQ(parse_mesh_file(maker.text(), "", "stdin").value().polygons, by_text);
  return by_text;
}

std::string refusal(const Maker& maker) {
  const Result<Polygons> read = parse_mesh(maker.text(), "gltf", "m.gltf");
  EXPECT_FALSE(read.ok());
  return read ? "" : read.error().text();
}

using Triangles = std::vector<std::array<Index, 3>>;
Triangles triangles(const Polygons& mesh) {
  Triangles list;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    EXPECT_EQ(mesh.degree(f), 3);
    const Index first = mesh.face_begin[f];
    list.push_back({mesh.corners[first], mesh.corners[first + 1], mesh.corners[first + 2]});
  }
  return list;
}

TEST(GltfRead, WhatLimnWritesReadsBack) {
  const Polygons cube = triangulated(test::cube());
  EXPECT_EQ(parse_mesh(*format_mesh("glb", cube), "glb", "m.glb").value(), cube);
}

TEST(GltfRead, IndicesOfEveryTypeAndNone) {
  Maker maker;
  const std::size_t quad = maker.quad();
  maker.primitive(quad)["indices"] = maker.add<std::uint8_t>(5121, "SCALAR", 6, {0, 1, 2, 0, 2, 3});
  maker.primitive(quad)["indices"] = maker.add<std::uint16_t>(5123, "SCALAR", 3, {0, 1, 2});
  maker.primitive(quad)["indices"] = maker.add<std::uint32_t>(5125, "SCALAR", 3, {1, 2, 3});
  maker.primitive(maker.add<float>(5126, "VEC3", 3, {0, 0, 5, 1, 0, 5, 0, 1, 5}));
  const Polygons mesh = must_read(maker);
  EXPECT_EQ(mesh.vertex_count(), 15);
  EXPECT_EQ(triangles(mesh),
            (Triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {9, 10, 11}, {12, 13, 14}}));
}

TEST(GltfRead, StripsAndFans) {
  Maker maker;
  const std::size_t five =
      maker.add<float>(5126, "VEC3", 5, {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0});
  maker.primitive(five)["mode"] = 5;
  maker.primitive(five)["mode"] = 6;
  Json& stitched = maker.primitive(five);
  stitched["mode"] = 5;
  stitched["indices"] = maker.add<std::uint8_t>(5121, "SCALAR", 7, {0, 1, 2, 2, 2, 3, 4});
  const Polygons mesh = must_read(maker);
  EXPECT_EQ(triangles(mesh), (Triangles{{0, 1, 2},
                                        {1, 3, 2},
                                        {2, 3, 4},
                                        {5, 6, 7},
                                        {5, 7, 8},
                                        {5, 8, 9},
                                        {10, 11, 12},
                                        {12, 13, 14}}));
}

TEST(GltfRead, NodesPlaceMeshes) {
  Maker maker;
  maker.primitive(maker.add<float>(5126, "VEC3", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0}));
  const double half = std::sqrt(0.5);
  maker.json["nodes"] = {
      {{"children", {1, 2}}, {"translation", {10, 0, 0}}},
      // a quarter turn about z after a scaling
      {{"mesh", 0}, {"rotation", {0, 0, half, half}}, {"scale", {2, 3, 1}}},
      // mirrored: the face is turned over in space, and is to be told so
      {{"mesh", 0}, {"matrix", {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 7, 1}}},
      {{"mesh", 0}}};
  maker.json["scenes"] = Json::parse(R"([{"nodes":[3]},{"nodes":[0]}])");
  maker.json["scene"] = 1;
  const Polygons mesh = must_read(maker);
  ASSERT_EQ(mesh.vertex_count(), 6);
  const auto expect_at = [&](Index v, Point3 p) {
    const Point3& q = mesh.positions[static_cast<std::size_t>(v)];
    EXPECT_NEAR(std::hypot(p.x - q.x, p.y - q.y, p.z - q.z), 0, 1e-14) << v;
  };
  expect_at(0, {10, 0, 0});
  expect_at(1, {10, 2, 0});
  expect_at(2, {7, 0, 0});
  expect_at(3, {10, 0, 7});
  expect_at(4, {9, 0, 7});
  expect_at(5, {10, 1, 7});
  EXPECT_EQ(triangles(mesh), (Triangles{{0, 1, 2}, {3, 5, 4}}));
}

TEST(GltfRead, PrimitivesThatShareTheirPositionsShareVertices) {
  Maker maker;
  const std::size_t quad = maker.quad();
  maker.primitive(quad)["indices"] = maker.add<std::uint8_t>(5121, "SCALAR", 3, {0, 1, 2});
  Json second = maker.json["meshes"][0]["primitives"][0];
  second["indices"] = maker.add<std::uint8_t>(5121, "SCALAR", 3, {0, 2, 3});
  maker.json["meshes"][0]["primitives"].push_back(second);
  const Polygons mesh = must_read(maker);
  EXPECT_EQ(mesh.vertex_count(), 4);
  EXPECT_EQ(triangles(mesh), (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

TEST(GltfRead, InterleavedAndQuantized) {
  Maker maker;
  const std::size_t mixed =
      maker.add<float>(5126, "VEC3", 3, {0, 0, 0, 9, 9, 9, 1, 0, 0, 9, 9, 9, 0, 1, 0, 9, 9, 9});
  maker.json["bufferViews"][0]["byteStride"] = 24;
  maker.primitive(mixed);
  const std::size_t shorts =
      maker.add<std::int16_t>(5122, "VEC3", 3, {0, 0, 0, 0, 32767, 0, 0, 0, 0, -32768, 0, 0});
  maker.json["bufferViews"][1]["byteStride"] = 8;
  maker.json["accessors"][shorts]["normalized"] = true;
  maker.primitive(shorts);
  maker.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const Polygons mesh = must_read(maker);
  EXPECT_EQ(
      mesh.positions,
      (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, -1, 0}}));
}

TEST(GltfRead, BuffersInFilesBesideIt) {
  const test::TemporaryFolder folder;
  Maker maker;
  maker.primitive(maker.quad())["indices"] = maker.add<std::uint8_t>(5121, "SCALAR", 3, {0, 1, 2});
  Json json = maker.json;
  json["buffers"][0] = {{"byteLength", maker.bytes.size()}, {"uri", "the%20data.bin"}};
  const std::string path = (folder.path() / "m.gltf").string();
  std::ofstream(path) << json.dump();
  std::ofstream(folder.path() / "the data.bin", std::ios::binary) << maker.bytes;
  EXPECT_EQ(read_mesh(path).value(), must_read(maker));
  EXPECT_NE(parse_mesh(json.dump(), "gltf", "m.gltf").error().text().find("another file"),
            std::string::npos);
  for (const char* outside :
       {"/etc/passwd", "../m.gltf", "a/../../b", "http://x/y", "a%2F..%2F..%2Fb"}) {
    json["buffers"][0]["uri"] = outside;
    std::ofstream(path) << json.dump();
    EXPECT_NE(read_mesh(path).error().text().find("is not beside"), std::string::npos) << outside;
  }
  json["buffers"][0]["uri"] = "none.bin";
  std::ofstream(path) << json.dump();
  EXPECT_NE(read_mesh(path).error().text().find("none.bin"), std::string::npos);
}

TEST(GltfRead, WhatIsLeftOutIsSaid) {
  Maker maker;
  Json& primitive = maker.primitive(maker.quad());
  primitive["indices"] = maker.add<std::uint8_t>(5121, "SCALAR", 3, {0, 1, 2});
  primitive["attributes"]["NORMAL"] = 0;
  primitive["attributes"]["TEXCOORD_0"] = 0;
  primitive["material"] = 0;
  const MeshFile file = parse_mesh_file(maker.text(), "gltf", "m.gltf").value();
  std::set<std::string> kinds;
  for (const LeftOut& kind : file.left_out) kinds.insert(kind.what);
  EXPECT_EQ(kinds, (std::set<std::string>{"normals", "texture coordinates", "materials"}));
}

TEST(GltfRead, RefusesWithThePlaceAndTheCause) {
  const auto start = [] {
    Maker maker;
    const std::size_t quad = maker.quad();
    maker.primitive(quad)["indices"] = maker.add<std::uint8_t>(5121, "SCALAR", 3, {0, 1, 2});
    return maker;
  };
  struct Wrong {
    const char* pointer;
    Json value;
    const char* said;
  };
  const Wrong list[] = {
      {"/asset/version", "1.0", "only 2.x"},
      {"/extensionsRequired", {"KHR_draco_mesh_compression"}, "KHR_draco_mesh_compression"},
      {"/accessors/0/sparse", Json::object(), "accessors[0]: sparse accessors are not read"},
      {"/accessors/0/count", 5, "5 elements do not fit into bufferViews[0] of 48 bytes"},
      {"/accessors/0/count", 9007199254740992, "do not fit"},
      {"/accessors/0/count", 0, "'count' is 0"},
      {"/accessors/0/count", -1, "no whole number"},
      {"/accessors/0/byteOffset", 40, "do not fit"},
      {"/accessors/0/type", "VEC2", "VEC3"},
      {"/accessors/0/componentType", 5130, "unknown 'type' or 'componentType'"},
      {"/accessors/0/bufferView", 7, "bufferViews[7] is meant, but there are 2"},
      {"/bufferViews/0/byteLength", 4000, "reaches beyond its buffer"},
      {"/bufferViews/0/byteOffset", 9007199254740992, "reaches beyond its buffer"},
      {"/bufferViews/0/byteStride", 4, "less than an element"},
      {"/bufferViews/0/buffer", 1, "buffers[1] is meant"},
      {"/accessors/1/componentType", 5120, "whole numbers without a sign"},
      {"/accessors/1/count", 2, "2 corners are no triangles"},
      {"/accessors/1/componentType", 5126, "do not fit"},
      {"/meshes/0/primitives/0/mode", 9, "unknown 'mode' 9"},
      {"/meshes/0/primitives/0/mode", 1, "no vertices"},
      {"/meshes/0/primitives/0/attributes/POSITION", 9, "accessors[9] is meant"},
      {"/meshes/0/primitives", 3, "no list 'primitives'"},
      {"/nodes", Json::parse(R"([{"children":[1]},{"children":[0],"mesh":0}])"), "no vertices"},
      {"/nodes", Json::parse(R"([{"children":[1,1]},{"mesh":0}])"), "two parents"},
      {"/nodes", Json::parse(R"([{"mesh":4}])"), "meshes[4] is meant"},
      {"/nodes", Json::parse(R"([{"mesh":0,"matrix":[1]}])"), "16 numbers"},
      {"/nodes", Json::parse(R"([{"mesh":0,"rotation":[0,0,0,0]}])"), "'rotation'"},
      {"/scenes", Json::parse(R"([{"nodes":[5]}])"), "nodes[5] is meant"}};
  for (const auto& [pointer, value, said] : list) {
    Maker maker = start();
    maker.json[Json::json_pointer(pointer)] = value;
    const std::string text = refusal(maker);
    EXPECT_NE(text.find(said), std::string::npos) << pointer << " " << value << ": " << text;
  }
  Maker far = start();
  far.bytes[48] = 7;  // the first index
  EXPECT_NE(refusal(far).find("index 7 at place 0 is out of range"), std::string::npos);
  const MeshFile kept =
      parse_mesh_file(far.text(), "gltf", "m.gltf", {.keep_faults = true}).value();
  EXPECT_EQ(mesh::find_mesh_faults(kept.polygons).list.front().kind,
            mesh::MeshFault::Kind::out_of_range);
  const Error syntax = parse_mesh("{\n\"asset\": {,\n", "gltf", "m.gltf").error();
  EXPECT_EQ(syntax.line, 2);
}

TEST(GltfRead, ScenesThatMultiplyMeshesAreBounded) {
  Maker maker;
  maker.primitive(maker.quad())["mode"] = 6;
  maker.json["meshes"][0]["primitives"] =
      Json(std::vector<Json>(20000, maker.json["meshes"][0]["primitives"][0]));
  maker.json["nodes"] = Json(std::vector<Json>(200000, Json{{"mesh", 0}}));
  EXPECT_NE(refusal(maker).find("more"), std::string::npos);
}

TEST(GltfRead, NestingHasNoDepthThatBreaks) {
  const std::string deep(2000000, '[');
  EXPECT_FALSE(parse_mesh(R"({"asset":{"version":"2.0"},"extras":)" + deep, "gltf", "m.gltf").ok());
  EXPECT_FALSE(parse_mesh(R"({"asset":{"version":"2.0"},"extras":)" + deep +
                              std::string(deep.size(), ']') + "}",
                          "gltf", "m.gltf")
                   .ok());
}

std::string sample() {
  Maker maker;
  maker.primitive(maker.quad())["indices"] =
      maker.add<std::uint8_t>(5121, "SCALAR", 6, {0, 1, 2, 0, 2, 3});
  maker.json["nodes"] = Json::parse(R"([{"mesh":0,"scale":[1,2,3]}])");
  return maker.glb();
}

TEST(GltfRead, EveryHeadOfAFileIsRefused) {
  const std::string whole = sample();
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_FALSE(parse_mesh(whole.substr(0, size), "glb", "m.glb").ok()) << size;
}

RC_GTEST_PROP(GltfReadLaws, NoiseIsReadOrRefused, (unsigned seed)) {
  std::mt19937 random(seed);
  const std::string whole = sample();
  for (int k = 0; k < 200; ++k) {
    std::string noisy = whole;
    for (unsigned n = 1 + random() % 4; n > 0; --n)
      noisy[random() % noisy.size()] = static_cast<char>(random());
    const Result<Polygons> read = parse_mesh(noisy, "glb", "m.glb");
    if (read)
      for (const Index v : read->corners) RC_ASSERT(v >= 0 && v < read->vertex_count());
    else
      RC_ASSERT(!read.error().message.empty());
  }
}

}  // namespace
}  // namespace limn
