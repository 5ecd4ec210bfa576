#include "limn/fairness/trend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace limn::test {
namespace {

template <class Value>
std::vector<double> levels(int count, Value value) {
  std::vector<double> values;
  for (int level = 0; level < count; ++level) values.push_back(value(level));
  return values;
}

TEST(Trend, FindsTheLimitOfAGeometricSeries) {
  for (const double ratio : {.25, .5, .7, -.5, -.3}) {
    const fairness::Trend trend =
        fairness::trend_of(levels(6, [&](int l) { return 7 - 3 * std::pow(ratio, l); }));
    EXPECT_EQ(trend.converges, Truth::yes) << ratio;
    EXPECT_NEAR(trend.ratio, std::abs(ratio), 1e-9);
    EXPECT_NEAR(trend.limit, 7, 1e-9);
  }
}

TEST(Trend, SeesGrowthOfPowersAndLogarithms) {
  const auto converges = [](auto value) { return fairness::trend_of(levels(8, value)).converges; };
  EXPECT_EQ(converges([](int l) { return std::pow(4, l); }), Truth::no);
  EXPECT_EQ(converges([](int l) { return 5.0 + l; }), Truth::no);
  EXPECT_EQ(converges([](int l) { return 5.0 + l - std::pow(.25, l); }), Truth::no);
  EXPECT_EQ(converges([](int l) { return std::pow(.9, l); }), Truth::undecided);
  EXPECT_EQ(converges([](int l) { return -std::pow(2, l); }), Truth::undecided);  // no energy
}

TEST(Trend, OfUnevenChangesLooksAtTheLargerOnes) {
  // the last change but one happens to be small
  const fairness::Trend trend = fairness::trend_of({5, 4.5, 4.4, 4.4001, 4.395});
  EXPECT_EQ(trend.converges, Truth::yes);
  EXPECT_LT(trend.ratio, .3);
}

TEST(Trend, IsNotDeceivedByLargeFirstChanges) {
  // a series that converges and, below it, one that doubles
  const fairness::Trend trend = fairness::trend_of({107.1, 173.4, 221.0, 254.8, 292.4});
  EXPECT_EQ(trend.converges, Truth::undecided);
  EXPECT_TRUE(std::isnan(trend.limit));
}

TEST(Trend, OfConstantsIsTheConstant) {
  const fairness::Trend constant = fairness::trend_of({3, 3, 3, 3});
  EXPECT_EQ(constant.converges, Truth::yes);
  EXPECT_EQ(constant.limit, 3);
  EXPECT_TRUE(std::isnan(constant.ratio));
  const std::vector<double> noise{1e-22, 1e-20, 1e-18, 1e-16};
  EXPECT_EQ(fairness::trend_of(noise).converges, Truth::no);
  EXPECT_EQ(fairness::trend_of(noise, 1e-12).converges, Truth::yes);
}

TEST(Trend, OfFewOrNoNumbersIsUndecided) {
  EXPECT_EQ(fairness::trend_of({}).converges, Truth::undecided);
  EXPECT_EQ(fairness::trend_of({1, 2, 2.5}).converges, Truth::undecided);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fairness::trend_of({1, kNan, 2, 3, 4}).converges, Truth::undecided);
  EXPECT_EQ(fairness::trend_of({1, 1, 2, 2, 3}).converges, Truth::undecided);
}

}  // namespace
}  // namespace limn::test
