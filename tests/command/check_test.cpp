/// `limn check`, and repair in every command that takes a mesh. The cases are small meshes after
/// reports of people's troubles with meshes, each named by what is odd about it.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

#include <nlohmann/json.hpp>

#include "limn/mesh/io/mesh_file.h"
#include "limn/mesh/mesh.h"
#include "run_command.h"

namespace limn::test {
namespace {

using Json = nlohmann::json;

std::string quoted(const std::string& path) { return "'" + path + "'"; }
std::string case_file(const std::string& name) {
  return quoted(std::string(LIMN_TEST_DATA) + "/cases/" + name);
}

Json check_json(const Folder& folder, const std::string& arguments, int code) {
  const Outcome outcome = folder.limn("check --json " + arguments);
  EXPECT_EQ(outcome.code, code) << arguments << "\n" << outcome.err;
  return Json::parse(outcome.out.empty() ? "null" : outcome.out);
}

/// What each case is: the counts of `check` that are not 0, and what mends it.
struct Case {
  std::string file;
  std::map<std::string, int> counts;
  std::string remedy = {};  ///< an option with which it is refined; empty: without any
};

const std::vector<Case>& cases() {
  static const std::vector<Case> list{
      {"01b-valence2-in-grid.obj", {}},
      {"03-edge-of-three-faces.obj", {{"non_manifold_edges", 1}}, "--cut"},
      {"05-bowtie-open.obj", {{"non_manifold_vertices", 1}}, "--cut"},
      {"06-flipped-face.obj", {{"flipped_edges", 3}}, "--orient"},
      {"07b-box-24-vertices.obj", {{"coincident_vertices", 16}}},
      {"08b-open-plane-triangles.obj", {}},
      {"102-end-solid.stl", {}},
      {"106-degenerate-facet.stl", {{"degenerate_faces", 1}}},
      {"107c-unit-cube-negative-zero.stl", {}},
      {"14b-collinear.obj", {{"degenerate_faces", 4}}},
      {"20-face-twice.obj", {{"duplicate_faces", 1}}, "--repair"},
      {"22-moebius.obj", {{"flipped_edges", 1}}, "--cut"},
      {"24c-enormous.obj", {}},
      {"26-concave-quad.obj", {}},
      {"31-planar.obj", {}},
      {"42b-continuation-space-after.obj", {}},
      {"44b-usemtl-ends-in-backslash.obj", {}},
      {"60-osd-crease-tags.obj", {}},
      {"77-tristrips.ply", {}},
      {"87-trailing-bytes.ply", {}},
      {"92-counts-glued.off", {}}};
  return list;
}

constexpr const char* kFaultCounts[] = {
    "isolated_vertices", "coincident_vertices", "degenerate_faces",      "duplicate_faces",
    "flipped_edges",     "non_manifold_edges",  "non_manifold_vertices", "not_finite"};

TEST(CheckCases, CountWhatTheirNamesSay) {
  const Folder folder;
  for (const Case& one : cases()) {
    const Json json = check_json(folder, case_file(one.file), one.remedy.empty() ? 0 : 2);
    for (const std::string key : kFaultCounts) {
      const auto expected = one.counts.find(key);
      EXPECT_EQ(json.at(key), expected == one.counts.end() ? 0 : expected->second)
          << one.file << " " << key;
    }
    EXPECT_EQ(json.at("refinable"), one.remedy.empty()) << one.file;
    int sum = 0;
    for (const auto& [key, value] : one.counts) sum += value;
    EXPECT_EQ(json.at("faults").size(), sum) << one.file;
  }
}

TEST(CheckCases, AreRefinedOrRefusedAsChecked) {
  const Folder folder;
  for (const Case& one : cases()) {
    const std::string refine = "refine " + case_file(one.file) + " -s catmull-clark -n 2 -o o.ply";
    if (!one.remedy.empty()) expect_refused(folder.limn(refine), {one.file, one.remedy});
    for (const std::string& option : {one.remedy, std::string("--repair")}) {
      const Outcome outcome = folder.limn(refine + " --limit --normals --no-tags --json " + option);
      ASSERT_EQ(outcome.code, 0) << one.file << " " << option << outcome.err;
      const Polygons fine = read_mesh(folder.file("o.ply")).value();
      EXPECT_TRUE(Mesh::build(fine).ok()) << one.file;
      const Json json = Json::parse(outcome.out);
      EXPECT_EQ(json.at("repaired").empty(), option.empty() || json.at("repaired").empty());
      if (!one.remedy.empty()) EXPECT_FALSE(json.at("repaired").empty()) << one.file;
    }
    EXPECT_EQ(folder.limn("check " + case_file(one.file) + " --repair").code, 0) << one.file;
  }
  expect_refused(folder.limn("check " + case_file("49-utf16.obj")), {"UTF-16"});
}

TEST(CheckCases, GoThroughEveryCommand) {
  const Folder folder;
  for (const Case& one : cases()) {
    const std::string mesh = case_file(one.file) + " " + one.remedy;
    std::vector<std::string> commands{"fairness " + mesh + " -s catmull-clark -n 2 --json",
                                      "draw " + mesh + " -s doo-sabin -n 1 -o o.svg --json"};
    if (one.file.starts_with("0"))  // it looks at the schemes, too
      commands.push_back(
          "compare catmull-clark doo-sabin --valence 4 --budget 20 -n 1 --json --mesh " + mesh);
    for (const std::string& command : commands) {
      const Outcome outcome = folder.limn(command);
      if (outcome.code != 0) {  // in words, and only where there is nothing to see or to compare
        expect_refused(outcome, one.file);
        continue;
      }
      EXPECT_EQ(outcome.out.find("nan"), std::string::npos) << command;
    }
  }
}

TEST(Check, TellsWhatAMeshIs) {
  const Folder folder;
  const Json json = check_json(folder, case_file("08b-open-plane-triangles.obj"), 0);
  EXPECT_EQ(json.at("vertices"), 9);
  EXPECT_EQ(json.at("faces"), 8);
  EXPECT_EQ(json.at("edges"), 16);
  EXPECT_EQ(json.at("components"), 1);
  EXPECT_EQ(json.at("boundary_loops"), 1);
  EXPECT_EQ(json.at("euler"), 1);
  EXPECT_EQ(json.at("genus"), 0);
  EXPECT_EQ(json.at("valences"), (Json{{"2", 2}, {"3", 2}, {"4", 4}, {"6", 1}}));
  const Outcome text = folder.limn("check " + case_file("08b-open-plane-triangles.obj"));
  EXPECT_NE(text.out.find("9 vertices, 16 edges, 8 faces, in 1 part"), std::string::npos)
      << text.out;
  EXPECT_NE(text.out.find("8 boundary edges in 1 loop"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("no faults"), std::string::npos) << text.out;
}

/// An OBJ with a fault of every kind that the reader or the mesh can have.
const std::string kBroken =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv 0 0 1e999\n"
    "f 1 2 3\nf 1 2 3\nf 1 2\nf 1 2 9\nf 0 1 2\nf -9 1 2\nf 3 4 5 4\n";

TEST(Check, ListsAllFaultsAtOnceInTheLinesOfTheFile) {
  const Folder folder;
  folder.write("m.obj", kBroken);
  const Json json = check_json(folder, "m.obj", 2);
  std::map<std::string, std::vector<int>> lines;
  for (const Json& fault : json.at("faults"))
    for (const int line : fault.at("lines"))
      lines[fault.at("kind").get<std::string>()].push_back(line);
  EXPECT_EQ(lines["few_corners"], (std::vector<int>{8}));
  EXPECT_EQ(lines["missing_vertex"], (std::vector<int>{9, 10, 11}));
  EXPECT_EQ(lines["repeated_corner"], (std::vector<int>{12}));
  EXPECT_EQ(lines["duplicate_face"], (std::vector<int>{6, 7}));
  EXPECT_EQ(lines["not_finite"], (std::vector<int>{4, 5}));
  EXPECT_EQ(json.at("degenerate_faces"), 2);
  EXPECT_EQ(json.at("remedies").at("duplicate_face"), "remove the repeated faces: --repair does");
  // the other commands still refuse the first of these
  expect_refused(folder.limn("refine m.obj -s loop -o o.obj"), {"m.obj:4:3", "nan"});
}

TEST(Check, EveryFormatKeepsItsFaults) {
  const Folder folder;
  folder.write("m.off", "OFF\n3 2 0\n0 0 0\n1 0 inf\n0 1 0\n3 0 1 2\n3 0 1 7\n");
  folder.write(
      "m.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 2\nproperty list uchar int vertex_index\nend_header\n"
      "0 0 0\n1 0 inf\n0 1 0\n3 0 1 2\n3 0 1 7\n");
  folder.write("m.stl",
               "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 inf\n"
               "vertex 0 1 0\nendloop\nendfacet\nendsolid\n");
  for (const std::string name : {"m.off", "m.ply", "m.stl"}) {
    const Json json = check_json(folder, name, 2);
    EXPECT_EQ(json.at("not_finite"), 1) << name;
    EXPECT_EQ(json.at("faults").size(), name == "m.stl" ? 1 : 2) << name;
    expect_refused(folder.limn("refine " + name + " -s loop -o o.obj"), name);
  }
}

TEST(Check, TextIsBoundedAndJsonIsWhole) {
  const Folder folder;
  std::string obj;
  for (int k = 0; k < 500; ++k) {
    for (const char* point : {" 0 0\n", " 1 0\n", " 0 1\n"})
      obj += "v " + std::to_string(k) + point;
    obj += "f -1 -2 -3\nf -1 -2 -3\n";
  }
  folder.write("m.obj", obj);
  const Outcome text = folder.limn("check m.obj");
  EXPECT_EQ(text.code, 2);
  EXPECT_LT(text.out.size(), 2500U);
  EXPECT_NE(text.out.find("500 faces are repeated"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("and 495 more"), std::string::npos) << text.out;
  EXPECT_EQ(check_json(folder, "m.obj", 2).at("faults").size(), 500U);
}

TEST(Check, WritesTheRepairedMesh) {
  const Folder folder;
  const Outcome outcome =
      folder.limn("check " + case_file("07b-box-24-vertices.obj") + " --weld -o box.obj");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("repaired: 16 vertices joined with one nearby"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(read_mesh(folder.file("box.obj")).value().vertex_count(), 8);
  const Json json = check_json(folder, "box.obj", 0);
  EXPECT_EQ(json.at("boundary_loops"), 0);
  EXPECT_EQ(json.at("coincident_vertices"), 0);
  // a mesh that is still no surface is not written
  const Outcome refused =
      folder.limn("check " + case_file("03-edge-of-three-faces.obj") + " --orient -o no.obj");
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("no.obj is not written"), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(folder.file("no.obj")));
  // nor the mesh over itself
  expect_refused(folder.limn("check box.obj -o box.obj"), "--overwrite");
  EXPECT_EQ(folder.limn("check box.obj -o box.obj --overwrite").code, 0);
  const Outcome piped = folder.shell("$LIMN check - -o - < box.obj");
  EXPECT_EQ(piped.code, 0) << piped.err;
  EXPECT_EQ(parse_mesh(piped.out, "obj", "out").value().vertex_count(), 8);
  expect_refused(folder.limn("check box.obj --json -o -"), "standard output");
}

TEST(Repair, IsCountedAndNamedInEveryCommand) {
  const Folder folder;
  const std::string box = case_file("07b-box-24-vertices.obj");
  for (const std::string& command : {"refine " + box + " -s catmull-clark -n 1 -o o.obj",
                                     "fairness " + box + " -s catmull-clark -n 1",
                                     "draw " + box + " -s catmull-clark -n 1 -o o.svg",
                                     "compare catmull-clark doo-sabin --valence 4 --budget 20 -n 1 "
                                     "--mesh " +
                                         box}) {
    const Outcome plain = folder.limn(command + " --json");
    if (plain.code != 0) continue;  // built without what it needs
    EXPECT_NE(plain.err.find("looks unwelded"), std::string::npos) << command << plain.err;
    EXPECT_TRUE(Json::parse(plain.out).at("repaired").empty()) << command;
    const Outcome welded = folder.limn(command + " --json --weld");
    EXPECT_EQ(welded.code, 0) << welded.err;
    EXPECT_EQ(welded.err.find("looks unwelded"), std::string::npos) << command;
    const Json repaired = Json::parse(welded.out).at("repaired");
    ASSERT_EQ(repaired.size(), 1U) << command;
    EXPECT_EQ(repaired[0].at("what"), "vertices_welded");
    EXPECT_EQ(repaired[0].at("count"), 16);
  }
}

TEST(Repair, WhatWasCutIsNotCalledUnwelded) {
  const Folder folder;
  const std::string band = case_file("22-moebius.obj") + " --cut";
  const Outcome outcome = folder.limn("refine " + band + " -s catmull-clark -n 1 -o o.obj");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err.find("unwelded"), std::string::npos) << outcome.err;
  EXPECT_EQ(check_json(folder, band, 0).at("coincident_vertices"), 0);
}

TEST(Repair, OptionsWithNothingToDoDoNothing) {
  const Folder folder;
  const std::string bracket = "'" LIMN_EXAMPLES "/bracket.obj'";
  const std::string refine = "refine " + bracket + " -s loop -n 2 -o ";
  ASSERT_EQ(folder.limn(refine + "plain.ply").code, 0);
  for (const std::string option : {"--weld", "--weld=0", "--weld=1e-9", "--cut", "--orient",
                                   "--repair", "--repair --weld=1e-7 --cut"}) {
    const Outcome outcome = folder.limn(refine + "o.ply " + option);
    EXPECT_EQ(outcome.code, 0) << option << outcome.err;
    EXPECT_EQ(folder.read("o.ply"), folder.read("plain.ply")) << option;
    EXPECT_EQ(outcome.err.find("repaired"), std::string::npos) << option;
  }
  for (const std::string wrong : {"--weld=-1", "--weld=nan", "--weld=x", "--weld=2"})
    expect_refused(folder.limn(refine + "o.ply " + wrong), "weld");
}

/// In every format; other commands mend what `check` says they do.
TEST(Repair, DropsFacesOfTwoCornersInEveryCommand) {
  const Folder folder;
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2\n");
  folder.write("a.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n2 0 1\n");
  folder.write("a.ply",
               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
               "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
               "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n2 0 1\n");
  for (const std::string file : {"a.obj", "a.off", "a.ply"}) {
    EXPECT_EQ(check_json(folder, file, 2).at("refinable"), false) << file;
    EXPECT_EQ(check_json(folder, file + " --repair", 0).at("refinable"), true) << file;
    const std::string refine = "refine " + file + " -s loop -n 1 -o o.obj";
    expect_refused(folder.limn(refine), {file, "a face of 2 corners", "--repair"});
    EXPECT_EQ(folder.limn(refine + " --repair").code, 0) << file;
    EXPECT_EQ(read_mesh(folder.file("o.obj")).value().face_count(), 4) << file;
  }
}

/// Exit code 0 means that `limn refine` takes the file as it is.
TEST(Check, FindsWhatIsWrongWithAttributesAndTags) {
  const Folder folder;
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const std::vector<std::pair<std::string, std::string>> wrong{
      {triangle + "vt nan 0\nvt 0 0\nf 1/1 2/2 3/2\n", "4:4: a texture coordinate is 'nan'"},
      {"v 0 0 0 nan 0 0\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1\nf 1 2 3\n", "1:9: a coordinate is 'nan'"},
      {triangle + "f 1 2 3\nt crease 2/1/0 0 7 1\n", "7"}};
  for (const auto& [text, fault] : wrong) {
    folder.write("a.obj", text);
    for (const std::string command :
         {"check a.obj", "check a.obj --json", "check - < a.obj", "refine a.obj -s loop -o o.ply"})
      expect_refused(folder.limn(command), {fault});
  }
  folder.write("a.obj", wrong.front().first);
  EXPECT_EQ(folder.limn("check a.obj --attributes none").code, 0);
  EXPECT_EQ(folder.limn("refine a.obj -s loop --attributes none -o o.ply").code, 0);
  folder.write("a.obj", triangle + "f 1 2 3\nt crease 2/1/0 0 1 1.5\n");
  EXPECT_EQ(folder.limn("check a.obj").code, 0);
}

TEST(Check, NamesNoVertexThatTheFileDoesNot) {
  const Folder folder;
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -5\n");
  const Outcome backwards = folder.limn("check a.obj");
  EXPECT_NE(backwards.out.find("corner 3 of face 1 (line 4) is no vertex"), std::string::npos)
      << backwards.out;
  folder.write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 4294967297\n");
  const Outcome large = folder.limn("check a.off");
  EXPECT_NE(large.out.find("is a vertex beyond 2147483646"), std::string::npos) << large.out;
}

/// A metre's cube in metres from the equator: a float has no digits left for it.
TEST(Check, WarnsOfEdgesThatFloatsLose) {
  const Folder folder;
  folder.write("a.obj",
               "v 500000 4649776.3 100\nv 500001 4649776.3 100\nv 500000 4649776.4 100\n"
               "v 500000 4649776.3 101\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  for (const std::string out : {"o.stl", "o.glb"}) {
    for (const std::string command : {"check a.obj -o ", "refine a.obj -s loop -n 2 -o "}) {
      const Outcome outcome = folder.limn(command + out);
      EXPECT_EQ(outcome.code, 0) << outcome.err;
      EXPECT_NE(outcome.err.find("no length any more"), std::string::npos) << outcome.err;
    }
  }
  EXPECT_EQ(folder.limn("check a.obj -o o.ply").err, "");
  EXPECT_EQ(folder.limn("check '" LIMN_EXAMPLES "/bracket.obj' -o o.stl").err, "");
}

TEST(Check, LengthsThatCannotBeSquaredAreRefusedWhereTheyWouldBe) {
  const Folder folder;
  for (const std::string size : {"1e160", "1e-160"}) {
    folder.write("a.obj", "v 0 0 0\nv " + size + " 0 0\nv 0 " + size + " 0\nv 0 0 " + size +
                              "\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    expect_refused(folder.limn("fairness a.obj -s loop -n 1"), {"a.obj", "squares", "scale"});
    EXPECT_EQ(folder.limn("refine a.obj -s loop -n 1 -o o.obj").code, 0);
  }
}

TEST(Check, SaysWhatWasLeftOutWhereNothingIsLeft) {
  const Folder folder;
  folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nfo 1 2 3\n");
  expect_refused(folder.limn("check a.obj"), {"no faces", "'fo'", "line 4"});
}

}  // namespace
}  // namespace limn::test
