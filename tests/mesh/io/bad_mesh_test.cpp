/// Every file of tests/data/bad-meshes is refused, at the right place and with a telling message.

#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "limn/base/files/file.h"
#include "limn/mesh/io/mesh_file.h"
#include "mesh/io/mesh_samples.h"
#include "support/temporary_folder.h"

namespace limn {
namespace {

struct Expected {
  std::string file, place, message;
  friend std::ostream& operator<<(std::ostream& out, const Expected& e) { return out << e.file; }
};

std::filesystem::path folder() { return std::filesystem::path(LIMN_TEST_DATA) / "bad-meshes"; }

std::vector<Expected> expectations() {
  std::vector<Expected> list;
  std::ifstream in(folder() / "expected.txt");
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    const std::size_t first = line.find(" | "), second = line.find(" | ", first + 3);
    list.push_back({line.substr(0, first), line.substr(first + 3, second - first - 3),
                    line.substr(second + 3)});
  }
  return list;
}

class BadMesh : public testing::TestWithParam<Expected> {};

TEST_P(BadMesh, IsRefusedAtItsPlace) {
  const Expected& expected = GetParam();
  const std::string path = (folder() / expected.file).string();
  const Result<Polygons> mesh = read_mesh(path);
  ASSERT_FALSE(mesh.ok());
  const Error& error = mesh.error();
  EXPECT_EQ(error.file, path);
  EXPECT_EQ(std::to_string(error.line) + ":" + std::to_string(error.column), expected.place)
      << error.text();
  const std::string said = error.message + " (" + error.hint + ")";
  EXPECT_NE(said.find(expected.message), std::string::npos) << said;
}

INSTANTIATE_TEST_SUITE_P(Corpus, BadMesh, testing::ValuesIn(expectations()),
                         [](const testing::TestParamInfo<Expected>& info) {
                           std::string name = info.param.file;
                           for (char& c : name) {
                             if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
                           }
                           return name;
                         });

TEST(BadMeshes, EveryFileHasAnExpectation) {
  std::map<std::string, int> listed;
  for (const Expected& expected : expectations()) ++listed[expected.file];
  EXPECT_GT(listed.size(), 100u);
  for (const auto& entry : std::filesystem::directory_iterator(folder())) {
    const std::string name = entry.path().filename().string();
    if (name != "expected.txt") EXPECT_EQ(listed[name], 1) << name;
  }
}

TEST(BadMeshes, MissingFileDirectoryAndUnknownExtension) {
  const test::TemporaryFolder temporary;
  const Result<Polygons> missing = read_mesh(temporary / "none.obj");
  ASSERT_FALSE(missing.ok());
  EXPECT_NE(missing.error().message.find("No such file"), std::string::npos);

  std::filesystem::create_directory(temporary / "folder.obj");
  const Result<Polygons> directory = read_mesh(temporary / "folder.obj");
  ASSERT_FALSE(directory.ok());
  EXPECT_NE(directory.error().message.find("directory"), std::string::npos);

  const Result<Polygons> unknown = read_mesh(temporary / "mesh.fbx");
  ASSERT_FALSE(unknown.ok());
  EXPECT_NE(unknown.error().message.find("'fbx'"), std::string::npos);
  EXPECT_NE(unknown.error().hint.find("obj, off, ply, stl"), std::string::npos);
  EXPECT_TRUE(check_readable("mesh.glb").ok());
  EXPECT_TRUE(check_writable("mesh.glb").ok());
  EXPECT_TRUE(check_readable("mesh.gltf").ok());
  EXPECT_FALSE(check_writable("mesh.gltf").ok());
  EXPECT_FALSE(check_writable("mesh").ok());
  EXPECT_FALSE(check_writable("folder.obj/mesh").ok());
  EXPECT_TRUE(check_readable("a.b/MESH.ObJ").ok());
}

/// Whatever is cut off or changed, the readers answer; under the sanitizers this is the test
/// that they read nothing outside the content.
TEST(BadMeshes, EveryPrefixAndEveryChangedByteIsAnswered) {
  for (const std::string extension : {"obj", "off", "ply", "stl"}) {
    const std::string good = *format_mesh(extension, test::cube());
    ASSERT_TRUE(parse_mesh(good, extension, "good").ok());
    for (std::size_t size = 0; size < good.size(); ++size) {
      const std::string cut(good.data(), size);  // of its own, so that its end is guarded
      const Result<Polygons> mesh = parse_mesh(cut, extension, "cut");
      if (extension == "ply" || extension == "stl") EXPECT_FALSE(mesh.ok()) << size;
    }
    for (std::size_t at = 0; at < good.size(); ++at) {
      for (const char byte : {'\0', '\n', '9', '-', '\xff'}) {
        std::string changed = good;
        changed[at] = byte;
        const Result<Polygons> mesh = parse_mesh(changed, extension, "changed");
        if (!mesh.ok()) EXPECT_FALSE(mesh.error().message.empty());
      }
    }
  }
}

}  // namespace
}  // namespace limn
