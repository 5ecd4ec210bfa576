#pragma once
/// The axes of a plot, and the sizes of text that all panels share.

#include <string>

#include "limn/figure/canvas/canvas.h"
#include "limn/figure/canvas/ticks.h"

namespace limn::figure {

inline constexpr double kTickSize = 7;     ///< points; numbers at ticks
inline constexpr double kLabelSize = 8;    ///< axis labels, legends, captions
inline constexpr double kTitleSize = 8.5;  ///< titles of panels
inline constexpr double kTitleHeight = 15;
inline constexpr double kTickLength = 2.5;

/// A range with its ticks and label, not yet at a place.
class Axis {
 public:
  /// About `count` ticks, fewer where their numbers would touch. The range is made drawable; a
  /// logarithmic one is cut to positive values.
  enum class Kind { linear, whole, logarithmic };  ///< whole: ticks at whole numbers only
  Axis(Range range, std::string label, int count, Kind kind = Kind::linear);

  [[nodiscard]] const Range& range() const { return range_; }
  /// Those that fit into an axis of this length in points, upright or lying.
  [[nodiscard]] Ticks ticks_within(double length, bool upright) const;

  /// 0 at the low end, 1 at the high one; not finite for a value that the axis cannot show.
  [[nodiscard]] double fraction(double value) const;

  /// Space in points that the drawn axis takes beside the plot: to its left, below it.
  [[nodiscard]] double width_as_y() const;
  [[nodiscard]] double height_as_x() const;

  /// Line, ticks, numbers and label below (left of) the given side of the plot's box.
  void draw_as_x(Canvas& canvas, double left, double right, double y) const;
  void draw_as_y(Canvas& canvas, double x, double bottom, double top) const;

 private:
  [[nodiscard]] std::string full_label() const;
  [[nodiscard]] Ticks ticks(int count) const;

  Range range_;
  std::string label_;
  int count_;
  Kind kind_;
  Ticks ticks_;
};

/// In points; that of the widest.
[[nodiscard]] double width_of_numbers(const Ticks& ticks);

/// What a title takes above a panel's plot, or what is left there without one.
[[nodiscard]] inline double title_height(const std::string& title, double without = 4) {
  return title.empty() ? without : kTitleHeight;
}

/// The title, centred over [left, right] with its top at `y`; nothing if it is empty.
void draw_title(Canvas& canvas, const std::string& title, double left, double right, double y);

}  // namespace limn::figure
