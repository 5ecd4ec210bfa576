#include "limn/certify/all/all_valences.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "limn/regular/regular_mask.h"

namespace limn::certify {
namespace {

Scheme scheme_of(const std::string& name, const std::vector<std::string>& parameters = {}) {
  Scheme scheme = find_scheme(name).value();
  if (!parameters.empty()) EXPECT_TRUE(set_parameters(scheme, parameters));
  return scheme;
}

/// What the regular lattice's proof gives.
struct Regular {
  explicit Regular(const Scheme& scheme)
      : cells(cell_matrices(regular_mask(scheme).value()).value()),
        bounds(enclose_contraction(cells, kContracted, 100'000).value()) {}
  CellMatrices cells;
  Contraction bounds;
};

/// Loop's edge rule, another vertex rule.
Scheme loop_with(const std::string& self, const std::string& ring) {
  return parse_scheme(
             "name = 'loop with another vertex rule'\nsplit = 'triangle-dyadic'\n"
             "[[vertex]]\nwhen = 'n <= 6'\nself = '5/8'\nring = '3/(8*n)'\n"
             "[[vertex]]\nself = '" +
                 self + "'\nring = '" + ring +
                 "'\n"
                 "[edge]\nend = '3/8'\nwing = '1/8'\n",
             "loop-with.toml")
      .value();
}

class ProvedForAll : public testing::TestWithParam<const char*> {};

TEST_P(ProvedForAll, FoundAndChecked) {
  const Scheme scheme = scheme_of(GetParam());
  const Regular regular(scheme);
  const AllValences all = certify_all_valences(scheme, regular.cells, regular.bounds, 12);
  EXPECT_EQ(all.c1, Truth::yes) << all.reason;
  EXPECT_TRUE(all.uncovered.empty());
  const Status checked = check_all_valences(scheme, regular.cells, regular.bounds, all);
  EXPECT_TRUE(checked) << checked.error().message;
}

INSTANTIATE_TEST_SUITE_P(Schemes, ProvedForAll,
                         testing::Values("loop", "loop-warren", "loop-ternary", "catmull-clark",
                                         "sqrt3", "doo-sabin", "laplacian-loop", "optimal",
                                         "catmull-clark-bounded"));

TEST(AllValences, ALaterStartIsProvedToo) {
  const Scheme scheme = scheme_of("catmull-clark");
  const Regular regular(scheme);
  for (const int from : {7, 50})
    EXPECT_EQ(certify_all_valences(scheme, regular.cells, regular.bounds, from).c1, Truth::yes);
  EXPECT_EQ(certify_all_valences(scheme, regular.cells, regular.bounds, 6).c1, Truth::undecided);
}

/// These valences, whatever the reasons say of frequency 0.
void expect_left_out(const AllValences& all, long long first, long long last) {
  ASSERT_FALSE(all.uncovered.empty());
  EXPECT_EQ(all.uncovered.front().last, last);
  EXPECT_EQ(all.uncovered.back().first, first);
  for (std::size_t i = 1; i < all.uncovered.size(); ++i)
    EXPECT_EQ(all.uncovered[i].last + 1, all.uncovered[i - 1].first);
  for (const UncoveredValences& left_out : all.uncovered)
    EXPECT_NE(left_out.reason.find("frequency 0"), std::string::npos) << left_out.reason;
}

// The vertex rule 1 - β has cup 5/8 - β, which is below 3/8 + cos(2π/n)/4 where β is above
// (1 - cos(2π/n))/4.
TEST(AllValences, ALargeCupIsNotProvedAndTheValencesAreNamed) {
  const Scheme scheme = loop_with("1 - 1/100", "1/(100*n)");  // equal at n = 22.1
  const Regular regular(scheme);
  const AllValences all = certify_all_valences(scheme, regular.cells, regular.bounds, 12);
  EXPECT_EQ(all.c1, Truth::undecided);
  expect_left_out(all, 12, 22);
  EXPECT_FALSE(check_all_valences(scheme, regular.cells, regular.bounds, all));
}

TEST(AllValences, ACupThatLeadsFromAValenceOnIsNotProved) {
  const Scheme scheme = loop_with("1 - 100/n^3", "100/n^4");  // equal at n = 20.3
  const Regular regular(scheme);
  const AllValences all = certify_all_valences(scheme, regular.cells, regular.bounds, 12);
  EXPECT_EQ(all.c1, Truth::undecided);
  expect_left_out(all, 21, 0);
  EXPECT_NE(all.reason.find("n ≥ "), std::string::npos) << all.reason;
  EXPECT_FALSE(all.intervals.empty());
}

TEST(AllValences, ACupThatOvertakesTheTangentAtInfinityIsNotProved) {
  // cup 5/8 - 1/n³, tangent about 5/8 - π²/(2n²): the cup leads from n = 1 on
  const Scheme scheme = loop_with("1 - 1/n^3", "1/n^4");
  const Regular regular(scheme);
  const AllValences all = certify_all_valences(scheme, regular.cells, regular.bounds, 12);
  EXPECT_EQ(all.c1, Truth::undecided);
  ASSERT_EQ(all.uncovered.size(), 1U);
  EXPECT_EQ(all.uncovered.front().first, 12);
  EXPECT_EQ(all.uncovered.front().last, 0);
  EXPECT_NE(all.reason.find("n ≥ 12"), std::string::npos) << all.reason;
}

TEST(AllValences, GapsThatCloseLinearlyAndQuadraticallyAreShown) {
  // cup 5/8 - 2/n and 5/8 - 6/n², tangent about 5/8 - 4.93/n²
  for (const auto& [self, ring] : {std::pair{"1 - 2/n", "2/n^2"}, {"1 - 6/n^2", "6/n^3"}}) {
    const Scheme scheme = loop_with(self, ring);
    const Regular regular(scheme);
    const AllValences all = certify_all_valences(scheme, regular.cells, regular.bounds, 12);
    EXPECT_EQ(all.c1, Truth::yes) << all.reason;
    EXPECT_EQ(all.intervals.front().constant_squarings, -1);
  }
  const Scheme closer = loop_with("1 - 4/n^2", "4/n^3");
  const Regular regular(closer);
  EXPECT_EQ(certify_all_valences(closer, regular.cells, regular.bounds, 12).c1, Truth::undecided);
}

TEST(AllValences, AFrequencyThatLeadsBeforeTheFirstIsFoundAtOnce) {
  const Scheme scheme = scheme_of("butterfly");
  const Regular regular(scheme);
  const AllValences all = certify_all_valences(scheme, regular.cells, regular.bounds, 12);
  EXPECT_EQ(all.c1, Truth::undecided);
  EXPECT_EQ(all.uncovered.size(), 1U);
  EXPECT_NE(all.reason.find("seems to lead"), std::string::npos) << all.reason;
}

TEST(AllValences, GuardsThatChangeBeyondTheStartAreRefused) {
  Scheme scheme =
      parse_scheme(
          "name = 'two rules'\nsplit = 'triangle-dyadic'\n"
          "[[vertex]]\nwhen = 'n < 20'\nself = '5/8'\nring = '3/(8*n)'\n"
          "[[vertex]]\nself = '1/2'\nring = '1/(2*n)'\n[edge]\nend = '3/8'\nwing = '1/8'\n",
          "two.toml")
          .value();
  const Regular regular(scheme);
  const AllValences early = certify_all_valences(scheme, regular.cells, regular.bounds, 12);
  EXPECT_EQ(early.c1, Truth::undecided);
  EXPECT_NE(early.reason.find("guards"), std::string::npos) << early.reason;
  const AllValences late = certify_all_valences(scheme, regular.cells, regular.bounds, 20);
  EXPECT_EQ(late.c1, Truth::yes) << late.reason;
  EXPECT_EQ(first_of_all_valences(scheme).value(), 20);
}

// The check refuses claims that were changed.
class ChangedClaims : public testing::Test {
 protected:
  void expect_refused(const std::string& what, const std::function<void(AllValences&)>& change) {
    AllValences changed = claim_;
    change(changed);
    EXPECT_FALSE(check_all_valences(scheme_, regular_.cells, regular_.bounds, changed)) << what;
  }
  Scheme scheme_ = scheme_of("catmull-clark");
  Regular regular_{scheme_};
  AllValences claim_ = certify_all_valences(scheme_, regular_.cells, regular_.bounds, 12);
};

TEST_F(ChangedClaims, AreRefused) {
  ASSERT_TRUE(check_all_valences(scheme_, regular_.cells, regular_.bounds, claim_));
  const std::size_t middle = claim_.intervals.size() / 2;
  expect_refused("from = 11", [&](AllValences& all) { all.from = 11; });
  expect_refused("c1 = Truth::undecided", [&](AllValences& all) { all.c1 = Truth::undecided; });
  expect_refused("intervals.erase(intervals.begin())",
                 [&](AllValences& all) { all.intervals.erase(all.intervals.begin()); });
  expect_refused("intervals.pop_back()", [&](AllValences& all) { all.intervals.pop_back(); });
  expect_refused("turns.erase(turns.begin() + 1)",
                 [&](AllValences& all) { all.turns.erase(all.turns.begin() + 1); });
  expect_refused("turns.pop_back()", [&](AllValences& all) { all.turns.pop_back(); });
  expect_refused("intervals[middle].eigenvalue += 1e-3",
                 [&](AllValences& all) { all.intervals[middle].eigenvalue += 1e-3; });
  expect_refused("intervals[middle].eigenvector.back() *= 1.01",
                 [&](AllValences& all) { all.intervals[middle].eigenvector.back() *= 1.01; });
  expect_refused("intervals[middle].squarings += 1",
                 [&](AllValences& all) { all.intervals[middle].squarings += 1; });
  expect_refused("intervals[0].cup += 1e-3",
                 [&](AllValences& all) { all.intervals[0].cup += 1e-3; });
  expect_refused("intervals[0].cup_squarings += 1",
                 [&](AllValences& all) { all.intervals[0].cup_squarings += 1; });
  expect_refused("intervals[0].odd_squarings += 1",
                 [&](AllValences& all) { all.intervals[0].odd_squarings += 1; });
  expect_refused("intervals[middle].parts.pop_back()",
                 [&](AllValences& all) { all.intervals[middle].parts.pop_back(); });
  expect_refused("intervals[middle].parts[1].pop_back()",
                 [&](AllValences& all) { all.intervals[middle].parts[1].pop_back(); });
  expect_refused("intervals[middle].parts[1].emplace_back('0000')",
                 [&](AllValences& all) { all.intervals[middle].parts[1].emplace_back("0000"); });
  expect_refused("intervals[0].end = Rational(1, 12)",
                 [&](AllValences& all) { all.intervals[0].end = Rational(1, 12); });
  expect_refused("turns[0].squarings += 1", [&](AllValences& all) { all.turns[0].squarings += 1; });
}

TEST_F(ChangedClaims, AnotherSchemesClaimIsRefused) {
  const Scheme loop = scheme_of("loop");
  const Regular regular(loop);
  EXPECT_FALSE(check_all_valences(loop, regular.cells, regular.bounds, claim_));
}

}  // namespace
}  // namespace limn::certify
