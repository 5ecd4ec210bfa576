#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "run_command.h"
#include "support/sanitized.h"

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
  EXPECT_EQ(loop.at("holder").at("exact"), "3");
  EXPECT_EQ(loop.at("holder").at("attained"), true);
  EXPECT_EQ(loop.at("holder").at("logarithm"), 0);
  EXPECT_EQ(loop.at("c1"), "yes");
  EXPECT_EQ(loop.at("c2"), "yes");
  EXPECT_EQ(loop.at("sum_rules"), 4);
  EXPECT_EQ(loop.at("joint_spectral_radius").at("eigenvalue"), "1/8");
  EXPECT_LT(loop.at("proofs").at("c2").at("norm"), 1);
}

TEST(RegularityCommand, SaysInWordsWhatIsProved) {
  const Folder folder;
  const Outcome butterfly = folder.limn("regularity butterfly --time 0");
  ASSERT_EQ(butterfly.code, 0) << butterfly.err;
  EXPECT_NE(butterfly.out.find("C1  yes"), std::string::npos);
  EXPECT_NE(butterfly.out.find("C2  no"), std::string::npos);
  EXPECT_NE(butterfly.out.find("\nHölder exponent 2 exactly, not attained: second differences grow "
                               "like |h|² log²(1/|h|)\n"),
            std::string::npos)
      << butterfly.out;
  const Outcome unstable = folder.limn("regularity box-spline-quad -p p=2 -p q=2 --json");
  ASSERT_EQ(unstable.code, 0) << unstable.err;
  EXPECT_TRUE(nlohmann::json::parse(unstable.out).at("holder").at("upper").is_null());
}

TEST(RegularityCommand, SaysWhetherTheExponentIsAttained) {
  const Folder folder;
  const auto holder = [&](const std::string& scheme) {
    return nlohmann::json::parse(folder.limn("regularity " + scheme + " --json --time 0").out)
        .at("holder");
  };
  const nlohmann::json butterfly = holder("butterfly");
  EXPECT_EQ(butterfly.at("exact"), "2");
  EXPECT_EQ(butterfly.at("attained"), false);
  EXPECT_EQ(butterfly.at("logarithm"), 2);
  EXPECT_EQ(butterfly.at("logarithm_sharp"), true);
  const nlohmann::json high = holder("optimal-high");
  EXPECT_EQ(high.at("exact"), "log2(3)");
  EXPECT_EQ(high.at("attained"), true);
  EXPECT_LT(high.at("lower"), high.at("upper"));
  const nlohmann::json bracket = holder("sqrt3");
  EXPECT_TRUE(bracket.at("exact").is_null());
  EXPECT_TRUE(bracket.at("attained").is_null());
  EXPECT_FALSE(std::string(bracket.at("attained_reason")).empty());
  const Outcome text = folder.limn("regularity optimal-high");
  EXPECT_NE(
      text.out.find("Hölder exponent log2(3) = 1.584963 exactly, attained: second differences "
                    "are at most a constant times |h|^log2(3)"),
      std::string::npos)
      << text.out;
}

TEST(RegularityCommand, TakesParametersBudgetAndTolerance) {
  const Folder folder;
  const auto lower = [&](const std::string& more) {
    const Outcome outcome = folder.limn("regularity optimal --json --time 0 " + more);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return double(nlohmann::json::parse(outcome.out).at("holder").at("lower"));
  };
  EXPECT_LT(lower("--budget 50"), lower("--tolerance 0.05"));
  EXPECT_LT(lower("--tolerance 0.05"), lower(""));
}

TEST(RegularityCommand, ListsAllDerivativesThatThereAre) {
  const Folder folder;
  const auto quintic =
      nlohmann::json::parse(folder.limn("regularity box-spline-quad -p i=6 -p j=6 --json").out);
  const nlohmann::json expected{"yes", "yes", "yes", "yes", "yes", "no"};
  EXPECT_EQ(quintic.at("smoothness"), expected);
  EXPECT_TRUE(quintic.at("proofs").contains("c4"));
  const Outcome text = folder.limn("regularity box-spline-quad -p i=6 -p j=6");
  EXPECT_NE(text.out.find("\nC4  yes"), std::string::npos) << text.out;
}

/// A mask of size × size weights without pattern, symmetric through its centre; each coset sums to
/// 1.
std::string generic_mask(int size) {
  std::vector<std::vector<int>> rows(static_cast<std::size_t>(size),
                                     std::vector<int>(static_cast<std::size_t>(size)));
  const auto at = [&](int i, int j) -> int& {
    return rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  };
  const int middle = size / 2;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) {
      const int a = std::min(i * size + j, size * size - 1 - i * size - j);
      at(i, j) = 1 + a * a * 7 % 23;
    }
  for (const int p : {0, 1})
    for (const int q : {0, 1}) {
      int sum = 0;
      for (int i = (middle + p) % 2; i < size; i += 2)
        for (int j = (middle + q) % 2; j < size; j += 2) sum += at(i, j);
      const int rest = 4000 - sum;  // split between the weights nearest to the centre
      for (const int di : p == 0 ? std::vector<int>{0} : std::vector<int>{-1, 1})
        for (const int dj : q == 0 ? std::vector<int>{0} : std::vector<int>{-1, 1})
          at(middle + di, middle + dj) += rest / ((1 + p) * (1 + q));
      at(middle + p, middle + q) += rest % ((1 + p) * (1 + q));
    }
  std::string text = "split = \"quad-dyadic\"\n[mask]\nscale = \"1/4000\"\nrows = [";
  for (const auto& row : rows) {
    text += "[";
    for (const int value : row) text += std::to_string(value) + ", ";
    text += "],";
  }
  return text + "]\n";
}

TEST(RegularityCommand, EndsInTimeWithWhatItReached) {
  const Folder folder;
  for (const int size : {9, 13}) {
    folder.write("generic.toml", generic_mask(size));
    const auto start = std::chrono::steady_clock::now();
    const Outcome outcome = folder.limn("regularity generic.toml --time 1 --json");
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const nlohmann::json found = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(found.at("time_ended"), true) << size;
    // without an end: minutes, and with sanitizers an hour
    EXPECT_LT(took.count(), kSanitized ? 300 : 60) << size;
    if (const auto& upper = found.at("holder").at("upper"); !upper.is_null()) {
      EXPECT_LE(double(found.at("holder").at("lower")), double(upper));
    }
  }
}

TEST(RegularityCommand, RefusesBadInputWithTheReason) {
  const Folder folder;
  expect_refused(folder.limn("regularity nosuch"), "nosuch");
  expect_refused(folder.limn("regularity"), "SCHEME");
  expect_refused(folder.limn("regularity loop --budget 0"), "--budget");
  expect_refused(folder.limn("regularity loop --tolerance x"), "--tolerance");
  expect_refused(folder.limn("regularity loop --time -1"), "--time");
  expect_refused(folder.limn("regularity loop -p nosuch=1"), "nosuch");
}

/// Bounds of any size have digits.
TEST(RegularityCommand, PrintsBoundsOfAnySize) {
  const Folder folder;
  for (const std::string exponent : {"9", "10", "13", "15"}) {
    folder.write("a.toml",
                 "split = \"triangle-dyadic\"\n[vertex]\nself = \"5/8\"\nring = "
                 "\"1/16\"\n[edge]\nend = \"10^" +
                     exponent + "\"\nwing = \"1/2 - 10^" + exponent + "\"\n");
    const Outcome outcome = folder.limn("regularity a.toml --budget 100");
    EXPECT_TRUE(outcome.code == 0 || outcome.code == 2) << exponent << outcome.err;
    EXPECT_EQ(folder.limn("regularity a.toml --budget 100 --json").code, outcome.code) << exponent;
  }
}

}  // namespace
}  // namespace limn::test
