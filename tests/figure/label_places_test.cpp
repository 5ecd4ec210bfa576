#include "limn/figure/chart/label_places.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace limn::test {
namespace {

TEST(LabelPlaces, CrossesTellsInsideFromOutside) {
  const figure::Box box{0, 0, 10, 4};
  EXPECT_TRUE(figure::crosses({{{-5, 2}, {15, 2}}}, box));
  EXPECT_TRUE(figure::crosses({{{2, 1}, {3, 2}}}, box));
  EXPECT_TRUE(figure::crosses({{{-1, 5}, {5, -1}}}, box));
  EXPECT_FALSE(figure::crosses({{{-5, 5}, {15, 5}}}, box));
  EXPECT_FALSE(figure::crosses({{{11, -5}, {11, 5}}}, box));
  EXPECT_FALSE(figure::crosses({{{-4, 4}, {3, 11}}}, box));
}

/// The hub and rim of wheels: every label finds a place where it hides nothing.
TEST(LabelPlaces, KeepsOffLinesDotsAndOneAnother) {
  for (int spokes = 3; spokes <= 9; ++spokes) {
    figure::LabelSurroundings around{.within = {0, 0, 200, 200}};
    std::vector<figure::LabelWish> labels{{{100, 100}, 8, 7}};
    const auto at = [&](int i) {
      const double angle = 2 * std::numbers::pi * i / spokes;
      return figure::PagePoint{100 + 70 * std::cos(angle), 100 + 70 * std::sin(angle)};
    };
    for (int i = 0; i < spokes; ++i) {
      around.lines.push_back({figure::PagePoint{100, 100}, at(i)});
      around.lines.push_back({at(i), at(i + 1)});
      around.dots.push_back({at(i), 2});
      labels.push_back({at(i), 12, 7});
    }
    const std::vector<figure::PagePoint> middles = figure::label_places(labels, around);
    ASSERT_EQ(middles.size(), labels.size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const figure::Box box{middles[i][0] - labels[i].width / 2,
                            middles[i][1] - labels[i].height / 2, labels[i].width,
                            labels[i].height};
      for (const auto& line : around.lines)
        EXPECT_FALSE(figure::crosses(line, box)) << spokes << ' ' << i;
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_TRUE(
            std::abs(middles[i][0] - middles[j][0]) >= (labels[i].width + labels[j].width) / 2 ||
            std::abs(middles[i][1] - middles[j][1]) >= (labels[i].height + labels[j].height) / 2);
    }
  }
}

}  // namespace
}  // namespace limn::test
