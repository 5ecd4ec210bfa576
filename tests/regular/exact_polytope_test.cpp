#include "limn/regular/smoothness/exact_polytope.h"

#include <gtest/gtest.h>

#include <cmath>

#include "limn/regular/algebra/approx_matrix.h"
#include "limn/regular/regular_mask.h"
#include "limn/regular/smoothness/exact_radius.h"
#include "limn/regular/smoothness/regularity.h"
#include "limn/regular/smoothness/transition_operators.h"

namespace limn {
namespace {

using Vectors = std::vector<regular::FieldVector<Rational>>;

regular::RationalMatrix sixteenths(const std::vector<std::vector<int>>& rows) {
  regular::RationalMatrix result;
  for (const std::vector<int>& row : rows) {
    result.emplace_back();
    for (const int entry : row) result.back().emplace_back(entry, 16);
  }
  return result;
}

/// Fourth differences of the four-point scheme: its radius is 1/4, reached by each of
/// the matrices.
std::vector<regular::RationalMatrix> four_point() {
  return {sixteenths({{-1, 0}, {-1, 4}}), sixteenths({{4, -1}, {0, -1}})};
}

const Rational kQuarter(1, 4);
const Rational kTiny(1, 1'000'000'000'000);
const Vectors kStart{{Rational(0), Rational(1)}};

TEST(ExactPolytope, ClosesAtTheLevelItself) {
  const auto found = regular::find_invariant_polytope(four_point(), kQuarter, kStart);
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(regular::certify_invariant_polytope(four_point(), kQuarter, *found));
  // nothing passes below, however little
  EXPECT_FALSE(regular::certify_invariant_polytope(four_point(), kQuarter - kTiny, *found));
  regular::ExactPolytopeLimits few;
  few.most_vertices = 200;
  EXPECT_FALSE(regular::find_invariant_polytope(four_point(), kQuarter - kTiny, kStart, few));
}

TEST(ExactPolytope, WithAVertexMovedIsRefused) {
  const Vectors found = regular::find_invariant_polytope(four_point(), kQuarter, kStart).value();
  const Rational minus(-1, 4);
  EXPECT_EQ(found, (Vectors{{Rational(0), Rational(1)}, {minus, minus}}));
  const auto passes = [](const Vectors& vertices) {
    return regular::certify_invariant_polytope(four_point(), kQuarter, vertices);
  };
  // the second is the image of the first, and lies on the surface
  EXPECT_FALSE(passes({{Rational(0), 1 + kTiny}, found[1]}));
  EXPECT_FALSE(passes({found[0], {minus + kTiny, minus + kTiny}}));
  EXPECT_FALSE(passes({found[0], {minus, minus + kTiny}}));
  EXPECT_FALSE(passes({found[0], {minus + kTiny, minus}}));
  // and has an image on an edge between ± both, which a larger one leaves
  EXPECT_FALSE(passes({found[0], {minus - kTiny, minus - kTiny}}));
}

TEST(ExactPolytope, NeedsAllVerticesAndASpanningSet) {
  const Vectors found = regular::find_invariant_polytope(four_point(), kQuarter, kStart).value();
  EXPECT_FALSE(regular::certify_invariant_polytope(four_point(), kQuarter, {found.front()}));
  EXPECT_FALSE(regular::certify_invariant_polytope(four_point(), kQuarter, {}));
}

/// The block of the scheme's differences with most rows, and its level.
struct Leading {
  std::vector<regular::RationalMatrix> matrices;
  Rational level;
};
Leading leading_of(const std::string& name, const Rational& level) {
  const Mask mask = regular_mask(find_scheme(name).value()).value();
  const regular::TransitionOperators operators =
      regular::transition_operators(mask, polynomial_orders(mask).sum_rules).value();
  Leading result{{}, level};
  for (const regular::DiagonalBlock& block : regular::diagonal_blocks(operators.on_differences))
    if (result.matrices.empty() || block.size() > result.matrices.front().size())
      result.matrices = block.matrices;
  return result;
}

/// Every product of so many factors, over level^length, stays within the polytope: its vertices
/// have coordinates no larger than the largest of a vertex.
double greatest_image(const Leading& block, const Vectors& vertices, int length) {
  std::vector<Eigen::MatrixXd> products{
      Eigen::MatrixXd::Identity(static_cast<Eigen::Index>(block.matrices.front().size()),
                                static_cast<Eigen::Index>(block.matrices.front().size()))};
  for (int n = 0; n < length; ++n) {
    std::vector<Eigen::MatrixXd> longer;
    for (const Eigen::MatrixXd& product : products)
      for (const regular::RationalMatrix& matrix : block.matrices)
        longer.emplace_back(regular::approx_matrix(matrix) * product / to_double(block.level));
    products = std::move(longer);
  }
  double most = 0;
  for (const Eigen::MatrixXd& product : products)
    for (const regular::FieldVector<Rational>& v : vertices) {
      Eigen::VectorXd x(static_cast<Eigen::Index>(v.size()));
      for (std::size_t i = 0; i < v.size(); ++i) x(static_cast<Eigen::Index>(i)) = to_double(v[i]);
      most = std::max(most, (product * x).lpNorm<Eigen::Infinity>());
    }
  return most;
}

TEST(ExactPolytope, HoldsTheImagesOfAllProducts) {
  for (const Leading& block :
       {leading_of("butterfly", Rational(1, 4)), leading_of("optimal-high", Rational(1, 3)),
        leading_of("laplacian-loop", Rational(3, 8))}) {
    std::vector<Eigen::MatrixXd> matrices;
    for (const regular::RationalMatrix& matrix : block.matrices)
      matrices.push_back(regular::approx_matrix(matrix));
    const regular::Product best = regular::approx_best_product(matrices, 2);
    EXPECT_NEAR(best.growth, to_double(block.level), 1e-9);
    const auto found = regular::find_invariant_polytope(
        block.matrices, block.level,
        regular::balanced_leading_vectors(block.matrices, block.level, best));
    ASSERT_TRUE(found.has_value());
    EXPECT_TRUE(regular::certify_invariant_polytope(block.matrices, block.level, *found));
    double size = 0;
    for (const regular::FieldVector<Rational>& v : *found)
      for (const Rational& entry : v) size = std::max(size, std::abs(to_double(entry)));
    EXPECT_LE(greatest_image(block, *found, 5), size * (1 + 1e-12));
    Vectors moved = *found;  // the first is an eigenvector, others are its images
    for (Rational& entry : moved.front()) entry *= 1 + kTiny;
    EXPECT_FALSE(regular::certify_invariant_polytope(block.matrices, block.level, moved));
  }
}

TEST(RationalRoot, IsExactOrNone) {
  EXPECT_EQ(regular::rational_root(Rational(49, 576), 2), Rational(7, 24));
  EXPECT_EQ(regular::rational_root(Rational(1, 5832), 3), Rational(1, 18));
  EXPECT_EQ(regular::rational_root(Rational(1, 5832), 6), std::nullopt);
  EXPECT_EQ(regular::rational_root(Rational(50, 576), 2), std::nullopt);
  EXPECT_EQ(regular::rational_root(Rational(5, 7), 1), Rational(5, 7));
}

}  // namespace
}  // namespace limn
