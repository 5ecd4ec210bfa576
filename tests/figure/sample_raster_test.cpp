#include "limn/figure/space/sample_raster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include "limn/base/parallel.h"
#include "limn/figure/space/shading.h"
#include "sample_surfaces.h"

namespace limn::test {
namespace {

constexpr figure::ViewFrame kFrame = {{-1, 1}, {-1, 1}};
constexpr figure::Box kBox = {0, 0, 200, 200};

figure::PixelGrid grid_of(int pixels) {
  return {figure::FramePlacement(kFrame, kBox), kBox, pixels, pixels};
}

figure::SeenSurface seen(const figure::SmoothSurface& surface) {
  return figure::seen_surface(surface, figure::ParallelView(0, 0));
}

template <class Body>
void for_each_sample(const figure::SampleRaster& raster, const figure::PixelGrid& grid, Body body) {
  figure::SampleRaster::Band band;
  for (int b = 0; b < raster.band_count(); ++b) {
    raster.fill(b, band);
    for (int row = raster.first_row(b); row < raster.first_row(b + 1); ++row)
      for (int column = 0; column < grid.width(); ++column)
        for (int k = 0; k < figure::kPixelSamples; ++k)
          body(grid.x(column + figure::sample_right(k)), grid.y(row + figure::sample_down(k)),
               band.at(row, column, k));
  }
}

/// Weights of the triangle's corners at (x, y); nothing where it is seen edge-on.
std::optional<figure::SpaceVector> weights_at(const figure::SeenSurface& on, std::size_t t,
                                              double x, double y) {
  const auto& [i, j, k] = on.triangles[t];
  const figure::SpaceVector &a = on.vertices[i], &b = on.vertices[j], &c = on.vertices[k];
  const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  if (area == 0) return std::nullopt;
  const double v = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area;
  const double w = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area;
  return figure::SpaceVector{1 - v - w, v, w};
}

/// Triangles anywhere, also beyond the picture.
figure::SeenSurface soup(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> at(-1.6, 1.6);
  figure::SeenSurface surface;
  for (int t = 0; t < count; ++t) {
    for (int c = 0; c < 3; ++c) surface.vertices.push_back({at(random), at(random), at(random)});
    surface.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  surface.normals.assign(surface.vertices.size(), {0, 0, 1});
  return surface;
}

TEST(SampleRaster, SeesTheNearestTriangle) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const std::vector<figure::SeenSurface> surfaces = {soup(12, seed)};
    const figure::SeenSurface& on = surfaces.front();
    const figure::PixelGrid grid = grid_of(19);
    const figure::SampleRaster raster(surfaces, grid);
    int met = 0, unclear = 0;
    for_each_sample(
        raster, grid, [&](double x, double y, const figure::SampleRaster::Sight& sight) {
          int nearest = -1;
          double depth = -1e9, second = -1e9, edge = 1;
          for (std::size_t t = 0; t < on.triangles.size(); ++t) {
            const auto w = weights_at(on, t, x, y);
            if (!w) continue;
            const double inside = *std::min_element(w->begin(), w->end());
            edge = std::min(edge, std::abs(inside));
            if (inside < 0) continue;
            double z = 0;
            for (std::size_t c = 0; c < 3; ++c) z += (*w)[c] * on.vertices[on.triangles[t][c]][2];
            if (z > depth)
              second = depth, depth = z, nearest = static_cast<int>(t);
            else
              second = std::max(second, z);
          }
          if (edge < 1e-9 || (nearest >= 0 && depth - second < 1e-5)) {
            ++unclear;
            return;
          }
          met += nearest >= 0 ? 1 : 0;
          ASSERT_EQ(sight.triangle, sight.surface < 0 ? sight.triangle : nearest) << x << ' ' << y;
          ASSERT_EQ(sight.surface < 0, nearest < 0) << x << ' ' << y;
        });
    EXPECT_GT(met, 1000);
    EXPECT_LT(unclear, 100);
  }
}

/// Corners of the grid lie on samples and scan lines.
TEST(SampleRaster, LeavesNoGapsAndCoversNothingTwice) {
  const int cells = 32;
  const figure::SmoothSurface plate =
      sampled_surface(cells, cells, [](double s, double t) -> SurfacePoint {
        return {{0, 2 * s - 1, 2 * t - 1}, {1, 0, 0}};
      });
  for (const int pixels : {2, 32, 37}) {
    const figure::PixelGrid grid = grid_of(pixels);
    const std::vector<figure::SeenSurface> surfaces = {seen(plate)};
    const figure::SampleRaster raster(surfaces, grid);
    std::vector<int> met(plate.triangles.size());
    for_each_sample(
        raster, grid, [&](double x, double y, const figure::SampleRaster::Sight& sight) {
          ASSERT_EQ(sight.surface, 0) << x << ' ' << y;
          ++met[static_cast<std::size_t>(sight.triangle)];
          const auto w = weights_at(surfaces[0], static_cast<std::size_t>(sight.triangle), x, y);
          ASSERT_GE(*std::min_element(w->begin(), w->end()), -1e-9);
        });
  }
}

TEST(SampleRaster, TakesBadAndFarPoints) {
  figure::SeenSurface far;
  far.vertices = {{-1e100, -1e100, 0}, {1e100, -1e100, 0}, {0, 1e100, 1e100}, {0.1, 0.1, 3}};
  far.normals.assign(4, {0, 0, 1});
  far.triangles = {{0, 1, 2}, {3, 3, 3}, {0, 3, 1}};
  const figure::PixelGrid grid = grid_of(5);
  const std::vector<figure::SeenSurface> surfaces = {figure::SeenSurface{}, far,
                                                     figure::SeenSurface{}};
  int met = 0;
  for_each_sample(figure::SampleRaster(surfaces, grid), grid,
                  [&](double, double, const figure::SampleRaster::Sight& sight) {
                    met += sight.surface == 1 ? 1 : 0;
                  });
  EXPECT_EQ(met, 5 * 5 * figure::kPixelSamples);
}

/// Two samplings of one sphere are one surface, though flat triangles lie far more off it.
TEST(SampleRaster, TellsThatSamplingsOfOneSurfaceAreEqual) {
  const std::vector<figure::SeenSurface> surfaces = {seen(sphere(40)), seen(sphere(31))};
  const double sag = std::pow(std::numbers::pi / 40, 2) / 8 / 2;  // of a chord, of the size 2
  ASSERT_GT(sag, 10 * figure::kEqualDepth);
  const figure::PixelGrid grid = grid_of(60);
  int met = 0, equal = 0;
  for_each_sample(figure::SampleRaster(surfaces, grid), grid,
                  [&](double x, double y, const figure::SampleRaster::Sight& sight) {
                    if (std::hypot(x, y) > 0.9) return;
                    ++met;
                    equal += sight.gap <= figure::kEqualDepth ? 1 : 0;
                    ASSERT_LT(sight.gap, sag / 2) << x << ' ' << y;
                  });
  EXPECT_GT(equal, 0.75 * met);
}

figure::Shading shading_of(std::vector<figure::Colour> colours) {
  return {.colours = std::move(colours)};
}

const std::uint8_t* pixel(const figure::Image& image, int row, int column) {
  return &image.rgba[4 * (static_cast<std::size_t>(row) * image.width + column)];
}

/// Each pixel of a sphere has the shade of a plate with the sphere's normal there.
TEST(ShadedImage, OfASphereHasTheShadeOfItsNormal) {
  const figure::Shading shading = shading_of({{0.8, 0.7, 0.6}});
  const figure::PixelGrid grid = grid_of(100);
  const figure::Image ball = figure::shaded_image({seen(sphere(120))}, grid, shading);
  double covered = 0;
  for (int row = 0; row < 100; ++row)
    for (int column = 0; column < 100; ++column)
      if (pixel(ball, row, column)[2] != 255) ++covered;
  EXPECT_NEAR(covered, std::numbers::pi * 50 * 50, 2 * std::numbers::pi * 50);  // pixels at the rim
  for (int row = 4; row < 100; row += 8) {
    for (int column = 4; column < 100; column += 8) {
      const double x = grid.x(column + 0.5), y = grid.y(row + 0.5);
      if (std::hypot(x, y) > 0.93) {
        if (std::hypot(x, y) > 1.03) EXPECT_EQ(pixel(ball, row, column)[2], 255);
        continue;
      }
      figure::SeenSurface plate;
      plate.vertices = {{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}};
      plate.normals.assign(3, {x, y, std::sqrt(1 - x * x - y * y)});
      plate.triangles = {{0, 1, 2}};
      const figure::Image flat = figure::shaded_image({plate}, grid_of(1), shading);
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(pixel(ball, row, column)[c], pixel(flat, 0, 0)[c], 2) << row << ' ' << column;
    }
  }
}

TEST(ShadedImage, ShowsTiesInAThirdColour) {
  const figure::Colour green = {0, 0.8, 0}, red = {0.8, 0, 0}, blue = {0, 0, 0.8};
  figure::Shading shading = shading_of({green, red});
  const auto plates = [](double slope, double apart) {
    const auto plate = [](double a, double b) {
      return sampled_surface(7, 7, [a, b](double s, double t) -> SurfacePoint {
        return {{b + a * (2 * s - 1), 2 * s - 1, 2 * t - 1}, {1, -a, 0}};
      });
    };
    return std::vector<figure::SeenSurface>{seen(plate(0, 0)),
                                            seen(plate(slope, 2 * apart))};  // size 2
  };
  const auto middle = [&](const std::vector<figure::SeenSurface>& surfaces) {
    const figure::Image image = figure::shaded_image(surfaces, grid_of(9), shading);
    const std::uint8_t* const colour = pixel(image, 4, 4);
    return std::max_element(colour, colour + 3) - colour;
  };
  EXPECT_EQ(middle(plates(0, 0)), 1);  // the earlier one
  EXPECT_EQ(middle(plates(0, 0.9 * figure::kEqualDepth)), 1);
  EXPECT_EQ(middle(plates(0, 1.1 * figure::kEqualDepth)), 0);
  shading.tie = blue;
  for (const double share : {-0.9, 0.0, 0.9})
    EXPECT_EQ(middle(plates(0, share * figure::kEqualDepth)), 2);
  EXPECT_EQ(middle(plates(0, 1.01 * figure::kNearDepth)), 0);
  EXPECT_EQ(middle(plates(0, -1.01 * figure::kNearDepth)), 1);
  // crossing: green on the left, red on the right, blue on the line alone
  const figure::Image image = figure::shaded_image(plates(0.2, 0), grid_of(64), shading);
  for (int column = 0; column < 64; ++column) {
    const std::uint8_t* const colour = pixel(image, 20, column);
    if (column < 30) EXPECT_GT(colour[1], std::max(colour[0], colour[2])) << column;
    if (column > 33) EXPECT_GT(colour[0], std::max(colour[1], colour[2])) << column;
  }
}

TEST(ShadedImage, IsTheSameForAnyNumberOfThreads) {
  figure::Shading shading = shading_of({{0.2, 0.8, 0.2}, {0.8, 0.2, 0.2}});
  shading.tie = figure::Colour{0.9, 0.9, 0.7};
  const std::vector<figure::SeenSurface> surfaces = {seen(torus(30, 0.4)), seen(sphere(20))};
  for (const bool striped : {false, true}) {
    if (striped) shading.lights = figure::MirroredLights({}, figure::ParallelView(0, 0));
    set_thread_limit(1);
    const figure::Image one = figure::shaded_image(surfaces, grid_of(90), shading);
    set_thread_limit(0);
    EXPECT_EQ(one.rgba, figure::shaded_image(surfaces, grid_of(90), shading).rgba);
  }
}

}  // namespace
}  // namespace limn::test
