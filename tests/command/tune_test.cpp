#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "run_command.h"

namespace limn::test {
namespace {

TEST(TuneCommand, GivesTheContractsJson) {
  const Folder folder;
  const Outcome outcome =
      folder.limn("tune sqrt3 --free alpha --require 'cup = tangent^2' --valence 3..5 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("scheme"), "sqrt3");
  EXPECT_EQ(json.at("free"), "alpha");
  EXPECT_EQ(json.at("require"), "cup = tangent^2");
  ASSERT_EQ(json.at("valences").size(), 3U);
  const nlohmann::json& three = json.at("valences")[0].at("solutions")[0];
  EXPECT_EQ(three.at("exact"), "5/9");
  EXPECT_EQ(three.at("holds"), false);
  EXPECT_NE(three.at("reason").get<std::string>().find("ring 2"), std::string::npos);
  const nlohmann::json& five = json.at("valences")[2].at("solutions")[0];
  EXPECT_NEAR(five.at("value"), (4 - 2 * std::cos(2 * M_PI / 5)) / 9, 1e-15);
  EXPECT_EQ(five.at("holds"), true);
  EXPECT_TRUE(five.at("exact").is_null());
  EXPECT_LT(five.at("residual"), 1e-14);
}

TEST(TuneCommand, GivesRanges) {
  const Folder folder;
  const std::string arguments = "tune laplacian-loop --free a --require c1 --valence 3..4 --range";
  const Outcome text = folder.limn(arguments);
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_NE(text.out.find("all  a between -0.3125 = -5/16 and 0.1875 = 3/16"), std::string::npos)
      << text.out;
  const nlohmann::json json = nlohmann::json::parse(folder.limn(arguments + " --json").out);
  const nlohmann::json& part = json.at("valences")[1].at("parts")[0];
  EXPECT_NEAR(part.at("high").at("value"), 15 / 64., 1e-14);
  EXPECT_EQ(part.at("high").at("exact"), "15/64");
  EXPECT_NEAR(json.at("common")[0][0], -5 / 16., 1e-14);
}

TEST(TuneCommand, TellsOfValencesWithoutASaddle) {
  const Folder folder;
  const std::string arguments = "tune loop --free beta --require 'cup = saddle' --valence ";
  const Outcome some = folder.limn(arguments + "3..5");
  EXPECT_EQ(some.code, 0);
  EXPECT_NE(some.out.find("there is no saddle at valence 3"), std::string::npos) << some.out;
  const Outcome none = folder.limn(arguments + "3");
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.err.find("there is no saddle at valence 3"), std::string::npos) << none.err;
}

TEST(TuneCommand, WritesASchemeThatExtendsAnother) {
  const Folder folder;
  const Outcome first = folder.limn(
      "tune loop --free beta --require 'cup = tangent^2/2' --valence 7..8 -o first.toml");
  ASSERT_EQ(first.code, 0) << first.err;
  // beside a file that extends a shipped scheme, one that extends that file, -p and all
  const Outcome second = folder.limn(
      "tune first.toml --free beta --require 'cup = 3*tangent^2/4' --valence 9 -o second.toml");
  ASSERT_EQ(second.code, 0) << second.err;
  const Outcome outcome = folder.limn("eigen second.toml --valence 7..9 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json json = nlohmann::json::parse(outcome.out).at("valences");
  for (int i = 0; i < 3; ++i) {
    const nlohmann::json& components = json[static_cast<std::size_t>(i)].at("components");
    const double tangent = components.at("tangent");
    EXPECT_NEAR(components.at("cup"), tangent * tangent * (i < 2 ? 0.5 : 0.75), 1e-14);
  }
}

TEST(TuneCommand, KeepsWhatOptionsSet) {
  const Folder folder;
  const Outcome outcome = folder.limn(
      "tune laplacian-loop -p a=n/100 --free beta --require 'cup = tangent^2' --valence 5 -o "
      "a.toml");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Outcome eigen = folder.limn("eigen a.toml --valence 5 --json");
  const nlohmann::json json = nlohmann::json::parse(eigen.out).at("valences")[0].at("components");
  EXPECT_NEAR(json.at("cup"), std::pow(json.at("tangent").get<double>(), 2), 1e-14);
}

TEST(TuneCommand, ExitsWith3WhereRoundingHidesAnAnswer) {
  const Folder folder;
  // the butterfly at an irrational value of g, where the cup is defective
  folder.write("hidden.toml",
               "split = \"triangle-dyadic\"\nextends = \"butterfly\"\n[let]\ns = \"g*sqrt(2)\"\n"
               "[parameter.g]\ndefault = \"1/32\"\nrange = [\"0\", \"1/8\"]\n"
               "[edge]\nend = \"1/2\"\nwing = \"2*s\"\nouter = \"-s\"\n");
  const Outcome outcome =
      folder.limn("tune hidden.toml --free g --require 'cup = tangent^2' --valence 6 --json");
  EXPECT_EQ(outcome.code, 3) << outcome.err;
  const nlohmann::json json = nlohmann::json::parse(outcome.out);
  const nlohmann::json& solution = json.at("valences")[0].at("solutions")[0];
  EXPECT_TRUE(solution.at("holds").is_null());
  EXPECT_NEAR(solution.at("value"), std::sqrt(2) / 32, 1e-7);
  EXPECT_NE(solution.at("reason").get<std::string>().find("rounding hides it"), std::string::npos);
}

TEST(TuneCommand, RefusesWhatItCannotSolve) {
  const Folder folder;
  const auto refused = [&](const std::string& arguments, const std::string& part) {
    expect_refused(folder.limn("tune " + arguments), part);
  };

  const std::string loop = "loop --free beta ";
  refused("catmull-clark --free a --require c1 --range", "nothing that can be freed");
  refused("loop --free gamma --require c1 --range", "can be freed: lambda, beta");
  refused(loop + "--require 'cup = tangnt'", "column 7: unknown name 'tangnt'");
  refused(loop + "--require c1", "add --range");
  refused(loop + "--require 'cup = 1/4' --range", "leave out --range");
  refused(loop + "--require 'cup = 1/4' --between 1,0", "is empty at n = 3");
  refused(loop + "--require 'cup = 1/4' --between 1", "no comma");
  refused(loop + "--require 'cup = 1/4' --require 'saddle = 1/4'", "2 equations are more than 1");
  refused(loop + "--free beta --require 'cup = 1/4'", "freed twice");
  refused(loop + "--free lambda --require c1 --require convergent",
          "no requirement is an equation");
  refused(loop + "--free lambda --require 'cup = 1/4' --range", "leave it out");
  refused(loop + "--free lambda --require 'cup = 1/4' --between 0,1", "once for each --free");
  refused(loop + "--require 'cup = 1/4' --between 0,1 --between 0,1", "more than once");
  refused(loop + "--require 'cup = 1/4' --valence 2", "2 is not between 3 and");
  refused("butterfly --free w --require 'cup = 1/4' --valence 5..6 --time 0 -o x.toml",
          "one number");
  refused(loop + "--require c1 --range -o x.toml", "not ranges");
  refused(loop + "--require 'cup = 1/5' --valence 5 -o no/x.toml", "cannot write");
  refused(loop + "--require 'cup = 1/(n - n)'", "requirement 'cup = 1/(n - n)': division by zero");
  refused(loop, "--require");
  refused("loop --require c1", "--free");
  refused("box-spline-triangle --free i --require c1 --range", "nothing that can be freed");
}

TEST(TuneCommand, SolvesForSeveralNames) {
  const Folder folder;
  const Outcome outcome = folder.limn(
      "tune loop-type --free b --free beta --require 'tangent = 11/20' --require 'cup = 1/4' "
      "--require c1 --valence 7 -o two.toml --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  const auto& found = json.at("valences")[0].at("solutions");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].at("holds"), true);
  const Outcome eigen = folder.limn("eigen two.toml --valence 7 --json");
  ASSERT_EQ(eigen.code, 0) << eigen.err;
  const auto components = nlohmann::json::parse(eigen.out).at("valences")[0].at("components");
  EXPECT_NEAR(components.at("tangent").get<double>(), 11.0 / 20, 1e-13);
  EXPECT_NEAR(components.at("cup").get<double>(), 1.0 / 4, 1e-13);
}

TEST(TuneCommand, RecognisesAFormulaOfN) {
  const Folder folder;
  folder.write("two.toml",
               "split = \"triangle-dyadic\"\nextends = \"loop\"\n"
               "[let]\nring = \"1/(2*n)\"\n"
               "[vertex]\nself = \"1 - n*ring\"\nring = \"ring\"\n");
  const Outcome outcome = folder.limn(
      "tune two.toml --free ring --require 'cup = tangent^2' --require c1 "
      "--valence 4..12 --time 0 -o t.toml");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("ring = (31/64 - 3/16*cos(2*pi/n) - 1/16*cos(2*pi/n)^2)/n"),
            std::string::npos)
      << outcome.out;
  const std::string text = folder.read("t.toml");
  EXPECT_NE(text.find("title   = \"two, tuned\""), std::string::npos) << text;
  EXPECT_NE(text.find("(n >= 4) * (n <= 5) + (n >= 7) * (n <= 12)"), std::string::npos) << text;
  EXPECT_NE(text.find("kept at n = 6"), std::string::npos) << text;
  EXPECT_EQ(folder.limn("show t.toml").code, 0);
}

}  // namespace
}  // namespace limn::test
