#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>

#include "limn/scheme/lattice_schemes.h"
#include "run_command.h"

namespace limn::test {
namespace {

using Json = nlohmann::json;

const std::string kBracket = LIMN_EXAMPLES "/bracket.obj";
const std::string kQuads = LIMN_EXAMPLES "/bracket-quads.obj";

Json compared(const Folder& folder, const std::string& arguments) {
  const Outcome outcome = folder.limn("compare --json " + arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return Json::parse(outcome.out);
}

/// The same values in swapped columns, to the last digit.
TEST(CompareCommand, IsSymmetric) {
  const Folder folder;
  const std::string rest = " --mesh " + kBracket + " -n 2 --valence 3..7 --budget 50";
  const std::string one = "loop", other = "laplacian-butterfly:b=3/16";
  const Json forth = compared(folder, one + " " + other + rest);
  Json back = compared(folder, other + " " + one + rest);
  ASSERT_EQ(forth.at("schemes").size(), 2U);
  EXPECT_EQ(forth.at("schemes")[0].at("scheme"), "loop");
  EXPECT_EQ(forth.at("schemes")[1].at("scheme"), "laplacian-butterfly b=3/16");
  EXPECT_EQ(forth.at("schemes")[0], back.at("schemes")[1]);
  EXPECT_EQ(forth.at("schemes")[1], back.at("schemes")[0]);
  ASSERT_EQ(forth.at("distances").size(), 1U);
  Json distance = back.at("distances")[0];
  std::swap(distance.at("a"), distance.at("b"));
  std::swap(distance.at("at")[0], distance.at("at")[1]);
  EXPECT_EQ(forth.at("distances")[0], distance);
  EXPECT_GT(distance.at("largest"), distance.at("mean"));
  EXPECT_GT(distance.at("mean"), 0);
}

TEST(CompareCommand, GivesTheWholeRecord) {
  const Folder folder;
  const Json json = compared(folder, "loop doo-sabin --valence 5");
  EXPECT_TRUE(json.at("mesh").is_null());
  EXPECT_TRUE(json.at("distances").empty());
  const Json& loop = json.at("schemes")[0];
  EXPECT_EQ(loop.at("split"), "triangle-dyadic");
  EXPECT_EQ(loop.at("interpolating"), false);
  EXPECT_LE(loop.at("regularity").at("holder").at("lower"), 3);
  EXPECT_GE(loop.at("regularity").at("holder").at("upper"), 3);
  EXPECT_EQ(loop.at("regularity").at("c2"), "yes");
  EXPECT_EQ(json.at("schemes")[1].at("regularity").at("c1"), "yes");  // biquadratic splines
  EXPECT_EQ(json.at("schemes")[1].at("regularity").at("c2"), "no");
  EXPECT_EQ(loop.at("regularity").at("sum_rules"), 4);
  EXPECT_EQ(loop.at("regularity").at("reproduction"), 1);
  EXPECT_EQ(loop.at("valences").size(), 1U);
  EXPECT_NEAR(loop.at("valences")[0].at("components").at("tangent"), .452254, 1e-6);
  EXPECT_EQ(loop.at("artifacts")[0].at("edges_per_wavelength"), 8);
  EXPECT_NEAR(loop.at("sampling").at("total_energy").at("worst").at("edges_per_wavelength"), 3.61,
              .01);
  EXPECT_EQ(json.at("schemes")[1].at("split"), "quad-dual");
  const Outcome text = folder.limn("compare loop doo-sabin --valence 5 --differences");
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_NE(text.out.find("quad-dual"), std::string::npos);
  EXPECT_EQ(text.out.find("interpolating"), std::string::npos);  // neither is
}

TEST(CompareCommand, ComparesDifferentSplitsInAllButWhatTheMeshRefuses) {
  const Folder folder;
  const Json json = compared(folder, "loop catmull-clark --valence 4 -n 1 --mesh " + kQuads);
  EXPECT_TRUE(json.at("schemes")[0].at("fairness").is_null());
  EXPECT_TRUE(json.at("schemes")[1].at("fairness").is_object());
  EXPECT_TRUE(json.at("distances").empty());
  EXPECT_EQ(json.at("missing").size(), 1U);
}

TEST(CompareCommand, DrawsTheSurfacesOverlaid) {
  const Folder folder;
  const Outcome outcome = folder.limn("compare loop laplacian-loop-low --valence 6 --mesh " +
                                      kBracket + " -n 2 -o both.svg");
  if (outcome.code == 2 && outcome.err.find("Embree") != std::string::npos) GTEST_SKIP();
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(folder.read("both.svg").find("<image"), std::string::npos);
  EXPECT_NE(outcome.out.find("loop – laplacian-loop-low: largest"), std::string::npos);
}

/// All shipped schemes and one's own, a line for each lattice.
TEST(CompareCommand, MapsTheField) {
  const Folder folder;
  const Outcome names = folder.limn("schemes --json");
  std::size_t lines = 0;
  const Json list = Json::parse(names.out);
  for (const Json& one : list.at("schemes"))
    lines += scheme::lattice_schemes(find_scheme(one.at("name")).value()).size();
  const Outcome outcome =
      folder.limn("compare --all loop-type:b=2/5 --markdown --time 0.1 --valence 4 -o field.svg");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'),
            static_cast<std::ptrdiff_t>(lines + 3));
  EXPECT_NE(outcome.out.find("| loop-type b=2/5 | triangle-dyadic |"), std::string::npos);
  EXPECT_NE(folder.read("field.svg").find("<svg"), std::string::npos);
}

TEST(CompareCommand, RefusesBadInput) {
  const Folder folder;
  const auto refused = [&](const std::string& arguments, const std::string& part) {
    expect_refused(folder.limn("compare " + arguments), part);
  };

  refused("loop", "name two or more");
  refused("loop nosuch", "nosuch");
  refused("loop loop", "twice");
  refused("loop butterfly --valence 2", "2 is not between 3 and");
  refused("loop butterfly --tolerance 0", "--tolerance");
  refused("loop butterfly --tolerance nan", "--tolerance");
  refused("loop butterfly --budget 0", "--budget");
  refused("loop butterfly --mesh none.obj", "none.obj");
  refused("loop butterfly -o a.png", "--mesh");
  refused("loop butterfly -n 2", "--mesh");
  refused("", "--all");
  refused("--all --differences", "--differences");
  refused("--all --mesh " + kBracket, "--mesh");
  refused("loop butterfly --markdown", "--all");
  refused("--all -p a=1", "a");
  refused("loop butterfly --mesh " + kBracket + " -o a.txt", ".svg");
  refused("loop butterfly --mesh " + kQuads + " -o a.png", "no two limit surfaces");
  EXPECT_EQ(folder.count(), 0);
}

}  // namespace
}  // namespace limn::test
