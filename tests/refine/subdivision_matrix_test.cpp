// Subdivision matrices against closed forms from the literature, and their symmetry.

#include "limn/refine/subdivision_matrix.h"
#include "limn/number/exact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/frequency.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-14;

Eigen::MatrixXd matrix_of(const std::string& scheme, int n, int rings) {
  return dense(refine::subdivision_matrix<double>(shipped(scheme), n, rings).value());
}

double cosine(double p, double q) { return std::cos(kPi * p / q); }

/// Places in `star` of triangles, k modulo n: B(k) on ring 1 at angle k, D(k) on ring 2 at angle k,
/// C(k) on ring 2 at angle k + 1/2 [BGSK §3]. On quads B and C alone, both on ring 1.
struct Places {
  int n;
  [[nodiscard]] int turn(int k) const { return (k % n + n) % n; }
  [[nodiscard]] int b(int k) const { return 1 + turn(k); }
  [[nodiscard]] int d(int k) const { return 1 + n + 2 * turn(k); }
  [[nodiscard]] int c(int k) const { return 1 + n + 2 * turn(k) + 1; }
  [[nodiscard]] int quad_b(int k) const { return 1 + 2 * turn(k); }
  [[nodiscard]] int quad_c(int k) const { return 1 + 2 * turn(k) + 1; }
};

Eigen::MatrixXd loop_two_rings(int n) {
  const Places at{n};
  const double lambda = 3 / 8. + cosine(2, n) / 4, beta = (5 / 8. - lambda * lambda) / n;
  Eigen::MatrixXd s = Eigen::MatrixXd::Zero(1 + 3 * n, 1 + 3 * n);
  s(0, 0) = 1 - n * beta;
  for (int k = 0; k < n; ++k) {
    s(0, at.b(k)) = beta;
    // a spoke's edge point
    s(at.b(k), 0) += 3 / 8.;
    s(at.b(k), at.b(k)) += 3 / 8.;
    for (const int wing : {at.b(k - 1), at.b(k + 1)}) s(at.b(k), wing) += 1 / 8.;
    // a regular vertex point
    s(at.d(k), at.b(k)) += 10 / 16.;
    for (const int near : {0, at.b(k - 1), at.b(k + 1), at.c(k - 1), at.d(k), at.c(k)})
      s(at.d(k), near) += 1 / 16.;
    // the edge point between two spokes
    for (const int end : {at.b(k), at.b(k + 1)}) s(at.c(k), end) += 3 / 8.;
    for (const int wing : {0, at.c(k)}) s(at.c(k), wing) += 1 / 8.;
  }
  return s;
}

TEST(SubdivisionMatrix, OfLoopIsTheLiteratures) {
  for (int n = 3; n <= 12; ++n) {
    const Eigen::MatrixXd two = loop_two_rings(n);
    EXPECT_LT((matrix_of("loop", n, 2) - two).cwiseAbs().maxCoeff(), kRounding) << n;
    EXPECT_LT((matrix_of("loop", n, 1) - two.topLeftCorner(n + 1, n + 1)).cwiseAbs().maxCoeff(),
              kRounding)
        << n;
  }
}

Eigen::MatrixXd sqrt3_two_rings(int n) {
  const Places at{n};
  const double alpha = (4 - 2 * cosine(2, n)) / 9;
  Eigen::MatrixXd s = Eigen::MatrixXd::Zero(1 + 3 * n, 1 + 3 * n);
  s(0, 0) = 1 - alpha;
  for (int k = 0; k < n; ++k) {
    s(0, at.b(k)) = alpha / n;
    // new places are half a sector on: b and d at k + 1/2, c between them at k + 1
    for (const int corner : {0, at.b(k), at.b(k + 1)}) s(at.b(k), corner) += 1 / 3.;
    for (const int corner : {at.b(k), at.b(k + 1), at.c(k)}) s(at.d(k), corner) += 1 / 3.;
    const int m = k + 1;
    s(at.c(k), at.b(m)) += 2 / 3.;
    for (const int near : {0, at.b(m - 1), at.b(m + 1), at.c(m - 1), at.c(m), at.d(m)})
      s(at.c(k), near) += 1 / 18.;
  }
  return s;
}

TEST(SubdivisionMatrix, OfSqrt3IsTheLiteratures) {
  for (int n = 3; n <= 12; ++n)
    EXPECT_LT((matrix_of("sqrt3", n, 2) - sqrt3_two_rings(n)).cwiseAbs().maxCoeff(), kRounding);
}

/// Σ over column orbit of s(row, q)·e^{2πiω(q - p)/n}, the phases at the points' own angles, in
/// half sectors: p of the row's point, q of the orbit's points place(k) at offset + 2k.
template <class Place>
std::complex<double> transformed(const Eigen::MatrixXd& s, int row, int p, int n, int omega,
                                 int offset, Place place) {
  std::complex<double> sum = 0;
  for (int k = 0; k < n; ++k)
    sum += s(row, place(k)) * std::polar(1.0, kPi * omega * (offset + 2 * k - p) / n);
  return sum;
}

TEST(SubdivisionMatrix, OfSqrt3HasTheBlocksOfThePaper) {
  for (int n = 3; n <= 12; ++n) {
    const Places at{n};
    const Eigen::MatrixXd s = matrix_of("sqrt3", n, 2);
    const double alpha = (4 - 2 * cosine(2, n)) / 9;
    for (int omega = 0; omega < n; ++omega) {
      const double k1 = cosine(omega, n), k2 = cosine(2 * omega, n);
      Eigen::Matrix3cd printed;
      printed << 2 / 3. * k1, 0, 0, 2 / 3. + k2 / 9, k1 / 9, 1 / 18., 2 / 3. * k1, 1 / 3., 0;
      Eigen::Matrix3cd found;
      const std::array<std::pair<int, int>, 3> rows{{{at.b(0), 1}, {at.c(0), 2}, {at.d(0), 1}}};
      for (int i = 0; i < 3; ++i) {
        const auto& [row, p] = rows[static_cast<std::size_t>(i)];
        found(i, 0) = transformed(s, row, p, n, omega, 0, [&](int k) { return at.b(k); });
        found(i, 1) = transformed(s, row, p, n, omega, 1, [&](int k) { return at.c(k); });
        found(i, 2) = transformed(s, row, p, n, omega, 0, [&](int k) { return at.d(k); });
      }
      if (omega == 0) {  // centred on A: the centre's own row is subtracted
        found.col(0).array() -= alpha;
        printed << 2 / 3. - alpha, 0, 0, 7 / 9. - alpha, 1 / 9., 1 / 18., 2 / 3. - alpha, 1 / 3., 0;
      }
      EXPECT_LT((found - printed).cwiseAbs().maxCoeff(), kRounding) << n << " " << omega;
    }
  }
}

Eigen::MatrixXd catmull_clark_ring(int n) {
  const Places at{n};
  Eigen::MatrixXd s = Eigen::MatrixXd::Zero(1 + 2 * n, 1 + 2 * n);
  s(0, 0) = 1 - 7 / (4. * n);
  for (int k = 0; k < n; ++k) {
    s(0, at.quad_b(k)) = 3 / (2. * n * n);
    s(0, at.quad_c(k)) = 1 / (4. * n * n);
    for (const int end : {0, at.quad_b(k)}) s(at.quad_b(k), end) += 3 / 8.;
    for (const int wing : {at.quad_b(k - 1), at.quad_c(k - 1), at.quad_c(k), at.quad_b(k + 1)})
      s(at.quad_b(k), wing) += 1 / 16.;
    for (const int corner : {0, at.quad_b(k), at.quad_c(k), at.quad_b(k + 1)})
      s(at.quad_c(k), corner) += 1 / 4.;
  }
  return s;
}

TEST(SubdivisionMatrix, OfCatmullClarkIsTheLiteratures) {
  for (int n = 3; n <= 12; ++n) {
    EXPECT_LT((matrix_of("catmull-clark", n, 1) - catmull_clark_ring(n)).cwiseAbs().maxCoeff(),
              kRounding);
    const Scheme& scheme = shipped("catmull-clark");
    const double c = cosine(2, n), tangent = (c + 5 + std::sqrt((c + 9) * (c + 1))) / 16;
    const double cup = (3 * n - 7 + std::sqrt(5. * n * n - 30 * n + 49)) / (8. * n);
    for (int rings = 1; rings <= 3; ++rings) {
      const auto leading = eigenvalues(frequency_block(scheme, n, rings, 1)).front();
      EXPECT_NEAR(std::abs(leading - tangent), 0, 1e-10);
      EXPECT_LT(eigenvalue_defect(frequency_block(scheme, n, rings, 0), cup), 1e-13);
    }
  }
}

TEST(SubdivisionMatrix, OfDooSabinIsTheLiteratures) {
  for (int n = 3; n <= 12; ++n) {
    Eigen::MatrixXd face(n, n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        face(i, j) = ((i == j ? n : 0) + 3 + 2 * cosine(2 * (j - i), n)) / (4. * n);
    EXPECT_LT((matrix_of("doo-sabin", n, 1) - face).cwiseAbs().maxCoeff(), kRounding);
    // the circulant's eigenvalues: 1; 1/2 twice; 1/4
    for (int omega = 0; omega < n; ++omega) {
      const double expected = omega == 0 ? 1 : omega == 1 || omega == n - 1 ? 1 / 2. : 1 / 4.;
      const auto block = frequency_block(shipped("doo-sabin"), n, 1, omega);
      ASSERT_EQ(block.size(), 1);
      EXPECT_NEAR(std::abs(block(0, 0) - expected), 0, kRounding);
    }
  }
}

TEST(SubdivisionMatrix, SaysWhenItsNeighbourhoodIsNotInvariant) {
  const Scheme& butterfly = shipped("butterfly");
  EXPECT_EQ(refine::invariant_rings(butterfly, 7).value(), 2);
  EXPECT_FALSE(refine::subdivision_matrix<double>(butterfly, 7, 1).ok());
  EXPECT_FALSE(refine::invariant_rings(butterfly, 7, 1).ok());
  EXPECT_EQ(refine::invariant_rings(shipped("loop"), 7).value(), 1);
}

// --- laws of all schemes --------------------------------------------------------------------

class OfEveryScheme : public ::testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] const Scheme& scheme() const { return shipped(GetParam()); }
  /// Schemes that are given by their mask alone have regular vertices alone.
  [[nodiscard]] std::vector<int> valences() const {
    if (GetParam() == "box-spline-triangle") return {6};
    if (GetParam() == "box-spline-quad") return {4};
    return {3, 4, 5, 6, 7, 8, 11, 12};
  }
};

TEST_P(OfEveryScheme, RotationByASectorCommutes) {
  const Scheme& scheme = this->scheme();
  for (const int n : valences()) {
    for (int rings = refine::invariant_rings(scheme, n).value(); rings <= 3; ++rings) {
      if (!refine::subdivision_matrix<double>(scheme, n, rings))
        continue;  // one ring may be, and two not
      const Eigen::MatrixXd s = matrix_of(GetParam(), n, rings);
      const std::vector<int> image = rotation(*scheme.split, n, rings);
      ASSERT_EQ(s.rows(), static_cast<int>(image.size()));
      double worst = 0;
      for (int i = 0; i < s.rows(); ++i)
        for (int j = 0; j < s.cols(); ++j)
          worst = std::max(worst, std::abs(s(i, j) - s(image[static_cast<std::size_t>(i)],
                                                       image[static_cast<std::size_t>(j)])));
      EXPECT_LT(worst, kRounding) << n << " " << rings;
    }
  }
}

TEST_P(OfEveryScheme, ExactEntriesAreTheDoublesAndSumToOne) {
  const Scheme& scheme = this->scheme();
  for (const int n : valences()) {
    const int rings = analysis_rings(scheme, n);
    const Eigen::MatrixXd s = matrix_of(GetParam(), n, rings);
    const auto exact = refine::subdivision_matrix<number::Exact>(scheme, n, rings).value();
    ASSERT_EQ(exact.size, s.rows());
    for (int i = 0; i < exact.size; ++i) {
      number::Exact sum;
      for (int j = 0; j < exact.size; ++j) {
        sum += exact(i, j);
        EXPECT_NEAR(exact(i, j).approx(), s(i, j), kRounding);
      }
      EXPECT_TRUE(sum == number::Exact(1)) << n << ", row " << i;
    }
  }
}

TEST_P(OfEveryScheme, SmallerNeighbourhoodsAreCornersOfLargerOnes) {
  const Scheme& scheme = this->scheme();
  for (const int n : valences()) {
    const int rings = refine::invariant_rings(scheme, n).value();
    const Eigen::MatrixXd small = matrix_of(GetParam(), n, rings);
    const Eigen::MatrixXd large = matrix_of(GetParam(), n, rings + 2);
    const auto rows = large.topRows(small.rows());
    EXPECT_LT((rows.leftCols(small.cols()) - small).cwiseAbs().maxCoeff(), kRounding);
    EXPECT_LT(rows.rightCols(large.cols() - small.cols()).cwiseAbs().maxCoeff(), kRounding);
  }
}

INSTANTIATE_TEST_SUITE_P(All, OfEveryScheme, ::testing::ValuesIn(lattice_names()),
                         [](const auto& chosen) { return test_name(chosen.param); });

}  // namespace
}  // namespace limn::test
