// Frequency blocks of steps that are sequences of averagings, against the dense spatial matrix and
// against closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "limn/spectrum/eigencomponents.h"
#include "limn/spectrum/frequency_blocks.h"
#include "support/frequency.h"
#include "support/shipped.h"
#include "support/spline_scheme.h"

namespace limn::test {
namespace {

/// Traces of powers, which defective eigenvalues do not blur.
double trace_distance(const Eigen::MatrixXcd& one, const Eigen::MatrixXcd& other) {
  Eigen::MatrixXcd a = one, b = other;
  double worst = one.rows() == other.rows() ? 0 : 1e9;
  for (int k = 0; k < one.rows() && worst < 1; ++k, a *= one, b *= other)
    worst = std::max(worst, std::abs(a.trace() - b.trace()));
  return worst;
}

TEST(StagedBlocks, AreThoseOfTheSpatialMatrix) {
  for (int degree = 2; degree <= 7; ++degree) {
    const Scheme scheme = spline_of_degree(degree, degree % 2 == 0 ? "1" : "1/3");
    FrequencyAnalysis analysis(scheme);
    for (const int n : {3, 4, 5, 7, 13, 14}) {
      const Result<FrequencyBlocks> blocks = analysis.blocks(n);
      ASSERT_TRUE(blocks.ok()) << degree << ' ' << n << ": " << blocks.error().text();
      const auto matrix = refine::subdivision_matrix<double>(scheme, n, blocks->rings);
      ASSERT_TRUE(matrix.ok()) << degree << ' ' << n << ": " << matrix.error().text();
      for (int omega = 0; omega <= n / 2; ++omega) {
        const Eigen::MatrixXcd spatial =
            frequency_block(*scheme.split, *matrix, n, blocks->rings, omega);
        EXPECT_LT(trace_distance(blocks->blocks[static_cast<std::size_t>(omega)], spatial), 1e-12)
            << degree << ' ' << n << ' ' << omega;
      }
    }
  }
}

/// With Stam's weights it is Catmull and Clark's scheme.
TEST(StagedBlocks, OfDegreeThreeAreCatmullAndClarks) {
  const Scheme scheme = spline_of_degree(3, "1");
  FrequencyAnalysis one(scheme), other(shipped("catmull-clark"));
  for (int n = 3; n <= 20; ++n) {
    const FrequencyBlocks ours = one.blocks(n).value(), theirs = other.blocks(n).value();
    ASSERT_EQ(ours.blocks.size(), theirs.blocks.size());
    for (std::size_t omega = 0; omega < ours.blocks.size(); ++omega) {
      ASSERT_EQ(ours.blocks[omega].rows(), theirs.blocks[omega].rows());
      EXPECT_LT((ours.blocks[omega] - theirs.blocks[omega]).cwiseAbs().maxCoeff(), 1e-14) << n;
    }
  }
}

/// A spline of degree d is controlled, over the quads at a vertex, by (d + 1)/2 rings of it.
TEST(StagedBlocks, HaveTheRingsOfTheSpline) {
  for (const int degree : {3, 5, 7, 9}) {
    const Scheme scheme = spline_of_degree(degree);
    FrequencyAnalysis analysis(scheme);
    for (const int n : {3, 4, 6}) EXPECT_EQ(analysis.blocks(n)->rings, (degree + 1) / 2) << n;
  }
}

/// On the lattice: 1, then 1/2 for linear and 1/4 for quadratic polynomials, whatever the degree.
TEST(StagedBlocks, HaveTheEigenvaluesOfPolynomialsAtValenceFour) {
  for (int degree = 2; degree <= 9; ++degree) {
    const Scheme scheme = spline_of_degree(degree);
    FrequencyAnalysis analysis(scheme);
    const Result<FrequencyBlocks> blocks = analysis.blocks(4);
    ASSERT_TRUE(blocks.ok()) << degree << ": " << blocks.error().text();
    const Eigencomponents found = approx_eigencomponents(*blocks);
    EXPECT_EQ(found.verdict.convergent, Truth::yes) << degree;
    EXPECT_NEAR(found.tangent.value_or(0), 1. / 2, 1e-6) << degree;
    EXPECT_NEAR(found.cup.value_or(0), 1. / 4, 1e-6) << degree;
  }
}

/// Degree 2 takes the mean of a corner, the middles of its two edges and the middle of the face:
/// round an n-gon (1 + 1 + cos(2πω/n))/4 for ω > 0.
TEST(StagedBlocks, OfDegreeTwoHaveTheClosedForm) {
  const Scheme scheme = spline_of_degree(2);
  FrequencyAnalysis analysis(scheme);
  for (int n = 3; n <= 40; ++n) {
    const Result<FrequencyBlocks> blocks = analysis.blocks(n);
    ASSERT_TRUE(blocks.ok());
    for (int omega = 1; omega <= n / 2; ++omega) {
      const double expected = (2 + std::cos(2 * std::numbers::pi * omega / n)) / 4;
      EXPECT_LT(eigenvalue_defect(blocks->blocks[static_cast<std::size_t>(omega)], expected), 1e-12)
          << n << ' ' << omega;
    }
  }
}

/// A vertex of thousands of faces costs no more.
TEST(StagedBlocks, HaveLargeValences) {
  for (const int degree : {4, 5}) {
    const Scheme scheme = spline_of_degree(degree);
    FrequencyAnalysis analysis(scheme);
    const Result<FrequencyBlocks> blocks = analysis.blocks(2000, 3);
    ASSERT_TRUE(blocks.ok()) << blocks.error().text();
    const Eigen::VectorXcd sums = blocks->blocks.front().rowwise().sum();
    for (const std::complex<double>& sum : sums) EXPECT_NEAR(std::abs(sum - 1.0), 0, 1e-12);
  }
}

}  // namespace
}  // namespace limn::test
