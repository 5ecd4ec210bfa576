// A test that a wrong weight would pass is no test: every weight of every shipped file is changed,
// and each time either the reader refuses the file or a check of the oracle fails.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "limn/scheme/check.h"
#include "support/mutants.h"
#include "support/scheme_oracle.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

std::string path_of(const std::string& scheme) {
  return std::string(LIMN_SCHEMES) + "/" + scheme + ".toml";
}

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

class Mutation : public ::testing::TestWithParam<std::string> {};

TEST_P(Mutation, OfTheFileIsRefusedOrCaught) {
  const std::string path = path_of(GetParam());
  const std::string text = text_of(path);
  ASSERT_TRUE(parse_scheme(text, path).ok());
  int refused = 0, caught = 0;
  for (const TextMutant& mutant : text_mutants(text)) {
    const Result<Scheme> scheme = parse_scheme(mutant.text, path);
    if (!scheme) {
      ++refused;
      continue;
    }
    ++caught;
    EXPECT_NE(first_failed_check(*scheme), std::nullopt) << path << " " << mutant.change;
  }
  RecordProperty("refused", refused);
  RecordProperty("caught", caught);
  EXPECT_GT(refused + caught, 9);
}

TEST_P(Mutation, OfARuleThatKeepsItsSumIsCaught) {
  const Scheme& scheme = shipped(GetParam());
  const std::vector<RuleMutant> mutants = rule_mutants(scheme);
  EXPECT_FALSE(mutants.empty());
  for (const RuleMutant& mutant : mutants) {
    // not because the sum were wrong
    const std::string failure = failed_reference(mutant.scheme).value_or("not caught");
    EXPECT_NE(failure.find("differs from the reference"), std::string::npos)
        << mutant.change << ": " << failure;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Mutation, ::testing::ValuesIn(shipped_schemes()),
                         [](const auto& chosen) { return test_name(chosen.param); });

}  // namespace
}  // namespace limn::test
