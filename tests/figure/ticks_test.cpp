#include "limn/figure/canvas/ticks.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace limn {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> labels(const figure::Ticks& ticks) {
  std::vector<std::string> result;
  for (const figure::Ticks::Tick& tick : ticks.ticks) result.push_back(tick.label);
  return result;
}

using Labels = std::vector<std::string>;

TEST(Ticks, AreRoundAndSaySo) {
  EXPECT_EQ(figure::round_levels({0, 1}, 5), (std::vector<double>{0, 0.2, 0.4, 0.6, 0.8, 1}));
  EXPECT_EQ(figure::round_levels({0.1, 0.7}, 6),
            (std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7}));
  EXPECT_EQ(labels(figure::linear_ticks({-0.5, 0.5}, 4)),
            (Labels{"−0.50", "−0.25", "0.00", "0.25", "0.50"}));
  EXPECT_EQ(labels(figure::linear_ticks({0, 40000}, 4)),
            (Labels{"0", "10000", "20000", "30000", "40000"}));
}

TEST(Ticks, TakeOutAPowerOfTen) {
  const figure::Ticks small = figure::linear_ticks({0, 4e-6}, 4);
  EXPECT_EQ(labels(small), (Labels{"0", "1", "2", "3", "4"}));
  EXPECT_EQ(small.factor, "×10^{−6}");
  EXPECT_EQ(small.ticks[3].value, 3e-6);
  EXPECT_EQ(figure::linear_ticks({0, 2e7}, 4).factor, "×10^{7}");
  EXPECT_EQ(figure::linear_ticks({0, 0.002}, 4).factor, "");
}

TEST(Ticks, OfALogarithmicAxisArePowersOfTen) {
  EXPECT_EQ(labels(figure::logarithmic_ticks({0.5e-2, 20}, 5)),
            (Labels{"10^{−2}", "10^{−1}", "10^{0}", "10^{1}"}));
  EXPECT_EQ(labels(figure::logarithmic_ticks({1e-12, 1}, 4)),
            (Labels{"10^{−12}", "10^{−8}", "10^{−4}", "10^{0}"}));
  EXPECT_EQ(labels(figure::logarithmic_ticks({2, 4}, 4)),
            (Labels{"2.0", "2.5", "3.0", "3.5", "4.0"}));
}

TEST(Ticks, DegenerateRangesAreWidened) {
  for (const figure::Range range : {figure::Range{2, 2},
                                    {0, 0},
                                    {-3, -3},
                                    {1, 1 + 1e-14},
                                    {kNan, 1},
                                    {1e308, 1e308},
                                    {-kInfinity, kInfinity},
                                    {5e-324, 5e-324},
                                    {2, 1}}) {
    const figure::Range wide = figure::drawable(range);
    EXPECT_LT(wide.low, wide.high);
    EXPECT_TRUE(std::isfinite(wide.high - wide.low));
    EXPECT_GE(figure::round_levels(range, 5).size(), 2u);
  }
  EXPECT_EQ(figure::range_of({kNan, kInfinity}).high, 1);
  EXPECT_EQ(figure::range_of({kNan, 3, -kInfinity, 2}).low, 2);
}

TEST(Ticks, NumbersAreShort) {
  EXPECT_EQ(figure::number_label(0.83), "0.83");
  EXPECT_EQ(figure::number_label(-0.25), "−0.25");
  EXPECT_EQ(figure::number_label(2.0 / 3), "0.667");
  EXPECT_EQ(figure::number_label(1.5e-9), "1.5·10^{−9}");
}

RC_GTEST_PROP(TicksLaws, AreWithinTheRangeAndAboutAsManyAsAsked, ()) {
  const double low = *rc::gen::inRange(-1000, 1000) / 7.0;
  const double size = std::pow(10.0, *rc::gen::inRange(-4, 5)) * *rc::gen::inRange(1, 100);
  const int count = *rc::gen::inRange(2, 13);
  const std::vector<double> levels = figure::round_levels({low, low + size}, count);
  RC_ASSERT(levels.size() <= 2u * count);
  RC_ASSERT(2 * levels.size() + 2 >= static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < levels.size(); ++i) {
    RC_ASSERT(levels[i] >= low - 1e-6 * size && levels[i] <= low + size * (1 + 1e-6));
    if (i > 0) RC_ASSERT(levels[i] > levels[i - 1]);
  }
}

TEST(Ticks, WholeOnesStandAtWholeNumbers) {
  for (double high = 4; high < 400; high += 1)
    for (int count = 1; count <= 12; ++count) {
      const figure::Ticks ticks = figure::linear_ticks({3, high}, count, true);
      for (const figure::Ticks::Tick& tick : ticks.ticks) {
        EXPECT_EQ(tick.value, std::round(tick.value)) << high << ' ' << count;
        EXPECT_EQ(tick.label.find('.'), std::string::npos) << tick.label;
      }
    }
}

}  // namespace
}  // namespace limn
