#pragma once
/// What both kinds of map share: a region of the plane to scale on the page, within axes.

#include <string>
#include <vector>

#include "limn/figure/chart/axes.h"
#include "limn/figure/chart/level_sets.h"

namespace limn::figure {

/// Where the bounding rectangle of a region lies on the page. x and y have one scale.
class RegionPlot {
 public:
  /// Precondition: none; a region without extent gets a unit square about it.
  RegionPlot(const TriangleGrid& grid, const std::string& x_label, const std::string& y_label,
             bool axes);

  /// Space beside the region that axes take.
  [[nodiscard]] double left_margin() const;
  [[nodiscard]] double bottom_margin() const;
  /// height / width of the region.
  [[nodiscard]] double aspect() const;

  /// Puts the region at the top of the box, midway, as large as it fits, margins included.
  void place(const Box& box);

  /// These need `place`. The region's rectangle on the page:
  [[nodiscard]] const Box& box() const { return box_; }
  /// Corners that no eye could see are left out.
  [[nodiscard]] Path path(const std::vector<Polyline>& lines, bool closed) const;
  [[nodiscard]] PagePoint point(const std::array<double, 2>& at) const;
  void draw_axes(Canvas& canvas) const;

 private:
  Axis x_, y_;
  bool axes_;
  Box box_;
};

}  // namespace limn::figure
