#pragma once
/// Points for meshes whose topology alone matters, and how far two are apart.

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "limn/mesh/polygons.h"

namespace limn::test {

/// In the cube from -1 to 1.
inline std::vector<Point3> random_points(Index count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Point3> points;
  points.reserve(static_cast<std::size_t>(count));
  for (Index i = 0; i < count; ++i)
    points.push_back({uniform(random), uniform(random), uniform(random)});
  return points;
}

/// The largest difference of a coordinate.
inline double distance(Point3 a, Point3 b) {
  return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

}  // namespace limn::test
