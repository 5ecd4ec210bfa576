#pragma once
/// Surfaces as pixels: shaded with interpolated normals (Phong), with or without the stripes that
/// light lines make in a mirror.

#include <array>
#include <optional>
#include <vector>

#include "limn/figure/canvas/canvas.h"
#include "limn/figure/chart/colour_bar.h"
#include "limn/figure/space/light_lines.h"
#include "limn/figure/space/sample_raster.h"
#include "limn/figure/space/surface_scene.h"

namespace limn::figure {

/// Numbers at a surface's vertices and the colours they have.
struct ValueColours {
  std::vector<double> values = {};
  ColourScale scale = {};
};

/// What a texture shows: squares, dark and light in turns, or an image.
struct TextureColours {
  std::vector<std::array<double, 2>> texture = {};  ///< one for each of the surface's vertices
  double squares = 8;                               ///< along a unit of the coordinates
  std::array<Colour, 2> colours = {};
  /// In place of squares: (0, 0) is its lower left corner, (1, 1) the upper right one, and it is
  /// repeated beyond. Between pixels linearly; where it is transparent one sees the surface.
  std::optional<Image> image = {};
};

struct Shading {
  std::vector<Colour> colours = {};  ///< one for each of the surfaces
  /// The first surface has these in place of its colour; one value for each of its vertices.
  std::optional<ValueColours> first = {};
  /// The same, by its texture; its own colour where there are no coordinates.
  std::optional<TextureColours> texture = {};
  std::optional<MirroredLights> lights = {};  ///< a dark stripe half as wide as their distance
  /// Where the surface in front and another are at one place (`kEqualDepth`), fading into the
  /// colour of the one in front where they are `kNearDepth` apart. Without it, of those at one
  /// place the earliest one's colour.
  std::optional<Colour> tie = {};
};

/// The surfaces in opaque pixels, white where there is none. Pixels are shared out among threads
/// and the same for any number of them. Each has `kPixelSamples` samples; all are shaded where some
/// of them differ by more than two levels of 255, and two or four elsewhere. Cost: some 0.2 µs a
/// pixel, and about as much for each triangle.
[[nodiscard]] Image shaded_image(const std::vector<SeenSurface>& surfaces, const PixelGrid& grid,
                                 const Shading& shading);

/// How dark the stripes of the light lines are at a `turn` of `MirroredLights`: 1 on a line, 0 in
/// the middle between two.
[[nodiscard]] double stripe_darkness(double turn);

}  // namespace limn::figure
