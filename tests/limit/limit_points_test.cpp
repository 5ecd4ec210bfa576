// Limit positions and normals against many levels of plain refinement round single vertices, on
// random meshes with boundaries, for every shipped scheme.

#include "limn/limit/limit_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "limn/limit/limit_stencil.h"
#include "limn/refine/refine.h"
#include "limn/refine/refine_values.h"
#include "mesh/random_mesh.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

struct Patch {
  Mesh mesh;
  std::vector<Point3> values;
  Index vertex;
};

/// The faces within a few rings of the vertex.
Patch cut(const Patch& patch) {
  constexpr int kRings = 7;
  const Mesh& mesh = patch.mesh;
  std::vector<bool> near(static_cast<std::size_t>(mesh.vertex_count()), false);
  near[patch.vertex] = true;
  std::vector<bool> kept(static_cast<std::size_t>(mesh.face_count()), false);
  for (int ring = 0; ring < kRings; ++ring) {
    for (Index h = 0; h < mesh.halfedge_count(); ++h)
      if (near[mesh.origin(h)]) kept[mesh.face(h)] = true;
    for (Index h = 0; h < mesh.halfedge_count(); ++h)
      if (kept[mesh.face(h)]) near[mesh.origin(h)] = true;
  }
  std::vector<Index> name(near.size(), kNone);
  Polygons part;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (!kept[f]) continue;
    for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h) {
      Index& v = name[mesh.origin(h)];
      if (v == kNone) {
        v = static_cast<Index>(part.positions.size());
        part.positions.push_back(patch.values[mesh.origin(h)]);
      }
      part.corners.push_back(v);
    }
    part.face_begin.push_back(static_cast<Index>(part.corners.size()));
  }
  return {Mesh::build(part).value(), part.positions, name[patch.vertex]};
}

double length(const Point3& a) { return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z); }

/// The plane through the centre that fits the sum of its faces.
Point3 normal_at(const Patch& patch) {
  Point3 sum;
  const Index first = patch.mesh.halfedge_of_vertex(patch.vertex);
  for (Index h = first; h != kNone;) {
    const Point3 from = patch.values[patch.vertex];
    sum = sum + cross(patch.values[patch.mesh.target(h)] - from,
                      patch.values[patch.mesh.origin(patch.mesh.prev(h))] - from);
    h = patch.mesh.rotate(h);
    if (h == first) break;
  }
  return (1 / length(sum)) * sum;
}

/// Moves the vertex to the origin and scales its neighbours to distance about 1, so that however
/// small the patch gets its shape keeps its digits.
void centre(Patch& patch, Point3& moved, double& scale) {
  const Point3 at = patch.values[patch.vertex];
  moved = moved + scale * at;
  double size = 0;
  for (Point3& p : patch.values) p = p - at;
  for (Index h = 0; h < patch.mesh.halfedge_count(); ++h)
    if (patch.mesh.origin(h) == patch.vertex)
      size = std::max(size, length(patch.values[patch.mesh.target(h)]));
  for (Point3& p : patch.values) p = (1 / size) * p;
  scale *= size;
}

void step(const Scheme& scheme, refine::RuleTables<double>& tables, int number, Patch& patch) {
  SplitResult fine = scheme.split->apply(patch.mesh, number);
  ASSERT_TRUE(tables.prepare(patch.mesh, fine.births).ok());
  patch.values = refine::refine_values(scheme, patch.mesh, fine.births, tables, patch.values);
  patch.mesh = std::move(fine.mesh);
}

struct Errors {
  double position = 0, normal = 0;
};

/// Whether two eigenvectors lead at a boundary vertex of so many faces: not so for Loop at 6, where
/// 3/8 + cos(2π/6)/4 ties with the boundary curve's 1/2.
bool has_tangents(const Scheme& scheme, int faces) {
  return !approx_boundary_limit_stencil(scheme, faces).value().first_tangent.empty();
}

/// How far limit points are from `levels` steps of plain refinement, at vertices of a random mesh.
Errors worst_errors(const Scheme& scheme, unsigned seed, int levels) {
  const Mesh mesh = random_control(*scheme.split, seed);
  std::mt19937 numbers(seed);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Point3> values(static_cast<std::size_t>(mesh.vertex_count()));
  for (Point3& p : values) p = {coordinate(numbers), coordinate(numbers), coordinate(numbers)};
  Errors errors;
  LimitOptions options;
  options.partial = true;
  const Result<LimitPoints> limit = approx_limit_points(scheme, mesh, values, options);
  EXPECT_TRUE(limit.ok()) << scheme.name << ' ' << seed << ": " << limit.error().text();
  if (!limit) return errors;
  refine::RuleTables<double> tables(scheme);
  for (Index v = 0; v < mesh.vertex_count(); v += 1 + mesh.vertex_count() / 5) {
    if (mesh.is_isolated(v)) continue;
    const bool two = mesh.valence(v) == 2 && !mesh.is_boundary_vertex(v);
    if (two && scheme.split->lattice == Lattice::triangle) continue;  // they have none
    EXPECT_TRUE(limit->refused.empty() || scheme.split->lattice == Lattice::triangle);
    Patch patch{mesh, values, v};
    Point3 moved;
    double scale = 1;
    for (int i = 0; i < levels; ++i) {
      step(scheme, tables, i, patch);
      if (i > 2) patch = cut(patch);
      centre(patch, moved, scale);
    }
    errors.position = std::max(errors.position, length(moved - limit->positions[v]));
    const bool boundary = mesh.is_boundary_vertex(v);
    if (two) EXPECT_EQ(length(limit->normals[v]), 0);
    if (two || (boundary && !has_tangents(scheme, mesh.valence(v) - 1))) continue;
    errors.normal = std::max(errors.normal, length(normal_at(patch) - limit->normals[v]));
  }
  return errors;
}

class LimitPointsOf : public testing::TestWithParam<std::string> {};

TEST_P(LimitPointsOf, AreWhereRefinementGoes) {
  const Scheme& scheme = shipped(GetParam());
  // patches as small as those: at a corner the second tangent shrinks against the first at each
  // step
  const int levels = scheme.split->dilation.growth() > 4 ? 26 : 42;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const Errors errors = worst_errors(scheme, seed, levels);
    EXPECT_LT(errors.position, 1e-11) << seed;
    EXPECT_LT(errors.normal, 0.04) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, LimitPointsOf,
                         testing::Values("loop", "catmull-clark", "sqrt3", "four-eight", "optimal",
                                         "butterfly-modified", "laplacian-loop", "loop-ternary",
                                         "laplacian-butterfly"),
                         [](const auto& info) { return test_name(info.param); });

// Whatever the level at which they are asked for. At odd ones the boundary has yet to be cut.
class LimitPointsAtAnyLevel : public testing::TestWithParam<std::string> {};

TEST_P(LimitPointsAtAnyLevel, AreThoseOfTheNextLevel) {
  const Scheme& scheme = shipped(GetParam());
  int open = 0;
  for (unsigned seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    const Mesh mesh = random_control(*scheme.split, seed);
    std::vector<Point3> values;
    for (Index v = 0; v < mesh.vertex_count(); ++v)
      values.push_back({std::sin(v), std::cos(3.0 * v), std::sin(5.0 * v)});
    std::vector<Point3> before;
    for (int level = 0; level <= 3; ++level) {
      const auto fine = refine::refine(scheme, mesh, values, level).value();
      LimitOptions options;
      options.steps_made = level;
      const auto limit = approx_limit_points(scheme, fine.mesh, fine.values, options);
      if (!limit) break;  // a vertex of two faces
      // old vertices keep their numbers
      for (std::size_t v = 0; v < before.size(); ++v)
        EXPECT_LT(length(limit->positions[v] - before[v]), 1e-11) << level;
      before = limit->positions;
    }
    for (Index v = 0; v < mesh.vertex_count(); ++v) open += mesh.is_boundary_vertex(v) ? 1 : 0;
  }
  EXPECT_GT(open, 0);
}

INSTANTIATE_TEST_SUITE_P(Shipped, LimitPointsAtAnyLevel, testing::Values("sqrt3", "four-eight"),
                         [](const auto& info) { return test_name(info.param); });

// Its matrix is dense: beyond a size it would take hours, and all memory.
TEST(LimitPoints, OfHugeFansAreRefusedAtOnce) {
  for (const char* name : {"loop", "catmull-clark", "sqrt3", "four-eight"})
    for (const int faces : {1100, 1'000'000'000}) {
      const Result<LimitStencil> found = approx_boundary_limit_stencil(shipped(name), faces);
      ASSERT_FALSE(found);
      EXPECT_NE(found.error().text().find("too large for limit points"), std::string::npos);
    }
}

// The corners born round a vertex of a closed mesh have the limit as their mean.
TEST(LimitPoints, OfDooSabinAreCentroidsOfTheFirstStepsFaces) {
  const Scheme& scheme = shipped("doo-sabin");
  const Mesh mesh = icosahedron();
  std::vector<Point3> values;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    values.push_back({std::sin(v), std::cos(3.0 * v), std::sin(5.0 * v)});
  const LimitPoints limit = approx_limit_points(scheme, mesh, values).value();
  refine::RuleTables<double> tables(scheme);
  Patch patch{mesh, values, 0};
  step(scheme, tables, 0, patch);
  std::vector<Point3> mean(values.size());
  for (Index h = 0; h < mesh.halfedge_count(); ++h)
    mean[mesh.origin(h)] = mean[mesh.origin(h)] + 0.2 * patch.values[h];
  for (std::size_t v = 0; v < values.size(); ++v)
    EXPECT_LT(length(limit.positions[v] - mean[v]), 1e-14);
}

// Of mid-edge the middles of the edges round a vertex have it.
TEST(LimitPoints, OfMidEdgeAreHalfTheVertexAndHalfItsNeighbours) {
  const Mesh mesh = icosahedron();
  std::vector<Point3> values;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    values.push_back({std::sin(v), std::cos(3.0 * v), std::sin(5.0 * v)});
  const LimitPoints limit = approx_limit_points(shipped("midedge"), mesh, values).value();
  std::vector<Point3> expected(values.size());
  for (Index h = 0; h < mesh.halfedge_count(); ++h) {
    Point3& sum = expected[mesh.origin(h)];
    sum = sum + 0.1 * (values[mesh.origin(h)] + values[mesh.target(h)]);
  }
  for (std::size_t v = 0; v < values.size(); ++v)
    EXPECT_LT(length(limit.positions[v] - expected[v]), 1e-14);
}

// At the boundary of a dual scheme the nearest point of the surface: for one face its centre.
TEST(LimitPoints, OfDooSabinStayOnAnOpenSurface) {
  const Mesh mesh = mesh::fan(Lattice::quad, 2, 2);
  std::vector<Point3> values;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    values.push_back({std::sin(v), std::cos(3.0 * v), std::sin(5.0 * v)});
  const LimitPoints limit = approx_limit_points(shipped("doo-sabin"), mesh, values).value();
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const Index h = mesh.halfedge_of_vertex(v);
    if (mesh.valence(v) != 2) continue;
    Point3 centre;
    for (Index i = mesh.face_begin(mesh.face(h)); i < mesh.face_begin(mesh.face(h) + 1); ++i)
      centre = centre + 0.25 * values[mesh.origin(i)];
    EXPECT_LT(length(limit.positions[v] - centre), 1e-14) << v;
  }
}

/// Control points of the lattice star over a quadratic surface.
std::vector<Point3> over_plane(Lattice lattice, const Mesh& mesh, double a, double b, double c) {
  std::vector<Point3> values(static_cast<std::size_t>(mesh.vertex_count()));
  for (Index v = 0; v < mesh.vertex_count(); ++v) {  // tori of 12 vertices a side
    const double i = v % 12 - 6;
    const double j = v / 12 - 6;
    const double x = lattice == Lattice::triangle ? i - j / 2 : i;
    const double y = lattice == Lattice::triangle ? j * std::sqrt(0.75) : j;
    values[v] = {x, y, (a * x * x + 2 * b * x * y + c * y * y) / 2};
  }
  return values;
}

TEST(LimitPoints, HaveTheCurvatureOfQuadraticSurfaces) {
  for (const auto& [name, lattice] : {std::pair{"loop", Lattice::triangle},
                                      {"catmull-clark", Lattice::quad},
                                      {"four-eight", Lattice::quad}}) {
    const Mesh mesh = mesh::torus(lattice, 12, 12);
    LimitOptions options;
    options.curvatures = true;
    const Index middle = 6 * 12 + 6;
    options.vertices = {middle};
    const LimitPoints limit =
        approx_limit_points(shipped(name), mesh, over_plane(lattice, mesh, 0.3, 0.2, -0.5), options)
            .value();
    const double mean = (0.3 - 0.5) / 2;
    const double spread = std::hypot((0.3 + 0.5) / 2, 0.2);
    EXPECT_NEAR(limit.curvatures[middle].largest, mean + spread, 1e-12) << name;
    EXPECT_NEAR(limit.curvatures[middle].smallest, mean - spread, 1e-12) << name;
    EXPECT_NEAR(limit.normals[middle].z, 1, 1e-12) << name;
  }
}

// … whose parameters' lines are not orthogonal: the twist counts.
TEST(LimitPoints, HaveTheCurvatureOfQuadraticSurfacesOverSkewMeshes) {
  for (const auto& [name, lattice] : {std::pair{"loop", Lattice::triangle},
                                      {"catmull-clark", Lattice::quad},
                                      {"doo-sabin", Lattice::quad}}) {
    const Mesh mesh = mesh::torus(lattice, 12, 12);
    std::vector<Point3> values(static_cast<std::size_t>(mesh.vertex_count()));
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const double i = v % 12 - 6, j = v / 12 - 6;
      const double x = i + 0.4 * j, y = 0.8 * j;
      values[v] = {x, y, (0.3 * x * x + 0.4 * x * y - 0.5 * y * y) / 2};
    }
    LimitOptions options;
    options.curvatures = true;
    const Index middle = 6 * 12 + 6;
    options.vertices = {middle};
    const LimitPoints limit = approx_limit_points(shipped(name), mesh, values, options).value();
    const double mean = (0.3 - 0.5) / 2, spread = std::hypot((0.3 + 0.5) / 2, 0.2);
    EXPECT_NEAR(limit.curvatures[middle].largest, mean + spread, 1e-12) << name;
    EXPECT_NEAR(limit.curvatures[middle].smallest, mean - spread, 1e-12) << name;
  }
}

// Loop's saddles are flat at valence 5, so what is left of the curvature there is a cup's.
TEST(LimitPoints, HaveTheCurvatureOfTheLimitOfACup) {
  const Scheme& scheme = shipped("loop");
  const Mesh mesh = mesh::star(Lattice::triangle, 5, 5);
  std::vector<Point3> values(static_cast<std::size_t>(mesh.vertex_count()));
  Index v = 1;
  for (int ring = 1; ring <= 5; ++ring)
    for (int k = 0; k < 5 * ring; ++k, ++v) {
      const double angle = 2 * M_PI * k / (5.0 * ring);
      values[v] = {ring * std::cos(angle), ring * std::sin(angle), 0.2 * ring * ring};
    }
  LimitOptions options;
  options.curvatures = true;
  options.vertices = {0};
  const LimitPoints::Curvatures found =
      approx_limit_points(scheme, mesh, values, options)->curvatures[0];
  EXPECT_NEAR(found.largest, found.smallest, 1e-12);
  Patch patch{mesh, values, 0};
  refine::RuleTables<double> tables(scheme);
  for (int i = 0; i < 12; ++i) {
    step(scheme, tables, i, patch);
    if (i > 1) patch = cut(patch);
  }
  LimitOptions near;
  const Index next = patch.mesh.target(patch.mesh.halfedge_of_vertex(patch.vertex));
  near.vertices = {patch.vertex, next};
  const LimitPoints limit = approx_limit_points(scheme, patch.mesh, patch.values, near).value();
  const Point3 chord = limit.positions[next] - limit.positions[patch.vertex];
  const double expected = 2 * chord.z / (chord.x * chord.x + chord.y * chord.y);
  EXPECT_NEAR(found.largest, expected, 1e-4 * expected);
}

// No one curvature where a frequency that no quadratic has is as slow as the quadratics, and none
// where it is not bounded.
TEST(LimitPoints, HaveNoCurvatureWhereItIsNotBounded) {
  const Mesh mesh = mesh::star(Lattice::triangle, 8, 4);
  std::vector<Point3> values(static_cast<std::size_t>(mesh.vertex_count()), Point3{1, 2, 3});
  LimitOptions options;
  options.curvatures = true;
  options.vertices = {0};
  const LimitPoints limit = approx_limit_points(shipped("loop"), mesh, values, options).value();
  EXPECT_TRUE(std::isnan(limit.curvatures[0].largest));
  EXPECT_EQ(length(limit.normals[0]), 0);  // all points are one
}

}  // namespace
}  // namespace limn::test
