#include "limn/mesh/sharpness/sharpness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "limn/mesh/sharpness/cut_mesh.h"
#include "mesh/random_mesh.h"

namespace limn::test {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// The edge between two vertices.
Index edge(const Mesh& mesh, Index a, Index b) {
  for (Index h = 0; h < mesh.halfedge_count(); ++h)
    if (mesh.origin(h) == a && mesh.target(h) == b) return mesh.edge(h);
  return kNone;
}

/// A grid of 3 × 3 quads: vertex x + 4 y at (x, y).
Mesh grid() {
  Faces faces;
  for (Index y = 0; y < 3; ++y)
    for (Index x = 0; x < 3; ++x) {
      const Index v = x + 4 * y;
      faces.push_back({v, v + 1, v + 5, v + 4});
    }
  return must_build(16, faces);
}

std::vector<bool> edges_of(const Mesh& mesh, const std::vector<std::array<Index, 2>>& ends) {
  std::vector<bool> result(at(mesh.edge_count()), false);
  for (const auto& [a, b] : ends) result[at(edge(mesh, a, b))] = true;
  return result;
}

// --- cutting ----------------------------------------------------------------------------------

TEST(CutMesh, KeepsFacesAndHalfEdgesAndTheLawsOfAMesh) {
  for (unsigned seed = 1; seed < 40; ++seed) {
    const Mesh mesh = RandomMesh(seed).polygons();
    std::vector<bool> along;
    std::mt19937 random(seed);
    for (Index e = 0; e < mesh.edge_count(); ++e) along.push_back(random() % 3 == 0);
    const mesh::CutMesh cut = mesh::cut_along(mesh, along);
    EXPECT_EQ(cut.mesh.check(), "") << seed;
    ASSERT_EQ(cut.mesh.halfedge_count(), mesh.halfedge_count());
    ASSERT_EQ(cut.originals.size(), at(cut.mesh.vertex_count()));
    for (Index h = 0; h < mesh.halfedge_count(); ++h) {
      EXPECT_EQ(cut.mesh.next(h), mesh.next(h));
      EXPECT_EQ(cut.originals[at(cut.mesh.origin(h))], mesh.origin(h));
      EXPECT_EQ(cut.mesh.twin(h), along[at(mesh.edge(h))] ? kNone : mesh.twin(h));
    }
  }
}

TEST(CutMesh, ACutThatEndsInsideLeavesItsEndWhole) {
  const Mesh mesh = grid();
  const mesh::CutMesh slit = mesh::cut_along(mesh, edges_of(mesh, {{1, 5}}));  // from the boundary
  EXPECT_EQ(slit.mesh.vertex_count(), 17);                                     // vertex 1 twice
  EXPECT_TRUE(slit.mesh.is_boundary_vertex(5));
  const mesh::CutMesh inside = mesh::cut_along(mesh, edges_of(mesh, {{5, 6}}));
  EXPECT_EQ(inside.mesh.vertex_count(), 16);
  EXPECT_EQ(inside.mesh.edge_count(), mesh.edge_count() + 1);
  const mesh::CutMesh cross =
      mesh::cut_along(mesh, edges_of(mesh, {{5, 6}, {5, 4}, {5, 1}, {5, 9}}));
  EXPECT_EQ(std::count(cross.originals.begin(), cross.originals.end(), 5), 4);
}

TEST(CutMesh, IsJoinedAgain) {
  for (const char* name : {"sqrt3", "quad-sqrt2"}) {
    const Split& split = *find_split(name);
    for (unsigned seed = 1; seed < 20; ++seed) {
      Mesh mesh = split.any_polygons ? RandomMesh(seed).polygons() : RandomMesh(seed).triangles();
      std::mt19937 random(seed);
      std::vector<bool> along;
      for (Index e = 0; e < mesh.edge_count(); ++e)
        along.push_back(!mesh.is_boundary_edge(e) && random() % 3 == 0);
      double length = static_cast<double>(std::count(along.begin(), along.end(), true));
      for (int step = 0; step < 4; ++step) {
        const mesh::CutMesh cut = mesh::cut_along(mesh, along);
        const Result<mesh::JoinedMesh> joined =
            mesh::join_again(mesh, cut, split.apply(cut.mesh, step));
        if (!joined) break;  // two creases between the same vertices
        EXPECT_EQ(joined->fine.mesh.check(), "") << name << ", " << seed;
        mesh = joined->fine.mesh;
        along = joined->seams;
        if (step % 2 == 1) length *= split.odd_step_cut;
        EXPECT_EQ(static_cast<double>(std::count(along.begin(), along.end(), true)), length);
      }
    }
  }
}

// --- inheritance ------------------------------------------------------------------------------

TEST(Sharpness, FadesByOneAStep) {
  EXPECT_EQ(after_step(0), 0);
  EXPECT_EQ(after_step(0.5), 0);
  EXPECT_EQ(after_step(1), 0);
  EXPECT_EQ(after_step(2.5), 1.5);
  EXPECT_EQ(after_step(9.5), 8.5);
  EXPECT_EQ(after_step(10), 10);
  EXPECT_EQ(after_step(1e9), 1e9);
}

TEST(Sharpness, ByChaikinLooksAtTheOtherEdgesThatFade) {
  const Mesh mesh = grid();
  Sharpness sharpness;
  sharpness.method = CreaseMethod::chaikin;
  sharpness.edges.assign(at(mesh.edge_count()), 0);
  const Index a = edge(mesh, 4, 5), b = edge(mesh, 5, 6), c = edge(mesh, 5, 9),
              i = edge(mesh, 5, 1);
  sharpness.edges[at(a)] = 2;
  sharpness.edges[at(b)] = 3;
  sharpness.edges[at(c)] = 4;
  sharpness.edges[at(i)] = 10;  // does not fade, and does not count
  const ChildSharpness children = child_sharpness(mesh, sharpness);
  const auto child = [&](Index e, Index v) {
    const bool first = mesh.origin(mesh.halfedge_of_edge(e)) == v;
    return children.edge_ends[2 * at(e) + (first ? 0 : 1)];
  };
  EXPECT_EQ(child(a, 4), 1);  // no other there: boundary edges do not fade
  EXPECT_EQ(child(a, 5), (3 * 2 + 3.5) / 4 - 1);
  EXPECT_EQ(child(b, 5), (3 * 3 + 3.0) / 4 - 1);
  EXPECT_EQ(child(c, 5), (3 * 4 + 2.5) / 4 - 1);
  EXPECT_EQ(child(b, 6), 2);
  EXPECT_EQ(child(i, 5), 10);
}

TEST(Sharpness, IsInheritedAlongOldEdgesAndHolesWithinOldFaces) {
  for (const char* name : {"triangle-dyadic", "quad-dyadic"}) {
    const Split& split = *find_split(name);
    for (unsigned seed = 1; seed < 20; ++seed) {
      const Mesh mesh =
          split.any_polygons ? RandomMesh(seed).polygons() : RandomMesh(seed).triangles();
      std::mt19937 random(seed);
      Sharpness sharpness;
      for (Index e = 0; e < mesh.edge_count(); ++e)
        sharpness.edges.push_back(random() % 3 == 0 ? 1 + static_cast<double>(e) / 1000 : 0);
      for (Index f = 0; f < mesh.face_count(); ++f) sharpness.holes.push_back(random() % 3 == 0);
      const SplitResult fine = split.apply(mesh, 0);
      const Sharpness left = inherit(mesh, sharpness, child_sharpness(mesh, sharpness), fine);
      // dyadic splits number the halves of edge e 2e and 2e + 1, and each has one kind of faces
      for (Index e = 0; e < fine.mesh.edge_count(); ++e) {
        const bool half = e < 2 * mesh.edge_count() && !mesh.is_boundary_edge(e / 2);
        EXPECT_EQ(left.edges[at(e)], half ? after_step(sharpness.edges[at(e / 2)]) : 0);
      }
      for (Index f = 0; f < fine.mesh.face_count(); ++f)
        EXPECT_EQ(left.holes[at(f)],
                  sharpness.holes[at(split.any_polygons ? mesh.face(f) : f / 4)]);
    }
  }
}

// --- what states sharpness --------------------------------------------------------------------

TEST(Sharpness, OfTheBoundary) {
  const Mesh mesh = grid();
  Sharpness corners;
  apply_boundary_mode(mesh, BoundaryMode::edge_and_corner, corners);
  for (Index v = 0; v < 16; ++v)
    EXPECT_EQ(corners.vertices[at(v)], v == 0 || v == 3 || v == 12 || v == 15 ? 10 : 0);
  Sharpness plain;
  apply_boundary_mode(mesh, BoundaryMode::edge_only, plain);
  EXPECT_FALSE(plain.any() || plain.has_holes());
  Sharpness none;
  apply_boundary_mode(mesh, BoundaryMode::none, none);
  for (Index f = 0; f < 9; ++f) EXPECT_EQ(none.holes[at(f)], f != 4);
  Sharpness kept;  // the lower boundary stated sharp, whose ends have other edges too
  kept.edges.assign(at(mesh.edge_count()), 0);
  for (Index v = 0; v < 3; ++v) kept.edges[at(edge(mesh, v, v + 1))] = 10;
  apply_boundary_mode(mesh, BoundaryMode::none, kept);
  for (Index f = 0; f < 9; ++f) EXPECT_EQ(kept.holes[at(f)], f != 4 && f != 1);
}

TEST(Sharpness, ByAngle) {
  const Mesh mesh = cube();
  std::vector<Point3> points;
  for (const double z : {0.0, 1.0})
    for (const auto& [x, y] : {std::pair{0., 0.}, {1., 0.}, {1., 1.}, {0., 1.}})
      points.push_back({x, y, z});
  Sharpness sharpness;
  EXPECT_EQ(sharpen_by_angle(mesh, points, 90.001, sharpness), 0);
  EXPECT_FALSE(sharpness.any());
  EXPECT_EQ(sharpen_by_angle(mesh, points, 89.999, sharpness), 12);
  EXPECT_EQ(sharpness.edges, std::vector<double>(12, 10));
}

TEST(Sharpness, HolesTakeTheirOwnVerticesAlong) {
  const Mesh mesh = grid();
  std::vector<Point3> points;
  for (int v = 0; v < 16; ++v) points.push_back({v * 1.0, 0, 0});
  std::vector<bool> holes(9, false);
  holes[0] = holes[1] = true;
  std::vector<Index> kept;
  const Polygons rest = without_holes(mesh.polygons(points), holes, kept);
  EXPECT_EQ(rest.face_count(), 7);
  EXPECT_EQ(kept, (std::vector<Index>{2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}));
  EXPECT_EQ(rest.positions[0].x, 2);
  EXPECT_EQ(rest.corners[0], 0);  // face 2: vertices 2, 3, 7, 6
}

// --- tags -------------------------------------------------------------------------------------

std::string fault(const Mesh& mesh, const SharpnessTags& tags) {
  Sharpness sharpness;
  const Status status = apply_tags(mesh, {}, tags, sharpness);
  return status ? "" : status.error().text();
}

TEST(Tags, OfAMeshGiveItsSharpnessAgain) {
  const Mesh mesh = grid();
  Sharpness sharpness;
  sharpness.edges.assign(at(mesh.edge_count()), 0);
  sharpness.edges[at(edge(mesh, 5, 6))] = 2.5;
  sharpness.edges[at(edge(mesh, 6, 10))] = 10;
  sharpness.vertices.assign(16, 0);
  sharpness.vertices[9] = 0.25;
  sharpness.holes.assign(9, false);
  sharpness.holes[4] = true;
  sharpness.method = CreaseMethod::chaikin;
  Sharpness again;
  ASSERT_TRUE(apply_tags(mesh, {}, tags_of(mesh, sharpness), again).ok());
  EXPECT_EQ(again.edges, sharpness.edges);
  EXPECT_EQ(again.vertices, sharpness.vertices);
  EXPECT_EQ(again.holes, sharpness.holes);
  EXPECT_EQ(again.method, sharpness.method);
}

TEST(Tags, AreChainsWithASharpnessForAllOrEach) {
  const Mesh mesh = grid();
  SharpnessTags tags;
  tags.creases = {{{4, 5, 6, 7}, {1, 2, 3}, 0}, {{8, 9, 10}, {4}, 0}};
  Sharpness sharpness;
  ASSERT_TRUE(apply_tags(mesh, {}, tags, sharpness).ok());
  EXPECT_EQ(sharpness.edges[at(edge(mesh, 4, 5))], 1);
  EXPECT_EQ(sharpness.edges[at(edge(mesh, 6, 7))], 3);
  EXPECT_EQ(sharpness.edges[at(edge(mesh, 9, 10))], 4);
  EXPECT_EQ(
      std::count_if(sharpness.edges.begin(), sharpness.edges.end(), [](double s) { return s > 0; }),
      5);
}

TEST(Tags, ThatNameNothingAreRefusedWithTheirLine) {
  const Mesh mesh = grid();
  SharpnessTags tags;
  tags.file = "a.obj";
  tags.creases = {{{0, 5}, {1}, 7}};
  EXPECT_EQ(fault(mesh, tags),
            "a.obj:7: no edge joins the vertices 0 and 5 of a crease (these numbers begin with 0)");
  tags.creases = {{{0, 16}, {1}, 7}};
  EXPECT_EQ(fault(mesh, tags),
            "a.obj:7: vertex 16 is out of range: the mesh has 16 (these numbers begin with 0)");
  tags.creases.clear();
  tags.corners = {{20, 1, 3}};
  tags.first = 1;
  EXPECT_EQ(fault(mesh, tags), "a.obj:3: vertex 21 is out of range: the mesh has 16");
  tags.corners.clear();
  tags.holes = {{9, 4}};
  EXPECT_EQ(fault(mesh, tags), "a.obj:4: face 10 is out of range: the mesh has 9");
}

}  // namespace
}  // namespace limn::test
