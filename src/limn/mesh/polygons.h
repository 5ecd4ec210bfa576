#pragma once
/// A control mesh exactly as a file or a caller gives it: points and polygons, in
/// order, with nothing merged, dropped, triangulated or reoriented. It may be
/// non-manifold; `Mesh::build` (mesh.h) is where that is refused.

#include <cstdint>
#include <span>
#include <string>
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

// Where the vertices and faces of a mesh come from, so that a message speaks in the numbers and
// lines of the file that a user has, not in limn's own.

/// The file of a mesh, and which of its lines and numbers the vertices and faces come from.
struct MeshSource {
  std::string file;               ///< as the user named it; empty: no file
  Index first = 0;                ///< the number of the first vertex and face: 1 in OBJ, else 0
  std::vector<int> vertex_lines;  ///< line of each vertex, from 1; empty: binary, or no file
  std::vector<int> face_lines;    ///< line of each face that the file has
  /// The place of each face among those of the file, from 0, where that is not the face's own
  /// index: facets were dropped, or polygons cut into triangles. Empty: its own index.
  std::vector<Index> file_faces;
  /// The same of vertices, where some were joined or copied.
  std::vector<Index> file_vertices;
  /// Of each vertex of the file the one that it was joined with, itself where there is none. Empty:
  /// none was.
  std::vector<Index> joined_with;

  /// The number among the file's faces, from 0, of a face of the mesh.
  [[nodiscard]] Index file_face(Index face) const {
    return file_faces.empty() ? face : file_faces[static_cast<std::size_t>(face)];
  }
  /// The number among the file's vertices, from 0, of a vertex of the mesh; of what is no vertex,
  /// itself.
  [[nodiscard]] Index file_vertex(Index vertex) const {
    const bool known = vertex >= 0 && static_cast<std::size_t>(vertex) < file_vertices.size();
    return known ? file_vertices[static_cast<std::size_t>(vertex)] : vertex;
  }
  /// Its line; 0 where none is known.
  [[nodiscard]] int face_line(Index face) const { return line(face_lines, file_face(face)); }
  /// Its line; 0 where none is known.
  [[nodiscard]] int vertex_line(Index vertex) const {
    return line(vertex_lines, file_vertex(vertex));
  }

 private:
  static int line(const std::vector<int>& lines, Index number) {
    const bool known = number >= 0 && static_cast<std::size_t>(number) < lines.size();
    return known ? lines[static_cast<std::size_t>(number)] : 0;
  }
};

}  // namespace limn
