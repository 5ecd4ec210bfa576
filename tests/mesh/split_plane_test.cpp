// Splits seen in the plane: place each new vertex where its birth says, and areas tell whether
// births, faces and orientation belong together.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "limn/mesh/split/split.h"
#include "random_mesh.h"

namespace limn::test {
namespace {

struct Placed {
  Mesh mesh;
  std::vector<Point3> at;
};

/// A piece of the plane: a grid of cells with some cells missing, slightly out of true, seen
/// from above (counterclockwise). `mixed`: some are of the other kind.
Placed planar_piece(unsigned seed, Lattice lattice, bool mixed = false) {
  std::mt19937 random(seed);
  const auto below = [&](unsigned n) { return static_cast<Index>(random() % n); };
  const Index nx = 2 + below(4), ny = 2 + below(4);
  std::vector<Point3> at;
  for (Index j = 0; j < ny; ++j)
    for (Index i = 0; i < nx; ++i) at.push_back({i + 0.01 * below(20), j + 0.01 * below(20), 0});
  Faces faces;
  for (Index j = 0; j + 1 < ny; ++j) {
    for (Index i = 0; i + 1 < nx; ++i) {
      const Index a = j * nx + i, b = a + 1, c = b + nx, d = a + nx;
      if ((lattice == Lattice::quad) != (mixed && below(2) == 0)) {
        faces.push_back({a, b, c, d});
      } else {
        faces.push_back({b, c, a});
        faces.push_back({a, c, d});
      }
    }
  }
  for (Index i = below(4); i > 0 && faces.size() > 1; --i) {
    Faces fewer = faces;
    fewer.erase(fewer.begin() + below(static_cast<unsigned>(faces.size())));
    if (Mesh::build(make_polygons(nx * ny, fewer))) faces = fewer;
  }
  return {must_build(nx * ny, faces), at};
}

Point3 centroid(const Placed& p, Index f) {
  Point3 sum;
  for (Index h = p.mesh.face_begin(f); h < p.mesh.face_begin(f + 1); ++h)
    sum = sum + p.at[p.mesh.origin(h)];
  return (1.0 / p.mesh.degree(f)) * sum;
}

double area(const Placed& p, Index f) {
  double twice = 0;
  for (Index h = p.mesh.face_begin(f); h < p.mesh.face_begin(f + 1); ++h) {
    const Point3 a = p.at[p.mesh.origin(h)], b = p.at[p.mesh.target(h)];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

double total_area(const Placed& p) {
  double sum = 0;
  for (Index f = 0; f < p.mesh.face_count(); ++f) sum += area(p, f);
  return sum;
}

/// Vertices stay, edge points in the middle (or at the thirds), face points at the centroid,
/// corner points half way from the vertex to the centroid, two thirds of it where vertices stay.
Placed place(const Placed& old, SplitResult refined) {
  const Births& births = refined.births;
  std::vector<Point3> at(old.at.begin(), old.at.begin() + births.from_vertices);
  const auto along = [&](Index h, double t) {
    return (1 - t) * old.at[old.mesh.origin(h)] + t * old.at[old.mesh.target(h)];
  };
  for (Index i = 0; i < births.from_edges; ++i) {
    const EdgeChild child = edge_child(old.mesh, births, i);
    at.push_back(along(child.halfedge, !child.third ? 0.5 : child.at_target ? 2 / 3. : 1 / 3.));
  }
  for (Index i = 0; i < births.from_faces; ++i)
    at.push_back(centroid(old, births.faces.empty() ? i : births.faces[i]));
  const double inwards = births.from_vertices > 0 ? 2 / 3. : 0.5;
  for (Index h = 0; h < births.from_corners; ++h)
    at.push_back((1 - inwards) * old.at[old.mesh.origin(h)] +
                 inwards * centroid(old, old.mesh.face(h)));
  for (const Index v : births.isolated) at.push_back(old.at[v]);
  return {std::move(refined.mesh), std::move(at)};
}

double least_area(const Placed& p) {
  double least = 1;
  for (Index f = 0; f < p.mesh.face_count(); ++f) least = std::min(least, area(p, f));
  return least;
}

/// What is cut off where the boundary goes from the middle of each edge to that of the next: a
/// triangle at each vertex, which counts as negative where the piece has a notch there.
double area_beside_middles(const Placed& p) {
  std::map<Index, Index> before;  // of a boundary vertex: the one before it
  for (Index h = 0; h < p.mesh.halfedge_count(); ++h)
    if (p.mesh.twin(h) == kNone) before[p.mesh.target(h)] = p.mesh.origin(h);
  double sum = 0;
  for (Index h = 0; h < p.mesh.halfedge_count(); ++h) {
    if (p.mesh.twin(h) != kNone) continue;
    const Point3 v = p.at[p.mesh.origin(h)];
    const Point3 a = p.at[before.at(p.mesh.origin(h))] - v, b = p.at[p.mesh.target(h)] - v;
    sum += (b.x * a.y - b.y * a.x) / 8;
  }
  return sum;
}

class SplitPlane : public ::testing::TestWithParam<Split> {};

TEST_P(SplitPlane, FacesTileThePieceCounterclockwise) {
  const Split& split = GetParam();
  const bool keeps_the_piece = split.births.vertices;
  EXPECT_TRUE(rc::check([&](unsigned seed) {
    Placed piece = planar_piece(seed, split.lattice, split.mixed);
    for (int step = 0; step < (split.dilation.growth() > 4 ? 2 : 3); ++step) {
      Placed fine = place(piece, split.apply(piece.mesh, step));
      RC_ASSERT(fine.at.size() == static_cast<std::size_t>(fine.mesh.vertex_count()));
      RC_ASSERT(least_area(fine) > 0);
      const double change = total_area(fine) - total_area(piece);
      // midedge leaves out what is at the boundary in odd steps
      const bool takes_middles = !keeps_the_piece && split.births.edges && step % 2 == 0;
      const double expected = takes_middles ? -area_beside_middles(piece) : 0;
      RC_ASSERT(
          (keeps_the_piece || takes_middles ? std::abs(change - expected) < 1e-9 : change < 0));
      piece = std::move(fine);
    }
  }));
}

INSTANTIATE_TEST_SUITE_P(All, SplitPlane, ::testing::ValuesIn(splits()), [](const auto& chosen) {
  std::string name(chosen.param.name);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(TriangleDyadic, ChildrenAreQuartersNextToTheirParent) {
  const Placed piece = planar_piece(7, Lattice::triangle);
  const Placed fine = place(piece, find_split("triangle-dyadic")->apply(piece.mesh, 0));
  for (Index f = 0; f < fine.mesh.face_count(); ++f)
    EXPECT_NEAR(area(fine, f), area(piece, f / 4) / 4, 1e-12);
  // child 3 in the middle: the parent's centroid
  for (Index f = 0; f < piece.mesh.face_count(); ++f) {
    EXPECT_NEAR(centroid(fine, 4 * f + 3).x, centroid(piece, f).x, 1e-12);
    EXPECT_EQ(fine.mesh.origin(12 * f + 3), piece.mesh.origin(3 * f + 1));
  }
}

TEST(Ternary, ChildrenAreNinths) {
  for (const char* name : {"triangle-ternary", "quad-ternary"}) {
    const Split& split = *find_split(name);
    const bool triangles = split.lattice == Lattice::triangle;
    const Placed one =
        triangles
            ? Placed{must_build(3, {{0, 1, 2}}), {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}}}
            : Placed{must_build(4, {{0, 1, 2, 3}}), {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}}};
    const Placed fine = place(one, split.apply(one.mesh, 0));
    // the points with integer coordinates, in congruent faces
    std::set<std::pair<long, long>> points;
    for (const Point3& p : fine.at) {
      EXPECT_NEAR(p.x, std::round(p.x), 1e-12);
      EXPECT_NEAR(p.y, std::round(p.y), 1e-12);
      points.insert({std::lround(p.x), std::lround(p.y)});
    }
    EXPECT_EQ(points.size(), triangles ? 10U : 16U);
    ASSERT_EQ(fine.mesh.face_count(), 9);
    for (Index f = 0; f < 9; ++f) EXPECT_NEAR(area(fine, f), triangles ? 0.5 : 1, 1e-12);
  }
}

TEST(TriangleTernary, IsTwoStepsOfSqrt3) {
  EXPECT_TRUE(rc::check([](unsigned seed) {
    const Placed piece = planar_piece(seed, Lattice::triangle);
    const Placed ternary = place(piece, find_split("triangle-ternary")->apply(piece.mesh, 0));
    const Split& sqrt3 = *find_split("sqrt3");
    const Placed middle = place(piece, sqrt3.apply(piece.mesh, 0));
    const Placed twice = place(middle, sqrt3.apply(middle.mesh, 1));
    RC_ASSERT(twice.mesh.vertex_count() == ternary.mesh.vertex_count());
    RC_ASSERT(twice.mesh.face_count() == ternary.mesh.face_count());
    RC_ASSERT(twice.mesh.edge_count() == ternary.mesh.edge_count());
  }));
}

TEST(Sqrt3, TwoStepsTrisectATriangle) {
  const Split& sqrt3 = *find_split("sqrt3");
  const Placed one{must_build(3, {{0, 1, 2}}), {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}}};
  const SplitResult first = sqrt3.apply(one.mesh, 0);
  EXPECT_EQ(first.mesh.face_count(), 3);
  EXPECT_EQ(first.births.from_edges, 0);
  const Placed middle = place(one, first);
  const SplitResult second = sqrt3.apply(middle.mesh, 1);
  EXPECT_EQ(second.births.from_vertices, 4);
  EXPECT_EQ(second.births.from_edges, 6);
  EXPECT_EQ(second.births.from_faces, 0);
  const Placed fine = place(middle, second);
  EXPECT_EQ(fine.mesh.face_count(), 9);
  EXPECT_EQ(fine.mesh.valence(3), 6);
  // the ten points with integer coordinates, in congruent triangles
  std::set<std::pair<long, long>> points;
  for (const Point3& p : fine.at) {
    EXPECT_NEAR(p.x, std::round(p.x), 1e-12);
    EXPECT_NEAR(p.y, std::round(p.y), 1e-12);
    points.insert({std::lround(p.x), std::lround(p.y)});
  }
  EXPECT_EQ(points.size(), 10U);
  for (Index f = 0; f < 9; ++f) EXPECT_NEAR(area(fine, f), 0.5, 1e-12);
}

TEST(Sqrt3, AnOddFirstStepCutsOnlyFacesWithOneBoundaryEdge) {
  const Split& sqrt3 = *find_split("sqrt3");
  const SplitResult alone = sqrt3.apply(must_build(3, {{0, 1, 2}}), 1);
  EXPECT_EQ(alone.mesh.check(), "");
  EXPECT_EQ(alone.births.from_edges, 0);
  EXPECT_EQ(alone.births.from_faces, 1);
  // the middle face has one boundary edge, its neighbours two each
  const SplitResult strip = sqrt3.apply(must_build(5, {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}), 1);
  EXPECT_EQ(strip.mesh.check(), "");
  EXPECT_EQ(strip.births.faces, (std::vector<Index>{0, 2}));
  EXPECT_EQ(strip.births.edge_ends, (std::vector<Index>{8, 9}));
  EXPECT_EQ(strip.mesh.face_count(), 9);
}

TEST(Sqrt3, ClosedMeshesIgnoreTheParity) {
  const Split& sqrt3 = *find_split("sqrt3");
  EXPECT_EQ(snapshot(sqrt3.apply(icosahedron(), 0).mesh),
            snapshot(sqrt3.apply(icosahedron(), 1).mesh));
}

/// The corners of each face, from the least on; in order.
std::set<std::vector<Index>> cycles(const Mesh& mesh) {
  std::set<std::vector<Index>> all;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    std::vector<Index> corners;
    for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h)
      corners.push_back(mesh.origin(h));
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.insert(corners);
  }
  return all;
}

TEST(QuadSqrt2, TwoStepsAreOneOfQuadDyadic) {
  const Split& sqrt2 = *find_split("quad-sqrt2");
  EXPECT_TRUE(rc::check([&](unsigned seed) {
    const Mesh mesh = RandomMesh(seed).polygons();
    const SplitResult first = sqrt2.apply(mesh, 0);
    const SplitResult second = sqrt2.apply(first.mesh, 1);
    RC_ASSERT(first.births.from_edges == 0);
    RC_ASSERT(first.mesh.face_count() == mesh.edge_count());  // face e comes from edge e
    // the dyadic number of each vertex after two steps
    std::vector<Index> dyadic;
    for (Index v = 0; v < second.births.from_vertices; ++v)
      dyadic.push_back(v < mesh.vertex_count() ? v : v + mesh.edge_count());
    for (const Index e : second.births.edges)
      dyadic.push_back(mesh.vertex_count() + first.mesh.face(first.mesh.halfedge_of_edge(e)));
    for (Index i = 0; i < second.births.from_faces; ++i)
      dyadic.push_back(mesh.vertex_count() +
                       (second.births.faces.empty() ? i : second.births.faces[i]));
    Polygons renamed = polygons_of(second.mesh);
    for (Index& corner : renamed.corners) corner = dyadic[corner];
    const Mesh expected = find_split("quad-dyadic")->apply(mesh, 0).mesh;
    RC_ASSERT(is_simple(second.mesh));
    RC_ASSERT(cycles(Mesh::build(renamed).value()) == cycles(expected));
  }));
}

TEST(QuadSqrt2, HalvesOfQuadsStandAtTheBoundaryBetweenTwoEvenLevels) {
  const Split& sqrt2 = *find_split("quad-sqrt2");
  const Placed square{must_build(4, {{0, 1, 2, 3}}), {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}};
  const Placed odd = place(square, sqrt2.apply(square.mesh, 0));
  EXPECT_EQ(odd.mesh.uniform_degree(), 3);
  EXPECT_EQ(odd.mesh.face_count(), 4);
  for (Index f = 0; f < 4; ++f) EXPECT_NEAR(area(odd, f), 1, 1e-12);
  const Placed even = place(odd, sqrt2.apply(odd.mesh, 1));
  EXPECT_EQ(even.mesh.uniform_degree(), 4);
  EXPECT_EQ(even.mesh.vertex_count(), 9);
  for (Index f = 0; f < 4; ++f) EXPECT_NEAR(area(even, f), 1, 1e-12);
}

TEST(QuadSqrt2, AnOddFirstStepCutsOnlyTrianglesWithOneBoundaryEdge) {
  const Split& sqrt2 = *find_split("quad-sqrt2");
  const SplitResult quad = sqrt2.apply(must_build(4, {{0, 1, 2, 3}}), 1);
  EXPECT_EQ(quad.births.from_edges, 0);
  // the middle face has one boundary edge, its neighbours two each
  const SplitResult strip = sqrt2.apply(must_build(5, {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}), 1);
  EXPECT_EQ(strip.mesh.check(), "");
  EXPECT_EQ(strip.births.faces, (std::vector<Index>{0, 2}));
  EXPECT_EQ(strip.births.edges.size(), 1U);
  EXPECT_EQ(strip.mesh.face_count(), 6);
}

TEST(MidEdge, CubeGivesTheCuboctahedron) {
  const Mesh mesh = find_split("midedge")->apply(cube(), 0).mesh;
  EXPECT_EQ(mesh.vertex_count(), 12);
  EXPECT_EQ(mesh.edge_count(), 24);
  Index triangles = 0, quads = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    triangles += mesh.degree(f) == 3;
    quads += mesh.degree(f) == 4;
  }
  EXPECT_EQ(triangles, 8);
  EXPECT_EQ(quads, 6);
}

TEST(MidEdge, ClosesBoundaryVerticesInEvenSteps) {
  const Split& midedge = *find_split("midedge");
  const Mesh mesh = mesh::star(Lattice::quad, 4, 3);
  const SplitResult refined = midedge.apply(mesh, 0);
  EXPECT_EQ(refined.mesh.check(), "");
  // 24 vertices are on the boundary, 4 of them corners
  EXPECT_EQ(refined.mesh.face_count(), mesh.face_count() + 25 + 20);
  EXPECT_EQ(refined.births.from_edges, mesh.edge_count());
  const SplitResult twice = midedge.apply(refined.mesh, 1);
  EXPECT_EQ(twice.mesh.check(), "");
  EXPECT_EQ(twice.births.from_edges, mesh.halfedge_count());
  EXPECT_TRUE(twice.births.edges.empty());
}

/// Two quads side by side: an odd step that no even one has prepared parts them, each with a vertex
/// of its own on the edge between them; in their turn the steps keep a quad for that edge.
TEST(MidEdge, KeepsTogetherWhatAnEdgeFromBoundaryToBoundaryJoins) {
  const Split& midedge = *find_split("midedge");
  const Mesh mesh = must_build(6, {{0, 1, 2, 3}, {1, 4, 5, 2}});
  const SplitResult parted = midedge.apply(mesh, 1);
  EXPECT_EQ(parted.mesh.check(), "");
  EXPECT_EQ(parted.births.from_edges, 8);
  EXPECT_EQ(parted.births.edges.size(), 8U);
  EXPECT_EQ(boundary_loops(parted.mesh), 2);
  const Mesh once = midedge.apply(mesh, 0).mesh, twice = midedge.apply(once, 1).mesh;
  EXPECT_EQ(once.face_count(), 4);
  EXPECT_EQ(twice.face_count(), 3);
  EXPECT_EQ(boundary_loops(twice), 1);
}

TEST(MidEdge, AFaceByItselfShrinks) {
  const Split& midedge = *find_split("midedge");
  Mesh mesh = must_build(4, {{0, 1, 2, 3}});
  for (int step = 0; step < 4; ++step) {
    mesh = midedge.apply(mesh, step).mesh;
    EXPECT_EQ(mesh.face_count(), 1);
    EXPECT_EQ(mesh.vertex_count(), 4);
  }
}

/// How often each degree of a face, and each valence of a vertex inside and at the boundary, is.
std::map<std::pair<int, Index>, int> degrees_and_valences(const Mesh& mesh) {
  std::map<std::pair<int, Index>, int> count;
  for (Index f = 0; f < mesh.face_count(); ++f) ++count[{0, mesh.degree(f)}];
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (!mesh.is_isolated(v)) ++count[{mesh.is_boundary_vertex(v) ? 1 : 2, mesh.valence(v)}];
  return count;
}

TEST(MidEdge, TwoStepsAreOneOfQuadDual) {
  EXPECT_TRUE(rc::check([](unsigned seed) {
    const Split& midedge = *find_split("midedge");
    const Mesh mesh = random_control(midedge, seed);
    for (Index v = 0; v < mesh.vertex_count(); ++v)
      RC_PRE(mesh.is_isolated(v) || mesh.valence(v) > 2);  // 2-gons are squeezed, a step apart
    const Mesh middle = midedge.apply(mesh, 0).mesh;
    const Mesh twice = midedge.apply(middle, 1).mesh;
    const Mesh dual = find_split("quad-dual")->apply(mesh, 0).mesh;
    RC_ASSERT(twice.face_count() == dual.face_count());
    RC_ASSERT(twice.edge_count() == dual.edge_count());
    RC_ASSERT(twice.vertex_count() == dual.vertex_count());
    RC_ASSERT(degrees_and_valences(twice) == degrees_and_valences(dual));
  }));
}

TEST(QuadDual, CubeGivesTheRhombicuboctahedron) {
  const Mesh mesh = find_split("quad-dual")->apply(cube(), 0).mesh;
  EXPECT_EQ(mesh.vertex_count(), 24);
  EXPECT_EQ(mesh.edge_count(), 48);
  Index triangles = 0, quads = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    triangles += mesh.degree(f) == 3;
    quads += mesh.degree(f) == 4;
  }
  EXPECT_EQ(triangles, 8);
  EXPECT_EQ(quads, 18);
}

TEST(QuadDual, BoundaryEdgesAndVerticesGiveNoFace) {
  const SplitResult refined = find_split("quad-dual")->apply(must_build(4, {{0, 1, 2, 3}}), 0);
  EXPECT_EQ(refined.mesh.face_count(), 1);
  EXPECT_EQ(refined.mesh.edge_count(), 4);
  EXPECT_EQ(boundary_loops(refined.mesh), 1);
}

TEST(QuadDual, SqueezesTheTwoGonsOfValenceTwo) {
  // every vertex of a pillow has valence 2: the dual of the n-gon pillow is the n-gon prism
  for (Index n = 3; n <= 6; ++n) {
    const Mesh prism = find_split("quad-dual")->apply(pillow(n), 0).mesh;
    EXPECT_EQ(prism.check(), "");
    EXPECT_EQ(prism.vertex_count(), 2 * n);
    EXPECT_EQ(prism.edge_count(), 3 * n);
    EXPECT_EQ(prism.face_count(), n + 2);
    EXPECT_TRUE(is_simple(prism));
  }
  // one such vertex in an otherwise ordinary disc: 4 between the quads 0-1-2-4 and 0-4-2-3
  const Mesh disc = must_build(5, {{0, 1, 2, 4}, {0, 4, 2, 3}});
  const Mesh dual = find_split("quad-dual")->apply(disc, 0).mesh;
  EXPECT_EQ(dual.check(), "");
  EXPECT_EQ(dual.face_count(), 4);  // two F-faces, two E-faces
  EXPECT_EQ(dual.edge_count(), 8 + 4 - 1);
}

}  // namespace
}  // namespace limn::test
