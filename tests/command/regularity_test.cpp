#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run_command.h"

namespace limn::test {
namespace {

TEST(RegularityCommand, GivesTheContractsJson) {
  const Folder folder;
  const Outcome outcome = folder.limn("regularity loop --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const nlohmann::json loop = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(loop.at("scheme"), "loop");
  EXPECT_EQ(loop.at("holder").at("lower"), 3);
  EXPECT_EQ(loop.at("holder").at("upper"), 3);
  EXPECT_EQ(loop.at("c1"), "yes");
  EXPECT_EQ(loop.at("c2"), "yes");
  EXPECT_EQ(loop.at("sum_rules"), 4);
  EXPECT_EQ(loop.at("joint_spectral_radius").at("eigenvalue"), "1/8");
  EXPECT_LT(loop.at("proofs").at("c2").at("norm"), 1);
}

TEST(RegularityCommand, SaysInWordsWhatIsProved) {
  const Folder folder;
  const Outcome butterfly = folder.limn("regularity butterfly");
  ASSERT_EQ(butterfly.code, 0) << butterfly.err;
  EXPECT_NE(butterfly.out.find("C1  yes"), std::string::npos);
  EXPECT_NE(butterfly.out.find("C2  no"), std::string::npos);
  EXPECT_NE(butterfly.out.find(", 2]"), std::string::npos);
  const Outcome unstable = folder.limn("regularity box-spline-quad -p p=2 -p q=2 --json");
  ASSERT_EQ(unstable.code, 0) << unstable.err;
  EXPECT_TRUE(nlohmann::json::parse(unstable.out).at("holder").at("upper").is_null());
}

TEST(RegularityCommand, TakesParametersBudgetAndTolerance) {
  const Folder folder;
  const auto lower = [&](const std::string& more) {
    const Outcome outcome = folder.limn("regularity optimal --json " + more);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return double(nlohmann::json::parse(outcome.out).at("holder").at("lower"));
  };
  EXPECT_LT(lower("--budget 50"), lower("--tolerance 0.05"));
  EXPECT_LT(lower("--tolerance 0.05"), lower(""));
}

TEST(RegularityCommand, RefusesBadInputWithTheReason) {
  const Folder folder;
  expect_refused(folder.limn("regularity nosuch"), "nosuch");
  expect_refused(folder.limn("regularity"), "SCHEME");
  expect_refused(folder.limn("regularity loop --budget 0"), "--budget");
  expect_refused(folder.limn("regularity loop --tolerance x"), "--tolerance");
  expect_refused(folder.limn("regularity loop -p nosuch=1"), "nosuch");
}

}  // namespace
}  // namespace limn::test
