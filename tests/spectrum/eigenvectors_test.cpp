// Eigenvectors of the blocks, and as values on the whole star.

#include "limn/spectrum/eigencomponents.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/frequency.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

const std::vector<std::string>& names() {
  static const std::vector<std::string> list{"loop",      "catmull-clark",      "sqrt3",
                                             "doo-sabin", "butterfly-modified", "optimal-high",
                                             "four-eight"};
  return list;
}

template <class Use>
void for_each_eigenvalue(const Use& use) {
  for (const std::string& name : names()) {
    FrequencyAnalysis analysis(shipped(name));
    for (int n = 3; n <= 9; ++n) {
      const FrequencyBlocks blocks = analysis.blocks(n).value();
      const Eigencomponents components = approx_eigencomponents(blocks);
      for (const BlockSpectrum& spectrum : components.spectra)
        for (const Eigenvalue& eigenvalue : spectrum.eigenvalues)
          use(name, blocks, eigenvalue, approx_eigenvectors(blocks, eigenvalue));
    }
  }
}

TEST(Eigenvectors, AreMappedToTheirMultiples) {
  for_each_eigenvalue([](const std::string& name, const FrequencyBlocks& blocks,
                         const Eigenvalue& eigenvalue, const Eigenvectors& vectors) {
    const auto& block = blocks.blocks[static_cast<std::size_t>(eigenvalue.frequency)];
    const double right = (block * vectors.right - eigenvalue.value * vectors.right).norm();
    const double left = (vectors.left * block - eigenvalue.value * vectors.left).norm();
    EXPECT_LT(right, 1e-10 * vectors.right.norm()) << name << ' ' << blocks.valence;
    EXPECT_LT(left, 1e-10 * vectors.left.norm()) << name << ' ' << blocks.valence;
    if (eigenvalue.jordan > 1) return;
    EXPECT_EQ(vectors.right.cols(), eigenvalue.multiplicity) << name << ' ' << blocks.valence;
    const Eigen::MatrixXcd products = vectors.left * vectors.right;
    EXPECT_LT((products - Eigen::MatrixXcd::Identity(products.rows(), products.cols())).norm(),
              1e-9)
        << name << ' ' << blocks.valence << ' ' << eigenvalue.value;
  });
}

TEST(Eigenvectors, LieInTheirRings) {
  for_each_eigenvalue([](const std::string& name, const FrequencyBlocks& blocks,
                         const Eigenvalue& eigenvalue, const Eigenvectors& vectors) {
    if (eigenvalue.multiplicity > 1) return;
    const Eigen::Index shift =
        vectors.left.cols() - static_cast<Eigen::Index>(blocks.orbits.size());
    for (Eigen::Index i = shift; i < vectors.left.cols(); ++i)
      if (blocks.orbits[static_cast<std::size_t>(i - shift)].ring > eigenvalue.ring) {
        EXPECT_EQ(vectors.left(0, i), 0.0) << name << ' ' << blocks.valence;
      }
  });
}

// √3's and √2's matrices turn the star by half a sector, so that spatial vectors are no plain
// eigenvectors.
TEST(Eigenvectors, InSpaceAreThoseOfTheDenseMatrix) {
  for (const std::string& name : names()) {
    if (shipped(name).split->dilation.turns()) continue;
    FrequencyAnalysis analysis(shipped(name));
    for (const int n : {3, 4, 5, 6, 8}) {
      const FrequencyBlocks blocks = analysis.blocks(n).value();
      const Eigen::MatrixXd matrix =
          dense(refine::subdivision_matrix<double>(shipped(name), n, blocks.rings).value());
      for (const BlockSpectrum& spectrum : approx_eigencomponents(blocks).spectra) {
        const Eigenvalue& leader = spectrum.eigenvalues.front();
        if (leader.jordan > 1 || std::abs(leader.value.imag()) > 0) continue;
        const Eigenvectors vectors = approx_eigenvectors(blocks, leader);
        for (const auto& values : spatial_vectors(blocks, leader.frequency, vectors.right.col(0))) {
          const auto x = Eigen::Map<const Eigen::VectorXd>(
              values.data(), static_cast<Eigen::Index>(values.size()));
          EXPECT_LT((matrix * x - leader.value.real() * x).norm(), 1e-12) << name << ' ' << n;
        }
        for (const auto& weights :
             spatial_functionals(blocks, leader.frequency, vectors.left.row(0))) {
          const auto y = Eigen::Map<const Eigen::RowVectorXd>(
              weights.data(), static_cast<Eigen::Index>(weights.size()));
          EXPECT_LT((y * matrix - leader.value.real() * y).norm(), 1e-12) << name << ' ' << n;
        }
      }
    }
  }
}

TEST(Eigenvectors, FunctionalsMeasureWhatIsThere) {
  for_each_eigenvalue([](const std::string& name, const FrequencyBlocks& blocks,
                         const Eigenvalue& eigenvalue, const Eigenvectors& vectors) {
    if (eigenvalue.jordan > 1 || eigenvalue.multiplicity > 1) return;
    const int omega = eigenvalue.frequency;
    const bool alone = omega == 0 || 2 * omega == blocks.valence;
    if (alone &&
        (eigenvalue.value.imag() != 0 || (omega > 0 && shipped(name).split->dilation.turns())))
      return;
    const std::complex<double> c(0.6, alone ? 0 : -1.7);
    const auto values = spatial_vectors(blocks, omega, c * vectors.right.col(0))[0];
    const auto weights = spatial_functionals(blocks, omega, vectors.left.row(0));
    std::array<double, 2> found{};
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t v = 0; v < values.size(); ++v) found[i] += weights[i][v] * values[v];
    EXPECT_NEAR(found[0], c.real(), 1e-10) << name << ' ' << blocks.valence << ' ' << omega;
    EXPECT_NEAR(found[1], c.imag(), 1e-10) << name << ' ' << blocks.valence << ' ' << omega;
  });
}

}  // namespace
}  // namespace limn::test
