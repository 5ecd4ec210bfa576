// A freed name against the same value written into the scheme.

#include "limn/tune/freed_scheme.h"

#include <gtest/gtest.h>

#include "support/shipped.h"
#include "tuned.h"

namespace limn::test {
namespace {

void expect_same(const FrequencyBlocks& a, const FrequencyBlocks& b) {
  ASSERT_EQ(a.orbits.size(), b.orbits.size());
  ASSERT_EQ(a.blocks.size(), b.blocks.size());
  for (std::size_t i = 0; i < a.blocks.size(); ++i)
    EXPECT_LT((a.blocks[i] - b.blocks[i]).cwiseAbs().maxCoeff(), 1e-15) << i;
}

FrequencyBlocks blocks_with(Scheme scheme, const std::string& assignment, int n) {
  const Status status = set_parameter(scheme, assignment);
  EXPECT_TRUE(status.ok()) << (status ? "" : status.error().text());
  return FrequencyAnalysis(scheme).blocks(n).value();
}

TEST(FreedScheme, LeavesTheRegularNeighboursAsTheyAre) {
  const Scheme& scheme = shipped("laplacian-loop");
  const std::string own = scheme.parameters.front().value.expression.text();
  FreedScheme freed = FreedScheme::make(scheme, "a").value();
  for (const int n : {3, 5, 7, 12}) {
    EXPECT_FALSE(freed.everywhere(n));
    const std::string only_here =
        "a=(n == " + std::to_string(n) + ")*3/32 + (n != " + std::to_string(n) + ")*(" + own + ")";
    expect_same(freed.blocks(n, 3 / 32.).value(), blocks_with(scheme, only_here, n));
  }
  EXPECT_TRUE(freed.everywhere(6));
  expect_same(freed.blocks(6, 3 / 32.).value(), blocks_with(scheme, "a=3/32", 6));
}

TEST(FreedScheme, ReachesThemWhereItIsToldTo) {
  const Scheme& scheme = shipped("laplacian-loop");
  FreedScheme freed = FreedScheme::make(scheme, "a", Reach::everywhere).value();
  for (const int n : {3, 6, 9}) {
    EXPECT_TRUE(freed.everywhere(n));
    for (const double x : {0.125, 0.25})
      expect_same(freed.blocks(n, x).value(),
                  blocks_with(scheme, x == 0.125 ? "a=1/8" : "a=1/4", n));
  }
}

TEST(FreedScheme, ReachesThemWhereARuleWithoutValenceUsesTheName) {
  const Scheme& scheme = shipped("butterfly");
  FreedScheme freed = FreedScheme::make(scheme, "w").value();
  for (const int n : {3, 5, 6}) {
    EXPECT_TRUE(freed.everywhere(n));
    expect_same(freed.blocks(n, 1 / 32.).value(), blocks_with(scheme, "w=1/32", n));
  }
}

TEST(FreedScheme, ReachesThemWhereItsDefinitionIsOneNumber) {
  Scheme scheme = shipped("laplacian-loop");
  EXPECT_FALSE(FreedScheme::make(scheme, "a").value().everywhere(5));
  ASSERT_TRUE(set_parameter(scheme, "a=1/8").ok());
  FreedScheme freed = FreedScheme::make(scheme, "a").value();
  EXPECT_TRUE(freed.everywhere(5));
  expect_same(freed.blocks(5, 0.25).value(), blocks_with(scheme, "a=1/4", 5));
}

TEST(FreedScheme, KeepsItsRingsWhereWeightsVanish) {
  FreedScheme freed = FreedScheme::make(shipped("butterfly"), "w").value();
  EXPECT_EQ(freed.blocks(5, 0).value().rings, freed.blocks(5, 1 / 16.).value().rings);
}

TEST(FreedScheme, ListsWhatCanBeFreed) {
  const auto names = [](const std::string& scheme) { return freeable_names(shipped(scheme)); };
  EXPECT_EQ(names("loop"), (std::vector<std::string>{"lambda", "beta"}));
  EXPECT_EQ(names("sqrt3"), std::vector<std::string>{"alpha"});
  EXPECT_EQ(names("laplacian-loop"), (std::vector<std::string>{"lambda", "beta", "a"}));
  EXPECT_EQ(names("catmull-clark"), std::vector<std::string>{});
  // Warren's rule does without the lets of the scheme that it extends
  EXPECT_EQ(names("loop-warren"), std::vector<std::string>{});
}

TEST(FreedScheme, RefusesWhatCannotBeFreed) {
  const auto refused = [](const Scheme& scheme, const std::string& name, const std::string& part) {
    const Result<FreedScheme> freed = FreedScheme::make(scheme, name);
    ASSERT_FALSE(freed.ok()) << name;
    EXPECT_NE(freed.error().text().find(part), std::string::npos) << freed.error().text();
  };
  refused(shipped("catmull-clark"), "a", "nothing that can be freed");
  refused(shipped("sqrt3"), "beta", "no let and no parameter 'beta' (can be freed: alpha)");
  refused(shipped("loop"), "n", "no let and no parameter 'n'");
  refused(shipped("loop-warren"), "beta", "no weight of an interior rule uses 'beta'");
  const Scheme by_k = parse_scheme(
                          "split = \"quad-dual\"\n[let]\ns = \"2*cos(2*pi*k/n)\"\nt = \"3\"\n"
                          "[[corner]]\nwhen = \"t == 3\"\n"
                          "round = \"((k == 0)*n + 3 + s)/(4*n)\"\n",
                          "k.toml")
                          .value();
  refused(by_k, "s", "'s' is a number for each k");
  refused(by_k, "t", "a case of a rule is chosen by 't'");
}

TEST(FreedScheme, ReadsSearchRanges) {
  FreedScheme butterfly = FreedScheme::make(shipped("butterfly"), "w").value();
  EXPECT_EQ(butterfly.search_range(5, nullptr)->high, 1 / 8.);
  FreedScheme loop = FreedScheme::make(shipped("loop"), "beta").value();
  EXPECT_EQ(loop.search_range(5, nullptr)->low, -4);
  const SearchRange stated = SearchRange::parse("-1/n, lambda").value();
  EXPECT_NEAR(loop.search_range(6, &stated)->low, -1 / 6., 1e-16);
  EXPECT_NEAR(loop.search_range(6, &stated)->high, 1 / 2., 1e-15);
  for (const char* text : {"", "1", "0,", ",1", "0;1", "0,1,2", "0.5,1"})
    EXPECT_FALSE(SearchRange::parse(text).ok()) << text;
  for (const char* text : {"1,0", "1,1", "0,k", "0,nosuch", "0,1/0"}) {
    const SearchRange range = SearchRange::parse(text).value();
    EXPECT_FALSE(loop.search_range(6, &range).ok()) << text;
  }
}

TEST(FreedScheme, SaysWhereWeightsNoLongerSumToOne) {
  const Scheme scheme =
      parse_scheme(
          "split = \"triangle-dyadic\"\nextends = \"loop\"\n[let]\nhub = \"5/8\"\n"
          "[vertex]\nself = \"hub\"\nring = \"3/(8*n)\"\n",
          "hub.toml")
          .value();
  FreedScheme freed = FreedScheme::make(scheme, "hub").value();
  EXPECT_TRUE(freed.blocks(5, 5 / 8.).ok());
  const Result<FrequencyBlocks> blocks = freed.blocks(5, 0.5);
  ASSERT_FALSE(blocks.ok());
  EXPECT_NE(blocks.error().text().find("sum to"), std::string::npos);
}

}  // namespace
}  // namespace limn::test
