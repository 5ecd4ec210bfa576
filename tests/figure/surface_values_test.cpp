#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "limn/figure/chart/colour_bar.h"
#include "limn/figure/figure.h"
#include "limn/figure/space/visibility.h"
#include "sample_surfaces.h"

namespace limn::test {
namespace {

class ValuePictures : public testing::Test {
 protected:
  void SetUp() override {
    if (!figure::rays_available()) GTEST_SKIP() << "built without Embree";
  }
};

figure::Canvas drawn(const figure::ShadedPanel& panel) {
  figure::Canvas canvas(206, panel.height(206));
  panel.draw(canvas, {0, 0, 206, panel.height(206)});
  return canvas;
}

template <class Op>
std::vector<const Op*> all(const figure::Canvas& canvas) {
  std::vector<const Op*> found;
  for (const figure::DrawingOp& op : canvas.ops())
    if (const Op* one = std::get_if<Op>(&op)) found.push_back(one);
  return found;
}

/// A square in [−1, 1]², seen from above.
figure::SurfaceScene plate() {
  const figure::SmoothSurface flat = height_surface(20, [](double, double) {
    return figure::SpaceVector{0, 0, 0};
  });
  return {.surfaces = {flat}, .azimuth = -90, .elevation = 90};
}

std::array<int, 3> pixel(const figure::Canvas& canvas, double x, double y) {
  const figure::Image& image = all<figure::ImageOp>(canvas).at(0)->image;
  const int column = static_cast<int>((x + 1) / 2 * image.width);
  const int row = static_cast<int>((1 - y) / 2 * image.height);
  const std::uint8_t* at = &image.rgba[4 * (std::size_t(row) * image.width + column)];
  return {at[0], at[1], at[2]};
}

/// Every point has the shade of a plate that is all in the colour of its value.
TEST_F(ValuePictures, HaveTheColoursOfTheBar) {
  figure::ShadedPanel panel{.scene = plate(), .values = figure::SurfaceValues{}, .resolution = 72};
  for (const figure::SpaceVector& at : panel.scene.surfaces[0].vertices)
    panel.values->values.push_back(3 * at[0] + 5);
  const figure::Canvas canvas = drawn(panel);
  const figure::ColourScale scale = figure::colour_scale({2, 8}, {2, 8}, 4);
  for (const double x : {-.93, -.51, .013, .62, .91}) {
    figure::ShadedPanel plain{.scene = plate(), .resolution = 72};
    plain.scene.surfaces[0].colour = figure::colour_of(scale, 3 * x + 5);
    EXPECT_EQ(pixel(canvas, x, .3), pixel(drawn(plain), x, .3)) << x;
  }
  EXPECT_NE(pixel(canvas, -.9, 0), pixel(canvas, .9, 0));
  panel.values->low = 8.5;  // all are below
  panel.values->high = 9;
  const figure::Canvas below = drawn(panel);
  EXPECT_EQ(pixel(below, -.9, 0), pixel(below, .9, 0));
}

TEST_F(ValuePictures, AreGreyWithoutAValue) {
  figure::ShadedPanel panel{.scene = plate(), .values = figure::SurfaceValues{}, .resolution = 72};
  const std::size_t count = panel.scene.surfaces[0].vertices.size();
  panel.values->values.assign(count, std::numeric_limits<double>::quiet_NaN());
  const auto [red, green, blue] = pixel(drawn(panel), 0, 0);
  EXPECT_EQ(red, green);
  EXPECT_EQ(green, blue);
  const double plain = figure::ShadedPanel{.scene = plate()}.height(206);
  EXPECT_GT(panel.height(206), plain);
  panel.values->values.pop_back();  // not one for each vertex: as if there were none
  EXPECT_EQ(panel.height(206), plain);
  EXPECT_NE(pixel(drawn(panel), 0, 0)[0], pixel(drawn(panel), 0, 0)[2]);
}

TEST_F(ValuePictures, HaveBarAndLegendBelow) {
  figure::ShadedPanel panel{.scene = plate(), .values = figure::SurfaceValues{}, .resolution = 72};
  panel.values->values.assign(panel.scene.surfaces[0].vertices.size(), 1);
  panel.values->values[0] = 2;
  panel.values->label = "what it is";
  panel.scene.surfaces.push_back(panel.scene.surfaces[0]);
  panel.scene.surfaces.push_back(panel.scene.surfaces[0]);
  panel.names = {"one", "", "three", "of no surface"};
  const figure::Canvas canvas = drawn(panel);
  const figure::ImageOp& image = *all<figure::ImageOp>(canvas).at(0);
  std::string words;
  for (const figure::TextOp* text : all<figure::TextOp>(canvas)) {
    words += text->text + "; ";
    EXPECT_GT(text->at[1], image.box.bottom()) << text->text;
    EXPECT_LT(text->at[1], canvas.height()) << text->text;
  }
  EXPECT_NE(words.find("what it is; "), std::string::npos) << words;
  EXPECT_NE(words.find("one; three; "), std::string::npos) << words;
  EXPECT_EQ(words.find("of no surface"), std::string::npos) << words;
  // pictures of one frame keep their scale, whatever is below them
  EXPECT_NEAR(image.box.width, all<figure::ImageOp>(drawn({.scene = plate()})).at(0)->box.width,
              1e-9);
}

/// A ball within a ball: hidden, but its outline is drawn.
TEST_F(ValuePictures, ShowOutlinesOfWhatIsHidden) {
  figure::SmoothSurface small = sphere(40);
  for (figure::SpaceVector& vertex : small.vertices) vertex = figure::sum({}, vertex, 0.5);
  small.line_colour = {0.5, 0, 0.1};
  const figure::SurfaceScene scene = {
      .surfaces = {sphere(40), small}, .azimuth = 0, .elevation = 0};
  const figure::Canvas canvas = drawn({.scene = scene, .outlines = true, .resolution = 36});
  const auto strokes = all<figure::StrokeOp>(canvas);
  double low = 1e9, high = -1e9;
  for (const figure::StrokeOp* stroke : strokes) {
    if (stroke->colour != small.line_colour) continue;
    for (const figure::PagePoint& at : stroke->path.points())
      low = std::min(low, at[0]), high = std::max(high, at[0]);
  }
  EXPECT_NEAR(low, 53, 0.3);  // the outer ball is 200 points wide
  EXPECT_NEAR(high, 153, 0.3);
}

TEST_F(ValuePictures, TakeTheFrameOfAnotherScene) {
  const figure::SurfaceScene large = plate();
  figure::SurfaceScene small = plate();
  for (figure::SpaceVector& vertex : small.surfaces[0].vertices)
    vertex = figure::sum({}, vertex, 0.25);
  small.frame = figure::SpaceBox{{-9, -9, -9}, {9, 9, 9}};
  small.seen_frame = figure::frame_of(large);
  const figure::Canvas canvas = drawn({.scene = small, .resolution = 72});
  EXPECT_EQ(pixel(canvas, .3, 0), (std::array<int, 3>{255, 255, 255}));
  EXPECT_NE(pixel(canvas, .2, 0), (std::array<int, 3>{255, 255, 255}));
}

}  // namespace
}  // namespace limn::test
