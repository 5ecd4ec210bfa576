#pragma once
/// Numbers in contour lines.

#include <string>
#include <vector>

#include "limn/figure/canvas/canvas.h"

namespace limn::figure {

/// A line on the page with the number of its level.
struct ContourLine {
  std::vector<PagePoint> points;
  std::string label;
  Colour background;  ///< of the map about the line
};

/// Writes their numbers into those lines that have room: a place where the line is about straight,
/// no other line is near and earlier labels are far. `within`: labels stay inside this box.
void label_contours(Canvas& canvas, const std::vector<ContourLine>& lines, const Box& within);

}  // namespace limn::figure
