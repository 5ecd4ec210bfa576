#include <gtest/gtest.h>

#include "random_mesh.h"

namespace limn::test {
namespace {

TEST(Polygons, TriangulatedCutsFansFromTheFirstCorner) {
  Polygons mixed = make_polygons(7, {{4, 0, 1}, {2, 3, 4, 5, 6}, {0, 1, 2, 3}});
  mixed.positions[6] = {1, 2, 3};
  const Polygons cut = triangulated(mixed);
  EXPECT_EQ(faces_of(cut),
            (Faces{{4, 0, 1}, {2, 3, 4}, {2, 4, 5}, {2, 5, 6}, {0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(cut.positions, mixed.positions);
}

TEST(Polygons, TriangulatedKeepsTrianglesAndHidesNoFault) {
  const Polygons triangles = make_polygons(4, {{0, 1, 2}, {2, 1, 3}});
  EXPECT_EQ(triangulated(triangles), triangles);
  const Polygons with_two_gon = make_polygons(4, {{0, 1}, {0, 1, 2}});
  EXPECT_EQ(triangulated(with_two_gon), with_two_gon);
  EXPECT_EQ(triangulated(Polygons{}), Polygons{});
}

}  // namespace
}  // namespace limn::test
