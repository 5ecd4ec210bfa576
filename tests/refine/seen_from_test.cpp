/// Rules that stand in for others, seen from an edge's end or a face's corner: who takes them,
/// means of several, and every reading of them against the plain engine.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "limn/limit/limit_points.h"
#include "limn/refine/linear_form.h"
#include "limn/refine/subdivision_matrix.h"
#include "limn/spectrum/frequency_blocks.h"
#include "mesh/random_mesh.h"
#include "scheme/refined.h"
#include "support/frequency.h"

namespace limn::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// The weights of each new vertex over the old ones.
std::vector<refine::LinearForm<double>> forms(
    const Scheme& scheme, const Mesh& mesh, const Births& births,
    refine::Boundary boundary = refine::Boundary::refined) {
  refine::RuleTables<double> tables(scheme, boundary);
  const Status ready = tables.prepare(mesh, births);
  EXPECT_TRUE(ready.ok()) << (ready ? "" : ready.error().text());
  return refine::refine_values(scheme, mesh, births, tables,
                               refine::unit_forms<double>(mesh.vertex_count()));
}

// --- faces ----------------------------------------------------------------------------------

/// Seen from a corner of valence 3 or 5 the face's vertex is that corner; of others, the mean.
constexpr const char* kCorner = R"toml(
split = "quad-dyadic"
vertex = { self = 1 }
edge = { end = "1/2" }
face = { corner = "1/n" }
boundary.vertex = { self = 1 }
boundary.edge = { end = "1/2" }
[[face-end]]
when = "n == 3 or n == 5"
self = 1
)toml";

TEST(FaceEnd, TakesTheMeanOfItsInteriorCorners) {
  const Scheme scheme = must_parse(kCorner);
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Mesh mesh = RandomMesh(seed).polygons();
    const SplitResult split = scheme.split->apply(mesh, 0);
    const auto fresh = forms(scheme, mesh, split.births);
    for (Index f = 0; f < mesh.face_count(); ++f) {
      std::map<Index, double> expected;
      double claims = 0;
      for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h) {
        const Index v = mesh.origin(h), n = mesh.valence(v);
        if (mesh.degree(f) != 4 || mesh.is_boundary_vertex(v) || (n != 3 && n != 5)) continue;
        expected[v] += 1;
        ++claims;
      }
      if (claims == 0) {
        claims = mesh.degree(f);
        for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h)
          expected[mesh.origin(h)] += 1;
      }
      const auto& form = fresh[split.births.from_vertices + split.births.from_edges + f];
      ASSERT_EQ(form.terms.size(), expected.size());
      for (const auto& [v, count] : expected)
        EXPECT_NEAR(form.coefficient(v), count / claims, 1e-14);
    }
  }
}

/// All named roles of a face's corner at once: on a star they are what they say they are.
TEST(FaceEnd, HasRolesThatGoRoundTheCorner) {
  const Scheme scheme = must_parse(R"toml(
split = "quad-dyadic"
vertex = { self = 1 }
edge = { end = "1/2" }
face = { corner = "1/n" }
[[face-end]]
when = "n == 5"
self = "1 - 31 - 341 - 2*1000 - 5000"
ring = "2^k"
diagonal = "4^k"
next = "1000"
opposite = "5000"
)toml");
  const Mesh mesh = mesh::star(Lattice::quad, 5, 2);
  const SplitResult split = scheme.split->apply(mesh, 0);
  const auto fresh = forms(scheme, mesh, split.births, refine::Boundary::left_out);
  // vertices of ring 1: 1 + 2j a neighbour, 2 + 2j the corner opposite 0 in face j
  const auto neighbour = [](Index j) { return 1 + 2 * ((j + 5) % 5); };
  const auto opposite = [](Index j) { return 2 + 2 * ((j + 5) % 5); };
  Index h = 0;  // from the centre to neighbour j, face j on its left
  for (Index j = 0; j < 5; ++j, h = mesh.rotate(h)) {
    const auto& form = fresh[split.births.from_vertices + split.births.from_edges + mesh.face(h)];
    EXPECT_NEAR(form.coefficient(0), 1 - 31 - 341 - 7000, 1e-9);
    for (Index k = 0; k < 5; ++k) {
      // half from either of the face's two edges at the corner, away from the face
      const double ring = (std::pow(2, k) + std::pow(2, 4 - k)) / 2;
      EXPECT_NEAR(form.coefficient(neighbour(j - k)), ring + (k == 0 || k == 4 ? 1000 : 0), 1e-9);
      const double round = (std::pow(4, k) + std::pow(4, (5 - k) % 5)) / 2;
      EXPECT_NEAR(form.coefficient(opposite(j + k)), round + (k == 0 ? 5000 : 0), 1e-9);
    }
  }
}

// --- every reading --------------------------------------------------------------------------

/// Rules at edges' ends and faces' corners, and old and edge vertices that weigh faces' new ones.
constexpr const char* kEverywhere = R"toml(
split = "quad-dyadic"
vertex = { self = "1/2", ring = "1/(4*n)", face = "1/(4*n)" }
edge = { end = "1/4", face = "1/4" }
face = { corner = "1/n" }
boundary.vertex = { self = "3/4", next = "1/8" }
boundary.edge = { end = "1/2" }
[[edge-end]]
when = "n != 4"
self = "3/8"
ring = "(1/2 + cos(2*pi*k/n)/2)/n"
diagonal = "1/(8*n)"
[[face-end]]
when = "n != 4"
self = "1/4"
ring = "(1/2 + cos(pi*(2*k + 1)/n)/3)/n"
diagonal = "(1/8 + cos(2*pi*k/n)/5)/n"
opposite = "1/8"
)toml";

TEST(FaceEnd, HasTheBlocksOfItsMatrix) {
  const Scheme scheme = must_parse(kEverywhere);
  for (const int n : {3, 5, 6, 7, 12}) {
    const FrequencyBlocks blocks = FrequencyAnalysis(scheme, 2).blocks(n).value();
    ASSERT_EQ(blocks.blocks.size(), static_cast<std::size_t>(n / 2 + 1));
    for (int omega = 0; omega <= n / 2; ++omega) {
      const Eigen::MatrixXcd dense = frequency_block(scheme, n, 2, omega);
      const auto own = eigenvalues(blocks.blocks[static_cast<std::size_t>(omega)]);
      ASSERT_EQ(static_cast<std::size_t>(dense.rows()), own.size());
      for (const auto& value : own) EXPECT_LT(eigenvalue_defect(dense, value.real()), 1e-10);
    }
  }
}

TEST(FaceEnd, HasLimitsThatRefinementGoesTo) {
  const Scheme scheme = must_parse(kEverywhere);
  for (const Mesh& mesh : {cube(), mesh::star(Lattice::quad, 5, 2), mesh::face_star(6, 2)}) {
    std::vector<Point3> points(static_cast<std::size_t>(mesh.vertex_count()));
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i] = {std::cos(3. * static_cast<double>(i)), static_cast<double>(i % 5), 0.1};
    const auto limits = approx_limit_points(scheme, mesh, points);
    ASSERT_TRUE(limits.ok()) << limits.error().text();
    const auto fine = refine::refine(scheme, mesh, points, 5);
    ASSERT_TRUE(fine.ok());
    const auto finer = approx_limit_points(scheme, fine->mesh, fine->values);
    ASSERT_TRUE(finer.ok()) << finer.error().text();
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      EXPECT_NEAR(limits->positions[v].x, finer->positions[v].x, 1e-9);
      EXPECT_NEAR(limits->positions[v].y, finer->positions[v].y, 1e-9);
    }
  }
}

/// A vertex with very many faces: its sums are made by Fourier transforms, as if one by one.
TEST(FaceEnd, IsQuickRoundManyFaces) {
  const Scheme scheme = must_parse(kEverywhere);
  const Mesh mesh = mesh::star(Lattice::quad, 600, 1);
  const std::vector<double> x = random_values(mesh);
  std::vector<Point3> points;
  for (const double value : x) points.push_back({value, 1 - value, 2 * value});
  const auto quick = refine::refine(scheme, mesh, points, 1);
  const auto plain = refine::refine<double>(scheme, mesh, x, 1);
  ASSERT_TRUE(quick.ok() && plain.ok());
  for (std::size_t i = 0; i < plain->values.size(); ++i)
    ASSERT_NEAR(quick->values[i].x, plain->values[i], 1e-12) << i;
}

// --- the boundary ---------------------------------------------------------------------------

/// H. Biermann, A. Levin, D. Zorin: Piecewise smooth subdivision surfaces with normal control,
/// 2000: near a smooth boundary vertex of n - 1 faces, and a corner that stays.
constexpr const char* kBiermann = R"toml(
extends = "loop"
split = "triangle-dyadic"
[[boundary.vertex]]
when = "n == 2"
self = 1
[[boundary.vertex]]
self = "3/4"
next = "1/8"
[[boundary.spoke]]
self = "1/4 + cos(pi/(n - 1))/4"
far  = "1/2 - cos(pi/(n - 1))/4"
wing = "1/8"
)toml";

TEST(BoundarySpoke, IsBiermannLevinAndZorins) {
  const Scheme scheme = must_parse(kBiermann);
  const Scheme loop = find_scheme("loop").value();
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Mesh mesh = RandomMesh(seed).triangles();
    const SplitResult split = scheme.split->apply(mesh, 0);
    const auto fresh = forms(scheme, mesh, split.births), plain = forms(loop, mesh, split.births);
    for (Index e = 0; e < mesh.edge_count(); ++e) {
      const Index h = mesh.halfedge_of_edge(e), twin = mesh.twin(h);
      const auto& form = fresh[split.births.from_vertices + e];
      if (twin == kNone) continue;
      std::map<Index, double> expected;
      double claims = 0;
      for (const Index out : {h, twin}) {
        const Index v = mesh.origin(out);
        if (!mesh.is_boundary_vertex(v)) continue;
        const double cosine = std::cos(kPi / (mesh.valence(v) - 1));
        expected[v] += 1 / 4. + cosine / 4;
        expected[mesh.target(out)] += 1 / 2. - cosine / 4;
        for (const Index side : {h, twin}) expected[mesh.target(mesh.next(side))] += 1 / 8.;
        ++claims;
      }
      if (claims == 0) {
        EXPECT_EQ(form.terms, plain[split.births.from_vertices + e].terms);
        continue;
      }
      for (const auto& [v, weight] : expected)
        EXPECT_NEAR(form.coefficient(v), weight / claims, 1e-14);
    }
  }
}

TEST(BoundaryEdgeEnd, MayEndACurveAtACorner) {
  const Scheme scheme = must_parse(R"toml(
extends = "kobbelt-quad"
split = "quad-dyadic"
[roles."boundary.edge-end"]
past = "vbv"
[[boundary.edge-end]]
when = "n == 2"
near = "3/8"
far = "3/4"
past = "-1/8"
)toml");
  const Mesh mesh = must_build(8, {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}});  // a strip of three
  const SplitResult split = scheme.split->apply(mesh, 0);
  const auto fresh = forms(scheme, mesh, split.births);
  const auto on = [&](Index a, Index b) {
    for (Index e = 0;; ++e) {
      const Index h = mesh.halfedge_of_edge(e), v = mesh.origin(h), w = mesh.target(h);
      if ((v == a && w == b) || (v == b && w == a)) return fresh[split.births.from_vertices + e];
    }
  };
  EXPECT_EQ(on(0, 1).coefficient(0), 3 / 8.);  // seen from the corner 0
  EXPECT_EQ(on(0, 1).coefficient(1), 3 / 4.);
  EXPECT_EQ(on(0, 1).coefficient(2), -1 / 8.);
  EXPECT_EQ(on(1, 2).coefficient(0), -1 / 16.);  // seen from no corner
  EXPECT_EQ(on(1, 2).coefficient(1), 9 / 16.);
  EXPECT_NEAR(on(3, 7).coefficient(3), (3 / 8. + 3 / 4.) / 2, 1e-15);  // from two: the mean
  EXPECT_NEAR(on(3, 7).coefficient(2), -1 / 16., 1e-15);
}

TEST(BoundaryEdgeEnd, HasTheValenceOfItsEndWhereEdgesAreCutInThree) {
  const Scheme scheme = must_parse(R"toml(
extends = "sqrt3"
split = "sqrt3"
[[boundary.edge-end]]
when = "n == 2"
near = 1
[[boundary.edge-end]]
near = "1 - 1/n"
far = "1/n"
)toml");
  const Mesh mesh = mesh::fan(Lattice::triangle, 3, 2);
  const SplitResult split = scheme.split->apply(mesh, 1);
  const auto fresh = forms(scheme, mesh, split.births);
  for (std::size_t i = 0; i < split.births.edge_ends.size(); ++i) {
    const Index end = split.births.edge_ends[i], h = end / 2;
    const Index near = end % 2 == 0 ? mesh.origin(h) : mesh.target(h);
    const double n = mesh.valence(near);
    const auto& form = fresh[static_cast<std::size_t>(split.births.from_vertices) + i];
    EXPECT_NEAR(form.coefficient(near), n == 2 ? 1 : 1 - 1 / n, 1e-15);
  }
  EXPECT_FALSE(parse_scheme("extends = \"sqrt3\"\nsplit = \"sqrt3\"\n[[boundary.edge-end]]\n"
                            "when = \"n == 2\"\nnear = 1\n",
                            "test.toml")
                   .ok());
}

}  // namespace
}  // namespace limn::test
