// Limit points of steps that are sequences of averagings, which look far: against those of finer
// levels, and against where refinement goes.

#include <gtest/gtest.h>

#include <cmath>

#include "limit/wavy_points.h"
#include "limn/limit/limit_points.h"
#include "limn/refine/refine.h"
#include "mesh/random_mesh.h"
#include "support/spline_scheme.h"

namespace limn::test {
namespace {

/// Also at boundaries. Old vertices keep their numbers.
TEST(StagedLimit, IsThatOfFinerLevels) {
  int compared = 0, open = 0;
  for (const int degree : {3, 5, 7}) {
    const Scheme scheme = spline_of_degree(degree);
    for (unsigned seed = 1; seed <= 8; ++seed) {
      SCOPED_TRACE(seed);
      const Mesh mesh = RandomMesh(seed).polygons();
      std::vector<Point3> before;
      for (int level = 0; level <= 2; ++level) {
        const auto fine = refine::refine(scheme, mesh, points_of(mesh), level).value();
        LimitOptions options;
        options.steps_made = level;
        const auto limit = approx_limit_points(scheme, fine.mesh, fine.values, options);
        ASSERT_TRUE(limit.ok()) << degree << ": " << limit.error().text();
        for (std::size_t v = 0; v < before.size(); ++v, ++compared)
          EXPECT_LT(length(limit->positions[v] - before[v]), 1e-11) << degree << ' ' << level;
        before = limit->positions;
      }
      for (Index v = 0; v < mesh.vertex_count(); ++v) open += mesh.is_boundary_vertex(v) ? 1 : 0;
    }
  }
  EXPECT_GT(compared, 1000);
  EXPECT_GT(open, 0);
}

TEST(StagedLimit, IsWhereRefinementGoes) {
  constexpr int kLevels = 5;
  for (const int degree : {3, 5, 7}) {
    const Scheme scheme = spline_of_degree(degree);
    for (const Mesh& mesh :
         {cube(), tetrahedron(), icosahedron(), mesh::fan(Lattice::quad, 3, 2)}) {
      const auto limit = approx_limit_points(scheme, mesh, points_of(mesh)).value();
      const auto fine = refine::refine(scheme, mesh, points_of(mesh), kLevels).value();
      for (std::size_t v = 0; v < limit.positions.size(); ++v)
        EXPECT_LT(length(fine.values[v] - limit.positions[v]), 4 * std::pow(.45, kLevels))
            << degree << ' ' << v;
    }
  }
}

/// Under an even degree a vertex goes to the middle of the face that it becomes.
TEST(StagedLimit, OfEvenDegreeIsWhereItsFaceGoes) {
  constexpr int kLevels = 5;
  for (const int degree : {2, 4, 6}) {
    const Scheme scheme = spline_of_degree(degree);
    for (const Mesh& mesh : {cube(), tetrahedron(), icosahedron()}) {
      const auto limit = approx_limit_points(scheme, mesh, points_of(mesh)).value();
      const auto fine = refine::refine(scheme, mesh, points_of(mesh), kLevels).value();
      // faces come before edges and these before vertices, and a face keeps its number
      for (Index v = 0; v < mesh.vertex_count(); ++v) {
        const Index f = mesh.face_count() + mesh.edge_count() + v;
        Point3 sum;
        for (Index h = fine.mesh.face_begin(f); h < fine.mesh.face_begin(f + 1); ++h)
          sum = sum + fine.values[static_cast<std::size_t>(fine.mesh.origin(h))];
        const Point3 middle = (1.0 / fine.mesh.degree(f)) * sum;
        EXPECT_LT(length(middle - limit.positions[static_cast<std::size_t>(v)]),
                  4 * std::pow(.45, kLevels))
            << degree << ' ' << v;
      }
    }
  }
}

}  // namespace
}  // namespace limn::test
