// Bounded curvature on the regular lattice, against the literature and against refined data.

#include "limn/regular/smoothness/regularity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "limn/mesh/lattice.h"
#include "limn/refine/refine.h"
#include "limn/regular/regular_mask.h"
#include "limn/regular/smoothness/difference_norm.h"
#include "tensor_mask.h"

namespace limn {
namespace {

using test::tensor;

Scheme scheme_of(const std::string& name, const std::vector<std::string>& parameters = {}) {
  Scheme scheme = find_scheme(name).value();
  const Status set = set_parameters(scheme, parameters);
  EXPECT_TRUE(set.ok()) << set.error().text();
  return scheme;
}

struct Stated {
  const char* name;
  std::vector<std::string> parameters;
  Truth bounded;
  const char* part;  // of the reason
};

TEST(RegularPart, IsAsTheLiteratureSays) {
  for (const Stated& one : std::vector<Stated>{
           {"loop", {}, Truth::yes, "above 2"},
           {"catmull-clark", {}, Truth::yes, "above 2"},
           {"sqrt3", {}, Truth::yes, "above 2"},
           {"doo-sabin", {}, Truth::yes, "a step multiplies them by 1 at most"},
           {"midedge", {}, Truth::yes, "box spline of 4 directions"},
           {"butterfly", {}, Truth::no, "Jordan block"},
           {"butterfly-modified", {}, Truth::no, "Jordan block"},
           {"laplacian-loop", {"a=-1/8"}, Truth::no, "at most 1.77760"},
           {"laplacian-loop", {"a=1/8"}, Truth::no, "at most 1.41503"},
           {"laplacian-loop", {"a=0"}, Truth::yes, "above 2"},
           {"laplacian-loop", {"a=1"}, Truth::no, "does not converge"},
           {"laplacian-butterfly", {}, Truth::no, "at most 1.23"},
           {"optimal", {}, Truth::no, "at most 1.85"},
           // C1 and no more: the hat function's degree along one direction
           {"box-spline-triangle", {"i=3", "j=1", "k3=1"}, Truth::no, "at most 1"}}) {
    const RegularPart part = find_regular_part(scheme_of(one.name, one.parameters));
    EXPECT_EQ(part.bounded, one.bounded) << one.name << ": " << part.reason;
    EXPECT_NE(part.reason.find(one.part), std::string::npos) << one.name << ": " << part.reason;
  }
}

TEST(RegularPart, AtTheExponentTwoIsToldExactly) {
  // quadratic splines are C^{1,1}, binary and ternary; the four-point scheme has a logarithm
  EXPECT_EQ(find_regular_part(tensor({1, 3, 3, 1}, 4, 2)).bounded, Truth::yes);
  EXPECT_EQ(find_regular_part(tensor({1, 3, 6, 7, 6, 3, 1}, 9, 3)).bounded, Truth::yes);
  const RegularPart four_point = find_regular_part(tensor({-1, 0, 9, 16, 9, 0, -1}, 16, 2));
  EXPECT_EQ(four_point.bounded, Truth::no);
  EXPECT_NE(four_point.reason.find("Jordan block"), std::string::npos) << four_point.reason;
  // an exact norm of 1, of which a rounded one could only say that it is not below
  EXPECT_EQ(regular::steps_that_bound_differences(tensor({1, 3, 3, 1}, 4, 2), 2, 2, 4), 1);
  EXPECT_EQ(regular::steps_that_bound_differences(tensor({-1, 0, 9, 16, 9, 0, -1}, 16, 2), 2, 2, 2),
            std::nullopt);
}

TEST(RegularPart, IsNotBoundedByANormThatIsALittleTooLarge) {
  // (1 + z)² ((1 + z)/4 - ε (1 - z)²): of its second differences a step multiplies some by 1/4 + 2ε
  const Rational tiny(1, 100'000'000'000);
  const std::vector<Rational> row{Rational(1, 4) - tiny, Rational(3, 4), Rational(3, 4) + 2 * tiny,
                                  Rational(1, 4), -tiny};
  Mask mask{Lattice::quad, LatticeMatrix{{{{2, 0}, {0, 2}}}}, {}};
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      mask.coefficients[{2 * i - 4, 2 * j - 4}] =
          row[static_cast<std::size_t>(i)] * row[static_cast<std::size_t>(j)];
  EXPECT_EQ(regular::steps_that_bound_differences(mask, 2, 2, 1), std::nullopt);
}

/// The largest second difference over h² along edges, level by level, of one raised vertex.
std::vector<double> measured(const Scheme& scheme, int levels) {
  const Mesh mesh = mesh::torus(Lattice::triangle, 8, 8);
  std::vector<Point3> values(static_cast<std::size_t>(mesh.vertex_count()));
  values[0].z = 1;
  std::vector<double> largest;
  for (int level = 1; level <= levels; ++level) {
    const auto fine = refine::refine(scheme, mesh, values, level).value();
    double most = 0;
    for (Index h = 0; h < fine.mesh.halfedge_count(); ++h) {
      const Index opposite = fine.mesh.rotate(fine.mesh.rotate(fine.mesh.rotate(h)));
      const auto z = [&](Index v) { return fine.values[static_cast<std::size_t>(v)].z; };
      most = std::max(most, std::abs(z(fine.mesh.target(h)) - 2 * z(fine.mesh.origin(h)) +
                                     z(fine.mesh.target(opposite))));
    }
    largest.push_back(most * std::pow(4, level));
  }
  return largest;
}

TEST(RegularPart, IsWhatRefinedDataShow) {
  const std::vector<double> low = measured(scheme_of("laplacian-loop", {"a=-1/8"}), 6);
  EXPECT_NEAR(low[4] / low[3], 7 / 6., 0.02);
  EXPECT_NEAR(low[5] / low[4], 7 / 6., 0.02);
  const std::vector<double> butterfly = measured(scheme_of("butterfly"), 6);
  EXPECT_GT(butterfly[5] - butterfly[4], 0.9 * (butterfly[4] - butterfly[3]));
  EXPECT_GT(butterfly[4] - butterfly[3], 0.01);
  const std::vector<double> loop = measured(scheme_of("loop"), 6);
  for (std::size_t l = 1; l < loop.size(); ++l) EXPECT_LE(loop[l], loop[l - 1] * (1 + 1e-12));
}

TEST(RegularPart, IsUndecidedWhereThereIsNoMask) {
  const RegularPart part = find_regular_part(
      parse_scheme("split = \"triangle-dyadic\"\nextends = \"loop\"\n[edge]\n"
                   "end = \"3/8 + cos(2*pi/7)/100\"\nwing = \"1/8 - cos(2*pi/7)/100\"\n",
                   "seventh.toml")
          .value());
  EXPECT_EQ(part.bounded, Truth::undecided);
  EXPECT_NE(part.reason.find("not rational"), std::string::npos) << part.reason;
}

}  // namespace
}  // namespace limn
