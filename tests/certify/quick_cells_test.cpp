// Cells in double precision hold what balls say of them, on the way to deep parts.

#include "limn/certify/ring/quick_cells.h"

#include <gtest/gtest.h>

#include <random>

#include "limn/certify/blocks/valence_balls.h"
#include "limn/certify/ring/eigenfunction.h"
#include "limn/certify/ring/ring_cells.h"
#include "limn/regular/regular_mask.h"
#include "support/shipped.h"

namespace limn::certify {
namespace {

/// Some number is in both.
bool meet(const DoubleBall& a, const number::Ball& b) {
  return b.overlaps(number::Ball(a.value).widened(a.error));
}

struct Setting {
  explicit Setting(const char* name)
      : scheme(test::shipped(name)),
        cells(cell_matrices(regular_mask(scheme).value()).value()),
        bounds(enclose_contraction(cells, 0.5, 200'000).value()),
        signs(cells, bounds),
        balls(ValenceBalls::make(scheme, 7).value()) {}
  Setting(const Setting&) = delete;

  Scheme scheme;
  CellMatrices cells;
  Contraction bounds;
  CellSigns signs;
  ValenceBalls balls;
};

EnclosedPair leader_of(const ValenceBalls& balls, int frequency) {
  const number::BallMatrix block = balls.block(frequency);
  const ApproxPair near = approx_leader(block).value();
  return enclose_eigenpair(block, near.value, near.vector).value();
}

class QuickCellsOf : public testing::TestWithParam<const char*> {};

TEST_P(QuickCellsOf, AgreeWithBalls) {
  const number::BallPrecision precision(256);
  Setting at(GetParam());
  const EnclosedPair leader = leader_of(at.balls, 1);
  EigenMap map(at.balls, at.cells, 1, leader);
  std::mt19937 random(3);
  const QuickCells& quick = at.signs.quick();
  const RingCells ring = ring_cells(at.cells).value();
  for (const LatticeVector cell : ring.cells) {
    CellMap exact = at.signs.map_on(map.net, cell).value();
    QuickCells::Map near = quick.map_of(exact);
    for (int depth = 0; depth < 20; ++depth) {
      const number::Ball jacobian = at.signs.jacobian(exact);
      const DoubleBall jacobian_near = quick.jacobian(near);
      // what quick says of a sign holds, and where rounding is small it says what balls say
      if (jacobian_near.is_positive()) ASSERT_FALSE(jacobian.is_negative());
      if (jacobian_near.is_negative()) ASSERT_FALSE(jacobian.is_positive());
      if (quick.is_sharp(near))
        ASSERT_LE(jacobian_near.error, 1.01 * jacobian.radius() + 1e-300) << depth;
      for (std::size_t i = 0; i < 2; ++i) {
        ASSERT_TRUE(meet(near.u.gradient[i], exact.u.gradient[i])) << depth;
        ASSERT_TRUE(meet(near.v.gradient[i], exact.v.gradient[i])) << depth;
      }
      ASSERT_TRUE(meet(near.u.origin, exact.u.origin));
      for (std::size_t i = 0; i < exact.u.residual.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        ASSERT_TRUE(meet({near.u.residual(row), near.u.error}, exact.u.residual[i])) << depth;
        ASSERT_TRUE(meet({near.v.residual(row), near.v.error}, exact.v.residual[i])) << depth;
      }
      const std::size_t digit = random() % at.cells.residual.size();
      exact = at.signs.part(exact, digit);
      near = quick.part(near, digit);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, QuickCellsOf,
                         testing::Values("loop", "laplacian-butterfly", "sqrt3", "four-eight",
                                         "catmull-clark", "doo-sabin"));

TEST(DoubleBall, HoldsWhatItsOperationsHold) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-2, 2);
  for (int round = 0; round < 2000; ++round) {
    const DoubleBall a(number(random), std::abs(number(random)) / 8);
    const DoubleBall b(number(random), std::abs(number(random)) / 8);
    for (const double x : {a.value - a.error, a.value, a.value + a.error})
      for (const double y : {b.value - b.error, b.value, b.value + b.error}) {
        const auto holds = [](const DoubleBall& ball, const number::Ball& exact) {
          return (exact - number::Ball(ball.value)).magnitude().upper() <= ball.error * (1 + 1e-15);
        };
        ASSERT_TRUE(holds(a + b, number::Ball(x) + number::Ball(y)));
        ASSERT_TRUE(holds(a - b, number::Ball(x) - number::Ball(y)));
        ASSERT_TRUE(holds(a * b, number::Ball(x) * number::Ball(y)));
      }
  }
  EXPECT_TRUE(DoubleBall(1, 1).holds_zero());
  EXPECT_TRUE(DoubleBall(1, 0.5).is_positive());
  EXPECT_TRUE(DoubleBall(-1, 0.5).is_negative());
  EXPECT_TRUE(DoubleBall(std::nan(""), 0).holds_zero());
}

TEST(Effective, SurfacesAreShownToBeOtherThanZero) {
  const number::BallPrecision precision(128);
  const Setting at("loop");
  const Effective effective(at.balls, at.cells, at.signs);
  for (const int frequency : {0, 1, 2, 3}) {
    EnclosedPair pair = leader_of(at.balls, frequency);
    EXPECT_TRUE(effective.is_shown(frequency, pair)) << frequency;
    EXPECT_TRUE(effective.is_shown(frequency, pair.value.approx())) << frequency;
    for (number::Ball& entry : pair.vector) entry = number::Ball(0);
    EXPECT_FALSE(effective.is_shown(frequency, pair)) << frequency;
  }
}

}  // namespace
}  // namespace limn::certify
