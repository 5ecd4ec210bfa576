#pragma once
/// Reflection lines of smooth surfaces as curves, not as pixels.

#include <string>

#include "limn/base/error.h"
#include "limn/figure/canvas/canvas.h"
#include "limn/figure/space/light_lines.h"
#include "limn/figure/space/surface_scene.h"

namespace limn::figure {

/// An error where so many light lines cannot be told apart in a picture of the scene, `width`
/// points wide: where their mirror images would lie less than a point apart, in the mean over a
/// surface. It names the most that can. O(triangles).
[[nodiscard]] Status check_lights(const SurfaceScene& scene, const LightLines& lights,
                                  double width);

/// A panel (see map_panel.h) of the scene in lines: what its surfaces mirror of the light lines,
/// and their outlines; what surfaces hide is left out. Without Embree (`rays_available`) the panel
/// only says so.
struct ReflectionLinePanel {
  SurfaceScene scene = {};
  LightLines lights = {};
  std::string title = {};
  bool outline = true;
  double line_width = 0.5;  ///< points; outlines are half as wide again

  /// In points, for the given width.
  [[nodiscard]] double height(double width) const;
  void draw(Canvas& canvas, const Box& box) const;
};

}  // namespace limn::figure
