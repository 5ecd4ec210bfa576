// Numbers and faces of √3's levels.

#include "limn/fast/layout/sqrt3_layout.h"
#include "fast/fast_check.h"

namespace limn::test {
namespace {

using fast::CentroidLayout;

std::vector<Mesh> some_meshes() {
  std::vector<Mesh> meshes{icosahedron(), fan(Lattice::triangle, 1, 2),
                           fan(Lattice::triangle, 1, 1)};
  for (unsigned seed = 0; seed < 12; ++seed) meshes.push_back(RandomMesh(seed).triangles());
  return meshes;
}

/// Every point of every patch has a number, every number a point; vertices keep theirs, and the
/// centroids of a patch are numbered as the grid's faces come.
TEST(Sqrt3Layout, NumbersEachPointOnce) {
  for (const Mesh& mesh : some_meshes())
    for (const Index n : {1, 3, 9}) {
      const CentroidLayout layout(mesh, n);
      std::vector<int> met(static_cast<std::size_t>(layout.vertex_count()), 0);
      for (Index f = 0; f < mesh.face_count(); ++f) {
        Index next = layout.centroid_begin(f);
        for (Index y = 0; y <= n; ++y)
          for (Index x = 0; x + y <= n; ++x) {
            EXPECT_EQ(layout.point(3 * f, 3 * x, 3 * y), layout.grid().point(3 * f, x, y));
            ++met[layout.point(3 * f, 3 * x, 3 * y)];
            if (x + y < n) EXPECT_EQ(layout.point(3 * f, 3 * x + 1, 3 * y + 1), next++);
            if (x + y + 1 < n) EXPECT_EQ(layout.point(3 * f, 3 * x + 2, 3 * y + 2), next++);
          }
        for (Index i = layout.centroid_begin(f); i < next; ++i) ++met[i];
        EXPECT_EQ(next - layout.centroid_begin(f), n * n);
      }
      for (Index v = 0; v < mesh.vertex_count(); ++v)
        if (mesh.is_isolated(v)) met[v] = 1;
      EXPECT_EQ(std::count(met.begin(), met.end(), 0), 0);
    }
}

TEST(Sqrt3Layout, TurnsFramesLooksBeyondSidesAndWritesColumns) {
  for (const Mesh& mesh : some_meshes())
    for (const Index n : {1, 3, 9}) {
      const CentroidLayout layout(mesh, n);
      const Index side = 3 * n;
      for (Index h = 0; h < mesh.halfedge_count(); ++h)
        for (Index x = 0; x <= side; ++x) {
          std::vector<Index> column;
          for (Index y = x % 3; x + y <= side; y += 3) {
            const Index point = layout.point(h, x, y);
            column.push_back(point);
            EXPECT_EQ(layout.point(mesh.next(h), y, side - x - y), point);
            if (y == 0) continue;
            const Index twin = mesh.twin(h);  // the mirror image's twin
            const Index beyond = twin == kNone ? kNone : layout.point(mesh.next(twin), y, x);
            EXPECT_EQ(layout.point_beyond(h, x + y, -y), beyond);
            EXPECT_EQ(layout.point_beyond(mesh.next(h), -y, side - x), beyond);
            EXPECT_EQ(layout.point_beyond(mesh.prev(h), side - x, x + y), beyond);
          }
          if (x == 0) continue;
          std::vector<Index> written(column.size() + 1, kNone);
          EXPECT_EQ(layout.column(h, x, written.data()) - written.data(), std::ssize(column));
          written.pop_back();
          EXPECT_EQ(written, column);
        }
    }
}

/// By definition, from places alone.
TEST(Sqrt3Layout, WritesFacesByHalfEdges) {
  for (const Mesh& mesh : some_meshes())
    for (const Index n : {1, 3, 9}) {
      const CentroidLayout layout(mesh, n);
      std::vector<Index> corners(3 * static_cast<std::size_t>(layout.face_count())), expected;
      layout.write_faces(0, mesh.face_count(), corners.data());
      for (Index f = 0; f < mesh.face_count(); ++f) {
        const auto at = [&](Index x, Index y) { return layout.point_beyond(3 * f, x, y); };
        const auto triangle = [&](std::array<fast::Offset, 3> p) {
          const Index own = at((p[0].a + p[1].a + p[2].a) / 3, (p[0].b + p[1].b + p[2].b) / 3);
          for (std::size_t i = 0; i < 3; ++i) {
            const fast::Offset a = p[i], b = p[(i + 1) % 3], c = p[(i + 2) % 3];
            const fast::Offset far{a.a + b.a - c.a, a.b + b.b - c.b};
            const Index across = at((a.a + b.a + far.a) / 3, (a.b + b.b + far.b) / 3);
            expected.insert(expected.end(),
                            {at(a.a, a.b), across == kNone ? at(b.a, b.b) : across, own});
          }
        };
        for (Index y = 0; y < 3 * n; y += 3)
          for (Index x = 0; x + y < 3 * n; x += 3) {
            triangle({{{x, y}, {x + 3, y}, {x, y + 3}}});
            if (x + y + 3 < 3 * n) triangle({{{x + 3, y}, {x + 3, y + 3}, {x, y + 3}}});
          }
      }
      EXPECT_EQ(corners, expected);
    }
}

}  // namespace
}  // namespace limn::test
