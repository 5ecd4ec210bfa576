// `limn refine` and `limn check` of meshes with colours, texture coordinates and groups.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "command/run_command.h"
#include "limn/mesh/io/mesh_file.h"

namespace limn::test {
namespace {

/// Two squares with a seam between them, colours, and a group each.
const std::string kSquares =
    "mtllib paint.mtl\n"
    "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nv 0 1 0 1 0 0\nv 2 0 0 0 0 1\nv 2 1 0 0 0 1\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 5 0\nvt 6 0\nvt 6 1\nvt 5 1\n"
    "g left\nusemtl red\nf 1/1 2/2 3/3 4/4\ng right\nusemtl blue\nf 2/5 5/6 6/7 3/8\n";

MeshFile read(const Folder& folder, const std::string& name) {
  return parse_mesh_file(folder.read(name), name.substr(name.rfind('.') + 1), name,
                         {.attributes = true})
      .value();
}

void expect_done(const Outcome& outcome) { EXPECT_EQ(outcome.code, 0) << outcome.err; }

TEST(Attributes, GoAlongFromObjToObj) {
  const Folder folder;
  folder.write("a.obj", kSquares);
  const Outcome outcome = folder.limn("refine a.obj -s catmull-clark -n 2 -o fine.obj --json");
  expect_done(outcome);
  EXPECT_EQ(outcome.err, "");
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["attributes"]["numbers"], (nlohmann::json{"red", "green", "blue"}));
  EXPECT_EQ(json["attributes"]["texture_points"], 50);
  EXPECT_EQ(json["attributes"]["labels"], (nlohmann::json{{"groups", 2}, {"materials", 2}}));
  const MeshFile fine = read(folder, "fine.obj");
  EXPECT_EQ(fine.attributes.texture.points.size(), 50U);
  EXPECT_EQ(fine.attributes.of(LabelKind::material).names,
            (std::vector<std::string>{"red", "blue"}));
  EXPECT_EQ(fine.attributes.material_files, std::vector<std::string>{"paint.mtl"});
  const std::vector<Index>& group = fine.attributes.of(LabelKind::group).of_face;
  EXPECT_EQ(std::count(group.begin(), group.end(), 0), 16);
  EXPECT_EQ(std::count(group.begin(), group.end(), 1), 16);
}

TEST(Attributes, ThatAFormatCannotHoldAreNamedInOneWarning) {
  const Folder folder;
  folder.write("a.obj", kSquares);
  const Outcome stl = folder.limn("refine a.obj -s catmull-clark -n 1 -o fine.stl");
  expect_done(stl);
  EXPECT_NE(stl.err.find("fine.stl: left out: vertex colours, texture coordinates, groups, "
                         "materials, names of material files, which stl files cannot hold"),
            std::string::npos)
      << stl.err;
  const Outcome glb = folder.limn("refine a.obj -s catmull-clark -n 1 -o fine.glb");
  expect_done(glb);
  EXPECT_NE(glb.err.find("left out: groups, materials, names of material files, which glb"),
            std::string::npos)
      << glb.err;
  const MeshFile fine = read(folder, "fine.glb");
  EXPECT_EQ(fine.polygons.vertex_count(), 18);  // three more along the seam
  EXPECT_TRUE(colour_of(fine.attributes));
}

TEST(Attributes, AreLeftOutAsAsked) {
  const Folder folder;
  folder.write("a.obj", kSquares);
  const Outcome outcome =
      folder.limn("refine a.obj -s catmull-clark -n 1 -o fine.obj --attributes none --json");
  expect_done(outcome);
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_FALSE(json.contains("attributes"));
  EXPECT_EQ(json["left_out"].size(), 5U);
  EXPECT_TRUE(read(folder, "fine.obj").attributes.empty());
}

TEST(Attributes, LinearAndSmoothNumbersDiffer) {
  const Folder folder;
  folder.write("a.obj", kSquares);
  const auto red_at_the_seam = [&](const std::string& how) {
    expect_done(
        folder.limn("refine a.obj -s catmull-clark -n 1 -o fine.ply --quiet --attributes " + how));
    return read(folder, "fine.ply").attributes.find("red")->values[1];
  };
  EXPECT_EQ(red_at_the_seam("linear"), 1);
  EXPECT_LT(red_at_the_seam("smooth"), 1);
}

TEST(Attributes, TextureThatASchemeCannotRefineIsLeftOutOrRefused) {
  const Folder folder;
  folder.write("a.obj", kSquares);
  const Outcome left = folder.limn("refine a.obj -s four-eight -n 1 -o fine.obj");
  expect_done(left);
  EXPECT_NE(left.err.find("left out: texture coordinates: four-eight cannot refine"),
            std::string::npos)
      << left.err;
  EXPECT_TRUE(read(folder, "fine.obj").attributes.texture.empty());
  const Outcome refused =
      folder.limn("refine a.obj -s four-eight -n 1 -o fine.obj --uv cornersOnly --overwrite");
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("--attributes none"), std::string::npos) << refused.err;
  EXPECT_EQ(folder.limn("refine a.obj -s loop -n 1 -o fine.obj --uv corners").code, 2);
}

TEST(Attributes, FaultyOnesAreRefusedWithTheirLine) {
  const Folder folder;
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/2 3/1\n");
  const Outcome refused = folder.limn("refine a.obj -s loop -n 1 -o fine.obj");
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("a.obj:5:7: the texture point 2 is not there"), std::string::npos)
      << refused.err;
  expect_done(folder.limn("refine a.obj -s loop -n 1 -o fine.obj --attributes none"));
}

TEST(Attributes, AreCountedAndRepairedByCheck) {
  const Folder folder;
  // the same squares, each with its own vertices
  folder.write("a.obj",
               "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\n"
               "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 2 0\nvt 2 1\n"
               "g a\nf 1/1 2/2 3/3 4/4\ng b\nf 5/2 6/5 7/6 8/3\n");
  const Outcome outcome = folder.limn("check a.obj --weld --json -o b.obj");
  expect_done(outcome);
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["attributes"]["texture_points"], 6);
  EXPECT_EQ(json["attributes"]["labels"]["groups"], 2);
  const MeshFile welded = read(folder, "b.obj");
  EXPECT_EQ(welded.polygons.vertex_count(), 6);
  EXPECT_EQ(welded.attributes.texture.of_corner, (std::vector<Index>{0, 1, 2, 3, 1, 4, 5, 2}));
  EXPECT_EQ(welded.attributes.of(LabelKind::group).names, (std::vector<std::string>{"a", "b"}));
}

}  // namespace
}  // namespace limn::test
