// Spectra of blocks made by hand, whose Jordan blocks are known, and connected parts by brute
// force.

#include "limn/spectrum/frequency_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "limn/spectrum/connected_parts.h"

namespace limn::test {
namespace {

/// A block of frequency 1 with one orbit on each of `rings`, each its own mirror image.
FrequencyBlocks made(const Eigen::MatrixXd& block, const std::vector<int>& rings) {
  FrequencyBlocks blocks;
  blocks.valence = 5;
  blocks.rings = rings.back();
  for (const int ring : rings)
    blocks.orbits.push_back({ring, 0.1 * static_cast<double>(blocks.orbits.size())});
  blocks.blocks.assign(3, block);
  return blocks;
}

std::vector<Eigenvalue> spectrum(const Eigen::MatrixXd& block, const std::vector<int>& rings) {
  return approx_spectrum(made(block, rings), 1).eigenvalues;
}

int jordan_at(double value, const std::vector<Eigenvalue>& list) {
  for (const Eigenvalue& one : list)
    if (std::abs(one.value - value) < 1e-12) return one.jordan;
  return 0;
}

TEST(BlockSpectrum, FindsJordanBlocksAlongPathsOnly) {
  const double a = .25;
  Eigen::Matrix3d chain = Eigen::Vector3d::Constant(a).asDiagonal();
  EXPECT_EQ(jordan_at(a, spectrum(chain, {1, 2, 3})), 1);
  chain(1, 0) = 1;
  EXPECT_EQ(jordan_at(a, spectrum(chain, {1, 2, 3})), 2);
  chain(2, 1) = 1;
  const auto list = spectrum(chain, {1, 2, 3});
  EXPECT_EQ(jordan_at(a, list), 3);
  EXPECT_EQ(list[0].multiplicity, 3);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(list[static_cast<std::size_t>(i)].ring, i + 1);
  chain(1, 1) = .5;  // the path leads through another eigenvalue
  EXPECT_EQ(jordan_at(a, spectrum(chain, {1, 2, 3})), 2);
  EXPECT_EQ(jordan_at(.5, spectrum(chain, {1, 2, 3})), 1);
}

TEST(BlockSpectrum, SeesTwoPathsThatCancel) {
  Eigen::Matrix4d paths = Eigen::Vector4d(.25, .5, .75, .25).asDiagonal();
  paths(1, 0) = paths(2, 0) = 1;
  paths(3, 1) = 1;
  paths(3, 2) = -2;  // 1/(.25-.5) - 2/(.25-.75) = 0
  EXPECT_EQ(jordan_at(.25, spectrum(paths, {1, 2, 2, 3})), 1);
  paths(3, 2) = 1;
  EXPECT_EQ(jordan_at(.25, spectrum(paths, {1, 2, 2, 3})), 2);
}

TEST(BlockSpectrum, JoinsADefectivePairWithinAPart) {
  Eigen::Matrix2d pair;
  pair << .7, .1, -.4, .3;  // (λ - 1/2)²
  const auto list = spectrum(pair, {1, 1});
  EXPECT_EQ(list[0].value, list[1].value);
  EXPECT_NEAR(list[0].value.real(), .5, 1e-15);
  EXPECT_EQ(list[0].multiplicity, 2);
  EXPECT_EQ(list[0].jordan, 2);
}

TEST(BlockSpectrum, HasComplexPairsOfTwoRows) {
  Eigen::Matrix2d turn;
  turn << .3, -.4, .4, .3;
  const auto list = spectrum(turn, {1, 1});
  EXPECT_LT(std::abs(list[0].value - std::complex<double>(.3, .4)), 1e-15);
  EXPECT_LT(std::abs(list[1].value - std::complex<double>(.3, -.4)), 1e-15);
}

TEST(ConnectedParts, AreThoseOfThePowersOfThePattern) {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    const int size = 1 + static_cast<int>(random() % 9);
    spectrum::BoolMatrix entries(size, size);
    for (int i = 0; i < size * size; ++i) entries(i / size, i % size) = random() % 5 == 0;
    const Eigen::MatrixXd step =
        entries.matrix().cast<double>() + Eigen::MatrixXd::Identity(size, size);
    Eigen::MatrixXd paths = step;
    for (int i = 0; i < size; ++i) paths *= step;
    const spectrum::ConnectedParts connected = spectrum::connected_parts(entries);
    std::size_t rows = 0;
    for (const auto& part : connected.parts) rows += part.size();
    EXPECT_EQ(rows, static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j) {
        EXPECT_EQ(connected.reaches(i, j), paths(i, j) > 0);
        EXPECT_EQ(connected.part_of[static_cast<std::size_t>(i)] ==
                      connected.part_of[static_cast<std::size_t>(j)],
                  paths(i, j) > 0 && paths(j, i) > 0);
      }
    const std::vector<Eigen::Index> between = spectrum::rows_between(connected, {0, size - 1});
    for (int i = 0; i < size; ++i) {
      const bool on_path = (paths(0, i) > 0 || paths(size - 1, i) > 0) &&
                           (paths(i, 0) > 0 || paths(i, size - 1) > 0);
      EXPECT_EQ(std::count(between.begin(), between.end(), i), on_path ? 1 : 0);
    }
  }
}

}  // namespace
}  // namespace limn::test
