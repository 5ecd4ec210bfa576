#include "limn/report/figure/shading.h"

#include <algorithm>
#include <cmath>

#include "limn/base/parallel.h"

namespace limn {
namespace {

constexpr int kSamples = 16;        // rays a pixel
constexpr double kSoftness = 0.04;  // of a stripe's edge, in distances of stripes
constexpr Colour kDarkStripe = {0.13, 0.15, 0.20};

using Rgb = SpaceVector;

Rgb rgb(const Colour& colour) { return {colour.red, colour.green, colour.blue}; }

/// The surface's normal where the ray met it, on the side of the viewer and of length 1.
SpaceVector normal_at(const SeenSurface& surface, const RayHit& hit) {
  const std::array<int, 3>& triangle = surface.triangles[hit.triangle];
  SpaceVector normal{};
  for (std::size_t c = 0; c < 3; ++c)
    normal = sum(normal, surface.normals[triangle[c]], hit.weights[c]);
  const SpaceVector& corner = surface.vertices[triangle[0]];
  const SpaceVector facet = cross(sum(surface.vertices[triangle[1]], corner, -1),
                                  sum(surface.vertices[triangle[2]], corner, -1));
  // The flat triangle says which side is seen: at an outline the normal itself may point away.
  const bool away = (facet[2] < 0) != (dot(facet, normal) < 0);
  normal = normalised(normal);
  return away ? sum({}, normal, -1) : normal;
}

Rgb shaded(const Colour& colour, const SpaceVector& normal) {
  const double towards = dot(normal, kLightFrom);
  const double half_lit = 0.5 + 0.5 * towards;  // soft on the dark side as well
  const double diffuse = 0.42 + 0.62 * half_lit * half_lit;
  const SpaceVector mirrored = MirroredLights::mirrored(normal);
  const double shine = 0.16 * std::pow(std::max(dot(mirrored, kLightFrom), 0.0), 24);
  const Rgb body = rgb(colour);
  Rgb result;
  for (std::size_t c = 0; c < 3; ++c)
    result[c] = std::min(body[c] * std::min(diffuse, 1.0) + shine, 1.0);
  return result;
}

Rgb striped(const Colour& colour, const SpaceVector& normal, const MirroredLights& lights) {
  const double darkness = stripe_darkness(lights.turn(MirroredLights::mirrored(normal)));
  const double light = 0.80 + 0.20 * std::max(dot(normal, kLightFrom), 0.0);
  Rgb bright = between(rgb(colour), {1, 1, 1}, 0.65);
  for (double& channel : bright) channel *= light;
  return between(bright, rgb(kDarkStripe), darkness);
}

std::uint8_t byte(double value) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

/// Between the values of the triangle's corners.
double value_at(const std::vector<double>& values, const std::array<int, 3>& triangle,
                const RayHit& hit) {
  double value = 0;
  for (std::size_t c = 0; c < 3; ++c) value += hit.weights[c] * values[triangle[c]];
  return value;
}

class Camera {
 public:
  Camera(const RayCaster& rays, const FramePlacement& place, const Shading& shading, Image& image)
      : rays_(rays), place_(place), shading_(shading), image_(image) {}

  void draw_row(int row) const {
    for (int column = 0; column < image_.width; ++column) {
      Rgb colour{};
      // Points of a lattice, no two of them in one row or column: edges of any slope are smooth.
      for (int k = 0; k < kSamples; ++k)
        colour = sum(colour, sample(column + (k + 0.5) / kSamples,
                                    row + (5 * k % kSamples + 0.5) / kSamples));
      std::uint8_t* const pixel = &image_.rgba[4 * (std::size_t(row) * image_.width + column)];
      for (std::size_t c = 0; c < 3; ++c) pixel[c] = byte(colour[c] / kSamples);
      pixel[3] = 255;
    }
  }

 private:
  [[nodiscard]] Rgb sample(double column, double row) const {
    const Box& box = place_.box();
    const auto [x, y] = place_.seen(
        {box.x + box.width * column / image_.width, box.y + box.height * row / image_.height});
    const std::optional<RayHit> hit = rays_.first_hit(x, y);
    if (!hit) return {1, 1, 1};
    const SpaceVector normal = normal_at(rays_.surfaces()[hit->surface], *hit);
    const Colour colour = colour_at(*hit);
    return shading_.lights ? striped(colour, normal, *shading_.lights) : shaded(colour, normal);
  }

  [[nodiscard]] Colour colour_at(const RayHit& hit) const {
    if (hit.surface > 0 || !shading_.first) return shading_.colours[hit.surface];
    const SeenSurface& surface = rays_.surfaces().front();
    return colour_of(shading_.first->scale,
                     value_at(shading_.first->values, surface.triangles[hit.triangle], hit));
  }

  const RayCaster& rays_;
  const FramePlacement& place_;
  const Shading& shading_;
  Image& image_;
};

}  // namespace

double stripe_darkness(double turn) {
  const double off = std::abs(turn - std::round(turn));  // in [0, 1/2]; the edge is at 1/4
  const double t = std::clamp((0.25 - off) / kSoftness + 0.5, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Image shaded_image(const RayCaster& rays, const FramePlacement& place, const Shading& shading,
                   int width, int height) {
  Image image{width, height, {}};
  image.rgba.resize(4 * std::size_t(width) * std::size_t(height));
  const Camera camera(rays, place, shading, image);
  parallel_for(
      0, height,
      [&](int first, int last) {
        for (int row = first; row < last; ++row) camera.draw_row(row);
      },
      4);
  return image;
}

}  // namespace limn
