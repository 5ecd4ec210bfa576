#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "run_command.h"
#include "support/sanitized.h"

namespace limn::test {
namespace {

nlohmann::json parsed(const Outcome& outcome) {
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  return nlohmann::json::parse(outcome.out);
}

TEST(ArtifactsCommand, GivesTheContractsJson) {
  const Folder folder;
  // θ = (.3π, .2π, -.5π): fx = .3, fy = (.2 + .15)/(√3/2)
  const nlohmann::json loop =
      parsed(folder.limn("artifacts loop --frequency 0.3,0.404145188432738 --json"));
  EXPECT_EQ(loop.at("scheme"), "loop");
  EXPECT_EQ(loop.at("stage"), "limit");
  EXPECT_NEAR(loop.at("signal"), .263106, 1e-6);
  ASSERT_EQ(loop.at("artifacts").size(), 3U);
  EXPECT_NEAR(loop.at("artifacts")[0], .017555, 1e-6);
  EXPECT_NEAR(loop.at("artifacts")[1], .050043, 1e-6);
  EXPECT_NEAR(loop.at("artifacts")[2], .002629, 1e-6);
  const double mean = std::sqrt((.017555 * .017555 + .050043 * .050043 + .002629 * .002629) / 3);
  EXPECT_NEAR(loop.at("mean_energy"), mean, 1e-6);
  EXPECT_NEAR(loop.at("percent_of_signal"), 100 * mean / .263106, 1e-3);
  EXPECT_GT(loop.at("total_energy_percent"), loop.at("percent_of_signal"));
  EXPECT_EQ(loop.at("frequency"), nlohmann::json::array({0.3, 0.404145188432738}));
}

TEST(ArtifactsCommand, TakesMagnitudesAfterStepsAndStages) {
  const Folder folder;
  const auto at = [&](const std::string& more) {
    return parsed(folder.limn("artifacts loop --frequency 0.1,-0.2 --json " + more));
  };
  const nlohmann::json one = at("--steps 1");
  EXPECT_EQ(one.at("stage"), 1);
  const nlohmann::json two_stages = at("--stages 2");  // which are all that Loop has
  EXPECT_EQ(two_stages.at("smoothing_stages"), 2);
  for (const char* key : {"signal", "mean_energy", "percent_of_signal", "total_energy_percent"})
    EXPECT_NEAR(one.at(key), two_stages.at(key), 1e-12) << key;
  EXPECT_NEAR(one.at("total_energy_percent"), std::sqrt(3.0) * double(one.at("percent_of_signal")),
              1e-9);
  EXPECT_NE(one.at("signal"), at("--steps 2").at("signal"));
}

TEST(ArtifactsCommand, HasTwoArtifactsForSqrt3AndParametersCount) {
  const Folder folder;
  EXPECT_EQ(parsed(folder.limn("artifacts sqrt3 -f .1,.1 --json")).at("artifacts").size(), 2U);
  EXPECT_EQ(parsed(folder.limn("artifacts four-eight -f .1,.1 --json")).at("artifacts").size(), 1U);
  const auto signal = [&](const std::string& b) {
    return double(parsed(folder.limn("artifacts laplacian-butterfly -f .2,.1 --json -p b=" + b))
                      .at("signal"));
  };
  EXPECT_EQ(signal("0"),
            double(parsed(folder.limn("artifacts butterfly -f .2,.1 --json")).at("signal")));
  EXPECT_LT(signal("3/16"), signal("1/8"));
}

TEST(ArtifactsCommand, SaysHowDenselyToSample) {
  const Folder folder;
  const nlohmann::json json =
      parsed(folder.limn("artifacts loop butterfly interpolating-loop --tolerance 1 --json"));
  ASSERT_EQ(json.at("schemes").size(), 3U);
  double coarser = 0;
  for (const auto& scheme : json.at("schemes")) {
    const auto& total = scheme.at("sampling").at("total_energy");
    EXPECT_GE(double(total.at("worst").at("edges_per_wavelength")),
              double(total.at("best").at("edges_per_wavelength")));
    EXPECT_GE(double(total.at("worst").at("edges_per_wavelength")), coarser - 1e-9);
    coarser = total.at("worst").at("edges_per_wavelength");
  }
  const Outcome text = folder.limn("artifacts loop butterfly");
  EXPECT_EQ(text.code, 0);
  EXPECT_NE(text.out.find("loop"), std::string::npos);
  EXPECT_NE(text.out.find("butterfly"), std::string::npos);
}

TEST(ArtifactsCommand, DrawsMapsAndWritesTheirNumbers) {
  const Folder folder;
  for (const char* name : {"m.pdf", "m.svg", "m.csv", "m.json"}) {
    const Outcome outcome = folder.limn(std::string("artifacts loop --map ") + name);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_GT(folder.read(name).size(), 1000U) << name;
  }
  EXPECT_EQ(folder.read("m.csv").substr(0, 6), "fx,fy,");
  const nlohmann::json table = nlohmann::json::parse(folder.read("m.json"));
  EXPECT_EQ(table.at("columns").size(), table.at("rows").at(0).size());
  const std::string once = folder.read("m.pdf");
  ASSERT_EQ(folder.limn("artifacts loop --map m.pdf").code, 0);
  EXPECT_EQ(folder.read("m.pdf"), once);
}

TEST(ArtifactsCommand, RefusesBadInputWithTheReason) {
  const Folder folder;
  expect_refused(folder.limn("artifacts loop -f a,b"), "'a,b' is not a frequency");
  expect_refused(folder.limn("artifacts loop -f nan,0"), "not a frequency");
  expect_refused(folder.limn("artifacts loop -f 0,inf"), "not a frequency");
  expect_refused(folder.limn("artifacts loop -f 1"), "two numbers");
  expect_refused(folder.limn("artifacts loop -f ''"), "two numbers");
  expect_refused(folder.limn("artifacts loop --map ''"), "");
  expect_refused(folder.limn("artifacts loop -f 1,2,3"), "not a frequency");
  expect_refused(folder.limn("artifacts loop -f 1e300,0"), "beyond");
  expect_refused(folder.limn("artifacts loop -f 0,0 --steps 0"), "--steps");
  expect_refused(folder.limn("artifacts loop -f 0,0 --steps 2 --stages 1"), "--stages");
  expect_refused(folder.limn("artifacts loop --steps 2"), "--frequency or --map is missing");
  for (const char* tolerance : {"0", "-1", "nan", "101", "1e-9", "abc", "", "1,5"})
    expect_refused(folder.limn("artifacts loop --tolerance '" + std::string(tolerance) + "'"),
                   "tolerance");
  expect_refused(folder.limn("artifacts nosuch -f 0,0"), "nosuch");
  expect_refused(folder.limn("artifacts loop --map m.tiff"), ".pdf");
  expect_refused(folder.limn("artifacts loop --map /nosuch/m.pdf"), "/nosuch/");
  expect_refused(folder.limn("artifacts loop butterfly --map m.pdf"), "one scheme");
  EXPECT_EQ(folder.count(), 0);
  folder.write("skew.toml",
               "split = \"triangle-dyadic\"\n[mask]\nscale = \"1/2\"\nrows = [ [1, 1], [1, 2, 1], "
               "[0, 2] ]\n");
  expect_refused(folder.limn("artifacts skew.toml -f 0,0"), "skew.toml");
}

TEST(ArtifactsCommand, RefusesMasksThatAreTooWideBeforeTheWork) {
  LIMN_SKIP_IF_SANITIZED();
  const Folder folder;
  folder.write(
      "wide.toml",
      "split = \"sqrt3\"\n[factors]\nstages = 4\ndirections = [ { step = [1, 0], count = 6 "
      "}, { step = [0, 1], count = 6 } ]\n");
  // 1 GB of addresses, where the whole matrices would take 6
  expect_refused(folder.limn("artifacts wide.toml -f 0.1,0.1", "ulimit -v 1000000;"),
                 {"too wide", "1450"});
  EXPECT_EQ(folder.limn("artifacts wide.toml -f 0.1,0.1 --steps 1", "ulimit -v 1000000;").code, 0);
}

TEST(ArtifactsCommand, RefusesASchemeWithoutLimitButShowsItsSteps) {
  const Folder folder;
  const std::string scheme = "artifacts laplacian-loop -p a=1 -f .1,.1 --json ";
  const Outcome limit = folder.limn(scheme);
  if (limit.code == 0) GTEST_SKIP() << "it converges";
  expect_refused(limit, "limit");
  EXPECT_EQ(folder.limn(scheme + "--steps 2").code, 0);
}

}  // namespace
}  // namespace limn::test
