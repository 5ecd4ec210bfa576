#pragma once
/// Smooth surfaces in shades, in the stripes of a mirror, or coloured by numbers.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "limn/figure/canvas/canvas.h"
#include "limn/figure/space/light_lines.h"
#include "limn/figure/space/surface_scene.h"

namespace limn::figure {

/// Numbers on the first surface of a scene, in bands of colour, with a bar that explains them.
struct SurfaceValues {
  std::vector<double> values = {};            ///< one per vertex; grey where they are not finite
  std::string label = {};                     ///< of the bar
  std::optional<double> low = {}, high = {};  ///< of the colours; without them the values' own
};

/// The texture of the first surface of a scene: squares, dark and light in turns, or an image.
struct TextureLook {
  double squares = 8;  ///< along a unit of the coordinates
  std::array<Colour, 2> colours = {{{0.93, 0.90, 0.82}, {0.45, 0.58, 0.68}}};
  std::optional<Image> image = {};  ///< TextureColours::image
};

/// What surfaces look like where they are equal.
struct TieLook {
  Colour colour = {};
  std::string name = {};  ///< in the legend
};

/// A panel (see map_panel.h) with an image of the scene's surfaces, each in its colour, and the
/// control net over it in lines. Several surfaces may cross. Lines need rays: without Embree
/// (`rays_available`) a panel that has some only says so.
struct ShadedPanel {
  SurfaceScene scene = {};
  /// The surfaces as mirrors in which one sees these; the curves of a `ReflectionLinePanel` are the
  /// middles of the dark stripes.
  std::optional<LightLines> stripes = {};
  /// In place of the first surface's colour, if there is a value for each of its vertices.
  std::optional<SurfaceValues> values = {};
  /// In its place where that surface has a texture; goes before `values`.
  std::optional<TextureLook> texture = {};
  /// What is seen where the surface in front and another are at one place (`kEqualDepth`), fading
  /// out to `kNearDepth`. Without it, of those at one place the earliest one.
  std::optional<TieLook> ties = {};
  /// Also the outlines of each surface, as if it were alone, in its colour of lines.
  bool outlines = false;
  /// A legend below the picture: the names of the surfaces, each with its colour, and of the
  /// scene's marks; those that are empty are left out.
  std::vector<std::string> names = {};
  std::string title = {};
  /// Pixels an inch, in [1, 2400], of the image in a file of curves; those of a .png are the file's
  /// own. The image has at most 8000 a side.
  double resolution = 300;

  /// In points, for the given width.
  [[nodiscard]] double height(double width) const;
  void draw(Canvas& canvas, const Box& box) const;
};

}  // namespace limn::figure
