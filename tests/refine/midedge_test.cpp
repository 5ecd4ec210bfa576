// Mid-edge at boundaries, where its steps take turns.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "limn/refine/refine.h"
#include "mesh/random_mesh.h"
#include "support/random_points.h"
#include "support/shipped.h"
#include "support/valences.h"

namespace limn::test {
namespace {

/// Every corner of the control mesh gives (previous + 2 own + next)/4, whatever lies beyond its
/// face: no point of a closing edge is left.
TEST(MidEdgeScheme, TwoStepsTakeEachCornerToTheMiddleOfItsMiddles) {
  EXPECT_TRUE(rc::check([](unsigned seed) {
    const Mesh mesh = RandomMesh(seed).polygons();
    RC_PRE(!has_inner_vertex_of_valence_two(mesh));
    const std::vector<Point3> points = random_points(mesh.vertex_count(), seed);
    const auto fine = refine::refine(shipped("midedge"), mesh, points, 2);
    RC_ASSERT(fine.ok());
    RC_ASSERT(fine->mesh.check() == "");
    for (Index h = 0; h < mesh.halfedge_count(); ++h) {
      const Index at = mesh.target(h), next = mesh.target(mesh.next(h));
      const Point3 corner = 0.25 * (points[mesh.origin(h)] + 2 * points[at] + points[next]);
      RC_ASSERT(distance(fine->values[h], corner) < 1e-14);
    }
  }));
}

/// A plane's refined mesh lies inside it, its boundary half a face and less within the old one.
TEST(MidEdgeScheme, RecedesByLessThanHalfAFace) {
  constexpr Index kSide = 6;
  Faces faces;
  std::vector<Point3> points;
  for (Index j = 0; j <= kSide; ++j)
    for (Index i = 0; i <= kSide; ++i) {
      points.push_back({double(i), double(j), 0});
      const Index v = j * (kSide + 1) + i;
      if (i < kSide && j < kSide) faces.push_back({v, v + 1, v + kSide + 2, v + kSide + 1});
    }
  const Mesh mesh = must_build(static_cast<Index>(points.size()), faces);
  for (const int levels : {2, 4, 6}) {
    const auto fine = refine::refine(shipped("midedge"), mesh, points, levels).value();
    double least = kSide, most = 0;
    for (const Point3& p : fine.values) {
      least = std::min(least, p.x);
      most = std::max(most, p.x);
    }
    const double gap = (1 - std::pow(2, -levels / 2)) / 2;
    EXPECT_NEAR(least, gap, 1e-12) << levels;
    EXPECT_NEAR(most, kSide - gap, 1e-12) << levels;
    EXPECT_EQ(boundary_loops(fine.mesh), 1);
  }
}

}  // namespace
}  // namespace limn::test
