#include "limn/figure/space/shaded_panel.h"

#include <gtest/gtest.h>

#include <numbers>

#include "limn/base/parallel.h"
#include "limn/figure/figure.h"
#include "limn/figure/space/shading.h"
#include "limn/figure/space/visibility.h"
#include "sample_surfaces.h"

namespace limn::test {
namespace {

constexpr figure::FigureFormat kFormats[] = {figure::FigureFormat::pdf, figure::FigureFormat::svg,
                                             figure::FigureFormat::png};
constexpr figure::Box kBox = {0, 0, 206, 206};  // a scene has 200 points each way

class Pictures : public testing::Test {
 protected:
  void SetUp() override {
    if (!figure::rays_available()) GTEST_SKIP() << "built without Embree";
  }
};

template <class Panel>
figure::Canvas drawn(const Panel& panel, const figure::Box& box = kBox) {
  figure::Canvas canvas(box.right(), box.bottom());
  panel.draw(canvas, box);
  return canvas;
}

const figure::ImageOp& image_of(const figure::Canvas& canvas) {
  for (const figure::DrawingOp& op : canvas.ops())
    if (const auto* image = std::get_if<figure::ImageOp>(&op)) return *image;
  throw std::runtime_error("there is no image");
}

/// Corners of all strokes of this width.
std::vector<figure::PagePoint> stroked_points(const figure::Canvas& canvas, double width) {
  std::vector<figure::PagePoint> points;
  for (const figure::DrawingOp& op : canvas.ops())
    if (const auto* stroke = std::get_if<figure::StrokeOp>(&op))
      if (stroke->stroke.width == width)
        points.insert(points.end(), stroke->path.points().begin(), stroke->path.points().end());
  return points;
}

/// In [0, 1], of the pixel there.
double brightness(const figure::ImageOp& op, const figure::PagePoint& at) {
  const auto index = [](double share, int size) {
    return static_cast<std::size_t>(std::clamp(static_cast<int>(share * size), 0, size - 1));
  };
  const std::size_t column = index((at[0] - op.box.x) / op.box.width, op.image.width);
  const std::size_t row = index((at[1] - op.box.y) / op.box.height, op.image.height);
  const std::uint8_t* pixel = &op.image.rgba[4 * (row * std::size_t(op.image.width) + column)];
  return (pixel[0] + pixel[1] + pixel[2]) / 765.0;
}

figure::SurfaceScene scene_of(const figure::SmoothSurface& surface) {
  return {.surfaces = {surface}};
}

figure::SurfaceScene sphere_from_x(int cells) {
  return {.surfaces = {sphere(cells)},
          .azimuth = 0,
          .elevation = 0,
          .frame = figure::SpaceBox{{-1, -1, -1}, {1, 1, 1}}};
}

/// θ of the light that the unit sphere mirrors at (x, y) of the page, from the eye upwards.
double light_angle(double x, double y) {
  const double z = std::sqrt(1 - x * x - y * y);
  return std::atan2(2 * z * y, 2 * z * z - 1);
}

TEST_F(Pictures, StripesOfASphereAreThoseOfTheFormula) {
  const figure::Canvas canvas = drawn(figure::ShadedPanel{
      .scene = sphere_from_x(150), .stripes = figure::LightLines{.count = 24}, .resolution = 150});
  const figure::ImageOp& image = image_of(canvas);
  int dark = 0, bright = 0;
  for (int i = -70; i <= 70; ++i) {
    for (int j = -70; j <= 70; ++j) {
      const double x = i * 0.01, y = j * 0.01;
      if (std::hypot(x, y) > 0.9 || std::abs(std::abs(x) - std::sqrt(0.5)) < 0.15) continue;
      const double turn = 24 * light_angle(x, y) / (2 * std::numbers::pi) - 0.5;
      const double off = std::abs(turn - std::round(turn));
      const double seen = brightness(image, {103 + 100 * x, 103 - 100 * y});
      dark += off < 0.15 ? 1 : 0;
      bright += off > 0.35 ? 1 : 0;
      if (off < 0.15) EXPECT_LT(seen, 0.3) << x << ' ' << y;
      if (off > 0.35) EXPECT_GT(seen, 0.6) << x << ' ' << y;
    }
  }
  EXPECT_GT(dark, 1000);
  EXPECT_GT(bright, 1000);
}

/// The curves of one panel run in the dark stripes of the other.
TEST_F(Pictures, CurvesAndStripesAgree) {
  for (const figure::SmoothSurface& surface : {torus(60, 0.4), saddle(24), sphere(8)}) {
    const figure::LightLines lights = {.direction = figure::SpaceVector{1, 0.3, 0.2}, .count = 16};
    const figure::Canvas pixels = drawn(
        figure::ShadedPanel{.scene = scene_of(surface), .stripes = lights, .resolution = 150});
    const figure::Canvas curves = drawn(figure::ReflectionLinePanel{
        .scene = scene_of(surface), .lights = lights, .line_width = 0.3});
    const figure::ImageOp& image = image_of(pixels);
    const std::vector<figure::PagePoint> points = stroked_points(curves, 0.3);
    const auto dark = std::count_if(points.begin(), points.end(), [&](const figure::PagePoint& at) {
      return brightness(image, at) < 0.5;
    });
    EXPECT_GT(points.size(), 60u);
    EXPECT_GT(static_cast<double>(dark), 0.9 * static_cast<double>(points.size()));
  }
}

TEST_F(Pictures, AreWhiteRoundASmoothDisk) {
  figure::SurfaceScene scene = sphere_from_x(100);
  scene.frame = figure::SpaceBox{{-1.25, -1.25, -1.25}, {1.25, 1.25, 1.25}};
  const figure::Canvas canvas = drawn(figure::ShadedPanel{.scene = scene});
  const figure::ImageOp& image = image_of(canvas);
  EXPECT_NEAR(image.image.width, 200 * 300 / 72, 1);
  EXPECT_NEAR(image.box.x, 3, 1e-12);
  const double pixel = 200.0 / image.image.width;
  for (int i = 0; i < 360; ++i) {
    const double a = i * std::numbers::pi / 180;
    const auto at = [&](double radius) -> figure::PagePoint {
      return {103 + radius * std::cos(a), 103 - radius * std::sin(a)};
    };
    EXPECT_EQ(brightness(image, at(80 + 1.6 * pixel)), 1) << i;
    EXPECT_LT(brightness(image, at(80 - 1.6 * pixel)), 0.9) << i;
  }
  EXPECT_GT(brightness(image, {78, 66}), brightness(image, {130, 150}) + 0.2);  // lit from above
}

TEST_F(Pictures, AreTheSameForAnyNumberOfThreads) {
  figure::SurfaceScene scene = scene_of(saddle(20));  // from above, rays run along its edges
  scene.surfaces.push_back(saddle(10));
  scene.azimuth = -90;
  scene.elevation = 90;
  for (const bool striped : {false, true}) {
    figure::ShadedPanel panel{.scene = scene, .resolution = 72};
    if (striped) panel.stripes = figure::LightLines{};
    set_thread_limit(1);
    const figure::Canvas one = drawn(panel);
    set_thread_limit(0);
    const figure::Canvas many = drawn(panel);
    EXPECT_EQ(image_of(one).image.rgba, image_of(many).image.rgba);
  }
}

/// Of a plate whose sides cut pixels anywhere, the pixels hold its area and its middle.
TEST_F(Pictures, CoverPixelsByTheirShares) {
  figure::SurfaceScene scene = {
      .azimuth = 0, .elevation = 0, .frame = figure::SpaceBox{{-1, -1, -1}, {1, 1, 1}}};
  scene.surfaces = {sampled_surface(1, 1, [](double s, double t) -> SurfacePoint {
    return {{0, s - 0.37, 0.7 * t - 0.21}, {1, 0, 0}};
  })};
  scene.surfaces[0].colour = figure::grey(0.5);
  const figure::Canvas canvas = drawn(figure::ShadedPanel{.scene = scene, .resolution = 20});
  const figure::Image& image = image_of(canvas).image;
  const double full = 1 - image.rgba[4 * std::size_t(image.width) * (image.height / 2) +
                                     4 * std::size_t(image.width / 2)] /
                              255.0;
  double area = 0, x = 0, y = 0;
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      const std::size_t pixel = std::size_t(row) * image.width + column;
      const double share = (1 - image.rgba[4 * pixel] / 255.0) / full;
      area += share;
      x += share * (column + 0.5);
      y += share * (row + 0.5);
    }
  }
  const double unit = image.width / 2.0;  // pixels
  EXPECT_NEAR(area, 0.7 * unit * unit, 0.005 * unit * unit);
  EXPECT_NEAR(x / area, unit * (1 + 0.13), 0.02);
  EXPECT_NEAR(y / area, unit * (1 - 0.14), 0.02);
}

/// Pixels do not change where triangles are turned over or normals are: both sides are alike.
TEST_F(Pictures, DoNotDependOnOrientation) {
  const figure::SmoothSurface surface = torus(40, 0.4);
  figure::SmoothSurface turned = surface, flipped = surface;
  for (std::size_t t = 0; t < turned.triangles.size(); t += 2)
    std::swap(turned.triangles[t][0], turned.triangles[t][1]);
  for (figure::SpaceVector& normal : flipped.normals) normal = figure::sum({}, normal, -3);
  const auto pixels = [](const figure::SmoothSurface& of) {
    return image_of(drawn(figure::ShadedPanel{.scene = scene_of(of), .resolution = 72})).image.rgba;
  };
  const std::vector<std::uint8_t> expected = pixels(surface);
  for (const auto& other : {pixels(turned), pixels(flipped)}) {
    ASSERT_EQ(other.size(), expected.size());
    int most = 0;
    for (std::size_t i = 0; i < other.size(); ++i)
      most = std::max(most, std::abs(other[i] - expected[i]));
    EXPECT_LE(most, 1);
  }
}

/// Of two surfaces each is seen where it is in front.
TEST_F(Pictures, ShowTheSurfaceInFront) {
  const auto tilted = [](double slope) {
    return height_surface(10, [slope](double x, double) {
      return figure::SpaceVector{slope * x, slope, 0.0};
    });
  };
  figure::SurfaceScene scene = {
      .surfaces = {tilted(0.2), tilted(-0.2)}, .azimuth = -90, .elevation = 90};
  scene.surfaces[0].colour = {0, 0.8, 0};
  scene.surfaces[1].colour = {0.8, 0, 0};
  const figure::Canvas canvas = drawn(figure::ShadedPanel{.scene = scene, .resolution = 72});
  const figure::Image& image = image_of(canvas).image;
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      const std::uint8_t* pixel = &image.rgba[4 * (std::size_t(row) * image.width + column)];
      if (std::abs(column - image.width / 2) < 2) continue;
      ASSERT_EQ(pixel[1] > pixel[0], column > image.width / 2) << row << ' ' << column;
    }
  }
}

/// A segment through the sphere is dashed within and behind it.
TEST_F(Pictures, DashTheHiddenNet) {
  figure::SurfaceScene scene = sphere_from_x(80);
  scene.frame = figure::SpaceBox{{-2, -2, -2}, {2, 2, 2}};
  scene.net = {.vertices = {{0, -2, 0}, {0, 2, 0}, {1.5, 0, 1}, {1e300, 0, 0}},
               .edges = {{0, 1}, {1, 2}, {2, 7}, {-1, 0}, {0, 3}}};
  const figure::Canvas canvas = drawn(figure::ShadedPanel{.scene = scene, .resolution = 36});
  std::vector<const figure::StrokeOp*> dashed, solid;
  for (const figure::DrawingOp& op : canvas.ops())
    if (const auto* stroke = std::get_if<figure::StrokeOp>(&op))
      (stroke->stroke.dash.empty() ? solid : dashed).push_back(stroke);
  ASSERT_EQ(dashed.size(), 1u);
  ASSERT_EQ(solid.size(), 1u);
  const std::vector<figure::PagePoint>& hidden = dashed[0]->path.points();
  ASSERT_EQ(hidden.size(), 2u);
  EXPECT_NEAR(hidden[0][0], 53, 0.1);  // the sphere is 100 points wide, round 103
  EXPECT_NEAR(hidden[1][0], 153, 0.1);
  EXPECT_EQ(solid[0]->path.points().size(), 6u);
}

TEST_F(Pictures, OfOneFrameShareAScale) {
  figure::SurfaceScene small = sphere_from_x(60);
  for (figure::SpaceVector& vertex : small.surfaces[0].vertices)
    vertex = figure::sum({}, vertex, 0.5);
  const auto width = [](const figure::SurfaceScene& scene) {
    double left = 1e9, right = -1e9;
    const figure::ReflectionLinePanel panel{.scene = scene, .line_width = 0.4};
    for (const figure::PagePoint& at : stroked_points(drawn(panel), 1.5 * 0.4))
      left = std::min(left, at[0]), right = std::max(right, at[0]);
    return right - left;
  };
  EXPECT_NEAR(width(sphere_from_x(60)), 200, 0.5);
  EXPECT_NEAR(width(small), 100, 0.5);
  small.frame = {};
  EXPECT_NEAR(width(small), 200, 0.5);
}

/// In a file of pixels the image has the file's own, whole ones.
TEST_F(Pictures, HaveThePixelsOfTheFile) {
  figure::Canvas canvas(kBox.right(), kBox.bottom(), figure::kPngDensity);
  figure::ShadedPanel{.scene = sphere_from_x(20), .title = "a"}.draw(canvas, kBox);
  const figure::ImageOp& op = image_of(canvas);
  EXPECT_EQ(op.box.width * figure::kPngDensity, op.image.width);
  EXPECT_EQ(op.box.height * figure::kPngDensity, op.image.height);
  for (const double side : {op.box.x, op.box.y})
    EXPECT_EQ(side * figure::kPngDensity, std::round(side * figure::kPngDensity));
  EXPECT_GE(op.image.width, 2 * 180);
}

TEST_F(Pictures, NameTiesInTheLegend) {
  figure::SurfaceScene scene = scene_of(saddle(6));
  scene.surfaces.push_back(saddle(6));
  const figure::ShadedPanel panel{.scene = scene,
                                  .ties = figure::TieLook{figure::grey(0.5), "both"},
                                  .names = {"one", "other"}};
  EXPECT_EQ(panel.height(200),
            (figure::ShadedPanel{.scene = scene, .names = {"a", "b"}}.height(200) + 11));
  const figure::Canvas canvas = drawn(panel);
  std::string words;
  for (const figure::DrawingOp& op : canvas.ops())
    if (const auto* text = std::get_if<figure::TextOp>(&op)) words += text->text + " ";
  EXPECT_EQ(words, "one other both ");
}

/// The unit square, from the front, with itself as texture.
figure::SurfaceScene textured_square() {
  figure::SurfaceScene scene{.azimuth = 0, .elevation = 0};
  scene.surfaces.push_back({.vertices = {{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}},
                            .normals = {{1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}},
                            .triangles = {{0, 1, 2}, {0, 2, 3}},
                            .texture = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  return scene;
}

/// Black and white pixels in the upper row, a transparent and a grey one below, over white: each
/// is itself in its middle, and halfway between two, also across the rim, is their mean.
TEST_F(Pictures, ShowTexturesAsImages) {
  figure::SurfaceScene scene = textured_square();
  scene.surfaces[0].colour = figure::grey(1);
  const figure::Image image{
      2, 2, {0, 0, 0, 255, 255, 255, 255, 255, 0, 0, 0, 0, 128, 128, 128, 255}};
  const figure::TextureLook look{.image = image};
  const auto brightness_at = [&](const figure::PagePoint& at) {
    return brightness(image_of(drawn(figure::ShadedPanel{.scene = scene, .texture = look})), at);
  };
  scene.surfaces[0].colour = figure::grey(1);
  const double white = brightness_at({153, 53});  // of the light that falls on it
  EXPECT_LT(brightness_at({53, 53}), 0.05 * white);
  EXPECT_NEAR(brightness_at({53, 153}), white, 0.02);
  EXPECT_NEAR(brightness_at({153, 153}) / white, 128.0 / 255, 0.05);
  EXPECT_NEAR(brightness_at({103, 53}) / white, 0.5, 0.05);
  EXPECT_NEAR(brightness_at({4, 53}) / white, 0.5, 0.05);
  // once more to the right, moved by a half, and upside down
  for (auto& [u, v] : scene.surfaces[0].texture) u += 7.5;
  EXPECT_LT(brightness_at({153, 53}), 0.05 * white);
  for (auto& [u, v] : scene.surfaces[0].texture) v = -v;
  EXPECT_LT(brightness_at({153, 153}), 0.05 * white);
}

/// The unit square in four squares.
TEST_F(Pictures, ShowTexturesAsCheckers) {
  figure::SurfaceScene scene = textured_square();
  const figure::TextureLook look{.squares = 2, .colours = {{figure::grey(1), figure::grey(0)}}};
  const figure::Canvas canvas = drawn(figure::ShadedPanel{.scene = scene, .texture = look});
  const figure::ImageOp& op = image_of(canvas);
  const std::vector<figure::PagePoint> light = {{53, 153}, {153, 53}, {99, 107}, {107, 99}};
  const std::vector<figure::PagePoint> dark = {{153, 153}, {53, 53}, {107, 107}, {99, 99}};
  for (const figure::PagePoint& at : light) EXPECT_GT(brightness(op, at), 0.6);
  for (const figure::PagePoint& at : dark) EXPECT_LT(brightness(op, at), 0.4);
  // one that has no coordinates has its own colour, as has one with too few
  scene.surfaces[0].texture[2] = {std::numeric_limits<double>::quiet_NaN(), 0};
  EXPECT_GT(
      brightness(image_of(drawn(figure::ShadedPanel{.scene = scene, .texture = look})), {153, 153}),
      0.6);
  scene.surfaces[0].texture.pop_back();
  EXPECT_GT(
      brightness(image_of(drawn(figure::ShadedPanel{.scene = scene, .texture = look})), {153, 153}),
      0.6);
}

/// A circle round the sphere is seen on its front alone, and so is a dot.
TEST_F(Pictures, ShowMarksWhereNothingHidesThem) {
  figure::SurfaceScene scene = sphere_from_x(80);
  figure::SceneMarks marks{.colour = {1, 0, 0}, .stroke = {1.7, {}}, .name = "circle"};
  marks.curves.emplace_back();
  for (int i = 0; i <= 360; ++i) {
    const double angle = i * std::numbers::pi / 180;
    marks.curves[0].push_back({1.0001 * std::cos(angle), 1.0001 * std::sin(angle), 0});
  }
  marks.curves.push_back({{1e300, 0, 0}, {0, 0, 0}});
  scene.marks = {marks, {.points = {{1, 0, 0}, {-1, 0, 0}}, .stroke = {0.5, {}}, .name = "dots"}};
  const figure::ShadedPanel panel{.scene = scene, .resolution = 36};
  EXPECT_EQ(panel.height(206), 206 + 2 * 11);
  const figure::Canvas canvas = drawn(panel, {0, 0, 206, 228});
  double left = 1e9, right = -1e9, lowest = -1e9;
  for (const figure::DrawingOp& op : canvas.ops())
    if (const auto* stroke = std::get_if<figure::StrokeOp>(&op);
        stroke != nullptr && stroke->stroke.width == 1.7 && stroke->path.points()[0][1] < 206)
      for (const figure::PagePoint& at : stroke->path.points()) {
        left = std::min(left, at[0]), right = std::max(right, at[0]);
        lowest = std::max(lowest, std::abs(at[1] - 103));
      }
  EXPECT_NEAR(left, 3, 3);
  EXPECT_NEAR(right, 203, 3);
  EXPECT_LT(lowest, 0.1);
  int dots = 0;
  std::string words;
  for (const figure::DrawingOp& op : canvas.ops()) {
    if (const auto* fill = std::get_if<figure::FillOp>(&op); fill != nullptr && !fill->path.empty())
      dots += fill->path.points()[0][1] < 206 ? 1 : 0;
    if (const auto* text = std::get_if<figure::TextOp>(&op)) words += text->text + " ";
  }
  EXPECT_EQ(dots, 1);
  EXPECT_EQ(words, "circle dots ");
}

TEST(SurfacePanels, TakeBadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  figure::SmoothSurface broken = sphere(6), far = sphere(6), flat = sphere(6), thin = sphere(6);
  broken.vertices[3] = {nan, 0, 0};
  broken.normals[9] = {0, 0, 0};
  broken.triangles[5] = {0, 1, 1 << 30};
  for (figure::SpaceVector& vertex : far.vertices) vertex = figure::sum({}, vertex, 1e99);
  for (figure::SpaceVector& vertex : flat.vertices) vertex[2] = 0;
  for (figure::SpaceVector& vertex : thin.vertices) vertex = {vertex[0], 0, 0};
  figure::SmoothSurface point = sphere(4), unfinished = sphere(4);
  for (figure::SpaceVector& vertex : point.vertices) vertex = {1, 2, 3};
  unfinished.normals.resize(3);
  for (const figure::SmoothSurface& surface :
       {broken, far, flat, thin, point, unfinished, figure::SmoothSurface{}}) {
    figure::SurfaceScene scene = scene_of(surface);
    scene.net = {.vertices = {{nan, 0, 0}, {0, 0, 1}}, .edges = {{0, 1}, {1, 1}, {5, 5}}};
    for (const double elevation : {30.0, 0.0, nan}) {
      scene.elevation = elevation;
      figure::Figure figure(3);
      figure.add(figure::ShadedPanel{.scene = scene, .resolution = 20});
      figure.add(
          figure::ShadedPanel{.scene = scene, .stripes = figure::LightLines{}, .resolution = nan});
      figure.add(figure::ReflectionLinePanel{.scene = scene, .lights = {.count = 3}});
      if (!figure::figures_available()) continue;
      for (const figure::FigureFormat format : kFormats)
        EXPECT_TRUE(figure.canvas().render(format).ok());
    }
  }
  figure::Figure empty(2);
  empty.add(figure::ShadedPanel{}).add(figure::ReflectionLinePanel{});
  EXPECT_GT(empty.canvas().height(), 0);
}

TEST(SurfacePanels, SayThatTheyLackEmbree) {
  if (figure::rays_available()) GTEST_SKIP() << "built with Embree";
  std::string words;
  const figure::Canvas canvas = drawn(figure::ReflectionLinePanel{.scene = sphere_from_x(4)});
  for (const figure::DrawingOp& op : canvas.ops())
    if (const auto* text = std::get_if<figure::TextOp>(&op)) words += text->text + " ";
  EXPECT_NE(words.find("Embree"), std::string::npos);
}

TEST(Stripes, AreAsWideAsTheirGaps) {
  double sum_of_all = 0;
  for (int i = 0; i < 1000; ++i) sum_of_all += figure::stripe_darkness(i * 0.001 - 3);
  EXPECT_NEAR(sum_of_all / 1000, 0.5, 1e-3);
  EXPECT_EQ(figure::stripe_darkness(7), 1);
  EXPECT_EQ(figure::stripe_darkness(-2.5), 0);
}

}  // namespace
}  // namespace limn::test
