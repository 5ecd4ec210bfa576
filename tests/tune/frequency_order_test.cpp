// Bounds that spare eigenvalue problems against the eigenvalues themselves.

#include "limn/tune/frequency_order.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

#include "tuned.h"

namespace limn::test {
namespace {

TEST(FrequencyOrder, BoundsEveryMatrixOfSuchModuli) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> entry(-1, 1);
  for (int round = 0; round < 200; ++round) {
    const int size = 1 + round % 7;
    Eigen::MatrixXcd matrix(size, size);
    for (auto& value : matrix.reshaped())
      value = entry(random) < 0 ? 0 : std::complex<double>(entry(random), entry(random));
    const double radius = matrix.eigenvalues().cwiseAbs().maxCoeff();
    EXPECT_GE(tune::radius_bound(matrix.cwiseAbs()), radius * (1 - 1e-9) - 1e-6);
  }
}

TEST(FrequencyOrder, IsCloseWhereABlockIsTriangular) {
  Eigen::MatrixXd moduli(2, 2);
  moduli << 0.6, 0, 0.5, 0.125;
  EXPECT_NEAR(tune::radius_bound(moduli), 0.6, 1e-3);
}

TEST(FrequencyOrder, BoundsAllOfAPartOfTheInterval) {
  const Scheme scheme = shipped("laplacian-butterfly");
  FreedScheme freed = FreedScheme::make(scheme, "b").value();
  const Interval interval = freed.search_range(9, nullptr).value();
  const tune::BlockCurve curve(freed, 9, interval);
  ASSERT_TRUE(curve.interpolated());
  tune::FrequencyOrder order(curve, interval);
  for (int k = 0; k <= 100; ++k) {
    const double x = interval.low + (interval.high - interval.low) * k / 100;
    const FrequencyBlocks blocks = curve(x).value();
    const std::vector<tune::BoundedFrequency>& bounds = order.at(x);
    EXPECT_EQ(bounds.size(), 2U);  // 3 and 4
    for (const auto& [omega, bound] : bounds)
      EXPECT_GE(bound + 1e-9, approx_spectrum(blocks, omega).eigenvalues.front().modulus());
  }
}

/// The eigenvalue g of frequency 3, which no label has, must stay below the tangent's 1/2.
TEST(FrequencyOrder, SparesNoFrequencyThatLeads) {
  const Scheme scheme = parse_scheme(
                            "split = \"triangle-dyadic\"\nextends = \"loop\"\n"
                            "[parameter.g]\ndefault = \"1/4\"\nrange = [\"-1\", \"1\"]\n"
                            "[[edge-end]]\nwhen = \"n == 9\"\nself = \"3/8\"\n"
                            "ring = \"(5/8 + cos(2*pi*k/n) + 2*g*cos(6*pi*k/n))/n\"\n",
                            "third.toml")
                            .value();
  const ValenceRange range = ranged(scheme, "g", "c1", 9);
  ASSERT_EQ(range.parts.size(), 1U);
  EXPECT_NEAR(range.parts.front().low.value, -0.5, 1e-13);
  EXPECT_NEAR(range.parts.front().high.value, 0.5, 1e-13);
  EXPECT_NE(range.parts.front().high.reason.find("of frequency 3"), std::string::npos);
}

}  // namespace
}  // namespace limn::test
