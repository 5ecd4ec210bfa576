// Characteristic maps: laws that they obey, and one that folds.

#include "limn/extraordinary/characteristic_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "limn/extraordinary/star_surface.h"
#include "limn/tune/prescribe.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

TEST(CharacteristicMap, OfRegularVerticesIsTheIdentity) {
  for (const auto& [name, n] : {std::pair{"loop", 6}, {"catmull-clark", 4}, {"butterfly", 6}}) {
    const CharacteristicMap map = approx_characteristic_map(shipped(name), n).value();
    EXPECT_NEAR(map.eigenvalue, 0.5, 1e-14);
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
  for (const std::string name : {"loop", "catmull-clark", "sqrt3", "doo-sabin"})
    for (const int n : {3, 4, 5, 8, 12, 20}) {
      const CharacteristicMap map = approx_characteristic_map(shipped(name), n).value();
      EXPECT_EQ(map.regular, Truth::yes) << name << ' ' << n << ": " << map.reason;
      EXPECT_GT(map.smallest_area, 0) << name << ' ' << n;
    }
}

TEST(CharacteristicMap, ThatFoldsIsFound) {
  const std::vector<std::string> rest{"24/25", "1/50", "1/50", "1/50"};
  const auto text = prescribed_scheme(shipped("loop"), "loop", "folds", {8, "1/50", rest});
  const Scheme scheme = parse_scheme(text.value(), "folds.toml").value();
  const CharacteristicMap map = approx_characteristic_map(scheme, 8).value();
  EXPECT_EQ(map.regular, Truth::no);
  EXPECT_NE(map.reason.find("folds"), std::string::npos);
}

TEST(CharacteristicMap, IsRefusedWithoutATangentPair) {
  const Result<CharacteristicMap> map = approx_characteristic_map(shipped("optimal"), 3);
  ASSERT_FALSE(map.ok());
  EXPECT_NE(map.error().text().find("frequency 1"), std::string::npos);
}

}  // namespace
}  // namespace limn::test
