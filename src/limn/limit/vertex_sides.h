#pragma once
/// The sides of a vertex: what creases, and the boundary, make of the faces round it; and how they
/// are found again in parts of the mesh that were refined. Private to crease_limit.

#include <vector>

#include "limn/limit/mesh_part.h"

namespace limn::limit {

/// The half-edges out of a vertex, counterclockwise, side by side.
struct VertexSides {
  std::vector<Index> halfedges;
  std::vector<std::size_t> begins;  ///< where each side begins, and the end
  Index last = kNone;               ///< the vertex at the end of the last side
  bool open = false;                ///< whether the vertex is on the boundary

  [[nodiscard]] std::size_t count() const { return begins.size() - 1; }
};

/// Of vertex v, which is not isolated, by the infinitely sharp edges that are not on the boundary.
/// The first side begins at the boundary, else at such an edge. A vertex amid the surface with one
/// such edge, or none, has one side. Cost O(valence).
[[nodiscard]] VertexSides sides_of(const Mesh& mesh, const Sharpness& sharpness, Index v);

/// Gives the infinitely sharp edges at vertex v of the mesh that a part was cut out of names, by
/// which `same_sides` knows them when the part was refined.
void name_edges(const Mesh& mesh, const Sharpness& sharpness, Index v, const PartCutter& cutter,
                MeshPart& part);
/// The sides of a centre of the part, in the order of `sides` of the vertex v that it stands for;
/// none of them where edges have lost their names, as by splits with a boundary that rests.
[[nodiscard]] VertexSides same_sides(const MeshPart& part, Index centre, const Mesh& mesh,
                                     const VertexSides& sides);

/// The normal of each side's faces, where the vertex is at 0: the sum of theirs by area, of length
/// 1, or zero.
[[nodiscard]] std::vector<Point3> normals_of_faces(const Mesh& mesh,
                                                   const std::vector<Point3>& values,
                                                   const VertexSides& sides);

}  // namespace limn::limit
