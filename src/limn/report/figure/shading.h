#pragma once
/// Surfaces as pixels: shaded with interpolated normals (Phong), with or without the stripes that
/// light lines make in a mirror.

#include <optional>
#include <vector>

#include "limn/report/figure/canvas.h"
#include "limn/report/figure/colour_bar.h"
#include "limn/report/figure/light_lines.h"
#include "limn/report/figure/visibility.h"

namespace limn {

/// Numbers at a surface's vertices and the colours they have.
struct ValueColours {
  std::vector<double> values = {};
  ColourScale scale = {};
};

struct Shading {
  std::vector<Colour> colours = {};  ///< one for each of the caster's surfaces
  /// The first surface has these in place of its colour; one value for each of its vertices.
  std::optional<ValueColours> first = {};
  std::optional<MirroredLights> lights = {};  ///< a dark stripe half as wide as their distance
};

/// The placement's box in width × height opaque pixels, white where there is no surface. 16 rays a
/// pixel; pixels are shared out among threads and the same for any number of them. Precondition:
/// width and height in [1, 32767].
[[nodiscard]] Image shaded_image(const RayCaster& rays, const FramePlacement& place,
                                 const Shading& shading, int width, int height);

/// How dark the stripes of the light lines are at a `turn` of `MirroredLights`: 1 on a line, 0 in
/// the middle between two.
[[nodiscard]] double stripe_darkness(double turn);

}  // namespace limn
