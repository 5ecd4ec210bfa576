/// What is said of masks whose analysis takes long, when the time ends before it does.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "limn/regular/regular_mask.h"
#include "limn/regular/smoothness/regularity.h"

namespace limn {
namespace {

/// Interpolating √3 subdivision (Labsik, Greiner, Computer Graphics Forum 19(3), 2000): a new
/// vertex weighs the corners of its triangle by 32/81, the three vertices beyond its edges by -1/81
/// and the six next to those, √(7/3) edges away, by -2/81.
Mask interpolating_sqrt3() {
  Scheme scheme = parse_scheme(R"(split = "sqrt3"
[mask]
scale = "1/81"
rows = [ [0, -2, -2, 0], [-2, -1, 0, -1, -2], [-2, 0, 32, 32, 0, -2], [0, -1, 32, 81, 32, -1, 0],
         [-2, 0, 32, 32, 0, -2], [-2, -1, 0, -1, -2], [0, -2, -2, 0] ]
)",
                               "interpolating-sqrt3.toml")
                      .value();
  return regular_mask(scheme).value();
}

/// A clock that moves by 1 whenever it is looked at: so much work, on any machine.
RegularityOptions after_looks(double looks, double& now) {
  RegularityOptions options;
  options.seconds = looks;
  options.clock = [&now] { return now++; };
  return options;
}

TEST(RegularityTime, EndsWithWhatIsProvedBySmallWork) {
  // [1.5571, 1.5608] with all the time
  double now = 0;
  const Regularity found =
      enclose_regularity(interpolating_sqrt3(), after_looks(2000, now)).value();
  EXPECT_TRUE(found.time_ended);
  EXPECT_EQ(found.smoothness[0].verdict, Truth::yes);
  EXPECT_GT(found.holder.lower, 0.26);  // one step of the differences has the norm 70/81
  EXPECT_LT(found.holder.lower, 1.5608);
  ASSERT_TRUE(found.holder.upper.has_value());
  EXPECT_NEAR(*found.holder.upper, 1.5608, 1e-4);
  EXPECT_EQ(found.smoothness[1].verdict, Truth::undecided);
  EXPECT_NE(found.smoothness[1].reason.find("the time ended"), std::string::npos);
  EXPECT_EQ(found.smoothness[2].verdict, Truth::no);
}

TEST(RegularityTime, IsNotCalledEndedWhereItSufficed) {
  double now = 0;
  const Mask mask = regular_mask(find_scheme("loop").value()).value();
  const Regularity found = enclose_regularity(mask, after_looks(1e9, now)).value();
  EXPECT_FALSE(found.time_ended);
  EXPECT_EQ(found.holder.lower, 3);
}

TEST(RegularityTime, EachMomentOfTheEndGivesATrueBracket) {
  // the butterfly's exponent is exactly 2, whenever the search is stopped
  const Mask mask = regular_mask(find_scheme("butterfly").value()).value();
  for (double looks = 1; looks < 5000; looks = looks * 3) {
    double now = 0;
    const Regularity found = enclose_regularity(mask, after_looks(looks, now)).value();
    EXPECT_LE(found.holder.lower, 2) << looks;
    if (found.holder.upper) EXPECT_GE(*found.holder.upper, 2) << looks;
    EXPECT_NE(found.smoothness[0].verdict, Truth::no) << looks;
    EXPECT_NE(found.smoothness[1].verdict, Truth::no) << looks;
    EXPECT_NE(found.smoothness[2].verdict, Truth::yes) << looks;
  }
}

TEST(RegularityBeyondC2, OfTensorBSplinesIsTheirDegreeLessOne) {
  for (int degree = 1; degree <= 5; degree += 2) {
    Scheme scheme = find_scheme("box-spline-quad").value();
    const std::string count = std::to_string(degree + 1);
    const Status set = set_parameters(scheme, {"i=" + count, "j=" + count});
    ASSERT_TRUE(set.ok()) << set.error().text();
    const Regularity found = enclose_regularity(regular_mask(scheme).value()).value();
    ASSERT_EQ(found.smoothness.size(), static_cast<std::size_t>(std::max(degree + 1, 3)));
    for (int r = 0; r < static_cast<int>(found.smoothness.size()); ++r)
      EXPECT_EQ(found.smoothness[static_cast<std::size_t>(r)].verdict,
                r < degree ? Truth::yes : Truth::no)
          << "degree " << degree << ", C" << r;
  }
}

}  // namespace
}  // namespace limn
