#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "limn/mesh/io/mesh_file.h"
#include "mesh/io/mesh_samples.h"

namespace limn {
namespace {

template <class T>
T at(const std::string& text, std::size_t offset) {
  T value;
  std::memcpy(&value, text.data() + offset, sizeof(T));
  return value;
}

TEST(Glb, ChunksAccessorsAndData) {
  const Polygons cube = test::cube();
  WriteOptions options;
  for (const Point3& p : cube.positions) options.normals.push_back({p.x + 1, p.y, p.z});
  const std::string glb = *format_mesh("glb", cube, options);

  ASSERT_EQ(glb.substr(0, 4), "glTF");
  EXPECT_EQ(at<std::uint32_t>(glb, 4), 2u);
  EXPECT_EQ(at<std::uint32_t>(glb, 8), glb.size());
  const auto json_size = at<std::uint32_t>(glb, 12);
  EXPECT_EQ(glb.substr(16, 4), "JSON");
  EXPECT_EQ(json_size % 4, 0u);
  const auto gltf = nlohmann::json::parse(glb.substr(20, json_size));
  const std::size_t data = 20 + json_size + 8;
  EXPECT_EQ(at<std::uint32_t>(glb, data - 8), glb.size() - data);
  EXPECT_EQ(glb.substr(data - 4, 4), std::string("BIN\0", 4));
  EXPECT_EQ(gltf["buffers"][0]["byteLength"], glb.size() - data);
  EXPECT_EQ(gltf["asset"]["version"], "2.0");
  EXPECT_EQ(gltf["scenes"][0]["nodes"], nlohmann::json({0}));

  const auto& primitive = gltf["meshes"][0]["primitives"][0];
  const auto offset_of = [&](const nlohmann::json& accessor, const char* type, int count) {
    const auto& entry = gltf["accessors"][accessor.get<std::size_t>()];
    EXPECT_EQ(entry["type"], type);
    EXPECT_EQ(entry["count"], count);
    return data + gltf["bufferViews"][entry["bufferView"].get<std::size_t>()]["byteOffset"]
                      .get<std::size_t>();
  };
  const std::size_t positions = offset_of(primitive["attributes"]["POSITION"], "VEC3", 8);
  const std::size_t normals = offset_of(primitive["attributes"]["NORMAL"], "VEC3", 8);
  const std::size_t indices = offset_of(primitive["indices"], "SCALAR", 36);
  EXPECT_EQ(gltf["accessors"][0]["min"], nlohmann::json({0.0, 0.0, 0.0}));
  EXPECT_EQ(gltf["accessors"][0]["max"], nlohmann::json({1.0, 1.0, 1.0}));
  EXPECT_EQ(at<float>(glb, positions + 12 * 6 + 8), 1.0f);
  EXPECT_EQ(at<float>(glb, normals), 1.0f);
  EXPECT_NEAR(at<float>(glb, normals + 12 * 2), 2 / std::sqrt(5.0), 1e-7);
  const Index expected[6] = {0, 3, 2, 0, 2, 1};  // the fan of the first quad
  for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(at<Index>(glb, indices + 4 * k), expected[k]);
  EXPECT_EQ(indices + 4 * 36, glb.size());
}

TEST(Glb, BoundsAreThoseOfTheFloats) {
  Polygons mesh{{{0.1, -0.3, 5}, {1.7, 2, 3}, {4, -7.7, 1e-3}}, {0, 3}, {0, 1, 2}};
  const std::string glb = *format_mesh("glb", mesh);
  const auto gltf = nlohmann::json::parse(glb.substr(20, at<std::uint32_t>(glb, 12)));
  EXPECT_EQ(gltf["accessors"][0]["min"][0].get<double>(), double{0.1f});
  EXPECT_EQ(gltf["accessors"][0]["min"][1].get<double>(), double{-7.7f});
  EXPECT_EQ(gltf["accessors"][0]["min"][2].get<double>(), double{1e-3f});
  EXPECT_FALSE(gltf["meshes"][0]["primitives"][0]["attributes"].contains("NORMAL"));
}

/// Found by the fuzzer: -1e-60 is -0 in floats, so the bounds had the sign of whichever zero came
/// first and a second trip changed the file.
TEST(Glb, BoundsThatAreZeroHaveNoSign) {
  Polygons mesh{{{-1e-60, 0, 0}, {0, -1e-60, 0}, {-1, -1, 1}}, {0, 3}, {0, 1, 2}};
  const std::string once = *format_mesh("glb", mesh);
  EXPECT_EQ(once.find("-0.0"), std::string::npos);
  EXPECT_EQ(*format_mesh("glb", *parse_mesh(once, "glb", "again")), once);
}

TEST(Glb, RefusesAnEmptyMesh) { EXPECT_FALSE(format_mesh("glb", Polygons{}).ok()); }

}  // namespace
}  // namespace limn
