#pragma once
/// Line charts.

#include <optional>
#include <string>
#include <vector>

#include "limn/figure/canvas/canvas.h"

namespace limn::figure {

/// A panel (see map_panel.h) of named lines. Each has a colour and a dash of its own, so that a
/// grey copy can be read too; so has each a marker, larger from series to series, so that points
/// which coincide show one in the other. The legend stands over the plot, where it hides nothing.
/// Where every x is a whole number (valences, levels), so are the ticks.
struct ChartPanel {
  struct Series {
    std::string name = {};  ///< empty: not in the legend
    /// As many; the line breaks where one of them cannot be shown.
    std::vector<double> x = {}, y = {};
    bool markers = false;  ///< a mark at every point
    bool line = true;      ///< from point to point
    /// Beside the points, each belonging to one of them, in rich text; missing ones are empty.
    std::vector<std::string> labels = {};
    std::optional<int> style = {};  ///< for `series_colour` and `series_dash`; default: its place
  };
  std::vector<Series> series = {};
  std::string title = {};
  std::string x_label = {}, y_label = {};
  bool log_x = false, log_y = false;              ///< then only positive values are shown
  std::optional<double> x_low = {}, x_high = {};  ///< of the axes; without them the data's
  std::optional<double> y_low = {}, y_high = {};
  double aspect = 0.62;  ///< height / width of the plot

  /// In points, for the given width.
  [[nodiscard]] double height(double width) const;
  void draw(Canvas& canvas, const Box& box) const;
};

}  // namespace limn::figure
