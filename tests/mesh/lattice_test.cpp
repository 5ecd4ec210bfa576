#include <gtest/gtest.h>

#include <queue>

#include "limn/mesh/pattern.h"
#include "limn/mesh/split/split.h"

#include "random_mesh.h"

namespace limn::test {
namespace {

constexpr Lattice kBoth[] = {Lattice::triangle, Lattice::quad};

std::set<std::vector<Index>> face_set(const Mesh& mesh) {
  std::set<std::vector<Index>> set;
  for (auto& face : faces_of(polygons_of(mesh))) set.insert(from_smallest(face));
  return set;
}

std::set<Index> neighbours(const Mesh& mesh, Index v) {
  std::set<Index> result;
  for (Index h = 0; h < mesh.halfedge_count(); ++h) {
    if (mesh.origin(h) == v) result.insert(mesh.target(h));
    if (mesh.target(h) == v) result.insert(mesh.origin(h));
  }
  return result;
}

/// Rotation by one sector, as the headers promise it: `step(r)` places within ring r.
template <class Size, class Step>
void expect_symmetric(const Mesh& mesh, Index first_ring, Index rings, Size size, Step step) {
  std::vector<Index> turned(static_cast<std::size_t>(mesh.vertex_count()), 0);
  for (Index r = first_ring; r <= rings; ++r) {
    const Index begin = r == 0 ? 0 : size(r - 1), length = size(r) - begin;
    for (Index k = 0; k < length; ++k) turned[begin + k] = begin + (k + step(r)) % length;
  }
  std::set<std::vector<Index>> image;
  for (auto face : faces_of(polygons_of(mesh))) {
    for (Index& v : face) v = turned[v];
    image.insert(from_smallest(face));
  }
  EXPECT_EQ(image, face_set(mesh));
}

TEST(CroppedStar, IsAStarWithoutTheCornersOfItsLastSquare) {
  for (const Index n : {3, 4, 5, 8})
    for (const Index rings : {2, 3, 4}) {
      const Mesh mesh = mesh::cropped_star(n, rings);
      EXPECT_EQ(mesh.check(), "");
      EXPECT_EQ(mesh.vertex_count(), mesh::cropped_star_size(n, rings));
      EXPECT_EQ(mesh.vertex_count(), mesh::star_size(Lattice::quad, n, rings) - n);
      EXPECT_EQ(mesh.face_count(), n * (rings * rings - 1));
      EXPECT_EQ(mesh.uniform_degree(), 4);
      EXPECT_EQ(euler_characteristic(mesh), 1);
      EXPECT_EQ(mesh.origin(0), 0);
      EXPECT_EQ(mesh.target(0), 1);
      EXPECT_EQ(mesh.valence(0), n);
      // all that is within is regular
      for (Index v = 1; v < mesh::cropped_star_size(n, rings - 1); ++v) {
        EXPECT_FALSE(mesh.is_boundary_vertex(v));
        EXPECT_EQ(mesh.valence(v), 4);
      }
      expect_symmetric(
          mesh, 0, rings, [n](Index r) { return mesh::cropped_star_size(n, r); },
          [](Index r) { return r == 0   ? 0
                               : r == 1 ? 1
                                        : 2 * r; });
    }
  EXPECT_EQ(mesh::cropped_star_size(5, 0), 1);
  EXPECT_EQ(mesh::cropped_star_size(5, 1), 6);
}

TEST(SectorStar, IsRegularButForItsCentreAndItsSeams) {
  constexpr Lattice kT = Lattice::triangle, kQ = Lattice::quad;
  for (const std::vector<Lattice>& kinds : std::vector<std::vector<Lattice>>{
           {kT, kT, kT, kQ, kQ}, {kT, kQ}, {kQ, kT, kQ, kT}, {kT, kT, kQ, kT, kQ, kQ, kQ}})
    for (const bool open : {false, true}) {
      const mesh::Sectors sectors{kinds, open};
      const Index rings = 4, inner = mesh::sector_star_size(sectors, rings - 1);
      const Mesh mesh = mesh::sector_star(sectors, rings);
      EXPECT_EQ(mesh.check(), "");
      EXPECT_EQ(mesh.vertex_count(), mesh::sector_star_size(sectors, rings));
      EXPECT_EQ(mesh.origin(0), 0);
      EXPECT_EQ(mesh.target(0), 1);
      EXPECT_EQ(mesh.face_count(), static_cast<Index>(kinds.size()) * rings * rings);
      EXPECT_EQ(mesh.valence(0), static_cast<Index>(kinds.size()) + (open ? 1 : 0));
      Index h = mesh.halfedge_of_vertex(0);
      for (const Lattice kind : kinds) {  // counterclockwise in this order
        EXPECT_EQ(mesh.degree(mesh.face(h)), kind == kT ? 3 : 4);
        h = mesh.rotate(h);
      }
      Index seams = 0, expected = 0;
      for (Index v = 1; v < inner; ++v) {
        if (mesh.is_boundary_vertex(v)) continue;
        seams += mesh.valence(v) == 5 ? 1 : 0;
        EXPECT_TRUE(mesh.valence(v) >= 4 && mesh.valence(v) <= 6);
      }
      for (std::size_t s = open ? 1 : 0; s < kinds.size(); ++s)
        expected += kinds[s] != kinds[(s + kinds.size() - 1) % kinds.size()] ? rings - 1 : 0;
      EXPECT_EQ(seams, expected);
    }
}

/// A step of the split makes the star of the same sectors again.
TEST(SectorStar, IsWhatQuadTriangleMakesOfIt) {
  constexpr Lattice kT = Lattice::triangle, kQ = Lattice::quad;
  for (const bool open : {false, true}) {
    const mesh::Sectors sectors{{kT, kQ, kQ, kT, kT}, open};
    const Mesh fine = find_split("quad-triangle")->apply(mesh::sector_star(sectors, 2), 0).mesh;
    const Mesh expected = mesh::sector_star(sectors, 4);
    EXPECT_EQ(fine.vertex_count(), expected.vertex_count());
    EXPECT_EQ(fine.face_count(), expected.face_count());
    std::vector<Index> places;
    Index start = fine.halfedge_of_vertex(0);
    const Index toward = mesh::sector_star_size(sectors, 2);  // the middle of edge 0
    for (Index i = 0; i < 6 && fine.target(start) != toward; ++i) start = fine.rotate(start);
    EXPECT_TRUE(mesh::Pattern(expected, expected.vertex_count()).match(fine, start, places));
  }
}

TEST(Torus, HasTheFacesAndDirectionsOfItsHeader) {
  for (const auto& [nx, ny] : {std::pair{3, 3}, {3, 5}, {7, 4}}) {
    for (const Lattice lattice : kBoth) {
      const Mesh mesh = mesh::torus(lattice, nx, ny);
      EXPECT_EQ(mesh.check(), "");
      EXPECT_EQ(mesh.vertex_count(), nx * ny);
      EXPECT_EQ(euler_characteristic(mesh), 0);
      EXPECT_FALSE(mesh.has_boundary());
      const auto at = [nx = nx, ny = ny](Index i, Index j) {
        return (j + ny) % ny * nx + (i + nx) % nx;
      };
      std::set<Index> expected{at(2, 1), at(0, 1), at(1, 2), at(1, 0)};
      if (lattice == Lattice::triangle) expected.insert({at(2, 2), at(0, 0)});
      EXPECT_EQ(neighbours(mesh, at(1, 1)), expected);
      const Faces faces = faces_of(polygons_of(mesh));
      const Index c = at(2, 1);
      if (lattice == Lattice::triangle) {
        EXPECT_EQ(faces[2 * c], (std::vector<Index>{at(2, 1), at(3, 1), at(3, 2)}));
        EXPECT_EQ(faces[2 * c + 1], (std::vector<Index>{at(2, 1), at(3, 2), at(2, 2)}));
      } else {
        EXPECT_EQ(faces[c], (std::vector<Index>{at(2, 1), at(3, 1), at(3, 2), at(2, 2)}));
      }
    }
  }
}

TEST(Fan, IsAStarCutOpenWithARegularBoundary) {
  for (const Lattice lattice : kBoth) {
    for (Index sectors = 1; sectors <= 7; ++sectors) {
      for (Index rings = 1; rings <= 4; ++rings) {
        const Mesh mesh = mesh::fan(lattice, sectors, rings);
        EXPECT_EQ(mesh.check(), "");
        EXPECT_EQ(mesh.vertex_count(), mesh::fan_size(lattice, sectors, rings));
        EXPECT_EQ(mesh.face_count(), sectors * rings * rings);
        EXPECT_EQ(euler_characteristic(mesh), 1);
        EXPECT_EQ(mesh.halfedge_of_vertex(0), 0);
        EXPECT_EQ(mesh.valence(0), sectors + 1);
        if (rings == 1) continue;
        for (Index v = 1; v < mesh::fan_size(lattice, sectors, rings - 1); ++v) {
          const Index regular = lattice == Lattice::triangle ? 6 : 4;
          EXPECT_EQ(mesh.valence(v), mesh.is_boundary_vertex(v) ? regular / 2 + 1 : regular) << v;
        }
      }
    }
  }
}

TEST(Star, IsRegularButForItsCentre) {
  for (const Lattice lattice : kBoth) {
    const Index regular = lattice == Lattice::triangle ? 6 : 4;
    for (Index n = lattice == Lattice::quad ? 2 : 3; n <= 9; ++n) {
      for (Index rings = 1; rings <= 4; ++rings) {
        const Mesh mesh = mesh::star(lattice, n, rings);
        EXPECT_EQ(mesh.check(), "");
        EXPECT_EQ(mesh.vertex_count(), mesh::star_size(lattice, n, rings));
        EXPECT_EQ(mesh.uniform_degree(), lattice == Lattice::triangle ? 3 : 4);
        EXPECT_EQ(euler_characteristic(mesh), 1);
        EXPECT_EQ(boundary_loops(mesh), 1);
        EXPECT_EQ(mesh.valence(0), n);
        for (Index v = 0; v < mesh.vertex_count(); ++v) {
          EXPECT_EQ(mesh.is_boundary_vertex(v), v >= mesh::star_size(lattice, n, rings - 1));
          if (v > 0 && !mesh.is_boundary_vertex(v)) {
            EXPECT_EQ(mesh.valence(v), regular);
          }
        }
        expect_symmetric(
            mesh, 0, rings, [&](Index r) { return mesh::star_size(lattice, n, r); },
            [&](Index r) { return lattice == Lattice::triangle ? r : 2 * r; });
      }
    }
  }
}

TEST(Star, NumbersRingsOutwardsFromTheFirstSpoke) {
  for (const Lattice lattice : kBoth) {
    const Index n = 5, rings = 3;
    const Mesh mesh = mesh::star(lattice, n, rings);
    // ring r: what the faces at ring r-1 touch
    for (Index r = 1; r <= rings; ++r) {
      std::set<Index> reached;
      for (const auto& face : faces_of(polygons_of(mesh)))
        if (*std::min_element(face.begin(), face.end()) < mesh::star_size(lattice, n, r - 1))
          reached.insert(face.begin(), face.end());
      EXPECT_EQ(static_cast<Index>(reached.size()), mesh::star_size(lattice, n, r));
      EXPECT_EQ(*reached.rbegin(), mesh::star_size(lattice, n, r) - 1);
    }
    // spokes are straight and run through the first vertex of each sector, counterclockwise
    Index h = 0;
    for (Index s = 0; s < n; ++s) {
      EXPECT_EQ(mesh.origin(h), 0);
      for (Index r = 1, k = h;; ++r) {
        const Index per_sector = lattice == Lattice::triangle ? r : 2 * r;
        EXPECT_EQ(mesh.target(k), mesh::star_size(lattice, n, r - 1) + s * per_sector);
        if (r == rings) break;
        // straight on: half way round the vertex
        k = mesh.twin(k);
        for (Index i = 0; i < (lattice == Lattice::triangle ? 3 : 2); ++i) k = mesh.rotate(k);
      }
      h = mesh.rotate(h);
    }
    EXPECT_EQ(h, 0);
    EXPECT_EQ(mesh.halfedge_of_vertex(0), 0);
    EXPECT_EQ(mesh.face(0), 0);
    // along ring 1 the indices grow counterclockwise, that is, with the centre on the left
    const Index a = mesh.next(0);
    EXPECT_EQ(mesh.origin(a), 1);
    EXPECT_EQ(mesh.target(a), 2);
  }
}

TEST(FaceStar, IsRegularButForItsFace) {
  for (Index n = 3; n <= 9; ++n) {
    for (Index rings = 1; rings <= 4; ++rings) {
      const Mesh mesh = mesh::face_star(n, rings);
      EXPECT_EQ(mesh.check(), "");
      EXPECT_EQ(mesh.vertex_count(), mesh::face_star_size(n, rings));
      EXPECT_EQ(euler_characteristic(mesh), 1);
      EXPECT_EQ(mesh.degree(0), n);
      EXPECT_EQ(mesh.origin(0), 0);
      EXPECT_EQ(mesh.target(0), 1);
      for (Index f = 1; f < mesh.face_count(); ++f) EXPECT_EQ(mesh.degree(f), 4);
      for (Index v = 0; v < mesh.vertex_count(); ++v) {
        EXPECT_EQ(mesh.is_boundary_vertex(v), v >= mesh::face_star_size(n, rings - 1));
        if (!mesh.is_boundary_vertex(v)) {
          EXPECT_EQ(mesh.valence(v), 4);
        }
      }
      expect_symmetric(
          mesh, 1, rings, [&](Index r) { return mesh::face_star_size(n, r); },
          [](Index r) { return 2 * r - 1; });
    }
  }
}

TEST(FaceStar, NumbersRingsByCorner) {
  const Mesh mesh = mesh::face_star(5, 3);
  for (Index r = 1; r <= 3; ++r) EXPECT_EQ(mesh::face_star_size(5, r), 5 * r * r);
  // sector 1 of ring 2 is 5+3, 5+4, 5+5: the outer two join corner 1, the middle one neither
  const std::set<Index> corner = neighbours(mesh, 1);
  EXPECT_EQ(corner, (std::set<Index>{0, 2, 8, 10}));
  EXPECT_TRUE(neighbours(mesh, 9).contains(8));
  EXPECT_TRUE(neighbours(mesh, 9).contains(10));
  EXPECT_TRUE(neighbours(mesh, 10).contains(11));
}

TEST(FaceStar, IsTheDualSplitOfAStar) {
  // Doo–Sabin corners round vertex 0 of the quad star are the face star of as many rings
  const Mesh split = find_split("quad-dual")->apply(mesh::star(Lattice::quad, 5, 3), 0).mesh;
  Index five_sided = 0;
  for (Index f = 0; f < split.face_count(); ++f) five_sided += split.degree(f) == 5;
  EXPECT_EQ(five_sided, 1);
  // rings of the star's sectors: (2·3)² quadrants' corners each
  EXPECT_EQ(split.vertex_count(), mesh::face_star_size(5, 6));
  EXPECT_EQ(split.face_count(), mesh::face_star(5, 6).face_count());
  EXPECT_EQ(split.edge_count(), mesh::face_star(5, 6).edge_count());
}

TEST(Tree, GluesRegularFacesAlongATree) {
  for (const Lattice lattice : kBoth) {
    const Index degree = lattice == Lattice::triangle ? 3 : 4;
    Index ring = degree, faces = 1;
    for (int depth = 0; depth <= 5; ++depth) {
      const Mesh mesh = mesh::tree(lattice, depth);
      EXPECT_EQ(mesh.check(), "");
      EXPECT_EQ(mesh.uniform_degree(), degree);
      EXPECT_EQ(mesh.face_count(), faces);
      EXPECT_EQ(mesh.edge_count() - boundary_edges(mesh), faces - 1);  // joins of a tree
      EXPECT_EQ(euler_characteristic(mesh), 1);
      EXPECT_EQ(isolated_count(mesh), 0);
      // crossings from face 0: inner faces are whole, and no face lies deeper than `depth`
      std::vector<int> level(static_cast<std::size_t>(faces), -1);
      std::queue<Index> todo({0});
      level[0] = 0;
      for (; !todo.empty(); todo.pop()) {
        const Index f = todo.front();
        for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h) {
          EXPECT_EQ(mesh.twin(h) == kNone, level[f] == depth && (depth == 0 || h != degree * f));
          if (mesh.twin(h) == kNone || level[mesh.face(mesh.twin(h))] >= 0) continue;
          level[mesh.face(mesh.twin(h))] = level[f] + 1;
          todo.push(mesh.face(mesh.twin(h)));
        }
      }
      faces += ring;
      ring *= degree - 1;
    }
  }
}

}  // namespace
}  // namespace limn::test
