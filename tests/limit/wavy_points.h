#pragma once
/// Points for meshes whose limits are compared, without pattern and the same on every machine.

#include <cmath>
#include <vector>

#include "limn/mesh/mesh.h"
#include "limn/mesh/polygons.h"

namespace limn::test {

inline double length(const Point3& a) { return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z); }

inline std::vector<Point3> points_of(const Mesh& mesh) {
  std::vector<Point3> points;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    points.push_back({std::sin(v), std::cos(3.0 * v), std::sin(5.0 * v)});
  return points;
}

}  // namespace limn::test
