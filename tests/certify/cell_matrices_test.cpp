// Cells against refinement on the lattice by the mask itself, step by step, where the lattice turns
// too; and the bounds of the way to the limit against going there.

#include "limn/certify/lattice/cell_matrices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "limn/certify/lattice/contraction.h"
#include "limn/regular/regular_mask.h"
#include "support/shipped.h"

namespace limn::certify {
namespace {

using Values = std::map<LatticeVector, double>;

/// Coordinates in the lattice's basis of those in a sector's.
LatticeVector on_lattice(Lattice lattice, LatticeVector k) {
  return lattice == Lattice::triangle ? LatticeVector{k[0] + k[1], k[1]} : k;
}

/// One step by the mask as it stands, twice the offsets: value m weighs values j with m - M j. Dual
/// values are at odd places of twice the lattice.
Values refined(const Mask& mask, const Values& twice, const std::vector<LatticeVector>& wanted) {
  Values result;
  for (const LatticeVector m : wanted) {
    double sum = 0;
    for (const auto& [j, value] : twice) {
      const LatticeVector at = mask.dilation.apply(j);
      const auto weight = mask.coefficients.find({m[0] - at[0], m[1] - at[1]});
      if (weight != mask.coefficients.end()) sum += to_double(weight->second) * value;
    }
    result[m] = sum;
  }
  return result;
}

class OfEveryMask : public testing::TestWithParam<const char*> {};

TEST_P(OfEveryMask, PartsHaveTheValuesOfRefinement) {
  const Mask mask = regular_mask(test::shipped(GetParam())).value();
  const CellMatrices cells = cell_matrices(mask).value();
  const int half = cells.dual ? 1 : 0;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  std::map<LatticeVector, double> at;  // by sector coordinates
  Values twice;
  for (const LatticeVector p : cells.points) {
    const double value = at[p] = number(random);
    const LatticeVector k = on_lattice(cells.lattice, {2 * p[0] + half, 2 * p[1] + half});
    twice[k] = value;
  }
  // the values that a part needs, by the mask's own labels: at place X the label is M X, and after
  // two steps M M X
  for (int y = 0; y < cells.scale; ++y)
    for (int x = 0; x < cells.scale; ++x) {
      std::vector<double> fine;
      for (const LatticeVector p : cells.points) {
        const LatticeVector k{2 * (x + p[0]) + half, 2 * (y + p[1]) + half};  // 2 s X
        LatticeVector label = on_lattice(cells.lattice, k);
        for (int step = 0; step < cells.steps; ++step) label = mask.dilation.apply(label);
        ASSERT_EQ(label[0] % cells.scale, 0);
        label = {label[0] / cells.scale, label[1] / cells.scale};
        Values now = twice;
        if (cells.steps == 2) {
          std::vector<LatticeVector> between;
          for (int a = -40; a <= 40; ++a)
            for (int b = -40; b <= 40; ++b) between.push_back({2 * a, 2 * b});
          static std::map<std::string, Values> known;  // of this mask: the same for all parts
          auto& first = known[GetParam()];
          if (first.empty()) first = refined(mask, twice, between);
          now = first;
        }
        fine.push_back(refined(mask, now, {label})[label]);
      }
      // the same by the matrices
      std::vector<double> residual;
      const double c0 = at.at({0, 0});
      const std::array<double, 2> g{at.at({1, 0}) - c0, at.at({0, 1}) - c0};
      for (std::size_t i = 3; i < cells.points.size(); ++i) {
        const auto [px, py] = cells.points[i];
        residual.push_back((at.at({px, py}) - c0 - px * g[0] - py * g[1]) /
                           to_double(cells.sizes[i - 3]));
      }
      const auto dot = [&](const std::vector<Rational>& row) {
        double sum = 0;
        for (std::size_t j = 0; j < row.size(); ++j) sum += to_double(row[j]) * residual[j];
        return sum;
      };
      const auto digit = static_cast<std::size_t>(x + cells.scale * y);
      const double shift = to_double(cells.shift);
      const double s = cells.scale;
      EXPECT_NEAR(fine[0],
                  c0 + (x / s + shift) * g[0] + (y / s + shift) * g[1] + dot(cells.value[digit]),
                  1e-12);
      for (std::size_t i = 0; i < 2; ++i)
        EXPECT_NEAR(fine[i + 1] - fine[0], g[i] / s + dot(cells.gradient[digit][i]), 1e-12);
      for (std::size_t i = 3; i < fine.size(); ++i) {
        const auto [px, py] = cells.points[i];
        const double affine = fine[0] + px * (fine[1] - fine[0]) + py * (fine[2] - fine[0]);
        EXPECT_NEAR((fine[i] - affine) / to_double(cells.sizes[i - 3]),
                    dot(cells.residual[digit][i - 3]), 1e-12);
      }
    }
}

TEST_P(OfEveryMask, BoundsHoldOnTheWayToTheLimit) {
  const CellMatrices cells = cell_matrices(regular_mask(test::shipped(GetParam())).value()).value();
  const Contraction bounds = enclose_contraction(cells, 0.5, 200'000).value();
  std::mt19937 random(11);
  std::uniform_real_distribution<double> number(-1, 1);
  double closest = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<double> r;
    for (std::size_t j = 0; j < cells.sizes.size(); ++j) r.push_back(number(random));
    std::array<double, 2> allowed{};
    for (std::size_t j = 0; j < r.size(); ++j)
      for (std::size_t i = 0; i < 2; ++i) allowed[i] += bounds.gradient[i][j] * std::abs(r[j]);
    std::array<double, 2> way{};
    double scale = cells.scale;
    for (int level = 0; level < 12; ++level, scale *= cells.scale) {
      const auto d = static_cast<std::size_t>(random() % cells.residual.size());
      const auto dot = [&](const std::vector<Rational>& row) {
        double sum = 0;
        for (std::size_t j = 0; j < row.size(); ++j) sum += to_double(row[j]) * r[j];
        return sum;
      };
      for (std::size_t i = 0; i < 2; ++i) way[i] += scale * dot(cells.gradient[d][i]);
      std::vector<double> next;
      for (const auto& row : cells.residual[d]) next.push_back(dot(row));
      r = next;
      for (std::size_t i = 0; i < 2; ++i) {
        ASSERT_LE(std::abs(way[i]), allowed[i]);
        closest = std::max(closest, std::abs(way[i]) / allowed[i]);
      }
    }
  }
  EXPECT_GT(closest, 0.01);  // bounds that allow a hundred times as much are of no use
}

INSTANTIATE_TEST_SUITE_P(Masks, OfEveryMask,
                         testing::Values("loop", "butterfly", "interpolating-loop", "sqrt3",
                                         "catmull-clark", "doo-sabin", "laplacian-loop"));

/// Bilinear patches: sum rules of order 2, smooth within each cell, and no C1.
TEST(Contraction, IsNotFoundWhereTheLatticeIsNotC1) {
  Scheme scheme = test::shipped("box-spline-quad");
  ASSERT_TRUE(set_parameters(scheme, {"i=2", "j=2", "p=0", "q=0"}).ok());
  const Mask mask = regular_mask(scheme).value();
  EXPECT_TRUE(enclose_contraction(cell_matrices(mask).value(), 0.75, 50'000).ok());
  const CellMatrices wide = cell_matrices(mask, CellExtent::neighbours).value();
  EXPECT_FALSE(enclose_contraction(wide, 0.75, 50'000).ok());
}

}  // namespace
}  // namespace limn::certify
