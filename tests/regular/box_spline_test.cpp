#include "limn/regular/smoothness/box_spline.h"

#include <gtest/gtest.h>

#include <cmath>

#include "limn/regular/artifacts.h"
#include "limn/regular/regular_mask.h"
#include "limn/regular/smoothness/regularity.h"
#include "limn/scheme/mask_rules.h"

namespace limn {
namespace {

Mask mask_of(const std::string& name, const std::vector<std::string>& parameters = {}) {
  Scheme scheme = find_scheme(name).value();
  const Status set = set_parameters(scheme, parameters);
  EXPECT_TRUE(set.ok()) << set.error().text();
  return regular_mask(scheme).value();
}

/// The Zwart–Powell element, and what differences find of others.
TEST(BoxSpline, HasTheExponentThatDifferencesFindWhereShiftsAreStable) {
  const auto exponent = [](const std::string& name, const std::vector<std::string>& counts) {
    const std::optional<regular::BoxSpline> spline =
        regular::find_box_spline(mask_of(name, counts));
    return spline ? spline->exponent() : -1;
  };
  Mask zwart_powell{Lattice::quad, find_split("quad-dyadic")->dilation, {{{0, 0}, Rational(4)}}};
  for (const LatticeVector d : {LatticeVector{1, 0}, {0, 1}, {1, 1}, {1, -1}})
    zwart_powell.coefficients =
        product(zwart_powell.coefficients, scheme::smoothing_direction(d, zwart_powell.dilation));
  EXPECT_EQ(regular::find_box_spline(zwart_powell).value().exponent(), 2);
  for (const auto& counts : {std::vector<std::string>{"i=1", "j=1", "k3=1"},
                             {"i=2", "j=2", "k3=2"},
                             {"i=4", "j=2", "k3=2"},
                             {"i=5", "j=3", "k3=1"}})
    EXPECT_EQ(exponent("box-spline-triangle", counts),
              *enclose_regularity(mask_of("box-spline-triangle", counts)).value().holder.upper);
  EXPECT_EQ(exponent("loop", {}), 3);
  EXPECT_EQ(exponent("loop-ternary", {}), 3);
  EXPECT_EQ(exponent("doo-sabin", {}), 2);
  EXPECT_EQ(exponent("catmull-clark", {}), 3);
  for (int degree = 2; degree <= 9; ++degree)
    EXPECT_EQ(exponent("b-spline-quad", {"degree=" + std::to_string(degree)}), degree);
  for (const char* other : {"butterfly", "sqrt3", "optimal"}) EXPECT_EQ(exponent(other, {}), -1);
  // directions that a step does not carry to one another: no box spline, whatever the kernel
  const Mask own = mask_of("four-eight");
  Mask lopsided{own.lattice, own.dilation, {}};
  const Laurent along = scheme::smoothing_direction({1, 0}, own.dilation);
  lopsided.coefficients = scaled(product(product(along, along), product(along, along)), 2);
  EXPECT_FALSE(regular::find_box_spline(lopsided).has_value());
}

/// φ̂ is a product of sinc², one for each of the four directions.
TEST(BoxSpline, OfFourEightHasItsFourierTransform) {
  const ArtifactAnalysis analysis = ArtifactAnalysis::of(mask_of("four-eight")).value();
  const auto sinc = [](double f) { return f == 0 ? 1 : std::sin(M_PI * f) / (M_PI * f); };
  for (const auto& [x, y] : {std::pair{.3, .1}, {.5, .5}, {1.7, -.6}, {0., 1.25}, {2.1, 3.4}})
    EXPECT_NEAR(analysis.amplitude({x, y}),
                std::pow(sinc(x) * sinc(y) * sinc(x + y) * sinc(x - y), 2), 1e-12)
        << x << ' ' << y;
}

}  // namespace
}  // namespace limn
