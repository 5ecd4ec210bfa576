// Numbers and faces of dual splits' levels.

#include <numeric>

#include "fast/fast_check.h"
#include "limn/fast/layout/kites.h"
#include "refine/dual_meshes.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

/// Every point has a number of its own, and isolated vertices the last.
TEST(FastKites, NumbersEachPointOnce) {
  std::vector<Mesh> meshes = open_meshes();
  for (const Mesh& mesh : bodies()) meshes.push_back(mesh);
  for (const Mesh& mesh : meshes) {
    const fast::Kites kites(mesh);
    for (const Index n : {1, 2, 4}) {
      const fast::KiteLayout layout(kites, n);
      std::vector<int> met(static_cast<std::size_t>(layout.vertex_count()), 0);
      for (Index h = 0; h < mesh.halfedge_count(); ++h)
        for (Index y = 0; y < n; ++y)
          for (Index x = 0; x < n; ++x) {
            const bool there = kites.is_whole(h) || (x == 0 && y == 0) ||
                               (y == 0 && kites.has_x_arm(h)) || (x == 0 && kites.has_y_arm(h));
            if (there) ++met[layout.point(h, x, y)];
          }
      for (std::size_t i = 0; i < met.size(); ++i)
        EXPECT_EQ(met[i], static_cast<Index>(i) < layout.isolated_begin() ? 1 : 0);
      EXPECT_EQ(layout.vertex_count() - layout.isolated_begin(), isolated_count(mesh));
    }
  }
}

/// The sizes say how much is written, before anything is.
TEST(FastKites, WritesAsManyFacesAsItSays) {
  for (const Mesh& mesh : open_meshes()) {
    const fast::Kites kites(mesh);
    for (const Index n : {1, 2, 8}) {
      const fast::KiteLayout layout(kites, n);
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

}  // namespace
}  // namespace limn::test
