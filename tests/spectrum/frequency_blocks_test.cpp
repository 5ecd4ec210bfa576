// Frequency blocks against the dense spatial matrix, and against BGSK's printed blocks.

#include "limn/spectrum/frequency_blocks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/frequency.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

using Values = std::vector<std::complex<double>>;

/// Every value of one finds a partner in the other: the largest distance between partners.
double multiset_distance(const Values& a, Values b) {
  double worst = a.size() == b.size() ? 0 : 1e9;
  for (const auto& value : a) {
    if (b.empty()) break;
    const auto nearest = std::min_element(b.begin(), b.end(), [&](const auto& x, const auto& y) {
      return std::abs(x - value) < std::abs(y - value);
    });
    worst = std::max(worst, std::abs(*nearest - value));
    b.erase(nearest);
  }
  return worst;
}

std::vector<std::string> refinable_schemes() {
  std::vector<std::string> names;
  for (const std::string& name : lattice_names())
    if (const Scheme& scheme = shipped(name); !scheme.mask && !scheme.factors)
      names.push_back(name);
  return names;
}

TEST(FrequencyBlocks, HaveTheEigenvaluesOfTheSpatialMatrixFrequencyByFrequency) {
  for (const std::string& name : refinable_schemes()) {
    const Scheme& scheme = shipped(name);
    FrequencyAnalysis analysis(scheme);
    for (int n = 3; n <= 12; ++n) {
      const Result<FrequencyBlocks> blocks = analysis.blocks(n);
      ASSERT_TRUE(blocks.ok()) << name << ' ' << n << ": " << blocks.error().text();
      for (int omega = 0; omega <= n / 2; ++omega) {
        const Eigen::MatrixXcd spatial = frequency_block(scheme, n, blocks->rings, omega);
        const Eigen::MatrixXcd& block = blocks->blocks[static_cast<std::size_t>(omega)];
        ASSERT_EQ(block.rows(), spatial.rows()) << name << ' ' << n << ' ' << omega;
        // defective eigenvalues are ill-conditioned: powers' traces are not
        Eigen::MatrixXcd a = block;
        Eigen::MatrixXcd b = spatial;
        for (int k = 1; k <= block.rows(); ++k, a *= block, b *= spatial)
          EXPECT_LT(std::abs(a.trace() - b.trace()), 1e-12) << name << ' ' << n << ' ' << omega;
        EXPECT_LT(multiset_distance(eigenvalues(block), eigenvalues(spatial)), 1e-3)
            << name << ' ' << n << ' ' << omega;
      }
    }
  }
}

TEST(FrequencyBlocks, OfSqrt3AreThePapersEntryByEntry) {
  FrequencyAnalysis analysis(shipped("sqrt3"), 2);
  for (int n = 3; n <= 12; ++n) {
    const FrequencyBlocks blocks = analysis.blocks(n).value();
    // orbits B, D, C here; B, C, D in the paper
    ASSERT_EQ(blocks.orbits.size(), 3U);
    EXPECT_EQ(blocks.orbits[2].angle, 0.5);
    const double alpha = (4 - 2 * std::cos(2 * M_PI / n)) / 9;
    for (int omega = 0; omega <= n / 2; ++omega) {
      const double k1 = std::cos(M_PI * omega / n);
      const double k2 = std::cos(2 * M_PI * omega / n);
      Eigen::Matrix3d paper;
      // The new points c lie at angle k, d at k + 1/2 of the *turned* star: c is its orbit C.
      if (omega == 0)
        paper << 2 / 3. - alpha, 0, 0, 7 / 9. - alpha, 1 / 9., 1 / 18., 2 / 3. - alpha, 1 / 3., 0;
      else
        paper << 2 / 3. * k1, 0, 0, 2 / 3. + k2 / 9, k1 / 9, 1 / 18., 2 / 3. * k1, 1 / 3., 0;
      Eigen::MatrixXcd block = blocks.blocks[static_cast<std::size_t>(omega)];
      if (omega == 0) {  // relative to the centre: the differences' matrix
        Eigen::MatrixXcd centred = block.bottomRightCorner(3, 3);
        for (int i = 0; i < 3; ++i) centred.row(i) -= block.row(0).tail(3);
        block = centred;
      }
      Eigen::PermutationMatrix<3> order;
      order.indices() << 0, 2, 1;  // D and C change places
      const Eigen::Matrix3cd in_paper_order = order * block * order;
      EXPECT_LT((in_paper_order - paper.cast<std::complex<double>>()).norm(), 1e-14)
          << n << ' ' << omega << '\n'
          << in_paper_order << "\n\n"
          << paper;
    }
  }
}

TEST(FrequencyBlocks, OfFourEightAreWhatItsStencilsSay) {
  FrequencyAnalysis analysis(shipped("four-eight"), 2);
  for (int n = 3; n <= 12; ++n) {
    const FrequencyBlocks blocks = analysis.blocks(n).value();
    // the neighbours; then of ring 2 the one straight on, one beside it, the diagonal one, one more
    ASSERT_EQ(blocks.orbits.size(), 5U);
    for (int omega = 0; omega <= n / 2; ++omega) {
      const double turn = M_PI * omega / n;  // by half a sector; c and s: by a quarter
      const double c = 2 * std::cos(turn);
      const std::complex<double> s = std::polar(1.0, turn / 2), t = std::conj(s);
      Eigen::MatrixXcd expected(5, 5);
      expected << c / 4, 0, 0, 1 / 4., 0,     // of the centre's faces
          c / 8, 0, t / 8., 1 / 2., s / 8.,   // where the diagonal was
          s / 4., s / 4., 0, t / 4., 1 / 4.,  // of the faces beyond
          1 / 2., 1 / 8., 0, c / 8, 0,        // where the neighbour was
          t / 4., t / 4., 1 / 4., s / 4., 0;
      const Eigen::MatrixXcd& block = blocks.blocks[static_cast<std::size_t>(omega)];
      EXPECT_LT((block.bottomRightCorner(5, 5) - expected).norm(), 1e-14)
          << n << ' ' << omega << '\n'
          << block;
      if (omega > 0) continue;
      Eigen::VectorXd to_centre(6);
      to_centre << 1 / 2., 1 / 4., 0, 0, 1 / 8., 0;
      EXPECT_LT((block.col(0) - to_centre).norm(), 1e-14) << n;
      EXPECT_NEAR(block(0, 1).real(), 1 / 2., 1e-14);
    }
  }
  EXPECT_FALSE(FrequencyAnalysis(shipped("four-eight"), 1).blocks(5).ok());
}

/// [PetersReif1997] The ring round a face is refined by its edges' middles alone.
TEST(FrequencyBlocks, OfMidEdgeHaveTheCosinesOfItsRing) {
  FrequencyAnalysis analysis(shipped("midedge"));
  for (int n = 3; n <= 12; ++n) {
    const FrequencyBlocks blocks = analysis.blocks(n).value();
    for (int omega = 0; omega <= n / 2; ++omega) {
      const Eigen::MatrixXcd& block = blocks.blocks[static_cast<std::size_t>(omega)];
      EXPECT_NEAR(block(0, 0).real(), std::cos(M_PI * omega / n), 1e-14) << n << ' ' << omega;
      for (Eigen::Index i = 1; i < block.cols(); ++i) EXPECT_EQ(std::abs(block(0, i)), 0);
    }
  }
}

TEST(FrequencyBlocks, FindTheRingsThatControlTheSurface) {
  const auto rings = [](const std::string& name, int n) {
    const Result<FrequencyBlocks> blocks = FrequencyAnalysis(shipped(name)).blocks(n);
    EXPECT_TRUE(blocks.ok()) << name << ": " << blocks.error().text();
    return blocks.ok() ? blocks->rings : 0;
  };
  EXPECT_EQ(rings("loop", 7), 2);
  EXPECT_EQ(rings("catmull-clark", 5), 2);
  EXPECT_EQ(rings("butterfly", 5), 3);
  EXPECT_EQ(rings("butterfly-modified", 5), 3);
  EXPECT_GE(rings("doo-sabin", 5), 1);
  EXPECT_GE(rings("sqrt3", 5), 2);
  EXPECT_EQ(rings("four-eight", 5), 3);
}

TEST(FrequencyBlocks, AreRefusedBelowTheLeastValenceAndOnTooFewRings) {
  FrequencyAnalysis loop(shipped("loop"));
  EXPECT_FALSE(loop.blocks(1).ok());
  FrequencyAnalysis dual(shipped("doo-sabin"));
  EXPECT_FALSE(dual.blocks(2).ok());
  FrequencyAnalysis butterfly(shipped("butterfly"), 1);
  const Result<FrequencyBlocks> blocks = butterfly.blocks(5);
  ASSERT_FALSE(blocks.ok());
  EXPECT_NE(blocks.error().hint.find("more rings"), std::string::npos);
}

TEST(FrequencyBlocks, CostNoMoreAtValence2000) {
  FrequencyAnalysis analysis(shipped("loop"));
  const FrequencyBlocks blocks = analysis.blocks(2000).value();
  EXPECT_EQ(blocks.blocks.size(), 1001U);
  EXPECT_EQ(blocks.blocks[1].rows(), 3);
  EXPECT_NEAR(eigenvalues(blocks.blocks[1])[0].real(), 3 / 8. + std::cos(2 * M_PI / 2000) / 4,
              1e-14);
}

}  // namespace
}  // namespace limn::test
