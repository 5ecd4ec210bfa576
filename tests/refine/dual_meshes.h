#pragma once
/// Meshes for tests of dual splits.

#include "limn/mesh/lattice.h"
#include "mesh/random_mesh.h"

namespace limn::test {

inline std::vector<Mesh> bodies() {
  return {tetrahedron(),
          cube(),
          icosahedron(),
          mesh::torus(Lattice::quad, 3, 4),
          mesh::torus(Lattice::triangle, 3, 4),
          pillow(3),
          pillow(5)};
}

/// Meshes with boundary whose faces have all kinds of corners.
inline std::vector<Mesh> open_meshes() {
  std::vector<Mesh> meshes{must_build(3, {{0, 1, 2}}), must_build(6, {{0, 1, 2, 3}, {1, 0, 4, 5}}),
                           must_build(7, {{0, 1, 2, 3}, {4, 5, 6}})};
  for (const Lattice lattice : {Lattice::triangle, Lattice::quad}) {
    for (const Index n : {3, 4, 5, 9}) {
      meshes.push_back(mesh::star(lattice, n, 1));
      meshes.push_back(mesh::star(lattice, n, 2));
      meshes.push_back(mesh::fan(lattice, n - 2, 2));
      meshes.push_back(mesh::face_star(n, 2));
    }
    meshes.push_back(mesh::tree(lattice, 2));
  }
  return meshes;
}

}  // namespace limn::test
