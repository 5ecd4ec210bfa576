#include "limn/mesh/repair/face_shape.h"

#include <algorithm>
#include <cmath>

#include "limn/mesh/io/stl_slivers.h"

namespace limn::mesh::detail {

bool is_flat_face(const Polygons& polygons, Index face) {
  const auto corner = [&](Index c) { return polygons.positions[polygons.corners[c]]; };
  const Index first = polygons.face_begin[face], last = polygons.face_begin[face + 1];
  if (first == last) return true;
  Index other = first;  // in another place than the first
  while (other < last && corner(other) == corner(first)) ++other;
  for (Index c = other; c < last; ++c)
    if (!io::lie_on_a_line(corner(first), corner(other), corner(c))) return false;
  return true;
}

FaceShape FaceShapes::of(Index face) {
  FaceShape shape;
  shape.flat = is_flat_face(polygons_, face);
  if (shape.flat || polygons_.degree(face) == 3) return shape;
  corners_.clear();
  const Point3 from = polygons_.positions[polygons_.corners[polygons_.face_begin[face]]];
  double size = 0;
  for (Index c = polygons_.face_begin[face]; c < polygons_.face_begin[face + 1]; ++c) {
    const Point3 p = polygons_.positions[polygons_.corners[c]];
    // halves, as the difference of two doubles may be none
    corners_.push_back(0.5 * p - 0.5 * from);
    for (const double x : {corners_.back().x, corners_.back().y, corners_.back().z})
      size = std::max(size, std::abs(x));
  }
  const auto count = static_cast<double>(corners_.size());
  Point3 centroid, normal;
  for (Point3& p : corners_) {
    p = {p.x / size, p.y / size, p.z / size};
    centroid = centroid + (1 / count) * p;
  }
  for (std::size_t i = 0; i < corners_.size(); ++i)
    normal = normal + cross(corners_[i], corners_[(i + 1) % corners_.size()]);
  const double length = std::sqrt(dot(normal, normal));
  if (!(length > 0)) return shape;  // a face that is crossed, as an 8
  constexpr double kRounding = 1e-9;
  double farthest = 0, diameter = 0;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Point3 a = corners_[i], b = corners_[(i + 1) % corners_.size()],
                 c = corners_[(i + 2) % corners_.size()];
    shape.concave = shape.concave || dot(cross(b - a, c - b), normal) < -kRounding * length;
    farthest = std::max(farthest, std::abs(dot(a - centroid, normal)) / length);
    diameter = std::max(diameter, 2 * std::sqrt(dot(a - centroid, a - centroid)));
  }
  shape.off_plane = farthest / diameter;
  return shape;
}

}  // namespace limn::mesh::detail
