#pragma once
/// Normals of vertices that have several sides.

#include <vector>

#include "limn/mesh/polygons.h"

namespace limn {

/// Along a crease, and at a corner where creases meet, a surface has a normal on each side. They
/// are given corner by corner; a vertex with one side has its normal elsewhere.
struct SideNormals {
  std::vector<Point3> normals;   ///< of length 1; zero where a side has none
  std::vector<Index> of_corner;  ///< the one of each corner; kNone: its vertex's own. May be empty

  /// Whether no vertex has several sides.
  [[nodiscard]] bool empty() const { return normals.empty(); }
};

}  // namespace limn
