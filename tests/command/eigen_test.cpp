#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "run_command.h"
#include "support/sanitized.h"

namespace limn::test {
namespace {

TEST(EigenCommand, DrawsManyMapsInBoundedMemoryOrRefusesThemBeforeTheWork) {
  LIMN_SKIP_IF_SANITIZED();
  const Folder folder;
  if (folder.limn("eigen loop --valence 3 --map m.pdf").code != 0) GTEST_SKIP() << "no figures";
  // 1.2 GB where every map kept all its faces
  EXPECT_EQ(folder.limn("eigen loop --valence 3..45 --map m.pdf", "ulimit -v 700000;").code, 0);
  expect_refused(folder.limn("eigen loop --valence 3..200 --map many.pdf"),
                 {"--map", "3..200", "fewer valences"});
  EXPECT_EQ(folder.count(), 1);
}

TEST(EigenCommand, GivesTheContractsJson) {
  const Folder folder;
  const Outcome outcome = folder.limn("eigen loop --valence 3..7 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("scheme"), "loop");
  ASSERT_EQ(json.at("valences").size(), 5U);
  const nlohmann::json& three = json.at("valences")[0];
  EXPECT_EQ(three.at("valence"), 3);
  EXPECT_TRUE(three.at("components").at("saddle").is_null());
  EXPECT_TRUE(three.at("verdict").at("saddle").is_null());
  EXPECT_EQ(three.at("verdict").at("bounded_curvature"), "no");
  const nlohmann::json& seven = json.at("valences")[4];
  EXPECT_NEAR(seven.at("components").at("tangent"), .530872, 1e-6);
  EXPECT_NEAR(seven.at("components").at("saddle"), .319370, 1e-6);
  ASSERT_EQ(seven.at("blocks").size(), 4U);
  const nlohmann::json& constant = seven.at("blocks")[0];
  EXPECT_EQ(constant.at("frequency"), 0);
  EXPECT_NEAR(constant.at("eigenvalues")[0].at("value")[0], 1, 1e-14);
  EXPECT_EQ(constant.at("matrix").size(), 4U);
  EXPECT_EQ(seven.at("verdict").at("c1_necessary"), "yes");
  EXPECT_EQ(seven.at("verdict").at("saddle"), "unbounded");
  EXPECT_FALSE(seven.at("verdict").at("reasons").empty());
}

TEST(EigenCommand, TakesTheRegularSurfaceIntoBoundedCurvature) {
  const Folder folder;
  const auto valences = [&](const std::string& arguments) {
    const Outcome outcome = folder.limn("eigen " + arguments + " --json");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out);
  };
  const nlohmann::json low = valences("laplacian-loop -p a=-1/8 --valence 3..8");
  EXPECT_EQ(low.at("regular_part").at("bounded"), "no");
  for (const nlohmann::json& one : low.at("valences")) {
    EXPECT_EQ(one.at("verdict").at("bounded_curvature"), "no");
    EXPECT_NE(one.at("verdict").at("reasons").dump().find("regular surface"), std::string::npos);
  }
  const nlohmann::json loop = valences("loop --valence 3..6");
  EXPECT_EQ(loop.at("regular_part").at("bounded"), "yes");
  for (const nlohmann::json& one : loop.at("valences"))
    EXPECT_EQ(one.at("verdict").at("bounded_curvature"), one.at("valence") == 3 ? "no" : "yes");
  const Outcome compared = folder.limn("compare laplacian-loop:a=-1/8 loop --valence 4..6");
  EXPECT_NE(compared.out.find("curvature is bounded, if C1         none "), std::string::npos)
      << compared.out;
}

TEST(EigenCommand, GivesVectorsAndStencils) {
  const Folder folder;
  const Outcome outcome = folder.limn("eigen catmull-clark --valence 5 --vectors --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json five = nlohmann::json::parse(outcome.out).at("valences")[0];
  EXPECT_EQ(five.at("orbits").size(), 6U);
  const nlohmann::json& stencil = five.at("spatial").at("position").at("left")[0];
  ASSERT_EQ(stencil.size(), 31U);
  EXPECT_NEAR(stencil[0], 5 / 10., 1e-14);  // n/(n+5), 4/(n(n+5)), 1/(n(n+5))
  EXPECT_NEAR(stencil[1], 4 / 50., 1e-14);
  EXPECT_NEAR(stencil[2], 1 / 50., 1e-14);
  EXPECT_EQ(five.at("spatial").at("tangent").at("left").size(), 2U);
  for (const nlohmann::json& block : five.at("blocks")) EXPECT_FALSE(block.at("vectors").empty());
  const Outcome text = folder.limn("eigen loop --valence 5 --vectors");
  EXPECT_EQ(text.code, 0);
  EXPECT_NE(text.out.find("stencil"), std::string::npos);
}

TEST(EigenCommand, DrawsCharacteristicMaps) {
  const Folder folder;
  const Outcome outcome = folder.limn("eigen sqrt3 --valence 3..5 --json --map maps.svg");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(folder.read("maps.svg").substr(0, 5), "<?xml");
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("valences")[1].at("characteristic_map").at("regular"), "yes");
  const Outcome refused = folder.limn("eigen sqrt3 --map maps.txt");
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find(".svg"), std::string::npos) << refused.err;
}

TEST(EigenCommand, TakesTheFacesRoundAVertex) {
  const Folder folder;
  const Outcome outcome = folder.limn("eigen quad-triangle --faces 3,3,3,4,4 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("faces"), (nlohmann::json{3, 3, 3, 4, 4}));
  EXPECT_EQ(json.at("matrix").size(), json.at("eigenvalues").size());
  EXPECT_NEAR(json.at("eigenvalues")[0].at("value")[0], 1, 1e-12);
  for (const std::size_t i : {1U, 2U})
    EXPECT_NEAR(json.at("eigenvalues")[i].at("modulus"), .5, 1e-12);
  EXPECT_NEAR(json.at("tangent")[0], .5, 1e-12);
  EXPECT_EQ(json.at("verdict").at("convergent"), "yes");
  EXPECT_EQ(json.at("verdict").at("c1_necessary"), "yes");
  const Outcome text = folder.limn("eigen quad-triangle --faces 3,3,4,3,4");
  EXPECT_NE(text.out.find("C1: necessary   yes"), std::string::npos) << text.out;
  EXPECT_EQ(folder.limn("eigen loop --faces 3,3,3,3,3").code, 0);
  expect_refused(folder.limn("eigen loop --faces 3,3,4"), {"--faces", "triangles alone"});
  expect_refused(folder.limn("eigen sqrt3 --faces 3,3,3"), {"--faces", "sqrt3"});
  for (const char* list : {"3", "3,3", "3,3,5", "3;3;3", "3,,3", "3,3,3,", "x"})
    expect_refused(folder.limn("eigen quad-triangle --faces '" + std::string(list) + "'"),
                   {"--faces", "no list of faces"});
}

TEST(EigenCommand, RefusesBadValencesAndSchemes) {
  const Folder folder;
  const auto refused = [&](const std::string& arguments, const std::string& part) {
    expect_refused(folder.limn("eigen " + arguments), part);
  };

  refused("loop --valence 1", "1 is not between 2 and");
  refused("doo-sabin --valence 2", "the number of a face's corners");
  refused("butterfly-modified --valence 2", "not 1, at valence 2");
  refused("loop --valence 7..3", "the range 7..3 is empty");
  for (const char* text : {"''", "x", "3..", "..7", "3...7", "3.5", "99999999999", "-4"})
    refused("loop --valence=" + std::string(text), "--valence");
  refused("loop --rings 99", "--rings");
  refused("butterfly --rings 1", "more rings");
  refused("box-spline-triangle --valence 7", "no vertex rule at n = 7");
  refused("nosuch", "nosuch");
}

bool without_flint(const Outcome& outcome) {
  return outcome.code == 2 && outcome.err.find("without FLINT") != std::string::npos;
}

TEST(EigenCommand, PrintsFormulas) {
  const Folder folder;
  const Outcome outcome = folder.limn("eigen sqrt3 --formulas");
  if (without_flint(outcome)) GTEST_SKIP() << outcome.err;
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* line :
       {"n ≥ 3\n", "omega = 0     ring 1  1\n", "ring 1  2/3 - alpha = 4/9*cos(pi/n)^2\n",
        "omega ≥ 1     ring 1  2/3*cos(pi*omega/n)\n", "ring 2  (1 + sqrt(7))/18\n",
        "(c + sqrt(c^2 + 6))/18  with c = cos(pi*omega/n)\n"})
    EXPECT_NE(outcome.out.find(line), std::string::npos) << line << "in\n" << outcome.out;
  const Outcome latex = folder.limn("eigen loop --formulas --latex");
  EXPECT_NE(latex.out.find("\\frac{5}{8} - n \\beta = \\left("), std::string::npos) << latex.out;
  const Outcome butterfly = folder.limn("eigen butterfly --formulas");
  EXPECT_NE(butterfly.out.find("no closed form"), std::string::npos);
}

TEST(EigenCommand, GivesFormulasAsJson) {
  const Folder folder;
  const Outcome outcome = folder.limn("eigen butterfly-modified --formulas --json");
  if (without_flint(outcome)) GTEST_SKIP() << outcome.err;
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  bool general = false;
  for (const nlohmann::json& one : json.at("formulas")) {
    EXPECT_GE(one.at("eigenvalues").size(), 5U);
    if (one.at("valences") != "n = 5, n ≥ 7" || one.at("frequency") != 1) continue;
    general = true;
    EXPECT_EQ(one.at("spans"), nlohmann::json::parse("[[5, 5], [7, null]]"));
    EXPECT_EQ(one.at("eigenvalues")[0].at("text"), "1/2");
    EXPECT_EQ(one.at("eigenvalues")[0].at("latex"), "\\frac{1}{2}");
    EXPECT_TRUE(one.at("left").empty());
  }
  EXPECT_TRUE(general);
}

TEST(EigenCommand, PutsGivenParametersIntoFormulas) {
  const Folder folder;
  const Outcome outcome = folder.limn("eigen laplacian-loop --formulas -p a=1/8");
  if (without_flint(outcome)) GTEST_SKIP() << outcome.err;
  EXPECT_NE(outcome.out.find("3/4 - n*beta = "), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("a_6"), std::string::npos) << outcome.out;
  EXPECT_EQ(folder.limn("eigen loop --latex").code, 2);
  EXPECT_EQ(folder.limn("eigen loop --formulas --valence 7").code, 2);
}

}  // namespace
}  // namespace limn::test
