#pragma once
/// Ranges of values and the round numbers that stand at their axes. Labels are in the markup of
/// rich_text.h and do not depend on the locale.

#include <string>
#include <vector>

namespace limn::figure {

struct Range {
  double low = 0, high = 1;
};

/// Smallest and largest of the finite values; [0, 1] if there are none.
[[nodiscard]] Range range_of(const std::vector<double>& values);

/// A range that an axis can be drawn for: one that is empty, or so narrow that rounding errors
/// would fill it (10⁻⁹ of its values), is widened about its middle; ends that are not finite are
/// replaced.
[[nodiscard]] Range drawable(Range range);

/// Round numbers within the range, equally spaced by 1, 2, 2.5 or 5 times a power of ten, about
/// `count` of them (at least 1) and never more than twice as many.
[[nodiscard]] std::vector<double> round_levels(Range range, int count);

struct Ticks {
  struct Tick {
    double value;
    std::string label;
  };
  std::vector<Tick> ticks;    ///< ascending, within the range
  std::vector<double> minor;  ///< unlabelled ones between them, on logarithmic axes
  std::string factor;         ///< "×10^{−5}" if the labels leave out this factor, or empty
  int exponent = 0;           ///< of that factor
};

/// `round_levels` with labels of equal precision; `whole`: at whole numbers only.
[[nodiscard]] Ticks linear_ticks(Range range, int count, bool whole = false);

/// Powers of ten, at most about `count`, or linear ticks if none two of them are within the range.
/// Precondition: 0 < low < high.
[[nodiscard]] Ticks logarithmic_ticks(Range range, int count);

/// The number with this many significant digits, without trailing zeros.
[[nodiscard]] std::string number_label(double value, int digits = 3);

}  // namespace limn::figure
