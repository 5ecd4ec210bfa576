// Balls of random matrices against eigenvalues in double precision.

#include "limn/certify/blocks/spectral_bound.h"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include <random>

#include "limn/certify/blocks/valence_balls.h"
#include "support/shipped.h"

namespace limn::certify {
namespace {

number::BallMatrix balls(const Eigen::MatrixXd& a) {
  number::BallMatrix result(static_cast<std::size_t>(a.rows()), static_cast<std::size_t>(a.rows()));
  for (Eigen::Index i = 0; i < a.rows(); ++i)
    for (Eigen::Index j = 0; j < a.rows(); ++j)
      result(static_cast<std::size_t>(i), static_cast<std::size_t>(j)) = number::Ball(a(i, j));
  return result;
}

TEST(SpectralBound, TellsRandomMatricesApart) {
  std::mt19937 random(3);
  std::normal_distribution<double> number;
  int enclosed = 0;
  for (int round = 0; round < 200; ++round) {
    const Eigen::Index size = 1 + static_cast<Eigen::Index>(random() % 7);
    const Eigen::MatrixXd a =
        Eigen::MatrixXd::NullaryExpr(size, size, [&] { return number(random); });
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(a);
    Eigen::Index k = 0;
    const double radius = solver.eigenvalues().cwiseAbs().maxCoeff(&k);
    EXPECT_TRUE(squarings_below(balls(a), number::Ball(radius * 1.001), 40));
    EXPECT_FALSE(squarings_below(balls(a), number::Ball(radius * 0.999), 40));
    EXPECT_FALSE(
        squarings_below(balls(a), number::Ball::between(radius * 0.999, radius * 1.01), 40));
    if (solver.eigenvalues()(k).imag() != 0) continue;
    std::vector<double> vector;
    for (Eigen::Index i = 0; i < size; ++i) vector.push_back(solver.eigenvectors()(i, k).real());
    const auto pair = enclose_eigenpair(balls(a), solver.eigenvalues()(k).real(), vector);
    if (!pair) continue;
    ++enclosed;
    EXPECT_NEAR(pair->value.approx(), solver.eigenvalues()(k).real(), 1e-10 * radius);
    EXPECT_LT(pair->value.radius(), 1e-25);
    double others = 0;
    for (Eigen::Index i = 0; i < size; ++i)
      if (i != k) others = std::max(others, std::abs(solver.eigenvalues()(i)));
    const number::BallMatrix rest = deflated(balls(a), *pair);
    EXPECT_TRUE(squarings_below(rest, number::Ball(others * 1.001 + 1e-6), 40));
    if (size > 1 && others > 1e-3)
      EXPECT_FALSE(squarings_below(rest, number::Ball(others * 0.999), 40));
  }
  EXPECT_GT(enclosed, 60);
}

TEST(SpectralBound, EnclosesNoDoubleEigenvalue) {
  Eigen::MatrixXd a(2, 2);
  a << 0.5, 1, 0, 0.5;
  EXPECT_FALSE(enclose_eigenpair(balls(a), 0.5, {1, 0}).ok());
  EXPECT_FALSE(squarings_below(balls(a), number::Ball(0.5), 60));
  EXPECT_TRUE(squarings_below(balls(a), number::Ball(0.51), 60));
}

/// Traces of powers of the real blocks and of those in double precision.
TEST(ValenceBalls, HaveTheBlocksOfTheFrequencyAnalysis) {
  for (const char* name : {"loop", "butterfly-modified", "catmull-clark", "sqrt3", "doo-sabin",
                           "interpolating-loop", "laplacian-butterfly"}) {
    const Scheme& scheme = test::shipped(name);
    FrequencyAnalysis analysis(scheme);
    for (const int n : {3, 4, 5, 6, 7, 9, 12}) {
      SCOPED_TRACE(testing::Message() << name << " n = " << n);
      const FrequencyBlocks blocks = analysis.blocks(n).value();
      const ValenceBalls exact = ValenceBalls::make(scheme, n).value();
      for (int omega = 0; omega <= n / 2; ++omega) {
        const Eigen::MatrixXcd& expected = blocks.blocks[static_cast<std::size_t>(omega)];
        const number::BallMatrix block = exact.block(omega);
        Eigen::MatrixXcd power = expected;
        number::BallMatrix found = block;
        for (int k = 1; k <= 6; ++k) {
          number::Ball trace =
              omega == 0 ? number::Ball(1) : number::Ball(0);  // frequency 0 has lost its 1
          for (std::size_t i = 0; i < found.rows(); ++i) trace += found(i, i);
          EXPECT_NEAR(trace.approx(), power.trace().real(), 1e-12) << omega << " " << k;
          power = power * expected;
          found = number::product(found, block);
        }
      }
    }
  }
}

}  // namespace
}  // namespace limn::certify
