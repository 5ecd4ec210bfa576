/// Where control edges run: on a regular mesh they are straight, on every mesh they are whole.

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "limn/mesh/lattice.h"
#include "limn/mesh/split/edge_paths.h"

namespace limn {
namespace {

constexpr Index kSide = 6;

struct Grid {
  Mesh mesh;
  std::vector<Point3> points;
};

/// A parallelogram of the lattice, with a boundary.
Grid grid(Lattice lattice) {
  Polygons polygons;
  const auto number = [](Index i, Index j) { return j * (kSide + 1) + i; };
  for (Index j = 0; j <= kSide; ++j)
    for (Index i = 0; i <= kSide; ++i) {
      const double x = i, y = j;
      polygons.positions.push_back(lattice == Lattice::triangle
                                       ? Point3{x - y / 2, y * std::sqrt(3) / 2, 0}
                                       : Point3{x, y, 0});
    }
  polygons.face_begin = {0};
  const auto face = [&](std::vector<Index> corners) {
    polygons.corners.insert(polygons.corners.end(), corners.begin(), corners.end());
    polygons.face_begin.push_back(static_cast<Index>(polygons.corners.size()));
  };
  for (Index j = 0; j < kSide; ++j)
    for (Index i = 0; i < kSide; ++i) {
      const Index a = number(i, j), b = number(i + 1, j), c = number(i + 1, j + 1),
                  d = number(i, j + 1);
      if (lattice == Lattice::triangle) {
        face({a, b, c});
        face({a, c, d});
      } else {
        face({a, b, c, d});
      }
    }
  return {Mesh::build(polygons).value(), polygons.positions};
}

Point3 mean_of_face(const Mesh& mesh, Index f, const std::vector<Point3>& points) {
  Point3 sum;
  for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h)
    sum = sum + points[mesh.origin(h)];
  return (1.0 / mesh.degree(f)) * sum;
}

/// Each new vertex in the middle of what it is born from, at a third of it, or halfway there.
std::vector<Point3> born(const Split& split, const Mesh& mesh, const Births& births,
                         const std::vector<Point3>& points) {
  std::vector<Point3> made(points.begin(), points.begin() + births.from_vertices);
  for (Index i = 0; i < births.from_edges; ++i) {
    const EdgeChild child = edge_child(mesh, births, i);
    Point3 a = points[mesh.origin(child.halfedge)], b = points[mesh.target(child.halfedge)];
    if (child.at_target) std::swap(a, b);
    made.push_back(child.third ? (1.0 / 3) * (2.0 * a + b) : 0.5 * (a + b));
  }
  for (Index i = 0; i < births.from_faces; ++i)
    made.push_back(mean_of_face(
        mesh, births.faces.empty() ? i : births.faces[static_cast<std::size_t>(i)], points));
  for (Index h = 0; h < births.from_corners; ++h) {
    const double far = split.is_dual() ? 0.5 : 2.0 / 3;
    made.push_back((1 - far) * points[mesh.origin(h)] +
                   far * mean_of_face(mesh, mesh.face(h), points));
  }
  for (const Index v : births.isolated) made.push_back(points[v]);
  return made;
}

std::vector<Point3> refined(const Split& split, Mesh mesh, std::vector<Point3> points, int levels) {
  for (int step = 0; step < levels; ++step) {
    SplitResult fine = split.apply(mesh, step);
    points = born(split, mesh, fine.births, points);
    mesh = std::move(fine.mesh);
  }
  return points;
}

Point3 point_of(const mesh::EdgePaths& paths, Index p, const std::vector<Point3>& points) {
  const std::size_t first = paths.begin[static_cast<std::size_t>(p)],
                    last = paths.begin[static_cast<std::size_t>(p) + 1];
  Point3 sum;
  for (std::size_t i = first; i < last; ++i) sum = sum + points[paths.vertices[i]];
  return (1.0 / static_cast<double>(last - first)) * sum;
}

TEST(EdgePaths, AreStraightAndWholeOnARegularMesh) {
  for (const Split& split : splits()) {
    const auto [mesh, points] = grid(split.lattice);
    for (int levels = 0; levels <= 4; ++levels) {
      SCOPED_TRACE(std::string(split.name) + ", level " + std::to_string(levels));
      const mesh::EdgePaths paths = mesh::edge_paths(split, mesh, levels);
      const std::vector<Point3> fine = refined(split, mesh, points, levels);
      std::vector<double> length(static_cast<std::size_t>(mesh.edge_count()));
      for (const auto& [from, to, edge] : paths.segments) {
        const Index h = mesh.halfedge_of_edge(edge);
        const Point3 a = points[mesh.origin(h)], along = points[mesh.target(h)] - a;
        const Point3 p = point_of(paths, from, fine), q = point_of(paths, to, fine);
        for (const Point3& at : {p, q}) {
          const Point3 across = cross(along, at - a);
          EXPECT_LT(dot(across, across), 1e-20);
          EXPECT_GT(dot(along, at - a), -1e-9);
          EXPECT_LT(dot(along, at - a), 1 + 1e-9);
        }
        length[static_cast<std::size_t>(edge)] += std::sqrt(dot(q - p, q - p));
      }
      for (Index e = 0; e < mesh.edge_count(); ++e) {
        const Index h = mesh.halfedge_of_edge(e);
        const bool inside =
            !mesh.is_boundary_vertex(mesh.origin(h)) && !mesh.is_boundary_vertex(mesh.target(h));
        if (inside || !split.is_dual()) {
          EXPECT_NEAR(length[static_cast<std::size_t>(e)], 1, 1e-9) << e;
        }
      }
    }
  }
}

/// How many segments an edge has.
Index pieces(const Split& split, int levels) {
  Index count = 1;
  const Index cut = split.births.thirds ? 3 : split.boundary_rests() ? split.odd_step_cut : 2;
  const bool slow = split.boundary_rests() || split.name == "midedge";
  for (int step = slow ? 1 : 0; step < levels; step += slow ? 2 : 1) count *= cut;
  if (levels % 2 == 1 && slow) count *= 2;  // and the middle of what is crossed
  return count;
}

TEST(EdgePaths, AreChainsFromEndToEndRoundEveryVertex) {
  for (const Split& split : splits()) {
    for (const Index valence : {3, 4, 5, 7}) {
      const Mesh mesh = mesh::star(split.lattice, valence, 2);
      for (int levels = 1; levels <= 3; ++levels) {
        SCOPED_TRACE(std::string(split.name) + " " + std::to_string(valence) + ", level " +
                     std::to_string(levels));
        const mesh::EdgePaths paths = mesh::edge_paths(split, mesh, levels);
        std::map<Index, std::map<Index, int>> met;  // of each edge how often each point
        std::map<Index, Index> count;
        for (const auto& [from, to, edge] : paths.segments) {
          ++met[edge][from];
          ++met[edge][to];
          ++count[edge];
        }
        for (Index e = 0; e < mesh.edge_count(); ++e) {
          const Index h = mesh.halfedge_of_edge(e);
          const bool inside =
              !mesh.is_boundary_vertex(mesh.origin(h)) && !mesh.is_boundary_vertex(mesh.target(h));
          const bool on_boundary = mesh.is_boundary_edge(e);
          if (split.is_dual() && !inside) continue;
          if (split.boundary_rests() && on_boundary) continue;
          EXPECT_EQ(count[e], pieces(split, levels)) << e;
          Index ends = 0;
          for (const auto& [point, times] : met[e]) {
            EXPECT_LE(times, 2);
            ends += times == 1 ? 1 : 0;
          }
          EXPECT_EQ(ends, 2) << e;
        }
      }
    }
  }
}

}  // namespace
}  // namespace limn
