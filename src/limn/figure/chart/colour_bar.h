#pragma once
/// The bands of colour of a map and the bar that explains them.

#include <string>
#include <vector>

#include "limn/figure/chart/axes.h"

namespace limn::figure {

/// Bands of a range of values: band i goes from edges[i−1] (from below everything, if i = 0) to
/// edges[i]. Every tick is an edge, so contour lines at the ticks run between bands.
struct ColourScale {
  Range range;
  Ticks ticks;
  std::vector<double> edges;    ///< ascending, inside the range
  std::vector<Colour> colours;  ///< edges.size() + 1
  bool low_clamped = false;     ///< there are values below the range
  bool high_clamped = false;
  bool is_signed = false;  ///< both signs occur: 0 is pale, equal amounts are equally dark
};

/// About `count` ticks with four bands between two of them. `data`: of all values.
[[nodiscard]] ColourScale colour_scale(Range range, Range data, int count);

/// The band that a value falls into; the ends' beyond the range, grey where it is not finite.
[[nodiscard]] Colour colour_of(const ColourScale& scale, double value);

/// Width in points of the bar with its numbers and label.
[[nodiscard]] double colour_bar_width(const ColourScale& scale, const std::string& label);

/// Draws the bar upright from (x, bottom) to (…, top), low values below.
void draw_colour_bar(Canvas& canvas, const ColourScale& scale, const std::string& label, double x,
                     double bottom, double top);

/// Draws it lying from (left, top) to (right, …), with its numbers below, high values on the right;
/// its factor, if there is one, and label below them.
void draw_lying_colour_bar(Canvas& canvas, const ColourScale& scale, const std::string& label,
                           double left, double right, double top);

/// In points.
[[nodiscard]] double lying_colour_bar_height(const ColourScale& scale, const std::string& label);

}  // namespace limn::figure
