#pragma once
/// What the tests of mesh files share: where the data are, and random meshes.

#include <rapidcheck.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "limn/mesh/polygons.h"

namespace limn::test {

inline std::filesystem::path source_dir() {
  return std::filesystem::path(LIMN_TEST_DATA).parent_path().parent_path();
}

/// Any finite double: all exponents, denormals and -0 among them.
inline rc::Gen<double> any_double() {
  return rc::gen::map(rc::gen::arbitrary<std::uint64_t>(), [](std::uint64_t bits) {
    double value = 0;
    std::memcpy(&value, &bits, sizeof(value));
    return std::isfinite(value) ? value : static_cast<double>(bits);
  });
}

/// Any finite float, as a double.
inline rc::Gen<double> any_float() {
  return rc::gen::map(rc::gen::arbitrary<std::uint32_t>(), [](std::uint32_t bits) {
    float value = 0;
    std::memcpy(&value, &bits, sizeof(value));
    return double{std::isfinite(value) ? value : static_cast<float>(bits)};
  });
}

/// Random polygons: not a surface, but every file must keep them.
inline Polygons random_polygons(const rc::Gen<double>& coordinate, int max_degree) {
  Polygons mesh;
  const int vertices = *rc::gen::inRange(1, 12);
  for (int v = 0; v < vertices; ++v)
    mesh.positions.push_back({*coordinate, *coordinate, *coordinate});
  const int faces = *rc::gen::inRange(1, 12);
  for (int f = 0; f < faces; ++f) {
    const int degree = *rc::gen::inRange(3, max_degree + 1);
    for (int k = 0; k < degree; ++k) mesh.corners.push_back(*rc::gen::inRange(0, vertices));
    mesh.face_begin.push_back(static_cast<Index>(mesh.corners.size()));
  }
  return mesh;
}

/// Equality that tells -0 from +0.
inline bool same_bits(const Polygons& a, const Polygons& b) {
  return a == b && std::memcmp(a.positions.data(), b.positions.data(),
                               a.positions.size() * sizeof(Point3)) == 0;
}

/// A cube of quads with side 1.
inline Polygons cube() {
  Polygons mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                    {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  mesh.corners = {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
  mesh.face_begin = {0, 4, 8, 12, 16, 20, 24};
  return mesh;
}

}  // namespace limn::test
