// Numbers and faces of dual splits' levels, and the places of their stars.

#include <numeric>

#include "fast/fast_check.h"
#include "limn/fast/layout/dual_layout.h"
#include "limn/fast/sites/dual_places.h"
#include "refine/dual_meshes.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

/// Every point has a number of its own, and isolated vertices the last.
TEST(FastDualLayout, NumbersEachPointOnce) {
  std::vector<Mesh> meshes = open_meshes();
  for (const Mesh& mesh : bodies()) meshes.push_back(mesh);
  for (const Mesh& mesh : meshes) {
    const fast::DualCorners corners(mesh);
    for (const Index n : {1, 2, 4}) {
      const fast::DualLayout layout(corners, n);
      std::vector<int> met(static_cast<std::size_t>(layout.vertex_count()), 0);
      for (Index h = 0; h < mesh.halfedge_count(); ++h)
        for (Index y = 0; y < n; ++y)
          for (Index x = 0; x < n; ++x) {
            const bool there = corners.is_whole(h) || (x == 0 && y == 0) ||
                               (y == 0 && corners.has_x_arm(h)) || (x == 0 && corners.has_y_arm(h));
            if (there) ++met[layout.point(h, x, y)];
          }
      for (std::size_t i = 0; i < met.size(); ++i)
        EXPECT_EQ(met[i], static_cast<Index>(i) < layout.isolated_begin() ? 1 : 0);
      EXPECT_EQ(layout.vertex_count() - layout.isolated_begin(), isolated_count(mesh));
    }
  }
}

TEST(FastDualLayout, WritesRowsAndColumns) {
  for (const Mesh& mesh : open_meshes()) {
    const fast::DualCorners corners(mesh);
    const fast::DualLayout layout(corners, 4);
    for (Index h = 0; h < mesh.halfedge_count(); ++h)
      for (Index i = 0; i < (corners.is_whole(h) ? 4 : 1); ++i) {
        std::array<Index, 4> row{}, column{};
        if (corners.has_x_arm(h)) layout.row(h, i, row.data());
        if (corners.has_y_arm(h)) layout.column(h, i, column.data());
        for (Index t = 0; t < 4; ++t) {
          if (corners.has_x_arm(h)) EXPECT_EQ(row[t], layout.point(h, t, i));
          if (corners.has_y_arm(h)) EXPECT_EQ(column[t], layout.point(h, i, t));
        }
      }
  }
}

/// The sizes say how much is written, before anything is.
TEST(FastDualLayout, WritesAsManyFacesAsItSays) {
  for (const Mesh& mesh : open_meshes()) {
    const fast::DualCorners corners(mesh);
    for (const Index n : {1, 2, 8}) {
      const fast::DualLayout layout(corners, n);
      std::vector<Index> faces(static_cast<std::size_t>(layout.corner_count()) + 1, -7);
      layout.write_faces(faces.data());
      EXPECT_EQ(std::count(faces.begin(), faces.end(), -7), 1);
      EXPECT_EQ(faces.back(), -7);
      std::vector<Index> begin(static_cast<std::size_t>(layout.face_count()) + 2, -7);
      layout.write_face_begin(begin.data());
      EXPECT_EQ(begin.back(), -7);
      EXPECT_EQ(begin[begin.size() - 2], layout.corner_count());
      EXPECT_TRUE(std::is_sorted(begin.begin(), begin.end() - 1));
    }
  }
}

TEST(FastDualPlaces, AreThoseOfTheStar) {
  for (const Index sides : {3, 4, 7}) {
    const Mesh mesh = face_star(sides, 4);
    for (Index v = 0; v < mesh.vertex_count(); ++v)
      EXPECT_EQ(fast::dual_vertex(sides, fast::dual_point(sides, v)), v);
    for (Index h = 0; h < mesh.halfedge_count() && sides == 4; ++h) {
      const fast::Offset from = fast::dual_on_plane(fast::dual_point(sides, mesh.origin(h)));
      const fast::Offset to = fast::dual_on_plane(fast::dual_point(sides, mesh.target(h)));
      EXPECT_EQ(std::abs(to.a - from.a) + std::abs(to.b - from.b), 1);
    }
  }
}

}  // namespace
}  // namespace limn::test
