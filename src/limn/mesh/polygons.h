#pragma once
/// A control mesh exactly as a file or a caller gives it: points and polygons, in
/// order, with nothing merged, dropped, triangulated or reoriented. It may be
/// non-manifold; `Mesh::build` (mesh.h) is where that is refused.

#include <cstdint>
#include <span>
#include <vector>

namespace limn {

/// Indices of vertices, edges, faces and half-edges. A mesh holds fewer than 2^31 half-edges.
using Index = std::int32_t;
/// No vertex, edge, face or half-edge.
inline constexpr Index kNone = -1;

/// A point or a vector of space, in the caller's unit of length.
struct Point3 {
  double x = 0;  ///< first coordinate
  double y = 0;  ///< second coordinate
  double z = 0;  ///< third coordinate
  /// Equal coordinates; -0 equals 0.
  friend bool operator==(const Point3&, const Point3&) = default;
};

///@{
/// Sums, multiples, scalar and cross products of vectors, in double precision.
inline Point3 operator+(Point3 a, Point3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Point3 operator-(Point3 a, Point3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Point3 operator*(double s, Point3 a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(Point3 a, Point3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Point3 cross(Point3 a, Point3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
///@}

/// The coordinates of points, x, y, z of each, one after the other: 3 · points.size() numbers, in
/// place. Cost O(1).
[[nodiscard]] inline std::span<const double> numbers_of(const std::vector<Point3>& points) {
  static_assert(sizeof(Point3) == 3 * sizeof(double));
  return points.empty() ? std::span<const double>()
                        : std::span<const double>(&points.front().x, 3 * points.size());
}
/// The same, to write them.
[[nodiscard]] inline std::span<double> numbers_of(std::vector<Point3>& points) {
  return points.empty() ? std::span<double>()
                        : std::span<double>(&points.front().x, 3 * points.size());
}

/// Points and polygons, in order.
struct Polygons {
  std::vector<Point3> positions;     ///< one per vertex
  std::vector<Index> face_begin{0};  ///< F+1 offsets into `corners`
  std::vector<Index> corners;        ///< vertex of each corner, face by face, in the order given

  /// V, the number of positions.
  [[nodiscard]] Index vertex_count() const { return static_cast<Index>(positions.size()); }
  /// F, the number of polygons.
  [[nodiscard]] Index face_count() const { return static_cast<Index>(face_begin.size()) - 1; }
  /// The number of corners of a face, 0 ≤ face < F.
  [[nodiscard]] Index degree(Index face) const { return face_begin[face + 1] - face_begin[face]; }

  /// The same numbers in the same order.
  friend bool operator==(const Polygons&, const Polygons&) = default;
};

/// Every polygon of more than three corners cut into triangles, concave ones too: `triangulate`
/// (triangulate.h) without what it has to say; what that refuses is a std::length_error here.
/// Polygons keep their order. Cost O(corners), more where polygons are concave.
[[nodiscard]] Polygons triangulated(const Polygons& polygons);

}  // namespace limn
