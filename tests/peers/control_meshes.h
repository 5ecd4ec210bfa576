#pragma once
/// Control meshes for comparisons with other libraries and for benchmarks: closed and open,
/// with extraordinary vertices, and in general position, all from fixed seeds. What other
/// libraries cannot hold is avoided: two edges between the same vertices, inner vertices of
/// valence 2, isolated vertices.

#include <string>
#include <vector>

#include "limn/mesh/mesh.h"

namespace limn::peers {

struct ControlMesh {
  std::string name;
  Polygons polygons;
};

[[nodiscard]] std::vector<ControlMesh> closed_triangles();
[[nodiscard]] std::vector<ControlMesh> open_triangles();
[[nodiscard]] std::vector<ControlMesh> closed_polygons();
[[nodiscard]] std::vector<ControlMesh> open_polygons();

/// A sphere of 10 * 4^levels + 2 vertices with valences from 3 to `max_valence`: `flips` random
/// edges of a refined icosahedron, flipped.
[[nodiscard]] Polygons random_sphere(int levels, int flips, Index max_valence, unsigned seed);

/// The quads that cut every face of `polygons` at its middle: all valences of vertices and faces
/// become valences of vertices.
[[nodiscard]] Polygons cut_into_quads(const Polygons& polygons);

/// Whether every library can hold the mesh (see above).
[[nodiscard]] bool is_plain(const Polygons& polygons);

}  // namespace limn::peers
