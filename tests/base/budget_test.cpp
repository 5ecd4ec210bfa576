#include "limn/base/budget.h"

#include <gtest/gtest.h>

#include <limits>

namespace limn {
namespace {

TEST(TimeBudget, EndsByShares) {
  double now = 100;
  const TimeBudget budget(8, [&] { return now; });
  const Stop early = budget.stop(0.5);
  now = 103;
  EXPECT_FALSE(early());
  EXPECT_FALSE(budget.ended());
  now = 104;
  EXPECT_TRUE(early());
  EXPECT_FALSE(budget.ended());
  now = 108;
  EXPECT_TRUE(budget.ended());
}

TEST(TimeBudget, WithoutEndIsNeverAskedFor) {
  EXPECT_FALSE(asked(TimeBudget().stop()));
  EXPECT_FALSE(asked(TimeBudget(std::numeric_limits<double>::infinity()).stop()));
  EXPECT_FALSE(TimeBudget().ended());
  EXPECT_TRUE(TimeBudget(0).ended());
}

}  // namespace
}  // namespace limn
