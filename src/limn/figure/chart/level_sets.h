#pragma once
/// Level sets of piecewise linear functions on triangles of the plane, as polygons and polylines.
///
/// The superlevel set at a level is {value >= level}. Two triangles that share an edge cut it in
/// the same point, which the edge's nodes name, so the sides of the pieces cancel by integers and
/// no tolerance is involved. A triangle with a node whose value is not finite is left out
/// altogether; it is a hole in the region. Cost: O(triangles) a level.

#include <array>
#include <vector>

namespace limn::figure {

/// A triangulated region. Triangles are counterclockwise (clockwise ones are turned) and share
/// edges by node number; indices are in range.
struct TriangleGrid {
  std::vector<std::array<double, 2>> nodes;
  std::vector<std::array<int, 3>> triangles;
};

/// Corners in order. A loop's last corner is joined to its first, which is not repeated.
using Polyline = std::vector<std::array<double, 2>>;

/// The function with these values at the nodes, ready for any number of levels.
class LevelSets {
 public:
  /// Precondition: one value per node. Keeps a copy of both. O(triangles · log) once.
  LevelSets(TriangleGrid grid, std::vector<double> values);

  /// Loops that bound {value >= level}: counterclockwise about it, clockwise about its holes, so
  /// that filling them by the nonzero winding rule paints the set. They may touch at corners.
  /// `level` may be −infinity (the whole region), but not NaN.
  [[nodiscard]] std::vector<Polyline> superlevel_loops(double level) const;

  /// The part of that boundary that is inside the region. A closed line repeats its first point.
  [[nodiscard]] std::vector<Polyline> contour_lines(double level) const;

 private:
  struct Segment;
  void find_neighbours();
  [[nodiscard]] std::vector<Segment> boundary(double level) const;
  [[nodiscard]] std::array<double, 2> position(long long key, double level) const;

  TriangleGrid grid_;
  std::vector<double> values_;
  std::vector<char> usable_;                    // per triangle: all its values are finite
  std::vector<std::array<bool, 3>> has_other_;  // per side i → i+1: a usable triangle beyond it
};

/// For one level; see the class.
[[nodiscard]] std::vector<Polyline> superlevel_loops(const TriangleGrid& grid,
                                                     const std::vector<double>& values,
                                                     double level);
[[nodiscard]] std::vector<Polyline> contour_lines(const TriangleGrid& grid,
                                                  const std::vector<double>& values, double level);

}  // namespace limn::figure
