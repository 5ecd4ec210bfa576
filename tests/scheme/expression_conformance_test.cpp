/// Every number type that an expression can be evaluated in gives the same values and fails at
/// the same places. A new specialisation of Arithmetic is added to `Numbers` below.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "limn/certify/all/power_ball.h"
#include "limn/number/ball.h"
#include "limn/number/jet.h"
#include "limn/number/symbolic.h"
#include "limn/scheme/evaluate.h"
#include "limn/scheme/expression.h"

namespace limn {

/// A double and a bound on its error: what tells a wrong value from a badly conditioned one.
struct Measured {
  double value = 0;
  double error = 0;
};

namespace number {
template <>
struct Arithmetic<Measured> {
  static Measured rounded(double value, double error) {
    const bool exact = error == 0 && value == std::nearbyint(value) && std::abs(value) < 1e15;
    return {value, exact ? 0 : error + 1.2e-16 * std::abs(value)};
  }
  static Measured from(const Rational& q) { return rounded(to_double(q), 0); }
  static Measured pi() { return rounded(M_PI, 0); }
  static Result<Measured> add(Measured a, Measured b) {
    return rounded(a.value + b.value, a.error + b.error);
  }
  static Result<Measured> subtract(Measured a, Measured b) {
    return rounded(a.value - b.value, a.error + b.error);
  }
  static Result<Measured> multiply(Measured a, Measured b) {
    return rounded(a.value * b.value,
                   std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error);
  }
  static Result<Measured> divide(Measured a, Measured b) {
    const double smallest = std::abs(b.value) - b.error;
    if (smallest <= 0) return Error{"unknown: near a division by zero"};
    const double q = a.value / b.value;
    return rounded(q, (a.error + std::abs(q) * b.error) / smallest);
  }
  static Result<Measured> cos(Measured a) { return rounded(std::cos(a.value), a.error); }
  static Result<Measured> sin(Measured a) { return rounded(std::sin(a.value), a.error); }
  static Result<Measured> sqrt(Measured a) {
    if (std::abs(a.value) <= a.error) return Error{"unknown: near the root of 0"};
    if (a.value < 0) return Error{"square root of a negative number"};
    return rounded(std::sqrt(a.value), a.error / std::sqrt(a.value));
  }
  static Result<int> sign(Measured a) {
    if (a.value == 0 && a.error == 0) return 0;
    if (std::abs(a.value) <= a.error) return Error{"unknown: near 0"};
    return a.value < 0 ? -1 : 1;
  }
  static Result<long long> integer(Measured a) {
    return number::Arithmetic<double>::integer(a.value);
  }
  static double approx(Measured a) { return a.value; }
};
}  // namespace number

namespace {

constexpr long long kN = 7;
constexpr long long kK = 2;

template <class Number>
Result<Number> evaluate(const std::string& text) {
  const Result<Expression> expression = Expression::parse(text);
  if (!expression) return expression.error();
  return limn::scheme::evaluate<Number>(*expression, [](const std::string& name) -> Result<Number> {
    const std::map<std::string, Rational> values{{"n", kN}, {"k", kK}, {"w", Rational(1, 16)}};
    const auto found = values.find(name);
    if (found == values.end()) return Error{"unknown name"};
    return number::Arithmetic<Number>::from(found->second);
  });
}

template <class Number>
class Conformance : public testing::Test {};

using Numbers = testing::Types<double, number::Jet, number::Exact, number::Symbolic, Measured,
                               number::Ball, certify::PowerBall>;
TYPED_TEST_SUITE(Conformance, Numbers);

TYPED_TEST(Conformance, Values) {
  const double c = std::cos(2 * M_PI / kN);
  const double lambda = 3.0 / 8 + c / 4;
  const std::pair<const char*, double> expected[] = {
      {"5/8", 0.625},
      {"1 - n*w", 1 - kN / 16.0},
      {"3/8 + cos(2*pi/n)/4", lambda},
      {"(5/8 - (3/8 + cos(2*pi/n)/4)^2)/n", (0.625 - lambda * lambda) / kN},
      {"(1/4 + cos(2*pi*k/n) + cos(4*pi*k/n)/2)/n",
       (0.25 + std::cos(4 * M_PI / kN) + std::cos(8 * M_PI / kN) / 2) / kN},
      {"(cos(2*pi/n) + 5 + sqrt((cos(2*pi/n) + 9)*(cos(2*pi/n) + 1)))/16",
       (c + 5 + std::sqrt((c + 9) * (c + 1))) / 16},
      {"(3*n - 7 + sqrt(5*n^2 - 30*n + 49))/(8*n)",
       (3 * kN - 7 + std::sqrt(5.0 * kN * kN - 30 * kN + 49)) / (8 * kN)},
      {"1/(1 + sqrt(2) + sqrt(3))", 1 / (1 + std::sqrt(2) + std::sqrt(3))},
      {"1/(cos(2*pi/n) + sqrt(2))", 1 / (c + std::sqrt(2))},
      {"sqrt(2 + sqrt(2))", std::sqrt(2 + std::sqrt(2))},
      {"sin(pi/n)/cos(pi/n)", std::tan(M_PI / kN)},
      {"sin(-pi/3) + cos(-pi/3)", 0.5 - std::sqrt(0.75)},
      {"cos(100*pi/3)", -0.5},
      {"cos(pi*w)^-3", std::pow(std::cos(M_PI / 16), -3)},
      {"-n^2 % 5", 1},
      {"(k - n) % 4", 3},
      {"2^-k^2", 1.0 / 16},
      {"(k == 2)*3 + (k != 2)*4 + (n >= 7) + (n <= 6)", 4},
      {"n > 3 and not k > 3 or n == 0", 1},
      {"sqrt(2) < cos(0*pi) + 1/2", 1},
      {"pi/(2*3)", M_PI / 6},
      {"0*pi", 0},
  };
  for (const auto& [text, value] : expected) {
    const Result<TypeParam> result = evaluate<TypeParam>(text);
    ASSERT_TRUE(result.ok()) << text << ": " << result.error().message;
    EXPECT_NEAR(number::Arithmetic<TypeParam>::approx(*result), value, 1e-12) << text;
  }
}

TYPED_TEST(Conformance, Failures) {
  const std::pair<const char*, int> expected[] = {
      // and the columns
      {"1/0", 2},    {"1/(n - 7)", 2}, {"0^-1", 2},      {"sqrt(0 - 1)", 1}, {"sqrt(3 - n)", 1},
      {"n % 0", 3},  {"n % -2", 3},    {"n % (1/2)", 3}, {"(1/2) % n", 7},   {"2^(1/2)", 2},
      {"2^5000", 2}, {"1 + foo", 5},   {"2^n^9", 2},
  };
  for (const auto& [text, column] : expected) {
    const Result<TypeParam> result = evaluate<TypeParam>(text);
    ASSERT_FALSE(result.ok()) << text;
    EXPECT_EQ(result.error().column, column) << text << ": " << result.error().message;
  }
}

/// What no double can hold fails in every type that checks, and at the same operation.
TEST(ConformanceOfTwo, NumbersBeyondDouble) {
  for (const char* text : {"10^999", "(10^200)*(10^200)", "10^200/10^-200", "2^1030 - 2^1030",
                           "((2^4096)^4096)^4096"}) {
    const Result<double> approx = evaluate<double>(text);
    const Result<number::Exact> exact = evaluate<number::Exact>(text);
    ASSERT_FALSE(approx.ok()) << text;
    ASSERT_FALSE(exact.ok()) << text;
    EXPECT_EQ(approx.error().message, exact.error().message) << text;
    EXPECT_EQ(approx.error().column, exact.error().column) << text;
  }
}

rc::Gen<std::string> any_atom() {
  return rc::gen::element<std::string>("0", "1", "2", "3", "(3/8)", "n", "k", "w", "cos(2*pi/n)",
                                       "cos(2*pi*k/n)", "sin(pi/n)", "cos(pi/5)", "sqrt(2)",
                                       "sqrt(w)", "sqrt(2 + cos(2*pi/n))");
}

rc::Gen<std::string> any_expression(int depth) {
  if (depth == 0) return any_atom();
  const auto inner = any_expression(depth - 1);
  const auto binary =
      rc::gen::apply([](const std::string& a, const std::string& op,
                        const std::string& b) { return "(" + a + op + b + ")"; },
                     inner,
                     rc::gen::element<std::string>(" + ", " - ", "*", "/", " % ", " == ", " < ",
                                                   " >= ", " != ", " and ", " or "),
                     inner);
  const auto unary =
      rc::gen::apply([](const std::string& op, const std::string& a) { return op + a + ")"; },
                     rc::gen::element<std::string>("(-", "(not ", "sqrt(", "(2 + "), inner);
  const auto power = rc::gen::apply(
      [](const std::string& a, int exponent) { return a + "^" + std::to_string(exponent); },
      any_atom(), rc::gen::inRange(-3, 4));
  return rc::gen::oneOf(binary, binary, binary, unary, power, any_atom());
}

/// Where the error bound says that a double is sound, it is the exact value; and the two types
/// fail together, but for what cannot be written exactly or be told from 0.
RC_GTEST_PROP(ConformanceOfTwo, RandomExpressions, ()) {
  const std::string text = *any_expression(4);
  const Result<Measured> measured = evaluate<Measured>(text);
  const Result<number::Exact> exact = evaluate<number::Exact>(text);
  const Result<double> approx = evaluate<double>(text);
  const Result<number::Symbolic> symbolic = evaluate<number::Symbolic>(text);
  if (!measured) {
    RC_CLASSIFY(true, "fails");
    if (measured.error().message.find("unknown") == 0) return;
    RC_ASSERT(!exact.ok());
    RC_ASSERT(!symbolic.ok());
    RC_ASSERT(!approx.ok());
    RC_ASSERT(approx.error().column == measured.error().column);
    return;
  }
  RC_ASSERT(approx.ok());
  if (symbolic)
    RC_ASSERT(std::abs(number::Arithmetic<number::Symbolic>::approx(*symbolic) - *approx) <=
              1e3 * measured->error + 1e-10 * (1 + std::abs(*approx)));
  if (!exact) {  // only for want of a way to write it
    RC_CLASSIFY(true, "not exact");
    const std::string& why = exact.error().message;
    RC_ASSERT(why.find("exact") != std::string::npos || why.find("integer") != std::string::npos ||
              why.find("cannot decide") != std::string::npos);
    return;
  }
  RC_CLASSIFY(true, "compared");
  RC_ASSERT(std::abs(exact->approx() - *approx) <=
            4 * measured->error + 1e-13 * (1 + std::abs(*approx)));
}

}  // namespace
}  // namespace limn
