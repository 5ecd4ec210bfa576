#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "run_command.h"

namespace limn::test {
namespace {

const std::string kBracket = LIMN_EXAMPLES "/bracket.obj";
const std::string kQuads = LIMN_EXAMPLES "/bracket-quads.obj";

TEST(DrawCommand, MakesPicturesOfLimitSurfaces) {
  const Folder folder;
  const Outcome shaded = folder.limn("draw " + kBracket + " -s loop -n 2 -o a.png --json");
  if (shaded.code == 2 && shaded.err.find("Embree") != std::string::npos) GTEST_SKIP();
  ASSERT_EQ(shaded.code, 0) << shaded.err;
  EXPECT_EQ(nlohmann::json::parse(shaded.out).at("scheme"), "loop");
  EXPECT_EQ(folder.read("a.png").substr(1, 3), "PNG");
  const Outcome lines =
      folder.limn("draw " + kQuads + " -s catmull-clark -n 2 --reflection-lines --net -o b.svg");
  ASSERT_EQ(lines.code, 0) << lines.err;
  EXPECT_NE(folder.read("b.svg").find("<path"), std::string::npos);
  EXPECT_EQ(folder.read("b.svg").find("<image"), std::string::npos);  // all of it curves
  const Outcome again =
      folder.limn("draw " + kQuads + " -s catmull-clark -n 2 --reflection-lines --net -o c.svg");
  EXPECT_EQ(folder.read("b.svg"), folder.read("c.svg"));
}

/// Some 100 000 triangles take under a second; the bound is for builds without optimisation on a
/// busy machine.
TEST(DrawCommand, TakesLittleTime) {
  const Folder folder;
  const auto start = std::chrono::steady_clock::now();
  const Outcome outcome = folder.limn("draw " + kBracket + " -s loop -n 5 -o a.png");
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  if (outcome.code == 2) GTEST_SKIP() << outcome.err;
  EXPECT_LT(taken.count(), 30);
}

TEST(DrawCommand, IsTheSameForAnyNumberOfThreads) {
  const Folder folder;
  const std::string arguments = "draw " + kBracket + " -s loop -n 3 --stripes --net -o ";
  if (folder.limn(arguments + "a.png").code == 2) GTEST_SKIP() << "built without cairo or Embree";
  EXPECT_EQ(folder.limn(arguments + "b.png", "taskset -c 0").code, 0);
  EXPECT_EQ(folder.read("a.png"), folder.read("b.png"));
}

TEST(DrawCommand, IsTheSameAtAnySize) {
  const Folder folder;
  const auto scaled = [](int exponent) {
    std::string text;
    for (const auto& [x, y, z] : {std::array{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}})
      text += fmt::format("v {} {} {}\n", std::ldexp(x, exponent), std::ldexp(y, exponent),
                          std::ldexp(z, exponent));
    return text + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  };
  folder.write("usual.obj", scaled(0));
  for (const std::string how : {"", " --reflection-lines --lights 8 --net"}) {
    const std::string rest = " -s loop -n 3 -o -" + how;
    const Outcome usual = folder.limn("draw usual.obj" + rest);
    if (usual.code == 2) GTEST_SKIP() << usual.err;
    for (const int exponent : {-1000, -700, 700, 1000}) {
      folder.write("other.obj", scaled(exponent));
      const Outcome other = folder.limn("draw other.obj" + rest);
      EXPECT_EQ(other.code, 0) << other.err;
      EXPECT_TRUE(other.out == usual.out) << how << exponent;
    }
  }
}

TEST(DrawCommand, ShowsCreasesSeamsAndTexture) {
  const Folder folder;
  const std::string knob = "draw " LIMN_EXAMPLES "/knob.obj -s catmull-clark -n 2 -o ";
  const Outcome plain = folder.limn(knob + "a.png --json");
  if (plain.code == 2) GTEST_SKIP() << plain.err;
  EXPECT_FALSE(nlohmann::json::parse(plain.out).contains("missing"));  // each side has a normal
  const Outcome marked = folder.limn(knob + "b.png --json --marks");
  ASSERT_EQ(marked.code, 0) << marked.err;
  const auto marks = nlohmann::json::parse(marked.out).at("marks");
  std::vector<std::string> names;
  for (const auto& kind : marks) names.push_back(kind.at("name"));
  EXPECT_EQ(names,
            (std::vector<std::string>{"edges of sharpness 0.5", "edges of sharpness 1.5",
                                      "edges of sharpness 2", "edges of sharpness 3",
                                      "edges of sharpness infinite", "seams of the texture"}));
  EXPECT_EQ(marks[0].at("curves"), 1);  // a closed one
  for (const std::string more :
       {" --texture", " --texture=3", " --texture --uv all", " --control --texture --marks",
        " --marks --reflection-lines", " --no-tags", " --stripes --texture"}) {
    const Outcome outcome = folder.limn(knob + "c.png" + more);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(folder.read("c.png"), folder.read("a.png")) << more;
  }
  folder.write("tip.toml", "[[corner]]\nvertices = [1]\nsharpness = \"infinite\"\n");
  const Outcome tip = folder.limn("draw " + kQuads + " -s catmull-clark --tags tip.toml -o f.png");
  EXPECT_EQ(tip.code, 0);
  EXPECT_EQ(tip.err, "");
  EXPECT_EQ(folder.limn(knob + "d.svg --marks --texture").code, 0);
  EXPECT_NE(folder.read("d.svg").find("<image"), std::string::npos);
  expect_refused(folder.limn("draw " + kQuads + " -s catmull-clark --texture -o e.png"),
                 "bracket-quads.obj: the mesh has no texture coordinates to draw");
  expect_refused(folder.limn("draw " LIMN_EXAMPLES "/knob.obj -s doo-sabin -o e.png"),
                 "doo-sabin takes no sharp edges");
  expect_refused(folder.limn(knob + "e.png --texture=0"), "--texture");
  const Outcome image = folder.limn(knob + "g.png --texture-image a.png");
  EXPECT_EQ(image.code, 0) << image.err;
  EXPECT_NE(folder.read("g.png"), folder.read("a.png"));
  expect_refused(folder.limn(knob + "e.png --texture-image " + kQuads), "no PNG image");
  expect_refused(folder.limn(knob + "e.png --texture-image a.png --texture"), "--texture");
}

TEST(DrawCommand, RefusesBadInput) {
  const Folder folder;
  const auto refused = [&](const std::string& arguments, const std::string& part) {
    expect_refused(folder.limn("draw " + arguments), part);
  };

  refused("none.obj -s loop -o a.png", "none.obj");
  refused(kBracket + " -s loop -o a.txt", ".svg");
  refused(kBracket + " -s nosuch -o a.png", "nosuch");
  refused(kQuads + " -s loop -o a.png", "--triangulate");
  refused(kBracket + " -s loop --stripes --reflection-lines -o a.png", "--reflection-lines");
  refused(kBracket + " -s loop --elevation 91 -o a.png", "--elevation");
  refused(kBracket + " -s loop --lights 0 -o a.png", "--lights");
  refused(kBracket + " -s loop --reflection-lines --lights 10000 -o a.pdf", "shows at most");
  refused(kBracket + " -s loop --stripes --lights 10000 -o a.pdf", "shows at most");
  refused(kBracket + " -s loop -n 11 -o a.png", "draw 8 levels");
  EXPECT_EQ(folder.count(), 0);
}

TEST(RefineCommand, MovesPointsToTheLimitAndWritesNormals) {
  const Folder folder;
  const Outcome outcome =
      folder.limn("refine " + kBracket + " -s loop -n 1 --limit --normals -o a.obj");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::string moved = folder.read("a.obj");
  EXPECT_NE(moved.find("\nvn "), std::string::npos);
  EXPECT_EQ(folder.limn("refine " + kBracket + " -s loop -n 1 -o b.obj").code, 0);
  EXPECT_NE(moved.substr(0, 200), folder.read("b.obj").substr(0, 200));
  // interpolating: the control points are limit points
  EXPECT_EQ(folder.limn("refine " + kBracket + " -s butterfly-modified -n 1 --limit -o c.obj").code,
            0);
  EXPECT_EQ(folder.limn("refine " + kBracket + " -s butterfly-modified -n 1 -o d.obj").code, 0);
  EXPECT_EQ(folder.read("c.obj"), folder.read("d.obj"));
}

TEST(RefineCommand, WritesCurvaturesWhereTheyAreBounded) {
  const Folder folder;
  const Outcome outcome =
      folder.limn("refine " + kQuads + " -s catmull-clark -n 1 -o a.obj --curvatures k.json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto rows = nlohmann::json::parse(folder.read("k.json")).at("rows");
  int bounded = 0;
  for (const auto& row : rows) bounded += row[4].is_null() ? 0 : 1;
  EXPECT_GT(bounded, 0);
  EXPECT_LT(bounded, static_cast<int>(rows.size()));  // not at the boundary
  const Outcome refused =
      folder.limn("refine " + kQuads + " -s catmull-clark -n 1 -o b.obj --curvatures k.txt");
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find(".csv"), std::string::npos) << refused.err;
}

}  // namespace
}  // namespace limn::test
