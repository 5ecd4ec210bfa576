#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "limn/mesh/io/mesh_file.h"
#include "limn/refine/refine.h"
#include "run_command.h"

namespace limn::test {
namespace {

const std::string kBracket = "'" LIMN_EXAMPLES "/bracket.obj'";
const std::string kQuads = "'" LIMN_EXAMPLES "/bracket-quads.obj'";

constexpr const char* kTetrahedron =
    "v 1 1 1\nv -1 -1 1\nv -1 1 -1\nv 1 -1 -1\nf 1 2 4\nf 3 2 1\nf 1 4 3\nf 2 3 4\n";

nlohmann::json parsed(const Outcome& outcome) {
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return nlohmann::json::parse(outcome.out);
}

TEST(Command, ListsTheShippedSchemes) {
  const Folder folder;
  const nlohmann::json json = parsed(folder.limn("schemes --json"));
  EXPECT_EQ(json.at("schemes").size(), shipped_schemes().size());
  const Outcome text = folder.limn("schemes");
  EXPECT_EQ(text.code, 0);
  for (const char* name : {"loop",
                           "loop-warren",
                           "butterfly",
                           "butterfly-modified",
                           "interpolating-loop",
                           "sqrt3",
                           "four-eight",
                           "loop-ternary",
                           "butterfly-ternary",
                           "midedge",
                           "catmull-clark",
                           "doo-sabin",
                           "laplacian-loop",
                           "laplacian-loop-low",
                           "laplacian-butterfly",
                           "optimal",
                           "optimal-high",
                           "optimal-low",
                           "box-spline-triangle",
                           "box-spline-quad",
                           "b-spline-quad",
                           "quad-triangle"})
    EXPECT_NE(text.out.find("\n" + std::string(name) + " "), text.out.find(name)) << name;
}

TEST(Command, ShowsEveryScheme) {
  const Folder folder;
  for (const std::string& name : shipped_schemes()) {
    const nlohmann::json json = parsed(folder.limn("show " + name + " --json"));
    EXPECT_EQ(json.at("name"), name);
    EXPECT_EQ(json.at("rules").empty(), json.contains("stages")) << name;
    const Outcome text = folder.limn("show " + name);
    EXPECT_EQ(text.code, 0);
    EXPECT_EQ(text.out.substr(0, name.size() + 1), name + ":");
  }
}

TEST(Command, ShowsStagesAtTheParametersGiven) {
  const Folder folder;
  const Outcome text = folder.limn("show b-spline-quad -p degree=4");
  EXPECT_NE(text.out.find("average × 3 (degree - 1)"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("split   quad-dual"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("1/256 ×"), std::string::npos) << text.out;
  const nlohmann::json json = parsed(folder.limn("show b-spline-quad --json"));
  EXPECT_EQ(json.at("split"), "quad-dyadic");
  EXPECT_EQ(json.at("stages").at("times"), 2);
  expect_refused(folder.limn("show b-spline-quad -p degree=10"), {"range"});
  expect_refused(folder.limn("show b-spline-quad -p degree=5/2"), {"number of averagings"});
}

TEST(Command, TellsOfBothLattices) {
  const Folder folder;
  const nlohmann::json shown = parsed(folder.limn("show quad-triangle --json"));
  EXPECT_EQ(shown.at("split"), "quad-triangle");
  EXPECT_EQ(shown.at("stages").at("first"), "linear");
  EXPECT_FALSE(shown.contains("mask"));
  for (const std::string job :
       {"show", "eigen --valence 5", "regularity", "artifacts -f 0.2,0.1"}) {
    const std::string command =
        job.substr(0, job.find(' ')) + " quad-triangle" +
        (job.find(' ') == std::string::npos ? "" : job.substr(job.find(' ')));
    const nlohmann::json json = parsed(folder.limn(command + " --json"));
    ASSERT_EQ(json.at("lattices").size(), 2U) << job;
    EXPECT_EQ(json.at("lattices")[0].at("lattice"), "triangle") << job;
    EXPECT_EQ(json.at("lattices")[1].at("lattice"), "quad") << job;
    const Outcome text = folder.limn(command);
    EXPECT_NE(text.out.find("on triangles"), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("on quads"), std::string::npos) << text.out;
  }
  // either by itself, from a file
  folder.write("half.toml", "extends = \"quad-triangle\"\nlattice = \"quad\"\n");
  const nlohmann::json half = parsed(folder.limn("eigen half.toml --valence 5 --json"));
  const nlohmann::json both = parsed(folder.limn("eigen quad-triangle --valence 5 --json"));
  EXPECT_EQ(half.at("valences"), both.at("lattices")[1].at("valences"));
  EXPECT_EQ(folder.limn("certify half.toml --valence 5").code, 0);
  expect_refused(folder.limn("certify quad-triangle --valence 5"), {"no single lattice"});
  expect_refused(folder.limn("eigen quad-triangle --table t.csv"), {"no single lattice"});
}

TEST(Command, ShowsTheMaskAtTheParametersGiven) {
  const Folder folder;
  const Outcome loop = folder.limn("show laplacian-loop -p a=0");
  EXPECT_NE(loop.out.find("1/16 ×"), std::string::npos) << loop.out;
  EXPECT_NE(loop.out.find("1   6  10   6   1"), std::string::npos) << loop.out;
  const Outcome example = folder.limn("show laplacian-loop");
  EXPECT_NE(example.out.find("1/24 ×"), std::string::npos) << example.out;
}

TEST(Command, TakesSeveralParametersTogether) {
  const Folder folder;  // one by one, these counts would fit no primal split
  const Outcome linear = folder.limn("show box-spline-triangle -p i=1 -p j=1 -p k3=1");
  EXPECT_EQ(linear.code, 0) << linear.err;
  EXPECT_NE(linear.out.find("1/2 ×"), std::string::npos) << linear.out;
  expect_refused(folder.limn("show box-spline-triangle -p i=1"), {"centre"});
}

TEST(Command, RefineSaysWhatItMade) {
  const Folder folder;
  folder.write("t.obj", kTetrahedron);
  const nlohmann::json json = parsed(folder.limn("refine t.obj -s loop -n 3 -o fine.ply --json"));
  EXPECT_EQ(json.at("vertices"), 130);
  EXPECT_EQ(json.at("faces"), 256);
  EXPECT_EQ(json.at("levels"), 3);
  EXPECT_GE(json.at("seconds").get<double>(), 0);
  const Result<Polygons> fine = read_mesh(folder.file("fine.ply"));
  ASSERT_TRUE(fine.ok()) << fine.error().text();
  EXPECT_EQ(fine->vertex_count(), 130);
  EXPECT_EQ(fine->face_count(), 256);
}

TEST(Command, RefinesWithEverySchemeIntoEveryFormat) {
  const Folder folder;
  for (const std::string& name : shipped_schemes()) {
    if (name.substr(0, 10) == "box-spline") continue;
    for (const std::string format : {"obj", "off", "ply", "stl", "glb"}) {
      const Split& split = *find_scheme(name)->split;
      const std::string mesh = split.any_polygons ? kQuads : kBracket;
      const Outcome outcome =
          folder.limn("refine " + mesh + " -s " + name + " -n 2 -o out." + format);
      EXPECT_EQ(outcome.code, 0) << name << " " << format << " " << outcome.err;
      EXPECT_FALSE(folder.read("out." + format).empty());
    }
  }
}

TEST(Command, LevelZeroKeepsTheControlMeshAsGiven) {
  const Folder folder;
  ASSERT_EQ(folder.limn("refine " + kQuads + " -s catmull-clark -n 0 -o same.obj").code, 0);
  EXPECT_EQ(*read_mesh(folder.file("same.obj")), *read_mesh(LIMN_EXAMPLES "/bracket-quads.obj"));
}

TEST(Command, OneThreadAndManyWriteTheSameBytes) {
  const Folder folder;
  for (const std::string scheme : {"loop", "sqrt3", "butterfly-modified"}) {
    const std::string job = "refine " + kBracket + " -n 5 -s " + scheme;
    ASSERT_EQ(folder.limn(job + " --threads 1 -o one.ply").code, 0);
    ASSERT_EQ(folder.limn("--threads 2 " + job + " -o two.ply").code, 0);
    EXPECT_EQ(folder.read("one.ply"), folder.read("two.ply")) << scheme;
  }
}

/// Each coordinate of all vertices, sorted: what does not depend on their order.
std::array<std::vector<double>, 3> sorted_coordinates(const Polygons& polygons) {
  std::array<std::vector<double>, 3> lists;
  for (const Point3& p : polygons.positions) {
    lists[0].push_back(p.x);
    lists[1].push_back(p.y);
    lists[2].push_back(p.z);
  }
  for (std::vector<double>& list : lists) std::sort(list.begin(), list.end());
  return lists;
}

TEST(Command, BothEnginesMakeTheSameSurface) {
  const Folder folder;
  for (const std::string job : {"-s loop -n 3", "-s butterfly-modified -n 3",
                                "-s loop -n 2 --limit --normals", "-s catmull-clark -n 2"}) {
    const std::string refine = "refine " + kBracket + " " + job + " --engine ";
    ASSERT_EQ(folder.limn(refine + "quick -o quick.obj").code, 0) << job;
    ASSERT_EQ(folder.limn(refine + "plain -o plain.obj").code, 0) << job;
    const Polygons quick = *read_mesh(folder.file("quick.obj"));
    const Polygons plain = *read_mesh(folder.file("plain.obj"));
    ASSERT_EQ(quick.vertex_count(), plain.vertex_count()) << job;
    EXPECT_EQ(quick.face_count(), plain.face_count()) << job;
    EXPECT_TRUE(Mesh::build(quick).ok()) << job;
    const auto a = sorted_coordinates(quick), b = sorted_coordinates(plain);
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < a[c].size(); ++i) EXPECT_NEAR(a[c][i], b[c][i], 1e-12) << job;
  }
  expect_refused(folder.limn("refine " + kBracket + " -s loop --engine fast -o y.obj"),
                 {"engine", "plain"});
}

TEST(Command, TakesASchemeFileItHasNeverSeen) {
  const Folder folder;
  folder.write("t.obj", kTetrahedron);
  folder.write("mine.toml",
               "split = \"triangle-dyadic\"\n"
               "vertex = { self = \"1 - n*b\", ring = \"b\" }\n"
               "edge = { end = \"2/5\", wing = \"1/10\" }\n"
               "parameter.b = { default = \"1/(4*n)\" }\n");
  const nlohmann::json shown = parsed(folder.limn("show ./mine.toml --json"));
  EXPECT_EQ(shown.at("name"), "mine");
  EXPECT_EQ(folder.limn("refine t.obj -s mine.toml -n 1 -o fine.obj").code, 0);
  const Polygons fine = *read_mesh(folder.file("fine.obj"));
  // 3/4 of the corner and 1/4 of the mean of the others, which is -1/3 of it
  EXPECT_NEAR(fine.positions[0].x, 0.75 - 0.25 / 3, 1e-15);
  EXPECT_EQ(folder.limn("refine t.obj -s mine.toml -p b=0 -n 1 -o fine.obj").code, 0);
  EXPECT_EQ(read_mesh(folder.file("fine.obj"))->positions[0].x, 1);
}

TEST(Command, RefusesBadUse) {
  const Folder folder;
  expect_refused(folder.limn(""), {"required"});
  expect_refused(folder.limn("frobnicate"), {"frobnicate", "refine"});
  expect_refused(folder.limn("show"), {"SCHEME"});
  expect_refused(folder.limn("show lop"), {"lop", "did you mean", "loop"});
  expect_refused(folder.limn("show nowhere/mine.toml"), {"nowhere/mine.toml"});
  expect_refused(folder.limn("show butterfly -p w"), {"'w'", "name=expression"});
  expect_refused(folder.limn("show butterfly -p v=1"), {"no parameter 'v'", "w"});
  expect_refused(folder.limn("show butterfly -p w=0.1"), {"decimal"});
  expect_refused(folder.limn("show butterfly -p w=1/2"), {"range", "1/8"});
  expect_refused(folder.limn("refine x.obj"), {"--scheme"});
  expect_refused(folder.limn("refine x.obj -s loop"), {"--output"});
  expect_refused(folder.limn("refine x.obj -s loop -n three -o y.obj"), {"three"});
  expect_refused(folder.limn("refine x.obj -s loop -n -1 -o y.obj"), {"-1"});
  expect_refused(folder.limn("refine x.obj -s loop --threads x -o y.obj"), {"threads"});
}

TEST(Command, RefusesBadMeshes) {
  const Folder folder;
  folder.write("t.obj", kTetrahedron);
  expect_refused(folder.limn("refine none.obj -s loop -o y.obj"), {"none.obj"});
  expect_refused(folder.limn("refine t.obj -s loop -o y.foo"), {"foo", "ply"});
  expect_refused(folder.limn("refine t.foo -s loop -o y.obj"), {"foo", "ply"});
  expect_refused(folder.limn("refine t.obj -s loop -o no/such/y.obj"), {"no/such"});
  folder.write("nan.obj", "v 0 0 nan\n");
  expect_refused(folder.limn("refine nan.obj -s loop -o y.obj"), {"nan.obj:1:7"});
  folder.write("fan.obj",
               "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\n"
               "f 1 2 3\nf 1 2 4\nf 1 2 5\n");
  expect_refused(folder.limn("refine fan.obj -s loop -o y.obj"), {"fan.obj:6", "vertices 1 and 2"});
  expect_refused(folder.limn("refine " + kQuads + " -s loop -o y.obj"),
                 {"corners", "--triangulate"});
  EXPECT_EQ(folder.limn("refine " + kQuads + " -s loop --triangulate -o y.obj").code, 0);
}

TEST(Command, RefusesLevelsThatDoNotFit) {
  const Folder folder;
  folder.write("t.obj", kTetrahedron);
  expect_refused(folder.limn("refine t.obj -s loop -n 40 -o y.obj"), {"40 levels", "vertices"});
  EXPECT_EQ(folder.count(), 1);
}

TEST(Command, SaysOncePerKindWhatOfAFileIsLeftOut) {
  const Folder folder;
  folder.write("uv.obj", "usemtl red\n" + std::string(kTetrahedron) + "vt 0 0\nvt 1 0\nvn 0 0 1\n");
  const Outcome outcome =
      folder.limn("refine uv.obj -s loop -n 1 -o y.obj --attributes none --json");
  EXPECT_EQ(outcome.code, 0);
  for (const char* note :
       {"limn: note: uv.obj:1:1: left out: materials of faces ('usemtl'), 1 line\n",
        "left out: texture coordinates ('vt'), 2 lines\n", "left out: normals ('vn'), 1 line\n"}) {
    const std::size_t first = outcome.err.find(note);
    ASSERT_NE(first, std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find(note, first + 1), std::string::npos);
  }
  const nlohmann::json json = parsed(outcome);
  EXPECT_EQ(json.at("warnings"), nlohmann::json::array());
  ASSERT_EQ(json.at("left_out").size(), 3U);
  EXPECT_EQ(
      json.at("left_out")[1],
      nlohmann::json(
          {{"what", "texture coordinates ('vt')"}, {"count", 2}, {"unit", "lines"}, {"line", 10}}));
}

TEST(Command, RefusesAMeshWithAllItsFaultsInTheNumbersOfTheFile) {
  const Folder folder;
  folder.write("bad.obj",
               "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 3\nf 2 3 4\nf 4 4 1\n");
  expect_refused(folder.limn("refine bad.obj -s loop -o y.obj"),
                 {"3 faults", "face 2 (line 6) is face 1 (line 5) once more",
                  "faces 1 (line 5) and 3 (line 7) both run from vertex 2 to vertex 3",
                  "face 4 (line 8) meets vertex 4 twice"});
  EXPECT_EQ(folder.count(), 1);
  // What is cut into triangles is named by the polygons of the file.
  folder.write("quads.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 2 3 4\n");
  expect_refused(folder.limn("refine quads.obj -s loop --triangulate -o y.obj"),
                 {"quads.obj:6: face 2 is face 1 once more"});
}

TEST(Command, TriangulateCutsConcavePolygonsAndSaysWhereItCannot) {
  const Folder folder;
  folder.write("concave.obj", "v 0 4 0\nv 0 0 0\nv 4 0 0\nv 1 1 0\nf 1 2 3 4\n");
  const std::string rest = " -s loop --triangulate -n 0 --json -o y.obj";
  EXPECT_EQ(parsed(folder.limn("refine concave.obj" + rest)).at("warnings").size(), 0U);
  EXPECT_EQ(read_mesh(folder.file("y.obj"))->corners, (std::vector<Index>{3, 0, 1, 3, 1, 2}));
  folder.write("bow.obj", "v 0 0 0\nv 3 0 0\nv 0 2 0\nv 1 2 0\nf 1 2 3 4\n");
  const Outcome bow = folder.limn("refine bow.obj" + rest);
  EXPECT_EQ(bow.code, 0);
  EXPECT_NE(bow.err.find("bow.obj:5: face 1 crosses itself"), std::string::npos) << bow.err;
  EXPECT_EQ(parsed(bow).at("warnings").size(), 1U);
}

/// The bytes of `name` there, or -1.
std::intmax_t bytes_of(const Folder& folder, const std::string& name) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(folder.file(name), error);
  return error ? -1 : static_cast<std::intmax_t>(bytes);
}

TEST(Command, AnInterruptLeavesNothingHalfWritten) {
  const Folder folder;
  const std::string refine = "refine " + kBracket + " -s loop -n 7 -o ";
  ASSERT_EQ(folder.limn(refine + "whole.obj").code, 0);
  const std::intmax_t whole = bytes_of(folder, "whole.obj");
  for (const char* seconds : {"0.02", "0.05", "0.1", "0.15", "0.2", "0.3"}) {
    const std::string interrupt = std::string("timeout --signal=INT ") + seconds;
    const Outcome outcome = folder.limn(refine + "big.obj", interrupt);
    // A fast machine may be done with the file before the interrupt: then it is whole.
    const std::intmax_t big = bytes_of(folder, "big.obj");
    EXPECT_EQ(folder.count(), big < 0 ? 1 : 2) << seconds;
    EXPECT_EQ(big, outcome.code == 0 || big >= 0 ? whole : -1) << seconds;
    std::filesystem::remove(folder.file("big.obj"));
  }
}

TEST(Command, AFullDiskIsNotSuccess) {
  if (!std::ifstream("/dev/full").good()) GTEST_SKIP() << "no /dev/full here";
  const Folder folder;
  folder.write("run.sh", "'" LIMN_COMMAND "' show loop >/dev/full 2>err; echo $? >code\n");
  ASSERT_EQ(std::system(("cd '" + folder.path() + "' && sh run.sh").c_str()), 0);
  EXPECT_EQ(folder.read("code"), "2\n");
}

TEST(Command, HelpAndVersionSucceed) {
  const Folder folder;
  for (const char* arguments :
       {"--help", "--version", "show --help", "refine --help", "schemes --help"}) {
    const Outcome outcome = folder.limn(arguments);
    EXPECT_EQ(outcome.code, 0) << arguments;
    EXPECT_FALSE(outcome.out.empty()) << arguments;
  }
  EXPECT_NE(folder.limn("refine --help").out.find("Example: "), std::string::npos);
}

}  // namespace
}  // namespace limn::test
