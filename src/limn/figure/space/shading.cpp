#include "limn/figure/space/shading.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "limn/base/parallel.h"

namespace limn::figure {
namespace {

constexpr std::array kProbes = {5, 11, 2, 14};  // samples all over a pixel
constexpr double kAlike = 2.0 / 255;
constexpr double kSoftness = 0.04;  // of a stripe's edge, in distances of stripes
constexpr Colour kDarkStripe = {0.13, 0.15, 0.20};

using Rgb = SpaceVector;

Rgb rgb(const Colour& colour) { return {colour.red, colour.green, colour.blue}; }

/// Where a sample meets a surface.
struct Meeting {
  const std::array<int, 3>& triangle;
  SpaceVector weights;  ///< of its corners: ≥ 0, sum 1
  bool towards;         ///< whether its corners are seen counterclockwise
};

/// Precondition: the triangle is not seen edge-on.
Meeting meeting(const SeenSurface& surface, int index, double x, double y) {
  const std::array<int, 3>& triangle = surface.triangles[static_cast<std::size_t>(index)];
  const SpaceVector &a = surface.vertices[triangle[0]], &b = surface.vertices[triangle[1]],
                    &c = surface.vertices[triangle[2]];
  const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  const double second = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area;
  const double third = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area;
  SpaceVector weights = {1 - second - third, second, third};
  double total = 0;
  for (double& weight : weights) total += weight = std::max(weight, 0.0);
  for (double& weight : weights) weight /= total;
  return {triangle, weights, area > 0};
}

/// The surface's normal there, on the side of the viewer and of length 1.
SpaceVector normal_at(const SeenSurface& surface, const Meeting& met) {
  SpaceVector normal{};
  for (std::size_t c = 0; c < 3; ++c)
    normal = sum(normal, surface.normals[met.triangle[c]], met.weights[c]);
  const SpaceVector& corner = surface.vertices[met.triangle[0]];
  const SpaceVector facet = cross(sum(surface.vertices[met.triangle[1]], corner, -1),
                                  sum(surface.vertices[met.triangle[2]], corner, -1));
  // The flat triangle says which side is seen: at an outline the normal itself may point away.
  const bool away = met.towards == (dot(facet, normal) < 0);
  const double size = std::sqrt(dot(normal, normal));  // of vectors of length 1: nothing overflows
  return size > 0 ? sum({}, normal, (away ? -1 : 1) / size) : normal;
}

double power24(double base) {
  const double third = base * base * base, sixth = third * third, twelfth = sixth * sixth;
  return twelfth * twelfth;
}

Rgb shaded(const Rgb& body, const SpaceVector& normal) {
  const double towards = dot(normal, kLightFrom);
  const double half_lit = 0.5 + 0.5 * towards;  // soft on the dark side as well
  const double diffuse = 0.42 + 0.62 * half_lit * half_lit;
  const SpaceVector mirrored = MirroredLights::mirrored(normal);
  const double shine = 0.16 * power24(std::max(dot(mirrored, kLightFrom), 0.0));
  Rgb result;
  for (std::size_t c = 0; c < 3; ++c)
    result[c] = std::min(body[c] * std::min(diffuse, 1.0) + shine, 1.0);
  return result;
}

Rgb striped(const Rgb& colour, const SpaceVector& normal, const MirroredLights& lights) {
  const double darkness = stripe_darkness(lights.turn(MirroredLights::mirrored(normal)));
  const double light = 0.80 + 0.20 * std::max(dot(normal, kLightFrom), 0.0);
  Rgb bright = between(colour, {1, 1, 1}, 0.65);
  for (double& channel : bright) channel *= light;
  return between(bright, rgb(kDarkStripe), darkness);
}

std::uint8_t byte(double value) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

/// Between the values of the triangle's corners.
double value_at(const std::vector<double>& values, const Meeting& met) {
  double value = 0;
  for (std::size_t c = 0; c < 3; ++c) value += met.weights[c] * values[met.triangle[c]];
  return value;
}

/// Nothing where there is no texture.
std::optional<std::array<double, 2>> place_at(const TextureColours& look, const Meeting& met) {
  constexpr double most = 1e15;  // beyond, numbers have no squares to tell apart
  std::array<double, 2> place = {0, 0};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (std::size_t c = 0; c < 3; ++c)
      place[axis] += met.weights[c] * look.texture[met.triangle[c]][axis];
    if (!(std::abs(place[axis]) <= most) || !(std::abs(place[axis] * look.squares) <= most))
      return std::nullopt;
  }
  return place;
}

Colour square_at(const TextureColours& look, std::array<double, 2> place) {
  const double turns = std::floor(place[0] * look.squares) + std::floor(place[1] * look.squares);
  return look.colours[std::fmod(std::abs(turns), 2) == 0 ? 0 : 1];
}

/// Of an image that is repeated, over a ground.
Colour pixel_at(const Image& image, std::array<double, 2> place, const Colour& ground) {
  const double x = (place[0] - std::floor(place[0])) * image.width - 0.5;
  const double y = (std::ceil(place[1]) - place[1]) * image.height - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  std::array<double, 3> sum = {0, 0, 0};
  const std::array<double, 3> behind = {ground.red, ground.green, ground.blue};
  for (const int down : {0, 1})
    for (const int right : {0, 1}) {
      const double weight =
          (right == 1 ? x - left : left + 1 - x) * (down == 1 ? y - top : top + 1 - y);
      const int column = (static_cast<int>(left) + right + image.width) % image.width;
      const int row = (static_cast<int>(top) + down + image.height) % image.height;
      const std::uint8_t* const pixel =
          image.rgba.data() + std::size_t{4} * static_cast<std::size_t>(row * image.width + column);
      const double opacity = pixel[3] / 255.0;
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += weight * (opacity * pixel[c] / 255.0 + (1 - opacity) * behind[c]);
    }
  return {sum[0], sum[1], sum[2]};
}

bool alike(const Rgb& a, const Rgb& b) {
  for (std::size_t c = 0; c < 3; ++c)
    if (!(std::abs(a[c] - b[c]) <= kAlike)) return false;
  return true;
}

/// 1 where surfaces are at one place, 0 where they are told apart, by the logarithm of their
/// distance between: a sharp border would run along the triangles' noise.
double tie_share(double gap) {
  if (gap <= kEqualDepth) return 1;
  if (gap >= kNearDepth) return 0;
  const double t = std::log(kNearDepth / gap) / std::log(kNearDepth / kEqualDepth);
  return t * t * (3 - 2 * t);
}

class Camera {
 public:
  Camera(const std::vector<SeenSurface>& surfaces, const PixelGrid& grid, const Shading& shading,
         Image& image)
      : surfaces_(surfaces),
        grid_(grid),
        shading_(shading),
        image_(image),
        probes_(shading.lights || shading.first || shading.tie || shading.texture ? kProbes.size()
                                                                                  : 2) {}

  void draw_row(const SampleRaster::Band& band, int row) const {
    for (int column = 0; column < image_.width; ++column) {
      const Rgb colour = colour_of_pixel(band, row, column);
      std::uint8_t* const pixel = &image_.rgba[4 * (std::size_t(row) * image_.width + column)];
      for (std::size_t c = 0; c < 3; ++c) pixel[c] = byte(colour[c]);
      pixel[3] = 255;
    }
  }

 private:
  [[nodiscard]] Rgb colour_of_pixel(const SampleRaster::Band& band, int row, int column) const {
    if (band.uniform(row, column)) {
      if (band.at(row, column, 0).surface < 0) return kWhite;
      const Rgb first = sample(band, row, column, kProbes[0]);
      Rgb total = first;
      bool same = true;
      for (std::size_t i = 1; i < probes_ && same; ++i) {
        const Rgb next = sample(band, row, column, kProbes[i]);
        same = alike(first, next);
        total = sum(total, next);
      }
      if (same) return sum({}, total, 1.0 / static_cast<double>(probes_));
    }
    Rgb total{};
    for (int k = 0; k < kPixelSamples; ++k) total = sum(total, sample(band, row, column, k));
    return sum({}, total, 1.0 / kPixelSamples);
  }

  [[nodiscard]] Rgb sample(const SampleRaster::Band& band, int row, int column, int k) const {
    const SampleRaster::Sight sight = band.at(row, column, k);
    if (sight.surface < 0) return kWhite;
    const SeenSurface& surface = surfaces_[static_cast<std::size_t>(sight.surface)];
    const Meeting met = meeting(surface, sight.triangle, grid_.x(column + sample_right(k)),
                                grid_.y(row + sample_down(k)));
    const SpaceVector normal = normal_at(surface, met);
    const Rgb colour = colour_at(sight, met);
    return shading_.lights ? striped(colour, normal, *shading_.lights) : shaded(colour, normal);
  }

  [[nodiscard]] Rgb colour_at(const SampleRaster::Sight& sight, const Meeting& met) const {
    const Rgb own = rgb(own_colour(sight, met));
    return shading_.tie ? between(own, rgb(*shading_.tie), tie_share(sight.gap)) : own;
  }

  [[nodiscard]] Colour own_colour(const SampleRaster::Sight& sight, const Meeting& met) const {
    if (sight.surface == 0 && shading_.texture)
      if (const auto place = place_at(*shading_.texture, met))
        return shading_.texture->image
                   ? pixel_at(*shading_.texture->image, *place, shading_.colours[0])
                   : square_at(*shading_.texture, *place);
    if (sight.surface > 0 || !shading_.first)
      return shading_.colours[static_cast<std::size_t>(sight.surface)];
    return colour_of(shading_.first->scale, value_at(shading_.first->values, met));
  }

  static constexpr Rgb kWhite = {1, 1, 1};

  const std::vector<SeenSurface>& surfaces_;
  const PixelGrid& grid_;
  const Shading& shading_;
  Image& image_;
  std::size_t probes_;  // of plain shades two tell enough
};

}  // namespace

double stripe_darkness(double turn) {
  const double off = std::abs(turn - std::round(turn));  // in [0, 1/2]; the edge is at 1/4
  const double t = std::clamp((0.25 - off) / kSoftness + 0.5, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Image shaded_image(const std::vector<SeenSurface>& surfaces, const PixelGrid& grid,
                   const Shading& shading) {
  Image image{grid.width(), grid.height(), {}};
  image.rgba.resize(4 * std::size_t(image.width) * std::size_t(image.height));
  const SampleRaster raster(surfaces, grid);
  const Camera camera(surfaces, grid, shading, image);
  base::parallel_for(
      0, raster.band_count(),
      [&](int first, int last) {
        SampleRaster::Band samples;
        for (int band = first; band < last; ++band) {
          raster.fill(band, samples);
          const int end = raster.first_row(band + 1);
          for (int row = raster.first_row(band); row < end; ++row) camera.draw_row(samples, row);
        }
      },
      8);
  return image;
}

}  // namespace limn::figure
