// The quick engine's numbers, frames and faces, for all lattices at once; its coordinates.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "fast/fast_check.h"
#include "limn/fast/layout/patch_frame.h"
#include "limn/fast/layout/star_places.h"
#include "mesh/random_mesh.h"

namespace limn::fast {
namespace {

/// The levels of a split as patches have them.
struct Levels {
  const char* name;
  Lattice lattice;
  Index cut, unit;
  bool centres;
};

std::ostream& operator<<(std::ostream& out, const Levels& levels) { return out << levels.name; }

class FastLayout : public ::testing::TestWithParam<Levels> {
 protected:
  [[nodiscard]] static bool triangles() { return GetParam().lattice == Lattice::triangle; }

  [[nodiscard]] static std::vector<Mesh> meshes() {
    std::vector<Mesh> meshes{triangles() ? test::icosahedron() : test::cube(),
                             mesh::fan(GetParam().lattice, 1, 1),
                             mesh::fan(GetParam().lattice, 1, 2)};
    for (unsigned seed = 0; seed < 12; ++seed) {
      const Mesh mesh =
          triangles() ? test::RandomMesh(seed).triangles() : test::RandomMesh(seed).polygons();
      meshes.push_back(triangles() || mesh.uniform_degree() == 4
                           ? mesh
                           : find_split("quad-dyadic")->apply(mesh, 0).mesh);
    }
    return meshes;
  }

  /// test(mesh, layout) for some meshes and grids.
  template <class Test>
  static void each(Test test) {
    const auto& [name, lattice, cut, unit, centres] = GetParam();
    for (const Mesh& mesh : meshes())
      for (const Index n : {Index{1}, cut, cut * cut})
        test(mesh, GridLayout(mesh, lattice, n, unit, centres));
  }

  /// visit(x, y) for all points of a patch.
  template <class Visit>
  static void each_point(const GridLayout& layout, Visit visit) {
    for (Index y = 0; y <= layout.side(); ++y)
      for (Index x = 0; x <= layout.side(); ++x)
        if (patch_holds(layout.lattice(), layout.side(), {x, y}) && layout.has_point(x, y))
          visit(x, y);
  }
};

INSTANTIATE_TEST_SUITE_P(Lattices, FastLayout,
                         ::testing::Values(Levels{"triangles", Lattice::triangle, 2, 1, false},
                                           Levels{"quads", Lattice::quad, 2, 1, false},
                                           Levels{"spread", Lattice::quad, 2, 2, false},
                                           Levels{"thirds", Lattice::triangle, 3, 1, false},
                                           Levels{"centroids", Lattice::triangle, 3, 3, true},
                                           Levels{"centres", Lattice::quad, 2, 2, true}),
                         [](const auto& info) { return info.param.name; });

/// Every point of every patch has a number, every number a point, neighbours agree on a side, and
/// the numbers inside of a patch come row by row.
TEST_P(FastLayout, NumbersEachPointOnce) {
  each([](const Mesh& mesh, const GridLayout& layout) {
    std::vector<int> met(static_cast<std::size_t>(layout.vertex_count()), 0);
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const Index h = layout.sides() * f, unit = layout.unit();
      each_point(layout, [&](Index x, Index y) { ++met[layout.point(h, x, y)]; });
      Index next = layout.face_begin(f);
      for (const Offset p : inner_places(layout.lattice(), layout.n()))
        EXPECT_EQ(layout.point(h, unit * p.a, unit * p.b), next++);
      EXPECT_EQ(next, layout.face_begin(f + 1));
      if (!layout.has_centres()) continue;
      next = layout.centre_begin(f);
      for (const Offset p : centre_places(layout.lattice(), layout.n(), unit))
        EXPECT_EQ(layout.point(h, p.a, p.b), next++);
      EXPECT_EQ(next, layout.centre_begin(f + 1));
    }
    for (Index v = 0; v < mesh.vertex_count(); ++v)
      if (mesh.is_isolated(v)) met[v] = 1;
    EXPECT_EQ(std::count(met.begin(), met.end(), 0), 0);
    for (Index h = 0; h < mesh.halfedge_count(); ++h) {
      EXPECT_EQ(layout.point(h, 0, 0), mesh.origin(h));
      for (Index t = 0; t <= layout.side() && mesh.twin(h) != kNone; t += layout.unit())
        EXPECT_EQ(layout.point(h, t, 0), layout.point(mesh.twin(h), layout.side() - t, 0));
    }
  });
}

TEST_P(FastLayout, TurnsFrames) {
  each([](const Mesh& mesh, const GridLayout& layout) {
    for (Index h = 0; h < mesh.halfedge_count(); ++h)
      each_point(layout, [&](Index x, Index y) {
        EXPECT_EQ(layout.point(mesh.next(h), y, mirrored(layout.lattice(), layout.side(), x, y)),
                  layout.point(h, x, y));
      });
  });
}

/// A point beyond a side is one of the neighbour, whose frame there is turned by half a turn; from
/// all frames of the patch it is the same.
TEST_P(FastLayout, LooksBeyondSides) {
  each([](const Mesh& mesh, const GridLayout& layout) {
    const Index side = layout.side();
    for (Index h = 0; h < mesh.halfedge_count(); ++h)
      each_point(layout, [&](Index x, Index y) {
        if (y == 0) return;
        const Index twin = mesh.twin(h);
        const Index expected = twin == kNone ? kNone : layout.point(twin, x, y);
        Offset place{side - x, -y};
        for (Index k = 0, g = h; k < layout.sides(); ++k, g = mesh.next(g)) {
          EXPECT_EQ(layout.point_beyond(g, place.a, place.b), expected);
          place = {place.b, mirrored(layout.lattice(), side, place.a, place.b)};
        }
      });
  });
}

TEST_P(FastLayout, NumbersFrames) {
  each([](const Mesh& mesh, const GridLayout& layout) {
    const PatchTopology topology(mesh, layout.sides());
    for (const Index halo : {Index{0}, Index{1}, layout.side()}) {
      const PatchFrame frame(layout, halo);
      std::vector<Index> numbers(frame.places().size() + 1, kNone);
      for (Index f = 0; f < mesh.face_count(); ++f) {
        frame.number(f, topology.face(f), numbers.data());
        const Index h = layout.sides() * f;
        for (std::size_t i = 0; i < frame.places().size(); ++i) {
          const Index there = layout.point_beyond(h, frame.places()[i].a, frame.places()[i].b);
          EXPECT_EQ(numbers[i], there == kNone ? mesh.origin(h) : there);
        }
      }
      EXPECT_EQ(numbers.back(), kNone);
    }
  });
}

/// By definition, from places alone.
TEST_P(FastLayout, WritesFaces) {
  if (GetParam().centres && !triangles()) GTEST_SKIP() << "its faces are edges";
  each([](const Mesh& mesh, const GridLayout& layout) {
    const Index unit = layout.unit(), sides = layout.sides();
    std::vector<Index> expected;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const auto at = [&](Offset p) { return layout.point_beyond(sides * f, p.a, p.b); };
      const auto cell = [&](std::vector<Offset> p) {
        if (!layout.has_centres())
          for (const Offset corner : p) expected.push_back(at(corner));
        for (std::size_t i = 0; layout.has_centres() && i < 3; ++i) {
          const Offset a = p[i], b = p[(i + 1) % 3], c = p[(i + 2) % 3];
          const Offset far{a.a + b.a - c.a, a.b + b.b - c.b};
          const Index own = at({(a.a + b.a + c.a) / 3, (a.b + b.b + c.b) / 3});
          const Index across = at({(a.a + b.a + far.a) / 3, (a.b + b.b + far.b) / 3});
          expected.insert(expected.end(), {at(a), across == kNone ? at(b) : across, own});
        }
      };
      for (Index y = 0; y < layout.side(); y += unit)
        for (Index x = 0; mirrored(layout.lattice(), layout.side(), x, y) > 0; x += unit) {
          const Offset right{x + unit, y}, up{x, y + unit}, far{x + unit, y + unit};
          if (triangles()) {
            cell({{x, y}, right, up});
            if (x + y + unit < layout.side()) cell({right, far, up});
          } else {
            cell({{x, y}, right, far, up});
          }
        }
    }
    std::vector<Index> corners(static_cast<std::size_t>(sides * layout.face_count()));
    layout.write_faces(0, mesh.face_count(), corners.data());
    EXPECT_EQ(corners, expected);
  });
}

/// A face for each edge of the grid, from places alone: those within patches, then those on control
/// edges.
TEST(FastLayoutOfCentres, WritesAFaceForEachEdgeOfQuads) {
  constexpr Index kUnit = 2;
  for (const Mesh& mesh : {test::cube(), mesh::fan(Lattice::quad, 1, 1),
                           mesh::fan(Lattice::quad, 3, 2), mesh::star(Lattice::quad, 5, 2)})
    for (const Index n : {1, 2, 4}) {
      const GridLayout layout(mesh, Lattice::quad, n, kUnit, true);
      std::vector<Index> expected, begin{0};
      const auto add = [&](std::vector<Index> face) {
        std::erase(face, kNone);
        expected.insert(expected.end(), face.begin(), face.end());
        begin.push_back(static_cast<Index>(expected.size()));
      };
      for (Index f = 0; f < mesh.face_count(); ++f) {
        const auto at = [&](Index x, Index y) { return layout.point(4 * f, x, y); };
        for (Index y = 0; y < 2 * n; y += 2) {
          for (Index x = 2; x < 2 * n; x += 2)
            add({at(x, y), at(x + 1, y + 1), at(x, y + 2), at(x - 1, y + 1)});
          for (Index x = 0; x < 2 * n && y + 2 < 2 * n; x += 2)
            add({at(x, y + 2), at(x + 1, y + 1), at(x + 2, y + 2), at(x + 1, y + 3)});
        }
      }
      for (Index e = 0; e < mesh.edge_count(); ++e) {
        const Index h = mesh.halfedge_of_edge(e);
        const auto at = [&](Index x, Index y) { return layout.point_beyond(h, x, y); };
        for (Index x = 0; x < 2 * n; x += 2)
          add({at(x, 0), at(x + 1, -1), at(x + 2, 0), at(x + 1, 1)});
      }
      ASSERT_EQ(std::ssize(expected), layout.corner_count());
      ASSERT_EQ(std::ssize(begin), layout.face_count() + 1);
      std::vector<Index> corners(expected.size()), begins(begin.size());
      layout.write_faces(0, mesh.face_count(), corners.data());
      layout.write_edge_faces(corners.data() + 4 * mesh.face_count() * layout.patch_faces());
      layout.write_face_begin(begins.data());
      EXPECT_EQ(corners, expected);
      EXPECT_EQ(begins, begin);
    }
}

/// Every vertex has a place of its own; on the plane, neighbours are next to each other.
TEST(FastPlaces, AreThoseOfTheStar) {
  std::vector<StarShape> shapes;
  for (const Index sectors : {3, 4, 6, 7}) {
    for (const Lattice lattice : {Lattice::triangle, Lattice::quad})
      for (const bool open : {false, true}) shapes.push_back({lattice, sectors, open});
    shapes.push_back({Lattice::quad, sectors, false, true});
  }
  for (const StarShape& shape : shapes) {
    const auto [lattice, sectors, open, offset] = shape;
    const Mesh mesh = offset ? mesh::face_star(sectors, 3)
                      : open ? mesh::fan(lattice, sectors, 3)
                             : mesh::star(lattice, sectors, 3);
    std::set<std::array<Index, 3>> places;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const SectorPoint point = sector_point(shape, v);
      EXPECT_TRUE(0 <= point.sector && point.sector < sectors && point.x >= 0 && point.y >= 0);
      places.insert({point.sector, point.x, point.y});
    }
    EXPECT_EQ(std::ssize(places), mesh.vertex_count());
    if (open ? sectors > plane_sectors(lattice) : sectors != plane_sectors(lattice))
      continue;  // no plane
    const auto on_plane_of = [&](Index v) {
      SectorPoint point = sector_point(shape, v);
      if (offset) point = {point.sector, 2 * point.x + 1, 2 * point.y + 1};
      return on_plane(lattice, point);
    };
    for (Index h = 0; h < mesh.halfedge_count(); ++h) {
      const Offset from = on_plane_of(mesh.origin(h)), to = on_plane_of(mesh.target(h));
      const Index step = offset ? 2 : 1;
      const Offset way{(to.a - from.a) / step, (to.b - from.b) / step};
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
    for (Index v = 0; v < mesh::star_size(lattice, sectors, 3); ++v) {
      const SectorPoint point = sector_point({lattice, sectors, false}, v);
      const bool beside = v == 0 || point.sector < 2 || point.sector == sectors - 1 ||
                          (point.sector == 2 && point.y == 0);
      EXPECT_EQ(beside_corner(lattice, on_plane(lattice, point)), beside);
    }
  }
}

}  // namespace
}  // namespace limn::fast
