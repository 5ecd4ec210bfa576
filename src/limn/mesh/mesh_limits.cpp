#include "limn/mesh/mesh_limits.h"

#include <algorithm>
#include <cmath>

namespace limn::mesh {

namespace {

double largest_coordinate(const std::vector<Point3>& positions) {
  double size = 0;
  for (const Point3& p : positions)
    for (const double x : {p.x, p.y, p.z})
      if (std::isfinite(x)) size = std::max(size, std::abs(x));
  return size;
}

}  // namespace

Status check_differences(const std::vector<Point3>& positions) {
  constexpr double kMost = 1e307;
  if (largest_coordinate(positions) <= kMost) return Done{};
  return Error{"the coordinates are so large that lengths are beyond what numbers can hold",
               "scale the control mesh down"};
}

Status check_squares(const std::vector<Point3>& positions) {
  constexpr double kMost = 1e150, kLeast = 1e-150;
  const double size = largest_coordinate(positions);
  if (size > kMost)
    return Error{
        "the coordinates are so large that squares of lengths are beyond what numbers can hold",
        "scale the control mesh down"};
  if (size > 0 && size < kLeast)
    return Error{
        "the coordinates are so small that squares of lengths are below what numbers can hold",
        "scale the control mesh up"};
  return Done{};
}

}  // namespace limn::mesh
