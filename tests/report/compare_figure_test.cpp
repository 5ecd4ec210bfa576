#include "limn/report/compare/compare_figure.h"

#include <gtest/gtest.h>

#include "figure/sample_surfaces.h"
#include "limn/figure/space/visibility.h"

namespace limn {
namespace {

figure::SmoothSurface ball(int cells, double radius) {
  figure::SmoothSurface surface = test::sphere(cells);
  for (figure::SpaceVector& vertex : surface.vertices) vertex = figure::sum({}, vertex, radius);
  return surface;
}

std::vector<const figure::Image*> images(const figure::Canvas& canvas) {
  std::vector<const figure::Image*> found;
  for (const figure::DrawingOp& op : canvas.ops())
    if (const auto* image = std::get_if<figure::ImageOp>(&op)) found.push_back(&image->image);
  return found;
}

std::string words(const figure::Canvas& canvas) {
  std::string all;
  for (const figure::DrawingOp& op : canvas.ops())
    if (const auto* text = std::get_if<figure::TextOp>(&op)) all += text->text + "\n";
  return all;
}

/// Red less green, in [−1, 1], of the pixel in the middle.
double redness(const figure::Image& image) {
  const std::size_t middle =
      std::size_t(image.height / 2) * image.width + std::size_t(image.width / 2);
  return (image.rgba[4 * middle] - image.rgba[4 * middle + 1]) / 255.0;
}

class CompareFigure : public testing::Test {
 protected:
  void SetUp() override {
    if (!figure::rays_available()) GTEST_SKIP() << "built without Embree";
  }
  static figure::Canvas drawn(const std::vector<report::NamedSurface>& surfaces) {
    return report::compare_figure(surfaces, *report::approx_distances(surfaces), {.resolution = 36})
        .canvas();
  }
};

TEST_F(CompareFigure, ShowsEachPairWithTheFirst) {
  const figure::Canvas canvas =
      drawn({{"A", ball(12, 1)}, {"B_{x}", ball(14, 1.25)}, {"C", ball(10, .75)}});
  const std::vector<const figure::Image*> all = images(canvas);
  ASSERT_EQ(all.size(), 8U);
  EXPECT_LT(redness(*all[0]), -.1);                                   // the first is green …
  EXPECT_GT(redness(*all[1]), .1);                                    // … the second pink …
  EXPECT_GT(redness(*all[2]), .1);                                    // … which lies outside
  EXPECT_LT(std::abs(redness(*all[3])), std::abs(redness(*all[1])));  // viridis
  EXPECT_GT(redness(*all[5]), .1);
  EXPECT_LT(redness(*all[6]), -.1);  // C lies within A
  const std::string text = words(canvas);
  for (const char* part : {"*{(a)} A\n", "*{(b)} B_{x}\n", "*{(f)} C\n", "% of the"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

TEST_F(CompareFigure, ShowsNeitherWhereBothAreEqual) {
  const figure::Canvas canvas = drawn({{"A", ball(12, 1)}, {"the same", ball(12, 1)}});
  const std::vector<const figure::Image*> all = images(canvas);
  ASSERT_EQ(all.size(), 4U);
  EXPECT_LT(redness(*all[0]), -.1);
  EXPECT_GT(redness(*all[1]), .1);
  EXPECT_LT(std::abs(redness(*all[2])), .1);  // nearly grey, everywhere
  for (std::size_t i = 0; i < all[2]->rgba.size(); i += 4)
    EXPECT_LE(std::abs(all[2]->rgba[i] - all[2]->rgba[i + 1]), 12);
  EXPECT_NE(words(canvas).find("both: less than 2e-05 of the size apart"), std::string::npos);
}

TEST(CompareDistances, AreOfAllPairs) {
  const std::vector<report::PairDistance> distances =
      *report::approx_distances({{"A", ball(40, 1)}, {"B", ball(40, 1.25)}, {"C", ball(40, .75)}});
  ASSERT_EQ(distances.size(), 3U);
  EXPECT_NEAR(distances[0].distance.mean, .25, 2e-3);
  EXPECT_NEAR(distances[1].distance.mean, .25, 2e-3);
  EXPECT_NEAR(distances[2].distance.mean, .5, 2e-3);
  EXPECT_EQ(distances[2].first, 1U);
  EXPECT_EQ(distances[2].second, 2U);
  EXPECT_FALSE(report::approx_distances({{"A", ball(3, 1)}, {"nothing", {}}}).ok());
  EXPECT_TRUE(report::approx_distances({{"alone", ball(3, 1)}})->empty());
}

}  // namespace
}  // namespace limn
