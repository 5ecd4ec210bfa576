#include "limn/mesh/split/split.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "limn/mesh/lattice.h"

namespace limn {
namespace {

constexpr LatticeMatrix kTernary{{{{3, 0}, {0, 3}}}};
constexpr LatticeMatrix kQuincunx{{{{1, 1}, {1, -1}}}};

TEST(Dilation, IsASimilarityForEverySplit) {
  for (const Split& split : splits()) {
    const LatticeMatrix& m = split.dilation;
    for (const LatticeVector k : {LatticeVector{1, 0}, {0, 1}, {1, 1}, {3, -2}})
      EXPECT_EQ(squared_length(split.lattice, m.apply(k)),
                m.growth() * squared_length(split.lattice, k))
          << split.name;
  }
}

TEST(Dilation, PutsEveryNewVertexOnTheRefinedLatticeOnce) {
  constexpr Index kSide = 6;
  for (const Split& split : splits()) {
    const Mesh mesh = mesh::torus(split.lattice, kSide, kSide);
    const SplitResult fine = split.apply(mesh, 0);
    std::set<LatticeVector> places;
    for (Index v = 0; v < fine.mesh.vertex_count(); ++v) {
      const mesh::Twelfths place = mesh::torus_birth_place(mesh, kSide, kSide, fine.births, v);
      const LatticeVector refined = split.dilation.apply(place);
      const int shift = split.is_dual() ? 6 : 0;  // dual: half a refined edge off
      EXPECT_EQ((refined[0] - shift) % 12, 0) << split.name;
      EXPECT_EQ((refined[1] - shift) % 12, 0) << split.name;
      places.insert({refined[0], refined[1]});
    }
    EXPECT_EQ(places.size(), static_cast<std::size_t>(fine.mesh.vertex_count())) << split.name;
  }
}

TEST(Dilation, OrdersTheArtifactsAsThePaper) {
  const std::vector<LatticeVector> expected{{0, 0}, {0, 1}, {1, 0}, {1, 1}};
  EXPECT_EQ(dual_cosets(find_split("triangle-dyadic")->dilation), expected);
  EXPECT_EQ(dual_cosets(find_split("quad-dual")->dilation), expected);
  EXPECT_EQ(dual_cosets(find_split("sqrt3")->dilation).size(), 3U);
  EXPECT_EQ(dual_cosets(find_split("quad-sqrt2")->dilation).size(), 2U);
  EXPECT_EQ(dual_cosets(kTernary).size(), 9U);
  EXPECT_EQ(dual_cosets(kQuincunx).size(), 2U);
}

TEST(Dilation, CosetsAreDisjointAndComplete) {
  for (const LatticeMatrix& m :
       {find_split("triangle-dyadic")->dilation, find_split("sqrt3")->dilation,
        find_split("quad-sqrt2")->dilation, kTernary, kQuincunx}) {
    std::vector<int> count(static_cast<std::size_t>(m.growth()));
    for (int a = -6; a < 6; ++a)
      for (int b = -6; b < 6; ++b) {
        const int coset = coset_of(m, {a, b});
        ASSERT_LT(coset, m.growth());
        ++count[static_cast<std::size_t>(coset)];
        EXPECT_EQ(coset == 0, m.divide({a, b}).has_value());
        EXPECT_EQ(coset, coset_of(m, {a + m.apply({2, -1})[0], b + m.apply({2, -1})[1]}));
      }
    for (const int c : count) EXPECT_EQ(c, 144 / m.growth());
  }
}

TEST(Dilation, AritiesAndSymmetries) {
  EXPECT_EQ(arity(find_split("quad-dyadic")->dilation), 2);
  EXPECT_EQ(arity(find_split("sqrt3")->dilation), 3);
  EXPECT_EQ(arity(kTernary), 3);
  EXPECT_EQ(arity(find_split("quad-sqrt2")->dilation), 2);
  EXPECT_EQ(arity(kQuincunx), 2);
  EXPECT_EQ(isometries(Lattice::triangle).size(), 12U);
  EXPECT_EQ(isometries(Lattice::quad).size(), 8U);
  for (const LatticeMatrix& s : isometries(Lattice::triangle))
    EXPECT_EQ(squared_length(Lattice::triangle, s.apply({3, -1})),
              squared_length(Lattice::triangle, {3, -1}));
}

TEST(Dilation, RefinedPhaseIsTheInverseTransposed) {
  for (const LatticeMatrix& m : {find_split("sqrt3")->dilation, kQuincunx, kTernary}) {
    const std::array<double, 2> theta = m.refined_phase({0.7, -1.3});
    for (const LatticeVector k : {LatticeVector{1, 0}, {0, 1}, {2, 5}}) {
      const LatticeVector image = m.apply(k);
      EXPECT_NEAR(theta[0] * image[0] + theta[1] * image[1], 0.7 * k[0] - 1.3 * k[1], 1e-14);
    }
  }
}

}  // namespace
}  // namespace limn
