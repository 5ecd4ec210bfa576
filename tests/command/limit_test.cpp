// What `limn` says where something of a limit surface cannot be had.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "limn/mesh/io/mesh_file.h"
#include "mesh/random_mesh.h"
#include "run_command.h"

namespace limn::test {
namespace {

constexpr const char* kButterfly = R"(
split = "triangle-dyadic"
source = "a test: the butterfly without boundary rules"
[vertex]
self = "1"
[edge]
end = "1/2"
wing = "1/8"
outer = "-1/16"
)";

/// An icosahedron of side about 1.
void write_icosahedron(const Folder& folder) {
  const Mesh mesh = icosahedron();
  std::string text = "v 0 0 1\n";
  for (const double z : {0.447, -0.447})
    for (int k = 0; k < 5; ++k) {
      const double angle = 1.2566370614 * (z > 0 ? k : k + 0.5);
      text += "v " + std::to_string(0.894 * std::cos(angle)) + ' ' +
              std::to_string(0.894 * std::sin(angle)) + ' ' + std::to_string(z) + '\n';
    }
  text += "v 0 0 -1\n";
  for (Index f = 0; f < mesh.face_count(); ++f) {
    text += "f";
    for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h)
      text += ' ' + std::to_string(mesh.origin(h) + 1);
    text += '\n';
  }
  folder.write("ball.obj", text);
}

TEST(LimitCommand, NeedsNoBoundaryRulesOnClosedMeshes) {
  const Folder folder;
  folder.write("open.toml", kButterfly);
  write_icosahedron(folder);
  for (const char* arguments :
       {"refine ball.obj -s ./open.toml -n 1 --limit --normals --engine plain -o out.obj",
        "refine ball.obj -s ./open.toml -n 0 --limit --engine plain -o out.obj",
        "refine ball.obj -s ./open.toml -n 2 --curvatures k.csv -o out.obj",
        "fairness ball.obj -s ./open.toml -n 2", "draw ball.obj -s ./open.toml -n 2 -o out.svg",
        "compare ./open.toml loop --mesh ball.obj -n 2 -o out.svg"}) {
    const Outcome outcome = folder.limn(arguments);
    EXPECT_EQ(outcome.code, 0) << arguments << '\n' << outcome.err;
  }
}

// A tetrahedron on a line has limit points, and no normal at all.
TEST(LimitCommand, SaysWhereNormalsAreMissing) {
  const Folder folder;
  folder.write("line.obj",
               "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  for (const char* output : {"out.obj", "out.off", "out.ply", "out.glb"})
    for (const char* engine : {"quick", "plain"}) {
      const Outcome outcome = folder.limn(
          "refine line.obj -s loop -n 1 --limit --normals --json "
          "--engine " +
          std::string(engine) + " -o " + output);
      ASSERT_EQ(outcome.code, 0) << outcome.err;
      EXPECT_NE(outcome.err.find("no normal at 10 vertices: 0, 1, 2"), std::string::npos)
          << outcome.err;
      const bool glb = std::string(output) == "out.glb";
      EXPECT_NE(outcome.err.find(glb ? "written as 0 0 1" : "written as 0 0 0"), std::string::npos);
      const auto json = nlohmann::json::parse(outcome.out);
      EXPECT_EQ(json.at("missing").at("normals").at("count"), 10);
    }
}

// … all of them in JSON, where the text names ten, and the warnings too.
TEST(LimitCommand, NamesAllThatIsMissingInJson) {
  const Folder folder;
  folder.write("line.obj",
               "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  const Outcome outcome = folder.limn(
      "refine line.obj -s loop -n 2 --limit --normals --curvatures k.csv --json -o out.obj");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("k.csv: no curvature at 30 vertices"), std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("and 20 more (counted from 0): no normal there"), std::string::npos)
      << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("missing").at("normals").at("vertices").size(), 34);
  EXPECT_EQ(json.at("missing").at("curvatures").at("vertices").size(), 34);
  // control vertices have three faces, where Loop's curvature is unbounded
  EXPECT_NE(outcome.err.find("k.csv: no curvature at 4 vertices: 0, 1, 2, 3 "), std::string::npos);
  std::size_t with_reasons = 0;
  for (const auto& one : json.at("missing").at("curvatures").at("reasons"))
    with_reasons += one.at("vertices").size();
  EXPECT_EQ(with_reasons, 34);
  ASSERT_EQ(json.at("warnings").size(), 3);
  EXPECT_EQ(json.at("warnings").at(0).at("file"), "out.obj");
  EXPECT_EQ(json.at("warnings").at(1).at("file"), "k.csv");
}

/// Loop that does not converge at valence 5, where an icosahedron's vertices all are.
constexpr const char* kNotAtFive = R"(
split = "triangle-dyadic"
source = "a test: Loop, that does not converge at valence 5"
extends = "loop"
[[vertex]]
when = "n == 5"
self = "-1"
ring = "2/5"
[[vertex]]
self = "1 - n*beta"
ring = "beta"
)";

TEST(LimitCommand, DrawsAndMeasuresWhatThereIs) {
  const Folder folder;
  folder.write("not.toml", kNotAtFive);
  write_icosahedron(folder);
  for (const char* arguments : {"refine ball.obj -s ./not.toml -n 2 --limit --json -o out.obj",
                                "draw ball.obj -s ./not.toml -n 2 --json -o out.svg",
                                "fairness ball.obj -s ./not.toml -n 2 --json",
                                "compare ./not.toml loop --mesh ball.obj -n 2 --json -o out.svg"}) {
    const Outcome outcome = folder.limn(arguments);
    ASSERT_EQ(outcome.code, 0) << arguments << '\n' << outcome.err;
    EXPECT_NE(outcome.err.find("no limit point at 12 vertices: 0, 1, 2"), std::string::npos)
        << arguments << '\n'
        << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    bool warned = false;
    for (const auto& warning : json.at("warnings"))
      warned = warned || warning.at("message").get<std::string>().find("no limit point at 12") !=
                             std::string::npos;
    EXPECT_TRUE(warned) << outcome.out;
    const auto& missing =
        json.contains("missing") && json.at("missing").is_object() ? json.at("missing")
        : json.at("schemes").at(0).contains("gaps") ? json.at("schemes").at(0).at("gaps")
                                                    : json.at("schemes").at(0).at("missing");
    EXPECT_EQ(missing.at("limits").at("vertices").size(), 12) << arguments;
  }
}

TEST(LimitCommand, GivesTheRestWhereAVertexHasValenceTwo) {
  const Folder folder;
  std::string text;
  for (int i = 0; i < 16; ++i)
    text += "v " + std::to_string(i % 4) + ' ' + std::to_string(i / 4) + ' ' +
            std::to_string(0.1 * (i % 4) * (i / 4)) + '\n';
  text += "v 1.5 1.5 0.6\n";
  text +=
      "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 5 6 10 9\nf 6 7 11 17\nf 6 17 11 10\n"
      "f 7 8 12 11\nf 9 10 14 13\nf 10 11 15 14\nf 11 12 16 15\n";
  folder.write("grid.obj", text);
  for (const char* engine : {"quick", "plain"}) {
    const Outcome outcome = folder.limn(
        "refine grid.obj -s catmull-clark -n 1 --limit --normals --json -o out.ply "
        "--engine " +
        std::string(engine));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto missing = nlohmann::json::parse(outcome.out).at("missing");
    EXPECT_EQ(missing.at("normals").at("vertices"), nlohmann::json({16}));
    EXPECT_FALSE(missing.contains("limits"));
    EXPECT_NE(outcome.err.find("no normal at vertex 16"), std::string::npos) << outcome.err;
  }
  const Outcome eigen = folder.limn("eigen catmull-clark --valence 2 --json --vectors");
  ASSERT_EQ(eigen.code, 0) << eigen.err;
  const auto valence = nlohmann::json::parse(eigen.out).at("valences").at(0);
  EXPECT_TRUE(valence.at("components").at("tangent").is_null());
  const Outcome loop = folder.limn("eigen loop --valence 2");
  ASSERT_EQ(loop.code, 0) << loop.err;
  EXPECT_NE(loop.out.find("no tangent pair"), std::string::npos) << loop.out;
  expect_refused(folder.limn("eigen doo-sabin --valence 2"), "the number of a face's corners");
}

TEST(LimitCommand, KeepsLimitsWhereCurvaturesAreMissing) {
  const Folder folder;
  folder.write("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3\nf 2 4 3\n");
  for (const char* level : {"0", "1", "2"}) {
    const Outcome outcome =
        folder.limn("refine two.obj -s doo-sabin --limit --curvatures k.csv --json -o out.obj -n " +
                    std::string(level));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("no curvature at "), std::string::npos) << outcome.err;
    EXPECT_TRUE(nlohmann::json::parse(outcome.out).at("missing").contains("curvatures"));
  }
}

// Normals are those of the shape, at any size.
TEST(LimitCommand, DoesNotDependOnTheSizeOfTheModel) {
  const Folder folder;
  for (const char* power : {"e-300", "e-80", "e100", "e200", "e300"}) {
    std::string text;
    for (const char* p : {"1 1 1", "-1 -1 1", "-1 1 -1", "1 -1 -1"}) {
      std::string point = std::string("v ") + p + ' ';
      for (std::size_t at = point.find('1'); at != std::string::npos; at = point.find('1', at + 3))
        point.insert(at + 1, power);
      text += point + '\n';
    }
    folder.write("large.obj", text + "f 1 2 4\nf 3 2 1\nf 1 4 3\nf 2 3 4\n");
    for (const char* engine : {"quick", "plain"}) {
      const Outcome outcome =
          folder.limn("refine large.obj -s loop -n 2 --limit --normals -o out.obj --engine " +
                      std::string(engine));
      ASSERT_EQ(outcome.code, 0) << power << outcome.err;
      EXPECT_EQ(outcome.err.find("no normal"), std::string::npos) << power << outcome.err;
    }
  }
}

}  // namespace
}  // namespace limn::test
