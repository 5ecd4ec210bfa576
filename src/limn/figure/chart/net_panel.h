#pragma once
/// Nets in the plane with names at their vertices.

#include <array>
#include <string>
#include <vector>

#include "limn/figure/canvas/canvas.h"

namespace limn::figure {

/// A panel (see map_panel.h) of nets drawn over one another, in their order, and of labels.
struct NetPanel {
  struct Net {
    std::vector<PagePoint> vertices = {};  ///< y upwards
    std::vector<std::array<int, 2>> edges = {};
    Colour colour = {};
    Stroke stroke = {};
    double dot = 1.2;  ///< radius of the vertices in points; 0: none
  };
  struct Label {
    PagePoint at = {};
    std::string text = {};  ///< in the markup of rich_text.h
    PagePoint shift = {};   ///< in points, y upwards
    Colour colour = {};
  };
  /// Straight, with a head at `to`; over the nets.
  struct Arrow {
    PagePoint from = {}, to = {};
    Colour colour = {};
  };
  std::vector<Net> nets = {};
  std::vector<Label> labels = {};
  std::vector<Arrow> arrows = {};
  std::string title = {};
  /// Labels are put beside their places where they hide nothing (label_places.h); `shift` is then
  /// not read.
  bool place_labels = false;

  /// In points, for the given width.
  [[nodiscard]] double height(double width) const;
  void draw(Canvas& canvas, const Box& box) const;
};

}  // namespace limn::figure
