#pragma once
/// A map of a function on a triangulated region of the plane, drawn with level sets as polygons:
/// each band of colour is painted over the lower ones, which reach beneath it, so there are no
/// seams.
///
/// A panel is plain data. `draw` puts it into a box of a canvas, `height` says how tall a box of a
/// given width it fills; figure.h arranges panels on a page.

#include <optional>
#include <string>
#include <vector>

#include "limn/figure/canvas/canvas.h"
#include "limn/figure/chart/level_sets.h"

namespace limn::figure {

/// A function in colour (viridis; where both signs occur, blue below 0 and red above it) with black
/// contour lines at round values and a colour bar. Where a value is not finite the map is empty.
struct MapPanel {
  TriangleGrid grid = {};
  std::vector<double> values = {};  ///< one per node
  std::string title = {};
  std::string x_label = "x", y_label = "y";
  std::string value_label = {};  ///< beside the colour bar
  /// Of the colours; without them the least and largest value. What is beyond is clamped, and the
  /// bar says so with ≤ and ≥.
  std::optional<double> low = {}, high = {};
  int contours = 8;             ///< about how many levels have lines and ticks; 0: no lines
  bool contour_labels = false;  ///< write the value into the longest line of each level
  bool axes = true;
  /// At least so much is kept free beside the region for the colour bar, in points: panels with the
  /// same get regions of one size.
  double side = 0;

  /// In points, for the given width.
  [[nodiscard]] double height(double width) const;
  void draw(Canvas& canvas, const Box& box) const;
};

}  // namespace limn::figure
