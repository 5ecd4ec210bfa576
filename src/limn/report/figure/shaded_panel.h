#pragma once
/// Smooth surfaces in shades, or in the stripes of a mirror.

#include <optional>
#include <string>

#include "limn/report/figure/canvas.h"
#include "limn/report/figure/light_lines.h"
#include "limn/report/figure/surface_scene.h"

namespace limn {

/// A panel (see map_panel.h) with an image of the scene's surfaces, each in its colour, and the
/// control net over it in lines. Several surfaces may cross; where they are equal the earlier one
/// is shown. Without Embree (`rays_available`) the panel only says so.
struct ShadedPanel {
  SurfaceScene scene = {};
  /// The surfaces as mirrors in which one sees these; the curves of a `ReflectionLinePanel` are the
  /// middles of the dark stripes.
  std::optional<LightLines> stripes = {};
  std::string title = {};
  double resolution = 300;  ///< pixels an inch, in [1, 2400]; the image has at most 8000 a side

  /// In points, for the given width.
  [[nodiscard]] double height(double width) const;
  void draw(Canvas& canvas, const Box& box) const;
};

}  // namespace limn
