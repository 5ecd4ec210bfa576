// Limit points of meshes with infinite creases, corners and darts.

#include "limn/limit/crease_limit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "limn/refine/refine.h"
#include "refine/crease_meshes.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

Sharpness random_infinite(const Mesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  Sharpness sharpness;
  for (Index e = 0; e < mesh.edge_count(); ++e)
    sharpness.edges.push_back(random() % 4 == 0 ? kInfinitelySharp : 0);
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    sharpness.vertices.push_back(random() % 12 == 0 ? kInfinitelySharp : 0);
  return sharpness;
}

Result<limit::SharpLimitPoints> limit_after(const Scheme& scheme, const Mesh& mesh,
                                            const std::vector<Point3>& points,
                                            const Sharpness& sharpness, int levels) {
  const auto fine = refine::refine(scheme, mesh, points, levels, {}, sharpness);
  if (!fine) return fine.error();
  LimitOptions options;
  options.steps_made = levels;
  return limit::approx_limit_points(scheme, fine->mesh, fine->values, fine->sharpness, options);
}

class CreaseLimits : public ::testing::TestWithParam<std::string> {};

// The limit of a control vertex is that of its child.
TEST_P(CreaseLimits, DoNotDependOnTheLevel) {
  const Scheme& scheme = shipped(GetParam());
  int compared = 0;
  for (unsigned seed = 1; seed < 40 && compared < 4; ++seed) {
    const Mesh mesh =
        scheme.split->any_polygons ? RandomMesh(seed).polygons() : RandomMesh(seed).triangles();
    if (mesh.vertex_count() > 60) continue;
    std::vector<Point3> points;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (Index v = 0; v < mesh.vertex_count(); ++v)
      points.push_back({uniform(random), uniform(random), uniform(random)});
    const Sharpness sharpness = random_infinite(mesh, seed);
    const int step = scheme.split->boundary_rests() ? 2 : 1;
    const auto first = limit_after(scheme, mesh, points, sharpness, step);
    const auto second = limit_after(scheme, mesh, points, sharpness, 2 * step);
    if (!first || !second) continue;  // no rule for some boundary
    for (std::size_t v = 0; v < points.size(); ++v) {
      EXPECT_LT(distance(first->positions[v], second->positions[v]), 1e-11)
          << GetParam() << ", seed " << seed << ", vertex " << v;
      if (sharpness.vertices[v] > 0) EXPECT_EQ(first->positions[v], points[v]);
    }
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

INSTANTIATE_TEST_SUITE_P(Shipped, CreaseLimits,
                         ::testing::Values("loop", "catmull-clark", "butterfly", "optimal",
                                           "laplacian-loop", "laplacian-butterfly", "sqrt3",
                                           "four-eight"),
                         [](const auto& one) { return test_name(one.param); });

class CreaseLimitLaws : public ::testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] const Scheme& scheme() const { return shipped(GetParam()); }
};

/// The normal at a corner's vertex, on the side of its face.
Point3 normal_at(const limit::SharpLimitPoints& limit, const Mesh& mesh, Index corner) {
  const Index side = limit.sides.empty() ? kNone : limit.sides.of_corner[at(corner)];
  return side == kNone ? limit.normals[at(mesh.origin(corner))] : limit.sides.normals[at(side)];
}

// A crease is a boundary that is seen from either side: limits are those of the mesh that is cut
// there, and each side has the normal of its part.
TEST_P(CreaseLimitLaws, AreThoseOfTheMeshCutThere) {
  std::mt19937 random(8);
  int compared = 0;
  for (unsigned seed = 1; seed < 60 && compared < 4; ++seed) {
    const Mesh mesh = control_mesh(scheme(), seed);
    const std::vector<bool> inside = region(mesh, random);
    if (inside.empty() || mesh.vertex_count() > 80) continue;
    const Polygons whole = mesh.polygons(random_points(mesh.vertex_count(), seed));
    const auto limit =
        limit::approx_limit_points(scheme(), mesh, whole.positions, rim_of(mesh, inside));
    if (!limit) continue;  // no rule for some boundary
    for (const bool which : {false, true}) {
      const Polygons polygons = part_of(whole, inside, which);
      const Result<Mesh> part = Mesh::build(polygons);
      if (!part) continue;
      const auto of_part = approx_limit_points(scheme(), *part, polygons.positions);
      if (!of_part) continue;
      Index corner = 0;  // of the part: its faces stand in the same order
      for (Index h = 0; h < mesh.halfedge_count(); ++h) {
        if (inside[at(mesh.face(h))] != which) continue;
        const Index v = mesh.origin(h), copy = polygons.corners[at(corner++)];
        ASSERT_EQ(whole.positions[at(v)], polygons.positions[at(copy)]);
        EXPECT_LT(distance(limit->positions[at(v)], of_part->positions[at(copy)]), 1e-10)
            << "seed " << seed << ", vertex " << v;
        EXPECT_LT(distance(normal_at(*limit, mesh, h), of_part->normals[at(copy)]), 1e-7)
            << "seed " << seed << ", vertex " << v;
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, 0);
}

// What fades is smooth after so many steps, of whatever mesh the limit is asked for.
TEST_P(CreaseLimitLaws, OfWhatFadesAreThoseOfTheSmoothMeshLater) {
  if (scheme().split->boundary_rests()) GTEST_SKIP() << "takes infinite sharpness only";
  // these are not C1 at some valences, or at corners, where the rule of a smooth boundary gives 1/2
  // a third time; the normal is that of the faces some steps on there
  const bool has_planes = GetParam().find("butterfly") == std::string::npos &&
                          GetParam().find("piecewise-smooth") == std::string::npos &&
                          GetParam() != "interpolating-loop";
  int compared = 0;
  for (unsigned seed = 1; seed < 60 && compared < 3; ++seed) {
    const Mesh mesh = control_mesh(scheme(), seed);
    if (mesh.vertex_count() > 20) continue;
    const std::vector<Point3> points = random_points(mesh.vertex_count(), seed);
    Sharpness sharpness = random_sharpness(mesh, seed, 0.3, seed % 2 == 0);
    if (seed % 3 == 0) sharpness.method = CreaseMethod::chaikin;
    if (compared % 2 == 1)  // some of it stays
      for (std::size_t e = 0; e < sharpness.edges.size(); e += 5)
        sharpness.edges[e] = kInfinitelySharp;
    const auto early = limit_after(scheme(), mesh, points, sharpness, 0);
    const auto late = limit_after(scheme(), mesh, points, sharpness, 3);
    if (!early || !late) continue;  // no rule for some boundary
    for (std::size_t v = 0; v < points.size(); ++v) {
      EXPECT_LT(distance(early->positions[v], late->positions[v]), 1e-10)
          << "seed " << seed << ", vertex " << v;
      if (has_planes)
        EXPECT_LT(distance(early->normals[v], late->normals[v]), 1e-6)
            << "seed " << seed << ", vertex " << v;
    }
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

INSTANTIATE_TEST_SUITE_P(Shipped, CreaseLimitLaws, ::testing::ValuesIn(schemes_that_take_creases()),
                         [](const auto& one) { return test_name(one.param); });

/// The same mesh, its faces in another order and from other corners on, so that any half-edge may
/// be a vertex's first.
Mesh shuffled(const Mesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::vector<Index>> faces;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    std::vector<Index> corners;
    for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h)
      corners.push_back(mesh.origin(h));
    std::rotate(corners.begin(), corners.begin() + random() % corners.size(), corners.end());
    faces.push_back(std::move(corners));
  }
  std::shuffle(faces.begin(), faces.end(), random);
  Polygons polygons;
  polygons.positions.resize(at(mesh.vertex_count()));
  for (const std::vector<Index>& corners : faces) {
    polygons.corners.insert(polygons.corners.end(), corners.begin(), corners.end());
    polygons.face_begin.push_back(static_cast<Index>(polygons.corners.size()));
  }
  return Mesh::build(polygons).value();
}

void expect_normals_of_a_cube(const Mesh& mesh, int levels) {
  const std::vector<Point3> points{{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                   {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  Sharpness sharpness;
  sharpness.edges.assign(12, kInfinitelySharp);
  const auto fine =
      refine::refine(shipped("catmull-clark"), mesh, points, levels, {}, sharpness).value();
  const limit::SharpLimitPoints limit =
      limit::approx_limit_points(shipped("catmull-clark"), fine.mesh, fine.values, fine.sharpness)
          .value();
  for (Index h = 0; h < fine.mesh.halfedge_count(); ++h) {
    const Index f = fine.mesh.face_begin(fine.mesh.face(h));
    const Point3 a = fine.values[at(fine.mesh.origin(f))];
    const Point3 b = fine.values[at(fine.mesh.origin(f + 1))] - a;
    const Point3 c = fine.values[at(fine.mesh.origin(f + 2))] - a;
    const Point3 n{b.y * c.z - b.z * c.y, b.z * c.x - b.x * c.z, b.x * c.y - b.y * c.x};
    const Point3 unit = (1 / std::sqrt(dot(n, n))) * n;
    EXPECT_LT(distance(normal_at(limit, fine.mesh, h), unit), 1e-13);
  }
}

TEST(CreaseLimit, HasTheNormalsOfACubesFaces) {
  for (const int levels : {0, 2}) expect_normals_of_a_cube(cube(), levels);
  for (unsigned seed = 0; seed < 8; ++seed) expect_normals_of_a_cube(shuffled(cube(), seed), 0);
}

// Of a single face the tangents are its edges, by Loop's and Catmull and Clark's rules.
TEST(CreaseLimit, HasTheNormalsOfSharpFacesAtTheirCorners) {
  for (const std::string name : {"loop", "catmull-clark"}) {
    const Scheme& scheme = shipped(name);
    unsigned seed = 4;
    const Mesh mesh = control_mesh(scheme, seed);
    const std::vector<Point3> points = random_points(mesh.vertex_count(), seed);
    Sharpness sharpness;
    sharpness.edges.assign(at(mesh.edge_count()), kInfinitelySharp);
    sharpness.vertices.assign(at(mesh.vertex_count()), kInfinitelySharp);
    const limit::SharpLimitPoints limit =
        limit::approx_limit_points(scheme, mesh, points, sharpness).value();
    for (Index h = 0; h < mesh.halfedge_count(); ++h) {
      const Point3 p = points[at(mesh.origin(h))];
      const Point3 b = points[at(mesh.target(h))] - p;
      const Point3 c = points[at(mesh.origin(mesh.prev(h)))] - p;
      const Point3 n{b.y * c.z - b.z * c.y, b.z * c.x - b.x * c.z, b.x * c.y - b.y * c.x};
      EXPECT_LT(distance(normal_at(limit, mesh, h), (1 / std::sqrt(dot(n, n))) * n), 1e-10)
          << name << ", corner " << h;
    }
  }
}

// A cone's tip has no normal, nor has a vertex that is sharp amid a smooth surface.
TEST(CreaseLimit, HasNoNormalAtATip) {
  const Mesh mesh = cube();
  unsigned seed = 2;
  Sharpness sharpness;
  sharpness.vertices.assign(8, 0);
  sharpness.vertices[3] = kInfinitelySharp;
  const limit::SharpLimitPoints limit =
      limit::approx_limit_points(shipped("catmull-clark"), mesh, random_points(8, seed), sharpness)
          .value();
  EXPECT_EQ(limit.normals[3], Point3{});
  EXPECT_NE(limit.normals[2], Point3{});
  EXPECT_TRUE(limit.sides.empty());
}

TEST(CreaseLimit, OfACubicCreaseIsThatOfItsSpline) {
  const Mesh mesh = mesh::torus(Lattice::quad, 5, 5);
  std::vector<Point3> points;
  std::mt19937 random(3);
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    points.push_back({static_cast<double>(random() % 100), static_cast<double>(random() % 100), 0});
  Sharpness sharpness;  // along the row 0 … 4
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index h = mesh.halfedge_of_edge(e);
    sharpness.edges.push_back(mesh.origin(h) < 5 && mesh.target(h) < 5 ? kInfinitelySharp : 0);
  }
  const limit::SharpLimitPoints limit =
      limit::approx_limit_points(shipped("catmull-clark"), mesh, points, sharpness).value();
  EXPECT_EQ(limit.sides.normals.size(), 10U);  // each on two sides
  for (std::size_t v = 0; v < 5; ++v) {
    const Point3 expected =
        (1.0 / 6) * points[(v + 4) % 5] + (2.0 / 3) * points[v] + (1.0 / 6) * points[(v + 1) % 5];
    EXPECT_LT(distance(limit.positions[v], expected), 1e-12);
    EXPECT_EQ(limit.normals[v], Point3{});
  }
  EXPECT_NE(limit.normals[12], Point3{});
}

}  // namespace
}  // namespace limn::test
