/// Schemes that limn has never seen need a text and no C++.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "limn/mesh/lattice.h"
#include "limn/scheme/placement.h"
#include "mesh/random_mesh.h"
#include "scheme/refined.h"

namespace limn {
namespace {

using test::expect_same_refinement;
using test::must_parse;
using test::refined;

Scheme shipped(const std::string& name) { return find_scheme(name).value(); }

// ---------------------------------------------------------------------------------------------
// roles of one's own on quads

/// L. Kobbelt: Interpolatory subdivision on open quadrilateral nets with arbitrary topology,
/// 1996; on regular meshes the tensor product of the four-point scheme.
const char* const kFourPoint = R"TOML(
split = "quad-dyadic"

[roles.face]
far = "fefvev"            # across a corner of the face, the opposite corner of that face

[let]
w = "1/16"
h = "1/2 + w"

[vertex]
self = 1

[edge]
end      = "h"
opposite = "-w"

[[face]]
when   = "n == 4"
corner = "h^2"
beyond = "-h*w"
far    = "w^2"

[[face]]
corner = "1/n"
)TOML";

TEST(NewScheme, TensorFourPointOnQuads) {
  const Scheme scheme = must_parse(kFourPoint);
  constexpr Index kSide = 7;
  const Mesh mesh = mesh::torus(Lattice::quad, kSide, kSide);
  const std::vector<double> old = test::random_values(mesh);
  const auto at = [&](Index i, Index j) {
    return old[(j + 2 * kSide) % kSide * kSide + (i + 2 * kSide) % kSide];
  };
  constexpr std::array<double, 4> kRule{-1.0 / 16, 9.0 / 16, 9.0 / 16, -1.0 / 16};
  const Result<refine::Refined<double>> result = refined(scheme, mesh);
  ASSERT_TRUE(result.ok()) << result.error().text();
  const std::vector<double>& fresh = result->values;
  for (Index v = 0; v < mesh.vertex_count(); ++v) EXPECT_EQ(fresh[v], old[v]);
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    Index h = mesh.halfedge_of_edge(e);
    const Index v = mesh.origin(h), x = v % kSide, y = v / kSide;
    const Index w = mesh.target(h);
    const Index dx = (w % kSide - x + kSide + 1) % kSide - 1;
    const Index dy = (w / kSide - y + kSide + 1) % kSide - 1;
    double expected = 0;
    for (Index k = 0; k < 4; ++k) expected += kRule[k] * at(x + (k - 1) * dx, y + (k - 1) * dy);
    EXPECT_NEAR(fresh[mesh.vertex_count() + e], expected, 1e-14);
  }
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index x = f % kSide, y = f / kSide;
    double expected = 0;
    for (Index k = 0; k < 4; ++k)
      for (Index l = 0; l < 4; ++l) expected += kRule[k] * kRule[l] * at(x + k - 1, y + l - 1);
    EXPECT_NEAR(fresh[mesh.vertex_count() + mesh.edge_count() + f], expected, 1e-14);
  }
  EXPECT_TRUE(refined(scheme, test::cube(), 3).ok());
}

// ---------------------------------------------------------------------------------------------
// roles of one's own on √3

/// U. Labsik, G. Greiner: Interpolatory √3-subdivision, 2000; the regular rule everywhere.
const char* const kInterpolatingSqrt3 = R"TOML(
split = "sqrt3"

[roles.face]
outer = "fefev"           # from each corner, the next neighbour but one, either way round

[vertex]
self = 1

[face]
corner = "32/81"
beyond = "-1/81"
outer  = "-2/81"
)TOML";

TEST(NewScheme, InterpolatingSqrt3) {
  const Scheme scheme = must_parse(kInterpolatingSqrt3);
  const auto count = [&](const char* walk) {
    return scheme::place(RuleKind::face, Lattice::triangle, parse_walk(walk).value())
               .value()
               .count *
           3;
  };
  EXPECT_EQ(count(""), 3);
  EXPECT_EQ(count("fev"), 3);
  EXPECT_EQ(count("fefev"), 6);
  // a cubic on the lattice, away from the seam of the torus, is reproduced at the centroids
  constexpr Index kSide = 8;
  const Mesh mesh = mesh::torus(Lattice::triangle, kSide, kSide);
  const auto cubic = [](double a, double b) {
    const double x = a - b / 2, y = b * std::sqrt(3) / 2;
    return 1 + x - 2 * y + x * x - 3 * x * y + x * x * x - 2 * x * y * y + y * y * y;
  };
  std::vector<double> old;
  for (Index v = 0; v < mesh.vertex_count(); ++v) old.push_back(cubic(v % kSide, v / kSide));
  const Result<refine::Refined<double>> result = refine::refine<double>(scheme, mesh, old, 1);
  ASSERT_TRUE(result.ok()) << result.error().text();
  for (Index v = 0; v < mesh.vertex_count(); ++v) EXPECT_EQ(result->values[v], old[v]);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index cell = f / 2, i = cell % kSide, j = cell / kSide;
    if (i < 2 || i > 4 || j < 2 || j > 4) continue;
    const double third = 1.0 / 3;
    const double a = i + (f % 2 == 0 ? 2 * third : third);
    const double b = j + (f % 2 == 0 ? third : 2 * third);
    EXPECT_NEAR(result->values[mesh.vertex_count() + f], cubic(a, b), 1e-12) << f;
  }
  EXPECT_TRUE(refined(scheme, test::tetrahedron(), 3).ok());
}

// ---------------------------------------------------------------------------------------------
// weights in k, guards, lets and parameters

TEST(NewScheme, WeightsInKAndGuardsOnTriangles) {
  const Scheme scheme = must_parse(R"TOML(
split = "triangle-dyadic"

[let]
near   = "k == 0"
fourth = "(1/4 + cos(2*pi*k/n) + cos(4*pi*k/n)/2)/n"
ringed = "n == 3 or n == 4"

[parameter.w]
default = "1/16"
range = [0, "1/8"]

[roles.edge]
corner-beyond = "efev"

[vertex]
self = 1

[edge]
end  = "1/2"
wing = "2*w"
corner-beyond = "-w"

[[edge-end]]
when = "ringed and n < 4"
self = "3/4"
ring = "(6*near - 1)/12"

[[edge-end]]
when = "ringed"
self = "3/4"
ring = "(3*near - (2*k == n))/8"

[[edge-end]]
when = "not (n == 6)"
self = "1 - sqrt(1/16)"
ring = "fourth"
)TOML");
  const Scheme butterfly = shipped("butterfly-modified");
  expect_same_refinement(scheme, butterfly, test::tetrahedron(), 3);
  expect_same_refinement(scheme, butterfly, test::icosahedron(), 2);
  expect_same_refinement(scheme, butterfly, mesh::torus(Lattice::triangle, 5, 4), 2);
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Mesh mesh = test::RandomMesh(seed).triangles();
    if (!mesh.has_boundary()) expect_same_refinement(scheme, butterfly, mesh, 2);
  }
}

TEST(NewScheme, ExtendsAFileBesideIt) {
  const std::string text = R"TOML(
extends = "catmull-clark"
split = "quad-dyadic"
name = "flat"
[vertex]
self = "1 - 1/n"
ring = "1/n^2"
)TOML";
  const Scheme scheme = must_parse(text);
  EXPECT_EQ(scheme.name, "flat");
  EXPECT_TRUE(scheme.rule(RuleKind::face).has_value());
  EXPECT_TRUE(scheme.rule(RuleKind::boundary_edge).has_value());
  EXPECT_TRUE(refined(scheme, test::cube(), 2).ok());
}

// ---------------------------------------------------------------------------------------------
// masks and factors

struct Given {
  const char* shipped;
  const char* text;
  friend std::ostream& operator<<(std::ostream& out, const Given& g) { return out << g.shipped; }
};

class GivenByMask : public testing::TestWithParam<Given> {};

Mesh regular(const Scheme& scheme) { return mesh::torus(scheme.split->lattice, 9, 8); }

TEST_P(GivenByMask, HasTheRulesOfTheShippedScheme) {
  const Scheme scheme = must_parse(GetParam().text);
  const Scheme other = shipped(GetParam().shipped);
  expect_same_refinement(scheme, other, regular(other), 2);
}

TEST_P(GivenByMask, SaysWhichRuleAnIrregularMeshLacks) {
  const Scheme scheme = must_parse(GetParam().text);
  const bool dual = scheme.split->is_dual();
  const Mesh mesh = dual ? mesh::face_star(5, 2) : mesh::star(scheme.split->lattice, 5, 3);
  const Result<refine::Refined<double>> result = refined(scheme, mesh);
  ASSERT_FALSE(result.ok());
  const std::string missing = dual ? "no corner rule at n = 5, needed at face 0"
                                   : "no vertex rule at n = 5, needed at vertex 0";
  EXPECT_NE(result.error().message.find(missing), std::string::npos) << result.error().text();
  EXPECT_NE(result.error().hint.find("regular mask alone"), std::string::npos);
  EXPECT_EQ(result.error().file, "new.toml");
  EXPECT_EQ(result.error().line, 2);
}

const Given kGiven[] = {
    {"loop",
     "split = \"triangle-dyadic\"\n[mask]\nscale = \"1/16\"\nrows = [ [1, 2, 1], "
     "[2, 6, 6, 2], [1, 6, 10, 6, 1], [2, 6, 6, 2], [1, 2, 1] ]"},
    {"loop", "split = \"triangle-dyadic\"\n[factors]\nstages = 2"},
    {"loop",
     "split = \"triangle-dyadic\"\n[factors]\nstages = 1\ndirections = [ { step = [1, 0], "
     "count = 1 }, { step = [0, -1], count = \"2 - 1\" }, { step = [1, 1], count = 1 } ]"},
    {"catmull-clark", "split = \"quad-dyadic\"\n[factors]\nstages = 4"},
    {"catmull-clark",
     "split = \"quad-dyadic\"\n[factors]\nstages = 2\nkernel.scale = \"1/16\"\n"
     "kernel.rows = [ [1, 2, 1], [2, 4, 2], [1, 2, 1] ]"},
    {"doo-sabin", "split = \"quad-dual\"\n[factors]\nstages = 3"},
    {"doo-sabin",
     "split = \"quad-dual\"\n[mask]\nscale = \"1/16\"\nrows = [ [1, 3, 3, 1], "
     "[3, 9, 9, 3], [3, 9, 9, 3], [1, 3, 3, 1] ]"},
    // the kernel's symbol is (1 + 2C - D)/4: 1 at the centre, 1 at the six neighbours and -1/2 at
    // the six vertices across, all over 4
    {"butterfly",
     "split = \"triangle-dyadic\"\n[factors]\nstages = 1\nkernel.scale = \"1/8\"\n"
     "kernel.rows = [ [-1], [-1, 2, 2, -1], [2, 2, 2], [-1, 2, 2, -1], [-1] ]"},
    // and (10 - 2C)/4
    {"interpolating-loop",
     "split = \"triangle-dyadic\"\n[factors]\nstages = 2\nkernel.scale = "
     "\"1/4\"\nkernel.rows = [ [-1, -1], [-1, 10, -1], [-1, -1] ]"},
    {"laplacian-butterfly",
     "split = \"triangle-dyadic\"\n[mask]\nscale = \"1/384\"\nrows = [ [2, -19, -19, 2], [-19, 0, "
     "46, 0, -19], [-19, 46, 182, 182, 46, -19], [2, 0, 182, 384, 182, 0, 2], [-19, 46, 182, 182, "
     "46, -19], [-19, 0, 46, 0, -19], [2, -19, -19, 2] ]"},
};

INSTANTIATE_TEST_SUITE_P(All, GivenByMask, testing::ValuesIn(kGiven));

/// In a row of a boundary there is no rule, and the error says so.
TEST(NewScheme, GivenByMaskHasNoBoundary) {
  const Scheme scheme = must_parse("split = \"triangle-dyadic\"\n[factors]\nstages = 2");
  const Result<refine::Refined<double>> result =
      refined(scheme, mesh::star(Lattice::triangle, 6, 2));
  ASSERT_FALSE(result.ok());
  EXPECT_NE(result.error().message.find("no boundary.vertex rule"), std::string::npos);
}

TEST(NewScheme, MaskWithoutSymmetryHasNoRules) {
  const Scheme scheme = must_parse(
      "split = \"triangle-dyadic\"\n[factors]\ndirections = [ { step = [1, 0], count = 3 }, "
      "{ step = [0, 1], count = 1 }, { step = [1, 1], count = 1 } ]");
  const Result<refine::Refined<double>> result =
      refined(scheme, mesh::torus(Lattice::triangle, 6, 6));
  ASSERT_FALSE(result.ok());
  EXPECT_NE(result.error().message.find("has no vertex rule at n = 6"), std::string::npos)
      << result.error().text();
}

TEST(NewScheme, LargeBoxSplines) {
  Scheme scheme = shipped("box-spline-triangle");
  for (const char* parameter : {"i=8", "j=8", "k3=8"}) {
    const Status status = set_parameter(scheme, parameter);
    ASSERT_TRUE(status.ok()) << status.error().text();
  }
  const Mesh mesh = mesh::torus(Lattice::triangle, 12, 12);
  EXPECT_TRUE(refined(scheme, mesh).ok());
}

}  // namespace
}  // namespace limn
