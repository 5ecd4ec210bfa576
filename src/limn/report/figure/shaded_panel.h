#pragma once
/// Smooth surfaces in shades, in the stripes of a mirror, or coloured by numbers.

#include <optional>
#include <string>
#include <vector>

#include "limn/report/figure/canvas.h"
#include "limn/report/figure/light_lines.h"
#include "limn/report/figure/surface_scene.h"

namespace limn {

/// Numbers on the first surface of a scene, in bands of colour, with a bar that explains them.
struct SurfaceValues {
  std::vector<double> values = {};            ///< one per vertex; grey where they are not finite
  std::string label = {};                     ///< of the bar
  std::optional<double> low = {}, high = {};  ///< of the colours; without them the values' own
};

/// A panel (see map_panel.h) with an image of the scene's surfaces, each in its colour, and the
/// control net over it in lines. Several surfaces may cross; where they are equal the earlier one
/// is shown. Without Embree (`rays_available`) the panel only says so.
struct ShadedPanel {
  SurfaceScene scene = {};
  /// The surfaces as mirrors in which one sees these; the curves of a `ReflectionLinePanel` are the
  /// middles of the dark stripes.
  std::optional<LightLines> stripes = {};
  /// In place of the first surface's colour, if there is a value for each of its vertices.
  std::optional<SurfaceValues> values = {};
  /// Also the outlines of each surface, as if it were alone, in its colour of lines.
  bool outlines = false;
  /// A legend below the picture: the names of the surfaces, each with its colour; those that are
  /// empty are left out.
  std::vector<std::string> names = {};
  std::string title = {};
  double resolution = 300;  ///< pixels an inch, in [1, 2400]; the image has at most 8000 a side

  /// In points, for the given width.
  [[nodiscard]] double height(double width) const;
  void draw(Canvas& canvas, const Box& box) const;
};

}  // namespace limn
