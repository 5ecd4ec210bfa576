#pragma once
/// A plane polygon cut into triangles: ear clipping [Meisters 1975], with exact tests and a tree of
/// the corners that can lie in an ear.

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "limn/mesh/polygon/orientation.h"
#include "limn/mesh/polygons.h"

namespace limn::mesh {

/// Keeps its memory from polygon to polygon.
class EarClipper {
 public:
  EarClipper();
  ~EarClipper();
  EarClipper(const EarClipper&) = delete;
  EarClipper& operator=(const EarClipper&) = delete;

  /// Appends n - 2 triangles of corner numbers to `triangles`, each in the polygon's direction.
  /// True where the polygon is simple, or touches itself without crossing (a slit to a hole), and
  /// runs counterclockwise: then the triangles do not overlap and have the polygon's area, and only
  /// where neighbouring corners coincide has one no area. Else false, and it is cut all the same.
  /// Corners may be collinear or coincide. Precondition: n ≥ 3, coordinates finite and at most
  /// 1e100. Cost: O(n log n) for most polygons; polygons of many long thin ears can cost more.
  bool cut(std::span<const Point2> corners, std::vector<std::array<Index, 3>>& triangles);

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace limn::mesh
