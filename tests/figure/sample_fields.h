#pragma once
/// Grids and fields for the tests of figures.

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "limn/figure/chart/level_sets.h"

namespace limn::test {

/// The rectangle [0, columns] × [0, rows] in unit squares, each cut along one of its diagonals,
/// which one being drawn from `seed`.
inline figure::TriangleGrid rectangle_grid(int columns, int rows, unsigned seed = 0) {
  std::mt19937 random(seed);
  figure::TriangleGrid grid;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) grid.nodes.push_back({double(i), double(j)});
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i, b = a + 1, d = a + columns + 1, c = d + 1;
      if (random() % 2 == 0) {
        grid.triangles.push_back({a, b, c});
        grid.triangles.push_back({a, c, d});
      } else {
        grid.triangles.push_back({a, b, d});
        grid.triangles.push_back({b, c, d});
      }
    }
  }
  return grid;
}

template <class Function>
std::vector<double> sampled(const figure::TriangleGrid& grid, Function function) {
  std::vector<double> values;
  for (const auto& [x, y] : grid.nodes) values.push_back(function(x, y));
  return values;
}

/// Signed area within closed polygons, each counted with its winding number.
inline double area_of(const std::vector<figure::Polyline>& loops) {
  double doubled = 0;
  for (const figure::Polyline& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto &p = loop[i], &q = loop[(i + 1) % loop.size()];
      doubled += p[0] * q[1] - p[1] * q[0];
    }
  }
  return doubled / 2;
}

inline double length_of(const std::vector<figure::Polyline>& lines) {
  double length = 0;
  for (const figure::Polyline& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i)
      length += std::hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
  return length;
}

/// The area where the linear function with these values at a triangle's corners is ≥ level, times
/// 1/area of the triangle: by the similar triangle that is cut off at one corner.
inline double share_above(std::array<double, 3> values, double level) {
  std::sort(values.begin(), values.end());
  const auto [a, b, c] = values;
  if (level <= a) return 1;
  if (level > c) return 0;
  if (level <= b) return 1 - (level - a) * (level - a) / ((b - a) * (c - a));
  return (c - level) * (c - level) / ((c - a) * (c - b));
}

}  // namespace limn::test
