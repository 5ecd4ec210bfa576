#pragma once
/// Polygons in space cut into triangles. [what `limn refine --triangulate` does]

#include <array>
#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/polygon/ear_clipping.h"
#include "limn/mesh/polygons.h"

namespace limn::mesh {

/// Cuts one face after the other; keeps its memory.
class FaceCutter {
 public:
  explicit FaceCutter(const Polygons& polygons) : polygons_(polygons) {}

  /// The triangles of the face, as numbers of its corners from 0: degree - 2 of them, in the face's
  /// direction; until the next call. A fan from corner `apex`, or else the first, where each
  /// triangle of that is positive as seen along the face's normal (Newell's, of its best-fitting
  /// plane); else by ear clipping in that plane. `gave_up` is then true where the face crosses
  /// itself in the plane or has no area: it is cut all the same. Not looked at where a corner is no
  /// vertex.
  const std::vector<std::array<Index, 3>>& cut(Index face, bool& gave_up, Index apex = 0);

 private:
  [[nodiscard]] bool project(Index face);
  [[nodiscard]] bool fan_is_positive(Index apex) const;
  void fan(Index degree, Index apex);

  const Polygons& polygons_;
  EarClipper clipper_;
  std::vector<Point3> scaled_;
  std::vector<Point2> plane_;
  std::vector<std::array<Index, 3>> triangles_;
};

struct Triangulation {
  Polygons polygons;             ///< the same vertices; triangles in the order of their polygons
  std::vector<Index> face_of;    ///< the polygon of each triangle
  std::vector<Index> corner_of;  ///< the corner of the input, of all its corners, that each is
  std::vector<Index> gave_up;    ///< polygons whose triangles overlap or have no area
};

/// Every polygon of more than three corners cut into triangles by a `FaceCutter`. Where two faces
/// share both edges of a vertex they are cut from there: both could else get the same diagonal,
/// opposite the vertex, and a triangle twice. Refused: offsets
/// that do not fit the corners, and results that are `too_many` (mesh_limits.h). A face of fewer
/// corners is kept, for `Mesh::build` to refuse. Cost O(corners) where fans do; else see
/// EarClipper.
[[nodiscard]] Result<Triangulation> triangulate(const Polygons& polygons);

/// "2 polygons cross themselves or have no area…", with the first in the numbers of `source`; none
/// where nothing gave up.
[[nodiscard]] Warnings warnings_of(const Triangulation& cut, const MeshSource& source);

/// The source of the triangles: `source` is that of the polygons.
[[nodiscard]] MeshSource source_of(const Triangulation& cut, const MeshSource& source);

}  // namespace limn::mesh
