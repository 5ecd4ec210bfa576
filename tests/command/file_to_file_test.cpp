/// Meshes that are written while they are refined: the bytes of a mesh that is refined first.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

#include "limn/mesh/io/mesh_file.h"
#include "limn/surface/refined_file.h"
#include "run_command.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

const std::string kBracket = LIMN_EXAMPLES "/bracket.obj";
const std::string kOpen = LIMN_EXAMPLES "/bracket-quads.obj";

/// The file that the whole mesh would give.
std::string whole_file(const Scheme& scheme, const Polygons& control,
                       const SurfaceOptions& options) {
  RefinedSurface surface =
      refine_surface(scheme, *Mesh::build(control), control.positions, options).value();
  if (options.limit) surface.polygons.positions = surface.limit;
  WriteOptions extras;
  extras.normals = surface.normals;
  return *format_mesh("ply", surface.polygons, extras);
}

class FileToFile : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Schemes, FileToFile, testing::ValuesIn(shipped_schemes()),
                         [](const auto& info) { return test_name(info.param); });

TEST_P(FileToFile, HasTheBytesOfTheWhole) {
  const Scheme& scheme = shipped(GetParam());
  const TemporaryFolder folder;
  const std::string path = folder / "fine.ply";
  int written = 0;
  for (const std::string& mesh : {kBracket, kOpen}) {
    const Polygons control = *read_mesh(mesh);
    if (!refine_surface(scheme, *Mesh::build(control), control.positions, {.levels = 1}))
      continue;  // it lacks a rule
    for (const int levels : {0, 1, scheme.split->dilation.growth() > 4 ? 3 : 4})
      for (const bool limit : {false, true})
        for (const bool normals : {false, true}) {
          const SurfaceOptions options{
              .levels = levels, .limit = limit, .normals = normals, .partial = true};
          if (!surface::may_write_refined(scheme, options, path, "ply")) continue;
          const auto file = surface::write_refined(scheme, *Mesh::build(control), control.positions,
                                                   options, path);
          ASSERT_TRUE(file.ok()) << file.error().text();
          EXPECT_EQ(std::filesystem::exists(path), file->has_value());
          if (!*file) continue;
          ++written;
          EXPECT_TRUE(*base::read_file(path) == whole_file(scheme, control, options))
              << mesh << " " << levels << limit << normals;
          EXPECT_EQ((*file)->vertices, read_mesh(path)->positions.size());
          EXPECT_EQ((*file)->faces, static_cast<std::size_t>(read_mesh(path)->face_count()));
          std::filesystem::remove(path);
        }
  }
  if (written == 0) GTEST_SKIP() << "the plain engine makes these";
}

/// Standard output takes no places, so it gets the whole mesh.
TEST(FileToFileOf, TheCommandHasTheBytesOfStandardOutput) {
  const Folder folder;
  folder.write("kept.ply", "old");
  std::filesystem::create_symlink("kept.ply", folder.file("link.ply"));
  for (const std::string& job : {"'" + kBracket + "' -s loop -n 4", "'" + kOpen + "' -s doo-sabin",
                                 "'" + kOpen + "' -s catmull-clark -n 3 --limit --normals"}) {
    ASSERT_EQ(folder.limn("refine " + job + " -o link.ply").code, 0);
    ASSERT_EQ(folder.limn("refine " + job + " -o - --format ply > all.ply").code, 0);
    EXPECT_TRUE(folder.read("kept.ply") == folder.read("all.ply")) << job;
    EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link.ply")));
  }
  EXPECT_EQ(folder.count(), 3);
}

TEST(FileToFileOf, TheReportIsThatOfTheWhole) {
  const Folder folder;
  const std::string job = "refine '" + kBracket + "' -s loop -n 3 --json --normals -o ";
  nlohmann::json one = nlohmann::json::parse(folder.limn(job + "a.ply").out);
  nlohmann::json other = nlohmann::json::parse(folder.limn(job + "a.obj").out);
  EXPECT_GT(one.at("seconds").get<double>(), 0);
  for (nlohmann::json* report : {&one, &other})
    for (const char* key : {"seconds", "output"}) report->erase(key);
  EXPECT_EQ(one, other);
}

TEST(FileToFileOf, VerticesWithoutANormalAreSaid) {
  const Folder folder;
  // all in one line
  folder.write("line.obj",
               "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n");
  const std::string job = "refine line.obj -s loop -n 3 --json --normals -o ";
  const nlohmann::json one = nlohmann::json::parse(folder.limn(job + "a.ply").out);
  const nlohmann::json other = nlohmann::json::parse(folder.limn(job + "a.obj").out);
  EXPECT_EQ(one.at("missing"), other.at("missing"));
}

}  // namespace
}  // namespace limn::test
