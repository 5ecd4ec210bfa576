#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run_command.h"

namespace limn::test {
namespace {

const std::string kBracket = "'" LIMN_EXAMPLES "/bracket.obj'";
const std::string kQuads = "'" LIMN_EXAMPLES "/bracket-quads.obj'";

nlohmann::json parsed(const Outcome& outcome) {
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  return nlohmann::json::parse(outcome.out);
}

TEST(FairnessCommand, GivesTheContractsJson) {
  const Folder folder;
  const nlohmann::json json = parsed(
      folder.limn("fairness " + kBracket + " -s loop -s laplacian-butterfly:b=1/8 -n 2 --json"));
  EXPECT_NE(std::string(json.at("mesh")).find("bracket.obj"), std::string::npos);
  ASSERT_EQ(json.at("schemes").size(), 2U);
  EXPECT_EQ(json.at("schemes")[0].at("scheme"), "loop");
  EXPECT_EQ(json.at("schemes")[1].at("scheme"), "laplacian-butterfly b=1/8");
  for (const auto& scheme : json.at("schemes")) {
    for (const char* key : {"laplacian_energy", "thin_plate", "curvature_variation", "area"}) {
      EXPECT_GT(double(scheme.at(key)), 0) << key;
      EXPECT_EQ(scheme.at(key), scheme.at("levels")[1].at(key));
    }
    EXPECT_EQ(scheme.at("levels").size(), 2U);
    EXPECT_EQ(scheme.at("trends").at("thin_plate").at("converges"), "undecided");
  }
  EXPECT_EQ(json.at("fairest").at("thin_plate"), "loop");
}

TEST(FairnessCommand, PrintsTablesAndDrawsCharts) {
  const Folder folder;
  const Outcome text =
      folder.limn("fairness " + kQuads + " -s catmull-clark -s doo-sabin -n 3 --chart c.svg");
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_NE(text.out.find("tends to"), std::string::npos);
  EXPECT_NE(text.out.find("* fairest"), std::string::npos);
  if (text.code == 0) EXPECT_GT(folder.read("c.svg").size(), 1000U);
}

TEST(FairnessCommand, ShowsTheSpectrumOfTheControlMesh) {
  const Folder folder;
  folder.write("t.off",
               "OFF\n4 4 6\n1 1 1\n-1 -1 1\n-1 1 -1\n1 -1 -1\n"
               "3 0 1 3\n3 2 1 0\n3 0 3 2\n3 1 2 3\n");
  const nlohmann::json json =
      parsed(folder.limn("fairness t.off -s loop -n 1 --spectrum 3 --json"));
  const auto& spectrum = json.at("spectrum");
  EXPECT_NEAR(spectrum.at("smallest")[0], 0, 1e-12);
  for (const auto& value : spectrum.at("largest")) EXPECT_NEAR(value, 4.0 / 3, 1e-12);
  const Outcome drawn = folder.limn("fairness " + kBracket + " -s loop -n 1 --spectrum s.pdf");
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_GT(folder.read("s.pdf").size(), 1000U);
}

TEST(FairnessCommand, TellsSchemesApart) {
  const Folder folder;
  folder.write("two.toml",
               "extends = \"butterfly\"\n[parameter.q]\ndefault = \"0\"\nmeaning = \"none\"\n");
  const auto labels = [&](const std::string& schemes) {
    std::vector<std::string> found;
    const nlohmann::json json =
        parsed(folder.limn("fairness " + kBracket + " -n 1 --json " + schemes));
    for (const auto& scheme : json.at("schemes")) found.push_back(scheme.at("scheme"));
    return found;
  };
  using List = std::vector<std::string>;
  EXPECT_EQ(labels("-s laplacian-butterfly -s laplacian-butterfly:b=3/16"),
            (List{"laplacian-butterfly", "laplacian-butterfly b=3/16"}));
  EXPECT_EQ(labels("-s laplacian-loop -p a=1/16"), (List{"laplacian-loop a=1/16"}));
  EXPECT_EQ(labels("-s two.toml:w=1/20,q=2"), (List{"two w=1/20 q=2"}));
  // a file of a shipped scheme's name, and one with a colon in its name
  folder.write("loop.toml", "extends = \"butterfly\"\n");
  folder.write("a:b.toml", "extends = \"butterfly\"\nname = \"mine\"\n");
  EXPECT_EQ(labels("-s loop -s loop.toml"), (List{"loop", "loop.toml"}));
  EXPECT_EQ(labels("-s a:b.toml -s a:b.toml:w=1/20"), (List{"mine", "mine w=1/20"}));
}

TEST(FairnessCommand, RefusesBadInput) {
  const Folder folder;
  const auto refused = [&](const std::string& arguments, const std::string& part) {
    expect_refused(folder.limn("fairness " + arguments), part);
  };
  refused("none.obj -s loop", "none.obj");
  refused(kBracket, "--scheme");
  refused(kBracket + " -s nosuch", "nosuch");
  refused(kBracket + " -s loop: -n 1", "after the colon");
  refused(kBracket + " -s loop:q=1 -n 1", "q");
  refused(kBracket + " -s laplacian-loop:a -n 1", "a");
  refused(kBracket + " -s laplacian-loop:a=0.5 -n 1", "0.5");
  refused(kBracket + " -s nosuch:a=1 -n 1", "nosuch");
  refused(kBracket + " -s loop -s loop", "twice");
  refused(kQuads + " -s loop", "--triangulate");
  refused(kBracket + " -s loop -n 0", "--levels");
  refused(kBracket + " -s loop -n 64", "level");
  refused(kBracket + " -s loop --chart c.txt", ".svg");
  refused(kBracket + " -s loop --spectrum c.txt", "--spectrum");
  refused(kBracket + " -s loop --spectrum 0", "--spectrum");
  refused(kBracket + " -s loop --spectrum 99999", "--spectrum");
  EXPECT_EQ(folder.count(), 0);
}

}  // namespace
}  // namespace limn::test
