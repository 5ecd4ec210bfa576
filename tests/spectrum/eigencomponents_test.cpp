// Labelled eigencomponents and verdicts against closed forms and what theory states of each scheme.

#include "limn/spectrum/eigencomponents.h"

#include <gtest/gtest.h>

#include <cmath>

#include "limn/regular/smoothness/regularity.h"
#include "support/frequency.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

Eigencomponents at(const std::string& name, int n, int rings = 0) {
  const Result<FrequencyBlocks> blocks = FrequencyAnalysis(shipped(name), rings).blocks(n);
  EXPECT_TRUE(blocks.ok()) << name << ' ' << n;
  return approx_eigencomponents(blocks.value(), find_regular_part(shipped(name)));
}

bool says(const Eigencomponents& components, const std::string& part) {
  for (const std::string& reason : components.verdict.reasons)
    if (reason.find(part) != std::string::npos) return true;
  return false;
}

constexpr double kRounding = 1e-13;

TEST(Eigencomponents, OfLoopAreTheClosedForms) {
  for (int n = 4; n <= 40; ++n) {
    const Eigencomponents loop = at("loop", n);
    const double tangent = 3 / 8. + std::cos(2 * M_PI / n) / 4;
    EXPECT_NEAR(*loop.position, 1, kRounding);
    EXPECT_NEAR(*loop.tangent, tangent, kRounding);
    EXPECT_NEAR(*loop.cup, tangent * tangent, kRounding);
    EXPECT_NEAR(*loop.saddle, std::max(1 / 8., 3 / 8. + std::cos(4 * M_PI / n) / 4), kRounding);
    EXPECT_EQ(loop.verdict.c1_necessary, Truth::yes) << n;
    EXPECT_EQ(loop.verdict.bounded_curvature, n <= 6 ? Truth::yes : Truth::no) << n;
    EXPECT_EQ(loop.verdict.cup, Curvature::bounded) << n;
    EXPECT_EQ(loop.verdict.saddle, n < 6    ? Curvature::flat
                                   : n == 6 ? Curvature::bounded
                                            : Curvature::unbounded)
        << n;
  }
}

/// Rows that sum to 1 have 1 and their trace less 1: a cup near 1 is no double 1.
TEST(Eigencomponents, NearOneAreNotOne) {
  for (const std::string gap : {"1/10^4", "1/10^6", "1/10^7"}) {
    const Scheme near =
        parse_scheme("split = \"triangle-dyadic\"\nextends = \"loop\"\nlet.gap = \"" + gap +
                         "\"\n[[vertex]]\nself = \"3/8 + 1 - gap\"\nring = \"(gap - 3/8)/n\"\n",
                     "near.toml")
            .value();
    const Eigencomponents found = approx_eigencomponents(FrequencyAnalysis(near).blocks(5).value());
    const double exact = 1 - 1 / std::pow(10, std::stod(gap.substr(gap.find('^') + 1)));
    EXPECT_NEAR(*found.cup, exact, 1e-15) << gap;
    EXPECT_EQ(found.verdict.convergent, Truth::yes) << gap;
  }
}

/// ((1 + z)³ (1 - z + z²)²/4)⊗: its surfaces are biquadratic B-splines of control points that were
/// averaged, C1, although -1/2 ties with the tangent's: the surface of its eigenvector is 0.
TEST(Eigencomponents, OfDependentShiftsRefuseNothing) {
  std::string rows;
  const int line[8] = {1, 1, 0, 2, 2, 0, 1, 1};
  for (const int a : line) {
    rows += "[";
    for (const int b : line) rows += "\"" + std::to_string(a * b) + "/16\",";
    rows += "],\n";
  }
  const Scheme scheme =
      parse_scheme("split = \"quad-dual\"\n[mask]\nrows = [\n" + rows + "]\n", "dual.toml").value();
  const RegularPart regular = find_regular_part(scheme);
  EXPECT_FALSE(regular.stable);
  const FrequencyBlocks blocks = FrequencyAnalysis(scheme).blocks(4).value();
  const Eigencomponents found = approx_eigencomponents(blocks, regular);
  EXPECT_EQ(found.verdict.c1_necessary, Truth::undecided);
  EXPECT_EQ(found.verdict.bounded_curvature, Truth::undecided);
  EXPECT_TRUE(says(found, "undecided C1: shifts are not proved to be stable"));
  EXPECT_EQ(approx_eigencomponents(blocks).verdict.c1_necessary, Truth::no);
}

/// 1/2, and its square twice: bounded, not flat, at every valence.
TEST(Eigencomponents, OfTheBoundedCatmullClarkAreBounded) {
  for (int n = 3; n <= 40; ++n) {
    const Eigencomponents bounded = at("catmull-clark-bounded", n);
    EXPECT_NEAR(*bounded.tangent, 1 / 2., kRounding);
    EXPECT_NEAR(*bounded.cup, 1 / 4., kRounding);
    if (n >= 4) EXPECT_NEAR(*bounded.saddle, 1 / 4., kRounding);
    EXPECT_EQ(bounded.verdict.c1_necessary, Truth::yes) << n;
    EXPECT_EQ(bounded.verdict.bounded_curvature, Truth::yes) << n;
    EXPECT_EQ(bounded.verdict.cup, Curvature::bounded) << n;
    if (n >= 4) EXPECT_EQ(bounded.verdict.saddle, Curvature::bounded) << n;
  }
}

/// (Labsik, Greiner 2000): (2/3)cos(π/n), and its square twice.
TEST(Eigencomponents, OfTheInterpolatingSqrt3AreItsAuthors) {
  for (int n = 3; n <= 20; ++n) {
    const Eigencomponents components = at("sqrt3-interpolating", n);
    const double tangent = 2 / 3. * std::cos(M_PI / n);
    EXPECT_NEAR(*components.tangent, tangent, kRounding) << n;
    if (n > 3 && n != 6) EXPECT_NEAR(*components.cup, tangent * tangent, kRounding) << n;
    EXPECT_EQ(components.verdict.c1_necessary, Truth::yes) << n;
  }
}

TEST(Eigencomponents, OfLoopAtValence3AreUnbounded) {
  const Eigencomponents loop = at("loop", 3);
  EXPECT_NEAR(*loop.tangent, .25, kRounding);
  EXPECT_FALSE(loop.saddle.has_value());
  EXPECT_FALSE(loop.verdict.saddle.has_value());
  EXPECT_EQ(loop.verdict.c1_necessary, Truth::yes);
  EXPECT_EQ(loop.verdict.bounded_curvature, Truth::no);
  EXPECT_TRUE(says(loop, "0.125 of frequency 0 (ring 2) exceeds tangent² = 0.0625"));
}

TEST(Eigencomponents, OfCatmullClarkAreTheClosedForms) {
  for (int n = 3; n <= 20; ++n) {
    const Eigencomponents cc = at("catmull-clark", n);
    const double c = std::cos(2 * M_PI / n);
    EXPECT_NEAR(*cc.tangent, (c + 5 + std::sqrt((c + 9) * (c + 1))) / 16, kRounding) << n;
    EXPECT_NEAR(*cc.cup, (3 * n - 7 + std::sqrt(5. * n * n - 30 * n + 49)) / (8 * n), kRounding)
        << n;
  }
  const Eigencomponents five = at("catmull-clark", 5);
  EXPECT_EQ(five.verdict.cup, Curvature::unbounded);
  EXPECT_EQ(five.verdict.saddle, Curvature::unbounded);
}

TEST(Eigencomponents, OfSqrt3AreBeyondThePapersFormulaAtSmallValences) {
  const Eigencomponents three = at("sqrt3", 3);
  EXPECT_NEAR(*three.tangent, 1 / 3., kRounding);
  EXPECT_NEAR(*three.cup, (1 + std::sqrt(7.)) / 18, kRounding);
  EXPECT_EQ(three.verdict.bounded_curvature, Truth::no);
  const Eigencomponents four = at("sqrt3", 4);
  EXPECT_NEAR(*four.saddle, 1 / std::sqrt(54.), kRounding);
  for (int n = 5; n <= 12; ++n) {
    const Eigencomponents sqrt3 = at("sqrt3", n);
    EXPECT_NEAR(*sqrt3.tangent, 2 / 3. * std::cos(M_PI / n), kRounding);
    EXPECT_NEAR(*sqrt3.cup, 4 / 9. * std::pow(std::cos(M_PI / n), 2), kRounding);
    EXPECT_NEAR(*sqrt3.saddle, 2 / 3. * std::cos(2 * M_PI / n), kRounding);
  }
}

TEST(Eigencomponents, OfThePlainButterflyTieAndLoseTheirOrder) {
  const Eigencomponents three = at("butterfly", 3);
  EXPECT_EQ(three.verdict.c1_necessary, Truth::no);
  EXPECT_TRUE(says(three, "0.25 of frequency 0 (ring 2) ties with the tangent's 0.25"));
  const Eigencomponents seven = at("butterfly", 7);
  EXPECT_NEAR(*seven.tangent, .4819, 5e-5);
  EXPECT_NEAR(*seven.saddle, .4061, 5e-5);
  EXPECT_EQ(seven.verdict.c1_necessary, Truth::yes);
  const Eigencomponents eight = at("butterfly", 8);
  EXPECT_NEAR(*eight.tangent, .4624, 5e-5);
  EXPECT_NEAR(*eight.saddle, .4690, 5e-5);
  EXPECT_EQ(eight.verdict.c1_necessary, Truth::no);
  EXPECT_TRUE(says(eight, "of frequency 2 (ring 2) leads the tangent's"));
}

TEST(Eigencomponents, OfTheModifiedButterflyAreTheRegularOnes) {
  for (int n = 3; n <= 12; ++n) {
    const Eigencomponents components = at("butterfly-modified", n);
    EXPECT_NEAR(*components.tangent, .5, kRounding) << n;
    if (n > 3) EXPECT_NEAR(*components.saddle, .25, 1e-12) << n;
    EXPECT_EQ(components.verdict.c1_necessary, Truth::yes) << n;
  }
  // the butterfly's exponent is 2 with a logarithm: a Jordan block at 1/4
  const Eigencomponents regular = at("butterfly-modified", 6);
  EXPECT_TRUE(says(regular, "is tangent² with a Jordan block of size 3"));
  EXPECT_EQ(regular.verdict.bounded_curvature, Truth::no);
}

TEST(Eigencomponents, OfTheOptimalSchemeTieWithAnOuterRing) {
  const Eigencomponents three = at("optimal", 3);
  EXPECT_NEAR(*three.tangent, 1 / 6., 1e-12);
  // the block's k λ^k drowns the tie with frequency 0 and does not by itself forbid C1
  EXPECT_EQ(three.verdict.c1_necessary, Truth::undecided);
  EXPECT_EQ(three.verdict.bounded_curvature, Truth::no);
  EXPECT_TRUE(says(three, "undecided C1: the tangent's 0.166667 has a Jordan block of size 2"));
  int sixths = 0;  // ω = 2 is the conjugate of ω = 1
  for (const BlockSpectrum& block : three.spectra)
    for (const Eigenvalue& one : block.eigenvalues)
      if (std::abs(one.value - 1 / 6.) < 1e-12) sixths += block.frequency == 0 ? 1 : 2;
  EXPECT_EQ(sixths, 5);
  const Eigencomponents four = at("optimal", 4);
  EXPECT_EQ(four.verdict.c1_necessary, Truth::yes);
  EXPECT_EQ(four.verdict.bounded_curvature, Truth::no);
}

TEST(Eigencomponents, BoundCurvatureOnlyWhereTheRegularSurfaceDoes) {
  Scheme low = shipped("laplacian-loop");
  ASSERT_TRUE(set_parameters(low, {"a=-1/8"}).ok());
  const RegularPart regular = find_regular_part(low);
  FrequencyAnalysis analysis(low);
  for (int n = 4; n <= 6; ++n) {
    const Eigencomponents found = approx_eigencomponents(analysis.blocks(n).value(), regular);
    EXPECT_EQ(found.verdict.curvature_necessary, Truth::yes) << n;
    EXPECT_EQ(found.verdict.bounded_curvature, Truth::no) << n;
    EXPECT_TRUE(says(found, "regular surface round it: its Hölder exponent is at most 1.7776"))
        << n;
    const Eigencomponents alone = approx_eigencomponents(analysis.blocks(n).value());
    EXPECT_EQ(alone.verdict.bounded_curvature, Truth::undecided) << n;
  }
  for (int n = 3; n <= 12; ++n)
    EXPECT_EQ(at("butterfly-modified", n).verdict.bounded_curvature, Truth::no) << n;
  EXPECT_EQ(at("doo-sabin", 4).verdict.bounded_curvature, Truth::yes);
}

TEST(Eigencomponents, AreLabelledByRing) {
  const Eigencomponents loop = at("loop", 9);
  for (const BlockSpectrum& block : loop.spectra) {
    int outer = 0;
    for (const Eigenvalue& one : block.eigenvalues) {
      const bool eighth = std::abs(one.value - .125) < kRounding;
      const bool sixteenth = std::abs(one.value - .0625) < kRounding;
      if (one.ring == 2) EXPECT_TRUE(eighth || sixteenth);
      outer += one.ring == 2 ? 1 : 0;
    }
    EXPECT_EQ(outer, 2);
  }
}

TEST(Eigencomponents, AreThoseOfTheDenseMatrixWithMultiplicity) {
  for (const char* name : {"loop", "sqrt3", "catmull-clark", "butterfly", "doo-sabin"})
    for (int n = 3; n <= 9; ++n) {
      const Eigencomponents components = at(name, n);
      for (const BlockSpectrum& block : components.spectra) {
        const Eigen::MatrixXcd spatial =
            frequency_block(shipped(name), n, components.rings, block.frequency);
        ASSERT_EQ(static_cast<std::size_t>(spatial.rows()), block.eigenvalues.size());
        std::complex<double> trace = 0;
        for (const Eigenvalue& one : block.eigenvalues) {
          trace += one.value;
          Eigen::MatrixXcd shifted = spatial;
          shifted.diagonal().array() -= one.value;
          Eigen::MatrixXcd power = shifted;
          for (int k = 1; k < one.jordan; ++k) power *= shifted;
          // (S - λ)^jordan has lost all of the algebraic multiplicity
          const Eigen::VectorXd sizes = singular_values(power);
          EXPECT_LT(sizes(sizes.size() - one.multiplicity), 1e-11) << name << ' ' << n;
        }
        EXPECT_LT(std::abs(trace - spatial.trace()), 1e-12) << name << ' ' << n;
      }
    }
}

TEST(Truths, Combine) {
  EXPECT_EQ(Truth::yes && Truth::undecided, Truth::undecided);
  EXPECT_EQ(Truth::no && Truth::undecided, Truth::no);
  EXPECT_EQ(to_string(Truth::undecided), "undecided");
}

}  // namespace
}  // namespace limn::test
