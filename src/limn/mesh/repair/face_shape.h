#pragma once
/// The shape of single faces. Private to mesh/.

#include <vector>

#include "limn/mesh/polygons.h"

namespace limn::mesh::detail {

/// Whether all corners of a face lie on a line, or in one place: exact, at any size. Preconditions:
/// the corners are vertices, their positions are finite. Cost O(corners).
[[nodiscard]] bool is_flat_face(const Polygons& polygons, Index face);

struct FaceShape {
  bool flat = false;     ///< without area: `is_flat_face`; then nothing else is said
  bool concave = false;  ///< in its plane it turns the other way at a corner
  double off_plane = 0;  ///< how far a corner is off the plane at most, in parts of the diameter
};

/// One face after the other; keeps its memory.
class FaceShapes {
 public:
  explicit FaceShapes(const Polygons& polygons) : polygons_(polygons) {}
  /// Of the plane through the centroid across Newell's normal. Preconditions as `is_flat_face`.
  [[nodiscard]] FaceShape of(Index face);

 private:
  const Polygons& polygons_;
  std::vector<Point3> corners_;  // from the centroid, of size about 1
};

}  // namespace limn::mesh::detail
