// Ranges of a parameter against closed forms.

#include "limn/tune/solve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tuned.h"

namespace limn::test {
namespace {

double tangent_of_loop(int n) { return 3 / 8. + std::cos(2 * M_PI / n) / 4; }

TEST(Range, SolvesOnlyFrequenciesThatTheNameChanges) {
  // alpha touches frequency 0 alone: all 51 at each sample would be many times as many
  const ValenceRange range = ranged(shipped("sqrt3"), "alpha", "c1", 100, Reach::automatic);
  EXPECT_LT(range.solved, 51LL * range.samples / 2);
}

TEST(Range, SolvesOnlyFrequenciesThatMayLead) {
  // with `everywhere` a touches all frequencies; that of 2 mostly bounds those above
  const ValenceRange range = ranged(shipped("laplacian-loop"), "a", "c1", 60, Reach::everywhere);
  EXPECT_LT(range.solved, 31LL * range.samples / 2);
}

TEST(Range, EndsWhereAsked) {
  const Scheme scheme = shipped("laplacian-loop");
  FreedScheme freed = FreedScheme::make(scheme, "a").value();
  const ValenceRange range =
      range_at(freed, Requirement::parse("c1", scheme).value(), 8, nullptr, [] {
        return true;
      }).value();
  EXPECT_TRUE(range.time_ended);
  EXPECT_TRUE(range.parts.empty());
}

/// With Loop's edge rule cup = tangent² + a, which must stay within ±tangent
/// [Kawaharada, Sugihara 2006, §3.3, who print only 0 < a].
TEST(Range, OfLaplacianLoopIsTheTangents) {
  for (const Reach reach : {Reach::automatic, Reach::everywhere})
    for (int n = 3; n <= 12; ++n) {
      const double tangent = tangent_of_loop(n);
      const ValenceRange range = ranged(shipped("laplacian-loop"), "a", "c1", n, reach);
      ASSERT_EQ(range.parts.size(), 1U) << n;
      const auto& [low, high] = range.parts.front();
      EXPECT_NEAR(low.value, -tangent - tangent * tangent, 1e-14) << n;
      EXPECT_NEAR(high.value, tangent - tangent * tangent, 1e-14) << n;
      EXPECT_FALSE(low.of_search);
      EXPECT_NE(high.reason.find("leads the tangent's"), std::string::npos) << high.reason;
    }
}

/// Curvature is bounded at the regular valence where the mask is Kobbelt's, and nowhere beside it:
/// at a fraction that is no sample.
TEST(Range, FindsTheOneFractionThatTheRegularLatticeAllows) {
  const Scheme scheme = shipped("sqrt3");
  FreedScheme freed = FreedScheme::make(scheme, "alpha").value();
  const SearchRange where = SearchRange::parse("1/5,1/2").value();
  const ValenceRange range =
      range_at(freed, Requirement::parse("bounded-curvature", scheme).value(), 6, &where).value();
  ASSERT_EQ(range.parts.size(), 1U) << range.reason;
  EXPECT_EQ(range.parts[0].low.rational, Rational(1, 3));
  EXPECT_EQ(range.parts[0].high.rational, Rational(1, 3));
}

TEST(Range, OfAllValencesIsTheNarrowest) {
  std::vector<ValenceRange> ranges;
  for (int n = 3; n <= 12; ++n) ranges.push_back(ranged(shipped("laplacian-loop"), "a", "c1", n));
  const std::vector<Interval> common = common_range(ranges);
  ASSERT_EQ(common.size(), 1U);
  EXPECT_NEAR(common.front().low, -5 / 16., 1e-14);
  EXPECT_NEAR(common.front().high, 3 / 16., 1e-14);
}

/// At b = 1/4 an outer ring reaches the tangent's 1/2 at regular vertices, where the paper reports
/// the loss of C1 [Kawaharada, Sugihara 2006].
TEST(Range, OfLaplacianButterflyEndsAtAQuarter) {
  const ValenceRange range = ranged(shipped("laplacian-butterfly"), "b", "c1", 6);
  ASSERT_EQ(range.parts.size(), 1U);
  EXPECT_TRUE(range.parts.front().low.of_search);
  EXPECT_EQ(range.parts.front().high.rational, Rational(1, 4));
}

TEST(Range, OfInequalitiesEndsWhereTheSidesAreEqual) {
  const ValenceRange below = ranged(shipped("laplacian-loop"), "a", "cup < tangent^2", 7);
  ASSERT_EQ(below.parts.size(), 1U);
  EXPECT_TRUE(below.parts.front().low.of_search);
  EXPECT_NEAR(below.parts.front().high.value, 0, 1e-15);
  const ValenceRange at_most = ranged(shipped("laplacian-loop"), "a", "tangent^2 >= cup", 7);
  ASSERT_EQ(at_most.parts.size(), 1U);
  EXPECT_NEAR(at_most.parts.front().high.value, 0, 1e-15);
}

/// |5/8 - n beta| < 1: the cup reaches 1, which is an eigenvalue already.
TEST(Range, OfConvergenceEndsWhereTheCupIsOne) {
  for (const int n : {3, 4, 5, 6}) {
    const ValenceRange range = ranged(shipped("loop"), "beta", "convergent", n);
    ASSERT_EQ(range.parts.size(), 1U) << n;
    EXPECT_NEAR(range.parts.front().low.value, -3 / (8. * n), 1e-14) << n;
    EXPECT_NEAR(range.parts.front().high.value, 13 / (8. * n), 1e-14) << n;
  }
}

TEST(Range, SaysHowTheSidesPassOneAnother) {
  const auto low_end = [](const std::string& requirement) {
    return ranged(shipped("loop"), "beta", requirement, 3).parts.at(0).low;
  };
  EXPECT_NEAR(low_end("1/(beta-1/7) > 0").value, 1 / 7., 1e-9);
  EXPECT_NE(low_end("1/(beta-1/7) > 0").reason.find("jump"), std::string::npos);
  EXPECT_EQ(low_end("beta > 1/7").reason, "the two sides are equal");
  const std::string never = ranged(shipped("loop"), "beta", "beta > 5", 3).reason;
  EXPECT_NE(never.find("beta = 4: it fails by 1"), std::string::npos) << never;
}

/// Round Loop's vertices the regular surface is C2, and curvature is bounded while |5/8 - n beta| ≤
/// tangent² and the outer rings' 1/8 ≤ tangent²; the saddle forbids it from 7 on. The high pass has
/// the same eigenvalues, but its regular surface has no bounded curvature.
TEST(Range, OfBoundedCurvatureClosesAtItsEnds) {
  for (const int n : {4, 5}) {
    const double square = std::pow(tangent_of_loop(n), 2);
    const ValenceRange range = ranged(shipped("loop"), "beta", "bounded-curvature", n);
    ASSERT_EQ(range.parts.size(), 1U) << n;
    EXPECT_NEAR(range.parts.front().low.value, (5 / 8. - square) / n, 1e-14);
    EXPECT_NEAR(range.parts.front().high.value, (5 / 8. + square) / n, 1e-14);
    EXPECT_FALSE(range.undecided);
    const ValenceRange high = ranged(shipped("laplacian-loop"), "a", "bounded-curvature", n);
    EXPECT_TRUE(high.parts.empty());
    EXPECT_FALSE(high.undecided);
    EXPECT_NE(high.reason.find("regular surface"), std::string::npos) << high.reason;
  }
  const ValenceRange none = ranged(shipped("loop"), "beta", "bounded-curvature", 7);
  EXPECT_TRUE(none.parts.empty());
  EXPECT_NE(none.reason.find("nowhere in [-4, 4]"), std::string::npos) << none.reason;
  EXPECT_NE(none.reason.find("of frequency 2"), std::string::npos) << none.reason;
}

TEST(Range, SeesNarrowPartsAndGaps) {
  // cup - tangent² = 1e-8 - (g - 1/3)², positive on 2e-4 alone
  const Scheme family =
      loop_with("(5/8 - lambda^2 + (g - 1/3)^2 - 1/100000000)/n", "[\"0\", \"1\"]");
  const ValenceRange part = ranged(family, "g", "cup > tangent^2", 7);
  ASSERT_EQ(part.parts.size(), 1U);
  EXPECT_NEAR(part.parts[0].low.value, 1 / 3. - 1e-4, 1e-11);
  EXPECT_NEAR(part.parts[0].high.value, 1 / 3. + 1e-4, 1e-11);
  const ValenceRange gap = ranged(family, "g", "cup < tangent^2", 7);
  ASSERT_EQ(gap.parts.size(), 2U);
  EXPECT_NEAR(gap.parts[0].high.value, 1 / 3. - 1e-4, 1e-11);
  EXPECT_NEAR(gap.parts[1].low.value, 1 / 3. + 1e-4, 1e-11);
}

TEST(Range, OfTwoPartsMeetsAnotherInTwo) {
  const auto range = [](std::vector<Interval> parts) {
    ValenceRange made;
    for (const Interval part : parts)
      made.parts.push_back({{part.low, {}, false, {}}, {part.high, {}, false, {}}});
    return made;
  };
  const std::vector<Interval> common =
      common_range({range({{0, 2}, {3, 5}}), range({{1, 4}}), range({{-1, 3.5}, {3.75, 9}})});
  ASSERT_EQ(common.size(), 3U);
  EXPECT_EQ(common[0].low, 1);
  EXPECT_EQ(common[0].high, 2);
  EXPECT_EQ(common[1].high, 3.5);
  EXPECT_EQ(common[2].low, 3.75);
  EXPECT_TRUE(common_range({range({{0, 1}}), range({{2, 3}})}).empty());
  EXPECT_TRUE(common_range({range({}), range({{2, 3}})}).empty());
}

}  // namespace
}  // namespace limn::test
