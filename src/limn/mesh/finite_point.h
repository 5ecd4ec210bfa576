#pragma once
/// Whether the coordinates of a point are numbers.

#include <cmath>

#include "limn/mesh/polygons.h"

namespace limn::mesh {

/// Neither infinite nor NaN.
[[nodiscard]] inline bool is_finite(const Point3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace limn::mesh
