#pragma once
/// Clean meshes at random places, and faults put into them.

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "limn/mesh/repair/repair.h"
#include "mesh/random_mesh.h"

namespace limn::test {

/// Positions in general position: no two in one place, no three on a line.
inline std::vector<Point3> random_places(Index count, std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  std::vector<Point3> places;
  for (Index v = 0; v < count; ++v)
    places.push_back({number(random), number(random), number(random)});
  return places;
}

inline Polygons placed(const Mesh& mesh, std::mt19937& random) {
  return mesh.polygons(random_places(mesh.vertex_count(), random));
}

inline Polygons with_faces(const Polygons& polygons, const Faces& faces) {
  Polygons result = make_polygons(polygons.vertex_count(), faces);
  result.positions = polygons.positions;
  return result;
}

/// Few vertices and places, and many faces: every fault is frequent, and so is every mixture.
inline Polygons rubble(unsigned seed) {
  std::mt19937 random(seed);
  const unsigned vertices = 3 + random() % 8, faces = 1 + random() % 9, side = 2 + random() % 3;
  const bool triangles = random() % 2 == 0;
  Faces list;
  for (unsigned f = 0; f < faces; ++f) {
    std::vector<Index> face(triangles ? 3 : 2 + random() % 4);
    for (Index& v : face) v = static_cast<Index>(random() % vertices);
    list.push_back(face);
  }
  Polygons polygons = make_polygons(static_cast<Index>(vertices), list);
  for (Point3& p : polygons.positions)
    p = {double(random() % side), double(random() % side), double(random() % side)};
  return polygons;
}

/// Its faces, with other names for the vertices.
inline std::vector<std::vector<Index>> named_by(const Polygons& polygons,
                                                const std::vector<Index>& names) {
  std::vector<std::vector<Index>> faces = faces_of(polygons);
  for (auto& face : faces)
    for (Index& v : face) v = names[static_cast<std::size_t>(v)];
  return faces;
}

}  // namespace limn::test
