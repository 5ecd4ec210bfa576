#include "limn/regular/regular_mask.h"

#include <gtest/gtest.h>

#include "limn/scheme/mask_rules.h"
#include "support/shipped.h"

namespace limn {
namespace {

Mask mask_of(const std::string& name, const std::vector<std::string>& parameters = {}) {
  Scheme scheme = test::shipped(name);
  const Status set = set_parameters(scheme, parameters);
  EXPECT_TRUE(set.ok()) << set.error().text();
  const Result<Mask> mask = regular_mask(scheme);
  EXPECT_TRUE(mask.ok()) << mask.error().text();
  return mask.value();
}

TEST(RegularMask, IsTheOneThatTheLiteratureStates) {
  int stated = 0;
  for (const std::string& name : test::lattice_names()) {
    const Scheme& scheme = test::shipped(name);
    if (!scheme.stated_mask) continue;
    ++stated;
    EXPECT_EQ(mask_of(name).coefficients,
              scheme::mask_from_rows(scheme, *scheme.stated_mask).value().coefficients)
        << name;
  }
  EXPECT_GE(stated, 10);
}

TEST(RegularMask, SumsToTheDeterminantAndToOneOverEachCoset) {
  for (const std::string& name : test::lattice_names()) {
    const Scheme& scheme = test::shipped(name);
    const int growth = scheme.split->dilation.growth();
    const int parity = scheme.split->is_dual() ? 1 : 0;
    Rational sum = 0;
    std::map<int, Rational> sums;
    for (const auto& [offset, value] : mask_of(name).coefficients) {
      sum += value;
      sums[coset_of(scheme.split->dilation,
                    {(offset[0] - parity) / 2, (offset[1] - parity) / 2})] += value;
    }
    EXPECT_EQ(sum, growth) << name;
    EXPECT_EQ(sums.size(), static_cast<std::size_t>(growth)) << name;
    for (const auto& [coset, part] : sums) EXPECT_EQ(part, 1) << name;
  }
}

TEST(RegularMask, OfFactorsIsThatOfTheRulesTheyStandFor) {
  EXPECT_EQ(mask_of("box-spline-triangle").coefficients, mask_of("loop").coefficients);
  EXPECT_EQ(mask_of("box-spline-quad").coefficients, mask_of("catmull-clark").coefficients);
  // linear interpolation, two ways
  EXPECT_EQ(mask_of("box-spline-triangle", {"i=1", "j=1", "k3=1"}).coefficients,
            mask_of("butterfly", {"w=0"}).coefficients);
}

TEST(RegularMask, OfAnUnsymmetricBoxSplineHasNoRulesButIsThere) {
  const Result<Scheme> skew = parse_scheme(
      "split = \"triangle-dyadic\"\n[factors]\ndirections = [ { step = [1, 0], count = 3 }, "
      "{ step = [0, 1], count = 1 }, { step = [1, 1], count = 1 } ]\n",
      "skew.toml");
  ASSERT_TRUE(skew.ok()) << skew.error().text();
  EXPECT_FALSE(skew->rule(RuleKind::vertex).has_value());
  EXPECT_EQ(regular_mask(*skew).value().coefficients.size(), 13U);
}

TEST(RegularMask, PrintsAsAHexagonOrARectangle) {
  EXPECT_EQ(to_string(mask_of("loop")),
            "1/16 ×\n"
            "       1   2   1\n"
            "     2   6   6   2\n"
            "   1   6  10   6   1\n"
            "     2   6   6   2\n"
            "       1   2   1\n");
  EXPECT_EQ(to_string(mask_of("doo-sabin")), "1/16 ×\n 1 3 3 1\n 3 9 9 3\n 3 9 9 3\n 1 3 3 1\n");
}

TEST(RegularMask, OfSqrt3IsWrittenInTheTurnedLattice) {
  EXPECT_EQ(to_string(mask_of("sqrt3")),
            "1/18 ×\n"
            "       0   1   0\n"
            "     1   6   6   1\n"
            "   0   6  12   6   0\n"
            "     1   6   6   1\n"
            "       0   1   0\n");
}

TEST(RegularMask, GivesSqrt3ItsRules) {
  const Result<Scheme> scheme = parse_scheme(
      "split = \"sqrt3\"\n[mask]\nscale = \"1/18\"\nrows = [ [0, 1, 0], [1, 6, 6, 1], "
      "[0, 6, 12, 6, 0], [1, 6, 6, 1], [0, 1, 0] ]\n",
      "mine.toml");
  ASSERT_TRUE(scheme.ok()) << scheme.error().text();
  ASSERT_TRUE(scheme->rule(RuleKind::vertex).has_value());
  ASSERT_TRUE(scheme->rule(RuleKind::face).has_value());
  Scheme rules = *scheme;
  rules.mask.reset();  // so that the mask is read off the rules that the first one gave
  EXPECT_EQ(regular_mask(rules).value().coefficients, mask_of("sqrt3").coefficients);
}

}  // namespace
}  // namespace limn
