#pragma once
/// Attributes of a mesh that was repaired or cut into triangles.

#include "limn/mesh/attributes/attributes.h"
#include "limn/mesh/polygon/triangulate.h"
#include "limn/mesh/repair/repair.h"

namespace limn::mesh {

/// Of a vertex that was joined with another, that one's numbers stay; its corners keep their
/// texture coordinates, so that a seam stays where those differ, and goes where they are equal. A
/// new corner, where a neighbour of a facet without area was cut, takes the texture coordinates of
/// another corner of its vertex; where there is none, its face has none. `attributes` fit the mesh
/// that was repaired. Cost O(size).
[[nodiscard]] MeshAttributes carried(const MeshAttributes& attributes, const Repaired& repaired);

/// Triangles have what their polygons have. Cost O(size).
[[nodiscard]] MeshAttributes carried(const MeshAttributes& attributes, const Triangulation& cut);

}  // namespace limn::mesh
