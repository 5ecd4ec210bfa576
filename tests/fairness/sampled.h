#pragma once
/// Meshes whose vertices lie on known smooth surfaces.

#include <Eigen/Geometry>
#include <vector>

#include "limn/mesh/lattice.h"
#include "mesh/random_mesh.h"
#include "support/smooth_surface.h"

namespace limn::test {

struct Sampled {
  Mesh mesh;
  std::vector<Point3> points;
};

inline Point3 point_of(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }
inline Eigen::Vector3d vector_of(const Point3& p) { return {p.x, p.y, p.z}; }

/// Equal steps of both parameters; `shear` bends the parameter lines, so that nothing is symmetric.
inline Sampled sampled_tube(const Tube& tube, Lattice lattice, Index n, double shear = 0.4) {
  Sampled result{mesh::torus(lattice, 2 * n, n), {}};
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < 2 * n; ++i) {
      const double v = 2 * std::numbers::pi * j / n;
      const double u = std::numbers::pi * i / n + shear * std::sin(v);
      result.points.push_back(point_of(tube.at(u, v)));
    }
  return result;
}

/// The convex hull of points whose faces are all triangles with edges of that length, or all quads.
inline Sampled regular_polyhedron(const std::vector<Eigen::Vector3d>& corners, double edge) {
  Faces faces;
  const auto count = static_cast<Index>(corners.size());
  const auto near = [&](Index a, Index b) {
    return std::abs((corners[a] - corners[b]).norm() - edge) < 1e-9;
  };
  for (Index a = 0; a < count; ++a)
    for (Index b = a + 1; b < count; ++b)
      for (Index c = a + 1; c < count; ++c)
        if (near(a, b) && near(b, c) && near(c, a) &&
            corners[a].dot(corners[b].cross(corners[c])) > 0)
          faces.push_back({a, b, c});
  Sampled result{must_build(count, faces), {}};
  for (const auto& p : corners) result.points.push_back(point_of(p.normalized()));
  return result;
}

inline Sampled tetrahedron_on_sphere() {
  return regular_polyhedron({{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}}, std::sqrt(8.0));
}
inline Sampled octahedron_on_sphere() {
  return regular_polyhedron({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                            std::sqrt(2.0));
}
inline Sampled icosahedron_on_sphere() {
  std::vector<Eigen::Vector3d> corners;
  for (const double a : {-1.0, 1.0})
    for (const double b : {-std::numbers::phi, std::numbers::phi}) {
      corners.emplace_back(0, a, b);
      corners.emplace_back(a, b, 0);
      corners.emplace_back(b, 0, a);
    }
  return regular_polyhedron(corners, 2);
}
inline Sampled cube_on_sphere() {
  Sampled result{
      must_build(
          8, {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}),
      {}};
  for (const double z : {-1.0, 1.0})
    for (const auto& [x, y] :
         {std::pair{-1, -1}, std::pair{1, -1}, std::pair{1, 1}, std::pair{-1, 1}})
      result.points.push_back(point_of(Eigen::Vector3d(x, y, z).normalized()));
  return result;
}

/// Dyadic splits, every new vertex at the mean of its edge or face, moved out onto the sphere.
inline Sampled refined_on_sphere(Sampled sphere, int steps) {
  const Split& split =
      *find_split(sphere.mesh.uniform_degree() == 3 ? "triangle-dyadic" : "quad-dyadic");
  for (int step = 0; step < steps; ++step) {
    const Mesh& mesh = sphere.mesh;
    SplitResult fine = split.apply(mesh, step);
    std::vector<Point3> points = sphere.points;
    const auto push = [&](const Eigen::Vector3d& p) { points.push_back(point_of(p.normalized())); };
    for (Index e = 0; e < fine.births.from_edges; ++e) {
      const Index h = mesh.halfedge_of_edge(e);
      push(vector_of(sphere.points[mesh.origin(h)]) + vector_of(sphere.points[mesh.target(h)]));
    }
    for (Index f = 0; f < fine.births.from_faces; ++f) {
      Eigen::Vector3d sum(0, 0, 0);
      for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h)
        sum += vector_of(sphere.points[mesh.origin(h)]);
      push(sum);
    }
    sphere = {std::move(fine.mesh), std::move(points)};
  }
  return sphere;
}

}  // namespace limn::test
