#pragma once
/// Several functions on one region, one upon the other.

#include <optional>
#include <string>
#include <vector>

#include "limn/figure/canvas/canvas.h"
#include "limn/figure/chart/level_sets.h"

namespace limn::figure {

/// A panel (see map_panel.h) of several functions on one region, each in nested translucent fills
/// of its own colour, darker where it is larger, with contour lines, and a legend with its range.
struct OverlayPanel {
  struct Layer {
    std::string name = {};
    std::vector<double> values = {};  ///< one per node
    std::optional<double> low = {}, high = {};
    std::optional<Colour> colour = {};  ///< without it red, green, blue, then greys
  };
  TriangleGrid grid = {};
  std::vector<Layer> layers = {};
  std::string title = {};
  std::string x_label = "x", y_label = "y";
  int contours = 5;  ///< about how many levels each layer has
  bool axes = true;
  double side = 0;  ///< as in MapPanel

  [[nodiscard]] double height(double width) const;
  void draw(Canvas& canvas, const Box& box) const;
};

}  // namespace limn::figure
