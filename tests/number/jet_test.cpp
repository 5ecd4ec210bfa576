// Derivatives of jets against those of difference quotients and of formulas.

#include "limn/number/jet.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include "limn/scheme/evaluate.h"

namespace limn::test {
namespace {

template <class Number>
Number value_of(const std::string& text, const Number& x, const Number& y) {
  return scheme::evaluate<Number>(
             Expression::parse(text).value(),
             [&](const std::string& name) -> Result<Number> { return name == "x" ? x : y; })
      .value();
}

RC_GTEST_PROP(Jet, HasTheSlopesOfDifferenceQuotients, ()) {
  const double x = *rc::gen::inRange(-300, 300) / 200. + 0.0012;
  const double y = *rc::gen::inRange(60, 400) / 200.;
  for (const char* text :
       {"x*y - 3*x^2*y^3", "x/y + cos(2*pi/y)*x", "sqrt(y)*sin(x) - (x - y)/(2 + x^2)",
        "(3/8 + cos(x)/4)^2/y", "(x == 5)*y + (x != 5)*x*y", "1/4 - x^-2"}) {
    const number::Jet jet =
        value_of<number::Jet>(text, number::Jet::variable(x, 0, 2), number::Jet::variable(y, 1, 2));
    RC_ASSERT(jet.value == value_of<double>(text, x, y));
    const double h = 1e-5;
    const double by_x =
        (value_of<double>(text, x + h, y) - value_of<double>(text, x - h, y)) / (2 * h);
    const double by_y =
        (value_of<double>(text, x, y + h) - value_of<double>(text, x, y - h)) / (2 * h);
    const double tolerance = 1e-7 * (1 + std::pow(std::abs(x), -5)) * 10;
    RC_ASSERT(std::abs(jet.slope(0) - by_x) <= tolerance * (1 + std::abs(by_x)));
    RC_ASSERT(std::abs(jet.slope(1) - by_y) <= tolerance * (1 + std::abs(by_y)));
  }
}

TEST(Jet, ConstantsHaveNoSlopes) {
  const number::Jet jet = number::Jet(3) * number::Jet(2) + number::Jet(1);
  EXPECT_EQ(jet.value, 7);
  EXPECT_TRUE(jet.slopes.empty());
  EXPECT_EQ(jet.slope(4), 0);
  EXPECT_FALSE(number::Arithmetic<number::Jet>::sqrt(number::Jet::variable(0, 0, 1)));
  EXPECT_TRUE(number::Arithmetic<number::Jet>::sqrt(number::Jet(0)));
  EXPECT_FALSE(
      number::Arithmetic<number::Jet>::divide(number::Jet(1), number::Jet::variable(0, 0, 1)));
}

}  // namespace
}  // namespace limn::test
