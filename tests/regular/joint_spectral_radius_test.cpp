#include "limn/regular/smoothness/joint_spectral_radius.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>
#include <random>

#include "limn/regular/algebra/approx_matrix.h"
#include "limn/regular/smoothness/spectral_radius.h"

namespace limn {
namespace {

regular::RationalMatrix matrix(const std::vector<std::vector<int>>& rows, int over = 1) {
  regular::RationalMatrix result;
  for (const std::vector<int>& row : rows) {
    result.emplace_back();
    for (const int entry : row) result.back().emplace_back(entry, over);
  }
  return result;
}

void expect_encloses(const JointSpectralRadius& found, double value, double width) {
  EXPECT_LE(found.lower, value * (1 + 1e-14));
  EXPECT_GE(found.upper, value * (1 - 1e-14));
  EXPECT_LE(found.upper - found.lower, width);
}

/// The bracket that all products of one length give: the greatest spectral radius and norm.
std::pair<double, double> by_all_products(const std::vector<regular::RationalMatrix>& matrices,
                                          int length) {
  std::vector<Eigen::MatrixXd> products{
      Eigen::MatrixXd::Identity(static_cast<Eigen::Index>(matrices[0].size()),
                                static_cast<Eigen::Index>(matrices[0].size()))};
  for (int i = 0; i < length; ++i) {
    std::vector<Eigen::MatrixXd> longer;
    for (const Eigen::MatrixXd& p : products)
      for (const regular::RationalMatrix& m : matrices)
        longer.emplace_back(p * regular::approx_matrix(m));
    products = std::move(longer);
  }
  double radius = 0;
  double norm = 0;
  for (const Eigen::MatrixXd& p : products) {
    radius = std::max(radius, p.eigenvalues().cwiseAbs().maxCoeff());
    norm = std::max(norm, p.cwiseAbs().rowwise().sum().maxCoeff());
  }
  return {std::pow(radius, 1.0 / length), std::pow(norm, 1.0 / length)};
}

TEST(JointSpectralRadius, OfTheGoldenPairIsTheGoldenMean) {
  const JointSpectralRadius found =
      regular::enclose_joint_spectral_radius({matrix({{1, 1}, {0, 1}}), matrix({{1, 0}, {1, 1}})});
  expect_encloses(found, (1 + std::sqrt(5)) / 2, 1e-7);
  EXPECT_EQ(found.product.size(), 2U);
}

TEST(JointSpectralRadius, OfDaubechiesFourIsThatOfOneMatrix) {
  // [DaubechiesLagarias1992]: ρ = (1 + √3)/4, Hölder exponent 0.5500; on differences of order 1
  // with sum rules of order 2 taken off the 2 × 2 matrices are triangular
  const double root3 = std::sqrt(3.0);
  const auto c = [&](double x) { return Rational(x); };
  const std::vector<double> h{(1 + root3) / 4, (3 + root3) / 4, (3 - root3) / 4, (1 - root3) / 4};
  // T_e(i, l) = h(e + 2i - l) for i, l in 0..2, on sequences that sum to 0: basis d_l = δ_l -
  // δ_{l+1}
  std::vector<regular::RationalMatrix> matrices;
  for (int e = 0; e < 2; ++e) {
    regular::RationalMatrix m(2, regular::FieldVector<Rational>(2, Rational(0)));
    const auto t = [&](int i, int l) {
      const int k = e + 2 * i - l;
      return k < 0 || k > 3 ? 0.0 : h[static_cast<std::size_t>(k)];
    };
    for (int l = 0; l < 2; ++l) {
      m[0][static_cast<std::size_t>(l)] = c(t(0, l) - t(0, l + 1));
      m[1][static_cast<std::size_t>(l)] = c(t(0, l) - t(0, l + 1) + t(1, l) - t(1, l + 1));
    }
    matrices.push_back(m);
  }
  const JointSpectralRadius found = regular::enclose_joint_spectral_radius(matrices);
  expect_encloses(found, (1 + root3) / 4, 1e-7);
  EXPECT_NEAR(-std::log2(found.upper), 0.5500, 1e-4);
}

TEST(JointSpectralRadius, OfOneMatrixIsItsSpectralRadius) {
  expect_encloses(regular::enclose_joint_spectral_radius({matrix({{2, 1}, {1, 1}}, 4)}),
                  (3 + std::sqrt(5)) / 8, 1e-7);
  // complex leading eigenvalues: the traces of powers are what is left
  expect_encloses(regular::enclose_joint_spectral_radius({matrix({{1, -2}, {2, 1}}, 5)}),
                  std::sqrt(5) / 5, 3e-3);
  expect_encloses(regular::enclose_joint_spectral_radius({matrix({{0, 1}, {0, 0}})}), 0, 0);
  const JointSpectralRadius single = regular::enclose_joint_spectral_radius({matrix({{-3}}, 7)});
  EXPECT_TRUE(single.exact);
  EXPECT_EQ(*single.eigenvalue, Rational(-3, 7));
}

TEST(JointSpectralRadius, IsExactWhereAPolytopeClosesAtARationalLevel) {
  // fourth differences of the four-point scheme
  const JointSpectralRadius found = regular::enclose_joint_spectral_radius(
      {matrix({{-1, 0}, {-1, 4}}, 16), matrix({{4, -1}, {0, -1}}, 16)});
  EXPECT_TRUE(found.exact);
  EXPECT_EQ(*found.eigenvalue, Rational(1, 4));
  ASSERT_EQ(found.blocks.size(), 1U);
  EXPECT_TRUE(found.blocks[0].bounded);
  EXPECT_FALSE(found.blocks[0].below);
  EXPECT_EQ(found.blocks[0].vertices, 2);
  // an irrational radius stays a bracket
  EXPECT_FALSE(
      regular::enclose_joint_spectral_radius({matrix({{1, 1}, {0, 1}}), matrix({{1, 0}, {1, 1}})})
          .exact);
}

TEST(JointSpectralRadius, LiesWithinWhatAllProductsGive) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> entry(-3, 3);
  for (int trial = 0; trial < 12; ++trial) {
    const int size = 2 + trial % 3;
    std::vector<regular::RationalMatrix> matrices;
    for (int m = 0; m < 2 + trial % 2; ++m) {
      std::vector<std::vector<int>> rows(static_cast<std::size_t>(size),
                                         std::vector<int>(static_cast<std::size_t>(size)));
      for (auto& row : rows)
        for (int& value : row) value = entry(random);
      matrices.push_back(matrix(rows, 4));
    }
    const JointSpectralRadius found = regular::enclose_joint_spectral_radius(matrices);
    const auto [low, high] = by_all_products(matrices, 6);
    EXPECT_GE(found.upper, low * (1 - 1e-12)) << trial;
    EXPECT_LE(found.lower, high * (1 + 1e-12)) << trial;
    EXPECT_LE(found.upper, found.lower * 1.01) << trial;
  }
}

regular::RationalMatrix inverse_of_unimodular(const regular::RationalMatrix& a) {
  const Eigen::MatrixXd inverse = regular::approx_matrix(a).inverse();
  regular::RationalMatrix result(a.size(), regular::FieldVector<Rational>(a.size(), Rational(0)));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j)
      result[i][j] = static_cast<int>(
          std::lround(inverse(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j))));
  return result;
}

TEST(DiagonalBlocks, AreFoundBehindAChangeOfBasis) {
  // blocks 2, 1 and 1, hidden by unimodular matrices; the golden pair leads
  const regular::RationalMatrix hide =
      matrix({{1, 2, 0, 1}, {0, 1, 3, 0}, {1, 2, 1, 2}, {0, 0, 0, 1}});
  const regular::RationalMatrix show = inverse_of_unimodular(hide);
  std::vector<regular::RationalMatrix> matrices;
  for (const auto& rows : {matrix({{1, 1, 5, 2}, {0, 1, 1, 1}, {0, 0, 1, 3}, {0, 0, 0, -1}}),
                           matrix({{1, 0, 2, 2}, {1, 1, 0, 1}, {0, 0, -1, 7}, {0, 0, 0, 1}})})
    matrices.push_back(regular::product(regular::product(show, rows), hide));
  std::vector<std::size_t> sizes;
  regular::Echelon<Rational> earlier(4);
  for (const regular::DiagonalBlock& block : regular::diagonal_blocks(matrices)) {
    sizes.push_back(block.size());
    EXPECT_TRUE(block.irreducible);
    // the basis: images differ from what the block's matrix says by vectors of earlier blocks
    for (std::size_t m = 0; m < matrices.size(); ++m)
      for (std::size_t j = 0; j < block.size(); ++j) {
        regular::FieldVector<Rational> rest = regular::product(matrices[m], block.basis[j]);
        for (std::size_t i = 0; i < block.size(); ++i)
          for (std::size_t k = 0; k < rest.size(); ++k)
            rest[k] -= block.matrices[m][i][j] * block.basis[i][k];
        EXPECT_TRUE(earlier.contains(rest));
      }
    for (const regular::FieldVector<Rational>& v : block.basis) EXPECT_TRUE(earlier.insert(v));
  }
  std::sort(sizes.begin(), sizes.end());
  EXPECT_EQ(sizes, (std::vector<std::size_t>{1, 1, 2}));
  expect_encloses(regular::enclose_joint_spectral_radius(matrices), (1 + std::sqrt(5)) / 2, 1e-7);
}

TEST(SpectralRadius, IsNotBoundedByWhatRoundingMakesOfJordanBlocks) {
  // 1/3 + N, hidden: in double precision the eigenvalues lie round 1/3, some of them beyond it
  int beyond = 0;
  for (std::size_t size = 2; size <= 5; ++size)
    for (int variant = 1; variant <= 6; ++variant) {
      regular::RationalMatrix left(size, regular::FieldVector<Rational>(size, Rational(0)));
      regular::RationalMatrix right = left;
      regular::RationalMatrix jordan = left;
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j < size; ++j) {
          const int entry = static_cast<int>(3 * i + 5 * j) * variant % 7 - 3;
          left[i][j] = i == j ? 1 : i > j ? entry : 0;
          right[i][j] = i == j ? 1 : i < j ? entry : 0;
          if (i == j) jordan[i][j] = Rational(1, 3);
          if (j == i + 1) jordan[i][j] = 1;
        }
      const regular::RationalMatrix hide = regular::product(left, right);
      const regular::RationalMatrix hidden =
          regular::product(regular::product(inverse_of_unimodular(hide), jordan), hide);
      for (const std::complex<double> value : regular::approx_matrix(hidden).eigenvalues())
        beyond += value.imag() == 0 && value.real() > (1 + 1e-9) / 3 ? 1 : 0;
      const double lower = regular::lower_spectral_radius(hidden).lower;
      EXPECT_LE(lower, 1.0 / 3) << size << ' ' << variant;
      EXPECT_GE(lower, 0.99 / 3) << size << ' ' << variant;
    }
  EXPECT_GT(beyond, 0);
}

TEST(SpectralRadius, IsBoundedFromBelow) {
  // a double eigenvalue, whose determinant does not change its sign
  const regular::RationalMatrix twice =
      matrix({{1, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 1}, {0, 0, 1, 0}});
  const regular::SpectralRadiusBound bound = regular::lower_spectral_radius(twice);
  EXPECT_LE(bound.lower, (1 + std::sqrt(5)) / 2);
  EXPECT_GE(bound.lower, (1 + std::sqrt(5)) / 2 * (1 - 1e-9));
  EXPECT_FALSE(bound.eigenvalue);
  // a Jordan block of a rational one
  EXPECT_EQ(regular::lower_spectral_radius(matrix({{-3, 1}, {0, -3}}, 7)).eigenvalue,
            Rational(-3, 7));
  EXPECT_EQ(regular::lower_spectral_radius(matrix({{0, 0}, {0, 0}})).lower, 0);
}

}  // namespace
}  // namespace limn
