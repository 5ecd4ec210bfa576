// Every shipped file against the literature: its rules, its facts, its mask, and the numbers of
// the papers (and of theory.md §3 and §5) that follow from eigenvalues alone.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "support/frequency.h"
#include "support/scheme_oracle.h"

namespace limn::test {
namespace {

class Shipped : public ::testing::TestWithParam<std::string> {};

TEST_P(Shipped, RefinesAsTheLiteratureSays) {
  EXPECT_EQ(failed_reference(find_scheme(GetParam()).value()), std::nullopt);
}

TEST_P(Shipped, HasTheMaskThatItStates) {
  EXPECT_EQ(failed_mask(find_scheme(GetParam()).value()), std::nullopt);
}

TEST_P(Shipped, HasFactsAndTheyHold) {
  EXPECT_EQ(failed_facts(find_scheme(GetParam()).value()), std::nullopt);
}

INSTANTIATE_TEST_SUITE_P(All, Shipped, ::testing::ValuesIn(shipped_schemes()),
                         [](const auto& chosen) {
                           std::string name = chosen.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });
}  // namespace
}  // namespace limn::test
