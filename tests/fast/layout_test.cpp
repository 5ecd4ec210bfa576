// The quick engine's parts: its numbers, its coordinates, and how far it finds rules to look.

#include <gtest/gtest.h>

#include <algorithm>

#include "limn/fast/layout/triangle_layout.h"
#include "limn/fast/sites/reach.h"
#include "mesh/random_mesh.h"
#include "support/shipped.h"

namespace limn::fast {
namespace {

using test::shipped;

std::vector<Mesh> some_meshes() {
  std::vector<Mesh> meshes{test::icosahedron(), fan(Lattice::triangle, 1, 2)};
  for (unsigned seed = 0; seed < 12; ++seed) meshes.push_back(test::RandomMesh(seed).triangles());
  return meshes;
}

/// Every point of every patch has a number, every number a point, and neighbours agree on a side.
TEST(FastLayout, NumbersEachPointOnce) {
  for (const Mesh& mesh : some_meshes())
    for (const Index n : {1, 2, 4, 8}) {
      const TriangleLayout layout(mesh, n);
      std::vector<int> met(static_cast<std::size_t>(layout.vertex_count()), 0);
      for (Index f = 0; f < mesh.face_count(); ++f)
        for (Index y = 0; y <= n; ++y)
          for (Index x = 0; x + y <= n; ++x) ++met[layout.point(3 * f, x, y)];
      for (Index v = 0; v < mesh.vertex_count(); ++v)
        if (mesh.is_isolated(v)) met[v] = 1;
      EXPECT_EQ(std::count(met.begin(), met.end(), 0), 0);
      for (Index h = 0; h < mesh.halfedge_count(); ++h) {
        EXPECT_EQ(layout.point(h, 0, 0), mesh.origin(h));
        for (Index t = 0; t <= n && mesh.twin(h) != kNone; ++t)
          EXPECT_EQ(layout.point(h, t, 0), layout.point(mesh.twin(h), n - t, 0));
      }
    }
}

/// The three frames of a patch are turned into each other by 120°.
TEST(FastLayout, TurnsFrames) {
  const Mesh mesh = test::icosahedron();
  const TriangleLayout layout(mesh, 4);
  for (Index h = 0; h < mesh.halfedge_count(); ++h)
    for (Index y = 0; y <= 4; ++y)
      for (Index x = 0; x + y <= 4; ++x)
        EXPECT_EQ(layout.point(mesh.next(h), y, 4 - x - y), layout.point(h, x, y));
}

/// A point beyond a side is the point of the neighbour that lies there: its mirror image's twin.
TEST(FastLayout, LooksBeyondSides) {
  for (const Mesh& mesh : some_meshes()) {
    const Index n = 4;
    const TriangleLayout layout(mesh, n);
    for (Index h = 0; h < mesh.halfedge_count(); ++h)
      for (Index y = 1; y <= n; ++y)
        for (Index x = y; x <= n; ++x) {
          const Index twin = mesh.twin(h);
          const Index expected = twin == kNone ? kNone : layout.point(twin, n - x, y);
          // the neighbour's frame at the other end looks back along the side
          EXPECT_EQ(layout.point_beyond(h, x, -y), expected);
          EXPECT_EQ(layout.point_beyond(mesh.next(h), -y, n - x + y), expected);
          EXPECT_EQ(layout.point_beyond(mesh.prev(h), n - x + y, x), expected);
        }
  }
}

TEST(FastLayout, WritesColumns) {
  for (const Mesh& mesh : some_meshes())
    for (const Index n : {1, 2, 4, 8}) {
      const TriangleLayout layout(mesh, n);
      for (Index h = 0; h < mesh.halfedge_count(); ++h)
        for (Index x = 1; x <= n; ++x) {
          std::vector<Index> column(2 * static_cast<std::size_t>(n) + 2, kNone);
          layout.column(h, x, column.data(), 2);
          for (Index y = 0; x + y <= n; ++y) EXPECT_EQ(column[2 * y], layout.point(h, x, y));
        }
    }
}

TEST(FastLayout, WritesFacesRowByRow) {
  const Mesh mesh = test::RandomMesh(2).triangles();
  for (const Index n : {1, 2, 4, 8, 16}) {
    const TriangleLayout layout(mesh, n);
    std::vector<Index> corners(3 * static_cast<std::size_t>(layout.face_count()));
    layout.write_faces(0, mesh.face_count(), corners.data());
    std::vector<Index> expected;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const auto add = [&](Index x, Index y) { expected.push_back(layout.point(3 * f, x, y)); };
      for (Index y = 0; y < n; ++y)
        for (Index x = 0; x + y < n; ++x) {
          add(x, y), add(x + 1, y), add(x, y + 1);
          if (x + y + 1 < n) add(x + 1, y), add(x + 1, y + 1), add(x, y + 1);
        }
    }
    EXPECT_EQ(corners, expected);
  }
}

TEST(FastPlaces, AreThoseOfTheStar) {
  for (const Lattice lattice : {Lattice::triangle, Lattice::quad})
    for (const bool open : {false, true})
      for (const Index sectors : {3, 4, 6}) {
        const Mesh mesh = open ? fan(lattice, sectors, 3) : star(lattice, sectors, 3);
        const StarShape shape{lattice, sectors, open};
        for (Index v = 0; v < mesh.vertex_count(); ++v)
          EXPECT_EQ(vertex_at(shape, sector_point(shape, v)), v);
        if (open ? sectors > plane_sectors(lattice) : sectors != plane_sectors(lattice))
          continue;  // no plane
        for (Index h = 0; h < mesh.halfedge_count(); ++h) {
          const Offset from = on_plane(lattice, sector_point(shape, mesh.origin(h)));
          const Offset to = on_plane(lattice, sector_point(shape, mesh.target(h)));
          const Offset way{to.a - from.a, to.b - from.b};
          const std::array<Offset, 6> ways{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {-1, 1}, {1, -1}}};
          const auto end = lattice == Lattice::triangle ? ways.end() : ways.begin() + 4;
          EXPECT_NE(std::find(ways.begin(), end, way), end);
        }
      }
}

/// The neighbours across the sides of a patch are itself, shifted or turned by 180° about the
/// middle of a side; round a corner, they lie in the sectors before and after its own.
TEST(FastPlaces, AreSeenFromPatches) {
  for (const Lattice lattice : {Lattice::triangle, Lattice::quad})
    for (const Index n : {1, 2, 3})
      for (Index a = -9; a <= 9; ++a)
        for (Index b = -9; b <= 9; ++b) {
          std::vector<Offset> images{{a, b}};
          if (lattice == Lattice::triangle) {
            images.insert(images.end(), {{n - a, -b}, {n - a, n - b}, {-a, n - b}});
          } else {
            images.insert(images.end(), {{a - n, b}, {a + n, b}, {a, b - n}, {a, b + n}});
          }
          const bool seen = std::any_of(images.begin(), images.end(), [&](Offset image) {
            return patch_holds(lattice, n, image);
          });
          EXPECT_EQ(patch_sees(lattice, n, {a, b}), seen);
        }
  for (const Lattice lattice : {Lattice::triangle, Lattice::quad}) {
    const Index sectors = plane_sectors(lattice);
    for (Index v = 0; v < star_size(lattice, sectors, 3); ++v) {
      const SectorPoint point = sector_point({lattice, sectors, false}, v);
      const bool beside = v == 0 || point.sector < 2 || point.sector == sectors - 1 ||
                          (point.sector == 2 && point.y == 0);
      EXPECT_EQ(beside_corner(lattice, on_plane(lattice, point)), beside);
    }
  }
}

TEST(FastPlaces, HaveANearestCorner) {
  const Index n = 6;
  for (const Lattice lattice : {Lattice::triangle, Lattice::quad})
    for (Index y = 0; y <= n; ++y)
      for (Index x = 0; patch_holds(lattice, n, {x, y}); ++x) {
        Index nearest = n;
        for (Offset p{x, y}; nearest > 0;) {  // from each corner in turn
          nearest = std::min(nearest, ring_of(lattice, p.a, p.b));
          p = {p.b, mirrored(lattice, n, p.a, p.b)};
          if (p == Offset{x, y}) break;
        }
        EXPECT_EQ(ring_of_nearest_corner(lattice, n, x, y), nearest);
      }
}

/// By hand: Loop's stencils need the neighbours of an edge's or vertex's own faces only, the
/// butterfly's also the vertices beyond, so that edges at a control vertex see round it.
TEST(FastReach, IsThatOfTheRules) {
  const Reach loop = find_reach(shipped("loop"), true).value();
  EXPECT_EQ(loop.star_zone, 0);
  EXPECT_EQ(loop.strip_depth, 0);
  EXPECT_EQ(loop.fan_zone, 0);
  EXPECT_EQ(loop.star_rings, 1);
  EXPECT_EQ(loop.smallest_grid, 1);
  const Reach butterfly = find_reach(shipped("butterfly"), true).value();
  EXPECT_EQ(butterfly.star_zone, 1);
  EXPECT_EQ(butterfly.strip_depth, 1);
  EXPECT_EQ(butterfly.star_rings, 2);
  EXPECT_EQ(butterfly.smallest_grid, 2);
}

}  // namespace
}  // namespace limn::fast
