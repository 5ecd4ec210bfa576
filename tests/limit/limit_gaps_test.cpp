// What a limit does not need takes nothing from it: boundary rules on a closed mesh, curvatures,
// other vertices' limits.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fast/fast_limit_check.h"
#include "limn/limit/limit_points.h"
#include "limn/refine/refine.h"
#include "limn/spectrum/eigencomponents.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

Scheme without_boundary_rules(const std::string& name) {
  Scheme scheme = shipped(name);
  for (const RuleKind kind :
       {RuleKind::boundary_vertex, RuleKind::boundary_edge, RuleKind::boundary_edge_end})
    scheme.rules[static_cast<std::size_t>(kind)].reset();
  return scheme;
}

void expect_same(const LimitPoints& found, const LimitPoints& expected) {
  EXPECT_EQ(found.positions, expected.positions);
  EXPECT_EQ(found.normals, expected.normals);
  ASSERT_EQ(found.curvatures.size(), expected.curvatures.size());
  for (std::size_t v = 0; v < found.curvatures.size(); ++v) {
    const auto &a = found.curvatures[v], &b = expected.curvatures[v];
    EXPECT_TRUE(a.largest == b.largest || (std::isnan(a.largest) && std::isnan(b.largest))) << v;
    EXPECT_TRUE(a.smallest == b.smallest || (std::isnan(a.smallest) && std::isnan(b.smallest)));
  }
}

class LimitWithoutBoundaryRules : public testing::TestWithParam<std::string> {};

// What is cut out round a vertex has a boundary that stands for nothing.
TEST_P(LimitWithoutBoundaryRules, IsThatOfClosedMeshes) {
  const Scheme& whole = shipped(GetParam());
  const Scheme scheme = without_boundary_rules(GetParam());
  const Lattice lattice = whole.split->lattice;
  std::vector<Mesh> meshes{mesh::torus(lattice, 3, 4)};
  for (const Mesh& mesh : {tetrahedron(), icosahedron(), cube()})
    if (whole.split->any_polygons || mesh.uniform_degree() == 3) meshes.push_back(mesh);
  for (const Mesh& mesh : meshes)
    for (const int level : {0, 1, 2}) {
      SCOPED_TRACE(level);
      const auto fine =
          refine::refine(scheme, mesh, random_points(mesh.vertex_count(), 1), level).value();
      LimitOptions options;
      options.steps_made = level;
      options.curvatures = true;
      const auto found = approx_limit_points(scheme, fine.mesh, fine.values, options);
      ASSERT_TRUE(found.ok()) << found.error().text();
      expect_same(*found, approx_limit_points(whole, fine.mesh, fine.values, options).value());
    }
}

INSTANTIATE_TEST_SUITE_P(Shipped, LimitWithoutBoundaryRules,
                         testing::Values("loop", "butterfly", "butterfly-modified", "sqrt3",
                                         "four-eight", "laplacian-butterfly", "catmull-clark",
                                         "doo-sabin"),
                         [](const auto& info) { return test_name(info.param); });

// Of an open mesh the limits that hang on no boundary are known; of the others the error names the
// vertex.
TEST(LimitGaps, MissingBoundaryRulesAreToldAtTheBoundary) {
  for (const char* name : {"loop", "butterfly", "catmull-clark", "sqrt3", "four-eight"}) {
    SCOPED_TRACE(name);
    const Scheme& whole = shipped(name);
    const Scheme scheme = without_boundary_rules(name);
    constexpr Index kRings = 7;
    const Mesh mesh = mesh::star(whole.split->lattice, 5, kRings);
    const auto points = random_points(mesh.vertex_count(), 2);
    LimitOptions options;
    options.curvatures = true;
    for (Index v = 0; v < mesh::star_size(whole.split->lattice, 5, 2); ++v)
      options.vertices.push_back(v);
    const auto found = approx_limit_points(scheme, mesh, points, options);
    ASSERT_TRUE(found.ok()) << found.error().text();
    expect_same(*found, approx_limit_points(whole, mesh, points, options).value());
    for (const bool partial : {false, true}) {
      options.partial = partial;
      const Index rim = mesh.vertex_count() - 1;
      options.vertices = {rim};
      const auto at_rim = approx_limit_points(scheme, mesh, points, options);
      ASSERT_FALSE(at_rim.ok());
      EXPECT_NE(at_rim.error().text().find("vertex " + std::to_string(rim) + ":"),
                std::string::npos)
          << at_rim.error().text();
      EXPECT_NE(at_rim.error().text().find("has no boundary"), std::string::npos);
    }
  }
}

TEST(LimitGaps, WhatIsBesideTheBoundaryDependsOnIt) {
  const Scheme scheme = without_boundary_rules("butterfly");
  const Mesh mesh = mesh::star(Lattice::triangle, 5, 3);
  LimitOptions options;
  const Index beside = mesh::star_size(Lattice::triangle, 5, 1);  // in ring 2
  options.vertices = {beside};
  const auto found =
      approx_limit_points(scheme, mesh, random_points(mesh.vertex_count(), 2), options);
  // an interpolating scheme's points are known, but the tangents look on
  ASSERT_FALSE(found.ok());
  EXPECT_NE(found.error().text().find("vertex " + std::to_string(beside) +
                                      ": its limit depends on the boundary"),
            std::string::npos)
      << found.error().text();
}

// A dual surface ends near its boundary, so that what is wide never becomes regular there.
TEST(LimitGaps, CurvaturesTakeNothingFromLimits) {
  const Scheme& scheme = shipped("doo-sabin");
  const Mesh mesh = must_build(4, {{0, 1, 2}, {1, 0, 3}});
  for (const int level : {0, 1, 2}) {
    const auto fine = refine::refine(scheme, mesh, random_points(4, 1), level).value();
    LimitOptions options;
    options.steps_made = level;
    const LimitPoints plain = approx_limit_points(scheme, fine.mesh, fine.values, options).value();
    options.curvatures = true;
    const auto curved = approx_limit_points(scheme, fine.mesh, fine.values, options);
    ASSERT_TRUE(curved.ok()) << curved.error().text();
    EXPECT_EQ(curved->positions, plain.positions);
    EXPECT_EQ(curved->normals, plain.normals);
    for (const auto& one : curved->curvatures) EXPECT_TRUE(std::isnan(one.largest));
  }
}

// … and limits that there are none of take nothing from the rest.
TEST(LimitGaps, OfSomeVerticesLeaveTheOthers) {
  const Scheme scheme = parse_scheme(R"(
split = "triangle-dyadic"
source = "a test: Loop, that does not converge at valence 3"
extends = "loop"
[[vertex]]
when = "n == 3"
self = "-1"
ring = "2/3"
[[vertex]]
self = "1 - n*beta"
ring = "beta"
)",
                                     "not-at-three.toml")
                            .value();
  const Mesh mesh =
      must_build(5, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4}, {2, 1, 4}, {0, 2, 4}});
  const auto fine = refine::refine(scheme, mesh, random_points(5, 1), 2).value();
  LimitOptions options;
  options.steps_made = 2;
  EXPECT_FALSE(approx_limit_points(scheme, fine.mesh, fine.values, options).ok());
  options.partial = true;
  const LimitPoints limit = approx_limit_points(scheme, fine.mesh, fine.values, options).value();
  ASSERT_EQ(limit.refused.size(), 2);
  for (const Index v : {3, 4}) {
    EXPECT_EQ(limit.refused[static_cast<std::size_t>(v - 3)].vertex, v);
    EXPECT_EQ(limit.positions[v], fine.values[v]);
    EXPECT_EQ(limit.normals[v], Point3{});
  }
  const LimitPoints next = [&] {  // limits do not hang on the level
    const auto finer = refine::refine(scheme, mesh, random_points(5, 1), 3).value();
    options.steps_made = 3;
    return approx_limit_points(scheme, finer.mesh, finer.values, options).value();
  }();
  for (std::size_t v = 0; v < fine.values.size(); ++v)
    if (v != 3 && v != 4) EXPECT_LT(distance(limit.positions[v], next.positions[v]), 1e-13) << v;
}

/// A quad of a grid whose inside is two quads that share two edges: vertex 16 has valence 2.
Mesh valence_two_in_grid() {
  return must_build(17, {{0, 1, 5, 4},
                         {1, 2, 6, 5},
                         {2, 3, 7, 6},
                         {4, 5, 9, 8},
                         {5, 6, 10, 16},
                         {5, 16, 10, 9},
                         {6, 7, 11, 10},
                         {8, 9, 13, 12},
                         {9, 10, 14, 13},
                         {10, 11, 15, 14}});
}

// Catmull-Clark's weights n² : 4 : 1 over n (n + 5) [Halstead, Kass, DeRose 1993].
TEST(ValenceTwo, HasTheClosedFormsLimit) {
  const Mesh mesh = valence_two_in_grid();
  const auto points = random_points(17, 3);
  const LimitPoints limit = approx_limit_points(shipped("catmull-clark"), mesh, points).value();
  const Point3 expected = (2.0 / 7) * points[16] + (2.0 / 7) * (points[5] + points[10]) +
                          (1.0 / 14) * (points[6] + points[9]);
  EXPECT_LT(distance(limit.positions[16], expected), 1e-15);
  for (std::size_t v = 0; v < 17; ++v) EXPECT_EQ(limit.normals[v] == Point3{}, v == 16) << v;
}

TEST(ValenceTwo, HasNoTangentPair) {
  const Scheme& scheme = shipped("catmull-clark");
  FrequencyAnalysis analysis(scheme);
  const Eigencomponents found = approx_eigencomponents(analysis.blocks(2).value());
  EXPECT_FALSE(found.tangent);
  EXPECT_FALSE(found.saddle);
  EXPECT_EQ(found.verdict.convergent, Truth::yes);
  EXPECT_EQ(found.verdict.c1_necessary, Truth::undecided);
  ASSERT_EQ(found.spectra.size(), 2);
  const auto& odd = found.spectra[1].eigenvalues;
  EXPECT_NEAR(odd[0].value.real(), 0.25, 1e-7);  // 1/4 twice, in a real block
  EXPECT_NEAR(odd[1].value.real(), 0.25, 1e-7);
  EXPECT_LT(odd[2].modulus(), 0.25 - 1e-3);
  for (const char* name : {"loop", "loop-warren", "sqrt3", "butterfly"}) {
    FrequencyAnalysis other(shipped(name));
    const Eigencomponents one = approx_eigencomponents(other.blocks(2).value());
    EXPECT_EQ(one.verdict.convergent, Truth::yes) << name;
    EXPECT_FALSE(one.tangent) << name;
    EXPECT_EQ(one.verdict.c1_necessary, Truth::undecided) << name;
  }
  for (const auto& [name, reason] :
       {std::pair{"doo-sabin", "corners"}, std::pair{"butterfly-modified", "n"}}) {
    FrequencyAnalysis other(shipped(name));
    const auto blocks = other.blocks(2);
    ASSERT_FALSE(blocks.ok()) << name;
    EXPECT_NE(blocks.error().text().find(reason), std::string::npos) << blocks.error().text();
  }
}

// Loop's vertex and its neighbours: 1 − 2χ and χ = 1/(n + 3/(8β)), β = 39/128 [Loop 1987]; √3's:
// 1/(1 + 3α) and the rest, α = 2/3 [Kobbelt 2000].
TEST(ValenceTwo, InTrianglesHasTheClosedFormsLimit) {
  for (const auto& [name, centre] : {std::pair{"loop", 16.0 / 42}, std::pair{"sqrt3", 1.0 / 3}}) {
    SCOPED_TRACE(name);
    const Scheme& scheme = shipped(name);
    for (const int level : {1, 2, 3}) {
      const auto fine = refine::refine(scheme, pillow(3), random_points(3, 8), level).value();
      LimitOptions options;
      options.steps_made = level;
      const LimitPoints limit =
          approx_limit_points(scheme, fine.mesh, fine.values, options).value();
      for (Index v = 0; v < 3; ++v) {
        ASSERT_EQ(fine.mesh.valence(v), 2);
        const Index h = fine.mesh.halfedge_of_vertex(v);
        const Point3 ring =
            fine.values[fine.mesh.target(h)] + fine.values[fine.mesh.target(fine.mesh.rotate(h))];
        EXPECT_LT(distance(limit.positions[v], centre * fine.values[v] + (1 - centre) / 2 * ring),
                  1e-15);
        EXPECT_EQ(limit.normals[v], Point3{});
      }
    }
  }
}

TEST(ValenceTwo, IsTheSameInTheQuickEngine) {
  const Scheme& scheme = shipped("catmull-clark");
  for (const Mesh& mesh : {valence_two_in_grid(), pillow(4)})
    for (const int levels : {0, 1, 2, 3}) {
      SCOPED_TRACE(levels);
      const FastRefiner refiner = FastRefiner::make(scheme, mesh, levels).value();
      const auto limit = approx_fast_limit(scheme, refiner);
      ASSERT_TRUE(limit.ok()) << limit.error().text();
      ASSERT_TRUE(*limit);
      const auto points = random_points(mesh.vertex_count(), 5);
      // the quick engine's faces may share two edges' ends: match by control vertices
      const auto plain = refine::refine(scheme, mesh, points, levels).value();
      LimitOptions options;
      options.steps_made = levels;
      const LimitPoints expected =
          approx_limit_points(scheme, plain.mesh, plain.values, options).value();
      std::vector<Point3> positions(static_cast<std::size_t>(refiner.vertex_count()));
      std::vector<Point3> normals = positions;
      FastRefiner::Scratch<double> scratch;
      refiner.evaluate_limit<double>(**limit, numbers_of(points), numbers_of(positions),
                                     numbers_of(normals), scratch);
      for (Index v = 0; v < mesh.vertex_count(); ++v) {
        EXPECT_LT(distance(positions[v], expected.positions[v]), 1e-13) << v;
        EXPECT_LT(distance(normals[v], expected.normals[v]), 1e-9) << v;
        if (mesh.valence(v) == 2 && !mesh.is_boundary_vertex(v)) EXPECT_EQ(normals[v], Point3{});
      }
    }
}

}  // namespace
}  // namespace limn::test
