/// The exact sign of a turn, against rational arithmetic.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

#include "limn/base/rational.h"
#include "limn/mesh/polygon/orientation.h"

namespace limn {
namespace {

int exact_turn(mesh::Point2 a, mesh::Point2 b, mesh::Point2 c) {
  const Rational ax(a.x), ay(a.y), bx(b.x), by(b.y), cx(c.x), cy(c.y);
  const Rational twice_area = (ax - cx) * (by - cy) - (ay - cy) * (bx - cx);
  return twice_area > 0 ? 1 : twice_area < 0 ? -1 : 0;
}

/// Three points near one line: exactly on it, or off by a few units in the last place.
RC_GTEST_PROP(Orientation, TheSignIsExact, (unsigned seed)) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto nudged = [&](double x) {
    for (unsigned k = random() % 3; k > 0; --k) x = std::nextafter(x, unit(random) * HUGE_VAL);
    return x;
  };
  int rounded_differs = 0;
  for (int k = 0; k < 200; ++k) {
    const double scale = std::ldexp(1.0, static_cast<int>(random() % 41) - 20);
    const mesh::Point2 a{scale * unit(random), unit(random)}, b{unit(random), scale * unit(random)};
    const double t = unit(random);
    const mesh::Point2 c{nudged(a.x + t * (b.x - a.x)), nudged(a.y + t * (b.y - a.y))};
    const int exact = exact_turn(a, b, c);
    RC_ASSERT(mesh::turn(a, b, c) == exact);
    RC_ASSERT(mesh::turn(b, c, a) == exact);
    RC_ASSERT(mesh::turn(b, a, c) == -exact);
    const double rounded = mesh::approx_turn(a, b, c);
    rounded_differs += (rounded > 0 ? 1 : rounded < 0 ? -1 : 0) != exact;
  }
  RC_ASSERT(rounded_differs > 0);  // else the test would not need the exact sign
}

TEST(Orientation, CollinearPointsOfALatticeDoNotTurn) {
  for (int k = -20; k <= 20; ++k) {
    const mesh::Point2 a{0.1, 0.3}, b{0.1 + 1.5 * k, 0.3 + 0.25 * k};
    EXPECT_EQ(mesh::turn(a, b, b), 0);
    EXPECT_EQ(mesh::turn({3.0 * k, 7.0 * k}, {0, 0}, {-9, -21}), 0);
    EXPECT_EQ(mesh::turn({3.0 * k, 7.0 * k}, {0, 0}, {-9, -20}), k > 0   ? -1
                                                                 : k < 0 ? 1
                                                                         : 0);  // -3 k
  }
}

}  // namespace
}  // namespace limn
