#include <array>
#include <cmath>
#include <numbers>

#include "limn/mesh/lattice.h"
#include "papers/kawaharada_parts.h"

namespace limn::ks {
namespace {

constexpr Index kAround = 12, kAcross = 6;   // edges of the torus
constexpr double kMajor = 1, kMinor = 0.45;  // its radii
constexpr Index kRings = 4;                  // round the raised vertex

/// Vertex i is the corner with the bits of i as coordinates; the diagonals join the corners with an
/// even number of ones.
constexpr std::array<std::array<Index, 3>, 12> kCube{{{0, 6, 2},
                                                      {6, 0, 4},
                                                      {3, 5, 1},
                                                      {5, 3, 7},
                                                      {5, 0, 1},
                                                      {0, 5, 4},
                                                      {6, 3, 2},
                                                      {3, 6, 7},
                                                      {0, 3, 1},
                                                      {3, 0, 2},
                                                      {5, 6, 4},
                                                      {6, 5, 7}}};

double turn(double part) { return 2 * std::numbers::pi * part; }

}  // namespace

Control torus_control() {
  std::vector<Point3> points;
  for (Index j = 0; j < kAcross; ++j)
    for (Index i = 0; i < kAround; ++i) {
      const double u = turn(static_cast<double>(i) / kAround);
      const double v = turn(static_cast<double>(j) / kAcross);
      const double radius = kMajor + kMinor * std::cos(v);
      points.push_back({radius * std::cos(u), radius * std::sin(u), kMinor * std::sin(v)});
    }
  return {"torus",
          "a torus of 12 × 6 vertices, each with six edges",
          mesh::torus(Lattice::triangle, kAround, kAcross),
          std::move(points),
          5,
          -60,
          40};
}

Control cube_control() {
  Polygons cube;
  for (Index i = 0; i < 8; ++i)
    cube.positions.push_back({static_cast<double>(i & 1), static_cast<double>((i >> 1) & 1),
                              static_cast<double>((i >> 2) & 1)});
  for (const auto& triangle : kCube) {
    cube.corners.insert(cube.corners.end(), triangle.begin(), triangle.end());
    cube.face_begin.push_back(static_cast<Index>(cube.corners.size()));
  }
  return {"cube",
          "a cube with a diagonal in each face: four vertices have three edges, four have six",
          Mesh::build(cube).value(),
          cube.positions,
          6,
          -56,
          26};
}

Control raised_control(int valence) {
  Mesh mesh = mesh::star(Lattice::triangle, valence, kRings);
  std::vector<Point3> points{{0, 0, 1}};
  for (Index ring = 1; ring <= kRings; ++ring)
    for (Index sector = 0; sector < valence; ++sector)
      for (Index k = 0; k < ring; ++k) {
        const double from = turn(sector / static_cast<double>(valence));
        const double to = turn((sector + 1) / static_cast<double>(valence));
        points.push_back({(ring - k) * std::cos(from) + k * std::cos(to),
                          (ring - k) * std::sin(from) + k * std::sin(to), 0});
      }
  return {"raised",
          "a flat regular mesh with one vertex raised by 1",
          std::move(mesh),
          std::move(points),
          5,
          -70,
          22};
}

}  // namespace limn::ks
