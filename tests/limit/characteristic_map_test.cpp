// Characteristic maps: laws that they obey, and one that folds.

#include "limn/limit/characteristic_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "limn/limit/judge_characteristic_map.h"
#include "limn/spectrum/eigencomponents.h"
#include "limn/tune/prescribe.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

TEST(CharacteristicMap, OfRegularVerticesIsTheIdentity) {
  for (const auto& [name, n] :
       {std::pair{"loop", 6}, {"catmull-clark", 4}, {"butterfly", 6}, {"four-eight", 4}}) {
    const CharacteristicMap map = approx_characteristic_map(shipped(name), n).value();
    const int growth = shipped(name).split->dilation.growth();
    EXPECT_NEAR(map.eigenvalue, 1 / std::sqrt(growth), 1e-14);
    EXPECT_EQ(map.regular, Truth::yes) << map.reason;
    // the lattice, scaled: every limit point is a multiple of 1/16 of the spokes
    const double c = std::cos(2 * M_PI / n);
    const double s = std::sin(2 * M_PI / n);
    for (const Point3& p : map.image.positions) {
      const double j = 16 * p.y / s;
      const double i = 16 * p.x - c * j;
      EXPECT_NEAR(i, std::nearbyint(i), 1e-9) << name;
      EXPECT_NEAR(j, std::nearbyint(j), 1e-9) << name;
    }
  }
}

TEST(CharacteristicMap, IsMappedToItsMultipleByRefinement) {
  for (const std::string name : {"loop", "catmull-clark", "doo-sabin", "butterfly-modified"}) {
    const CharacteristicMap coarse = approx_characteristic_map(shipped(name), 7, 2).value();
    const CharacteristicMap fine = approx_characteristic_map(shipped(name), 7, 3).value();
    // each point of the coarse image, times the eigenvalue, is one of the fine image
    for (const Point3& p : coarse.image.positions) {
      double nearest = 1e9;
      for (const Point3& q : fine.image.positions)
        nearest = std::min(
            nearest, std::hypot(q.x - coarse.eigenvalue * p.x, q.y - coarse.eigenvalue * p.y));
      EXPECT_LT(nearest, 1e-12) << name;
    }
  }
}

TEST(CharacteristicMap, IsRegularWhereTheLiteratureSaysSo) {
  for (const std::string name : {"loop", "catmull-clark", "sqrt3", "doo-sabin", "four-eight",
                                 "loop-ternary", "butterfly-ternary"})
    for (const int n : {3, 4, 5, 8, 12, 20}) {
      const CharacteristicMap map = approx_characteristic_map(shipped(name), n).value();
      EXPECT_EQ(map.regular, Truth::yes) << name << ' ' << n << ": " << map.reason;
      EXPECT_GT(map.smallest_area, 0) << name << ' ' << n;
    }
}

TEST(CharacteristicMap, ThatFoldsIsFound) {
  const std::vector<std::string> rest{"24/25", "1/50", "1/50", "1/50"};
  const auto text = tune::prescribed_scheme(shipped("loop"), "loop", "folds", {8, "1/50", rest});
  const Scheme scheme = parse_scheme(text.value().text, "folds.toml").value();
  const CharacteristicMap map = approx_characteristic_map(scheme, 8).value();
  EXPECT_EQ(map.regular, Truth::no);
  EXPECT_NE(map.reason.find("folds"), std::string::npos);
}

/// Every corner half itself and a quarter its neighbours. At n = 7 a null vector of 16 rows was
/// once wrong, which looked like a map turned over.
Scheme half_and_quarters() {
  return parse_scheme(
             "split = \"quad-dual\"\n[corner]\nself = \"1/2\"\n"
             "round = \"(k == 1 or k == n-1)/4\"\n",
             "half.toml")
      .value();
}

TEST(CharacteristicMap, OfADualSchemeIsRegularAtAllValences) {
  const Scheme scheme = half_and_quarters();
  for (int n = 4; n <= 12; ++n) {  // at 3 frequency 1 has a tie
    const CharacteristicMap map = approx_characteristic_map(scheme, n, 2).value();
    EXPECT_NEAR(map.eigenvalue, (1 + std::cos(2 * M_PI / n)) / 2, 1e-14) << n;
    EXPECT_EQ(map.regular, Truth::yes) << n << ": " << map.reason;
    EXPECT_FALSE(map.turned_over) << n;
    // ring 1 of the net is the regular n-gon, as the circulant matrix has it
    EXPECT_NEAR(map.net_points[1].x, std::cos(2 * M_PI / n), 1e-9) << n;
  }
}

TEST(CharacteristicMap, HasNetsThatAStepMultiplies) {
  const Scheme scheme = half_and_quarters();
  for (int rings = 2; rings <= 4; ++rings)
    for (int n = 3; n <= 12; ++n) {
      const FrequencyBlocks blocks = FrequencyAnalysis(scheme, rings).blocks(n).value();
      for (const BlockSpectrum& spectrum : approx_spectra(blocks)) {
        const Eigenvalue& leader = spectrum.eigenvalues.front();
        const Eigenvectors vectors = approx_eigenvectors(blocks, leader);
        const Eigen::MatrixXcd& block = blocks.blocks[static_cast<std::size_t>(leader.frequency)];
        const double off =
            (block * vectors.right - leader.value * vectors.right).cwiseAbs().maxCoeff();
        EXPECT_LT(off, 1e-9 * vectors.right.cwiseAbs().maxCoeff()) << n << ' ' << leader.frequency;
      }
    }
}

TEST(CharacteristicMap, ThatIsTurnedOverIsTurnedBackAndIsNoFold) {
  const CharacteristicMap upright = approx_characteristic_map(shipped("loop"), 7, 2).value();
  CharacteristicMap over = approx_characteristic_map(shipped("loop"), 7, 2).value();
  for (Point3& p : over.image.positions) p.y = -p.y;
  for (Point3& p : over.net_points) p.y = -p.y;
  for (Point3& normal : over.image.normals) normal.z = -normal.z;
  limit::judge_characteristic_map(over);
  EXPECT_TRUE(over.turned_over);
  EXPECT_EQ(over.regular, Truth::yes) << over.reason;
  EXPECT_NEAR(over.smallest_area, upright.smallest_area, 1e-12);
  for (std::size_t v = 0; v < over.net_points.size(); ++v)
    EXPECT_EQ(over.net_points[v].y, upright.net_points[v].y);
}

TEST(CharacteristicMap, WithoutAnyJacobianIsUndecided) {
  CharacteristicMap map = approx_characteristic_map(shipped("loop"), 5, 2).value();
  for (Point3& p : map.image.positions) p.y = 0;
  for (Point3& normal : map.image.normals) normal = {};
  limit::judge_characteristic_map(map);
  EXPECT_EQ(map.regular, Truth::undecided);
  EXPECT_NE(map.reason.find("degenerate"), std::string::npos) << map.reason;
}

TEST(CharacteristicMap, IsRefusedWithoutATangentPair) {
  const Result<CharacteristicMap> map = approx_characteristic_map(shipped("optimal"), 3);
  ASSERT_FALSE(map.ok());
  EXPECT_NE(map.error().text().find("frequency 1"), std::string::npos);
}

}  // namespace
}  // namespace limn::test
