/// The grammar of weight expressions, by values that another reading would not give.

#include "limn/scheme/expression.h"
#include "limn/scheme/evaluate.h"

#include <gtest/gtest.h>

#include <map>

namespace limn {
namespace {

/// The value at n = 7, k = 3, w = 1/16; an error's text and column otherwise.
std::string value(const std::string& text) {
  const Result<Expression> expression = Expression::parse(text);
  const auto failed = [](const Error& error) {
    return std::to_string(error.column) + ": " + error.message;
  };
  if (!expression) return failed(expression.error());
  const Result<number::Exact> result = limn::scheme::evaluate<number::Exact>(
      *expression, [](const std::string& name) -> Result<number::Exact> {
        const std::map<std::string, Rational> values{{"n", 7}, {"k", 3}, {"w", Rational(1, 16)}};
        const auto found = values.find(name);
        if (found == values.end()) return Error{"unknown " + name};
        return number::Exact(found->second);
      });
  if (!result) return failed(result.error());
  return result->is_rational() ? to_string(result->rational()) : "irrational";
}

TEST(Expression, PrecedenceAndAssociativity) {
  EXPECT_EQ(value("1 + 2*3"), "7");
  EXPECT_EQ(value("2*3 + 1"), "7");
  EXPECT_EQ(value("10 - 3 - 2"), "5");
  EXPECT_EQ(value("24/4/3"), "2");
  EXPECT_EQ(value("24/4*3"), "18");
  EXPECT_EQ(value("2*3^2"), "18");
  EXPECT_EQ(value("2^3^2"), "512");  // to the right
  EXPECT_EQ(value("(2^3)^2"), "64");
  EXPECT_EQ(value("17 % 5 * 2"), "4");
  EXPECT_EQ(value("2 * 17 % 5"), "4");
  EXPECT_EQ(value("1 + 7 % 4"), "4");
  EXPECT_EQ(value("(1 + 2)*3"), "9");
}

TEST(Expression, UnaryMinus) {
  EXPECT_EQ(value("-n^2"), "-49");
  EXPECT_EQ(value("(-n)^2"), "49");
  EXPECT_EQ(value("2^-1"), "1/2");
  EXPECT_EQ(value("2^-n"), "1/128");
  EXPECT_EQ(value("-2^-2"), "-1/4");
  EXPECT_EQ(value("2 - -3"), "5");
  EXPECT_EQ(value("--3"), "3");
  EXPECT_EQ(value("---3"), "-3");
  EXPECT_EQ(value("-3*2"), "-6");
  EXPECT_EQ(value("2*-3"), "-6");
  EXPECT_EQ(value("-1 % 3"), "2");  // (-1) % 3: the minus binds closer
}

TEST(Expression, ModuloIsNeverNegative) {
  EXPECT_EQ(value("(-1) % 3"), "2");
  EXPECT_EQ(value("(k - n) % n"), "3");
  EXPECT_EQ(value("k % n"), "3");
  EXPECT_EQ(value("6 % 3"), "0");
  EXPECT_EQ(value("5 % -3"), "3: % needs a positive right-hand side");
  EXPECT_EQ(value("5 % 0"), "3: % needs a positive right-hand side");
  EXPECT_EQ(value("5 % (1/2)"), "3: % needs two integers");
  EXPECT_EQ(value("(1/2) % 5"), "7: % needs two integers");
}

TEST(Expression, Comparisons) {
  EXPECT_EQ(value("3 < 4"), "1");
  EXPECT_EQ(value("4 < 3"), "0");
  EXPECT_EQ(value("3 <= 3"), "1");
  EXPECT_EQ(value("3 >= 4"), "0");
  EXPECT_EQ(value("3 > 3"), "0");
  EXPECT_EQ(value("1/3 == 2/6"), "1");
  EXPECT_EQ(value("1/3 != 2/6"), "0");
  EXPECT_EQ(value("k == 1 + 2"), "1");
  EXPECT_EQ(value("1 + k == 4"), "1");  // sums bind closer
  EXPECT_EQ(value("5*(k == 3) - 2*(k == 4)"), "5");
  EXPECT_EQ(value("cos(2*pi/n) > 1/2"), "1");
  EXPECT_EQ(value("cos(2*pi/6) == 1/2"), "1");
  EXPECT_EQ(value("sqrt(2) < 3/2"), "1");
  EXPECT_EQ(value("1 < 2 < 3"), "7: found '< 3', expected an operator or the end");
}

TEST(Expression, Logic) {
  EXPECT_EQ(value("n == 7 and k == 3"), "1");
  EXPECT_EQ(value("n == 7 and k == 4"), "0");
  EXPECT_EQ(value("n == 6 or k == 3"), "1");
  EXPECT_EQ(value("1 or 1 and 0"), "1");  // and binds closer
  EXPECT_EQ(value("(1 or 1) and 0"), "0");
  EXPECT_EQ(value("not n == 6"), "1");
  EXPECT_EQ(value("not not 5"), "1");
  EXPECT_EQ(value("not 1 or 1"), "1");
  EXPECT_EQ(value("not (1 or 1)"), "0");
  EXPECT_EQ(value("2 and 3"), "1");
  EXPECT_EQ(value("notk"), "1: unknown notk");
  EXPECT_EQ(value("1 andk"), "3: found 'andk', expected an operator or the end");
}

TEST(Expression, Functions) {
  EXPECT_EQ(value("cos(pi/3)"), "1/2");
  EXPECT_EQ(value("sin(pi/6)"), "1/2");
  EXPECT_EQ(value("cos (pi)"), "-1");
  EXPECT_EQ(value("sqrt(9/4)"), "3/2");
  EXPECT_EQ(value("sqrt(2)^2"), "2");
  EXPECT_EQ(value("sqrt(2)"), "irrational");
  EXPECT_EQ(value("-cos(pi)^2"), "-1");
  EXPECT_EQ(value("cos(2*pi*k/n)^2 + sin(2*pi*k/n)^2"), "1");
  EXPECT_EQ(value("tan(pi)"), "1: unknown function 'tan'");
  EXPECT_EQ(value("cos pi"), "5: found 'pi', expected '(' after cos");
  EXPECT_EQ(value("sqrt(1 - k)"), "1: square root of a negative number");
}

TEST(Expression, NumbersAndNames) {
  EXPECT_EQ(value("007"), "7");
  EXPECT_EQ(value("010"), "10");  // no octal
  EXPECT_EQ(value("089 + 0"), "89");
  EXPECT_EQ(value("000"), "0");
  EXPECT_EQ(value("2*w"), "1/8");
  EXPECT_EQ(value("_w"), "1: unknown _w");
  EXPECT_EQ(value("w2"), "1: unknown w2");
  EXPECT_EQ(value("2w"), "2: found 'w', expected an operator or the end");
  EXPECT_EQ(value("0.5"), "1: a decimal stands for a fraction here");
  EXPECT_EQ(value("1 + .5"), "5: a decimal stands for a fraction here");
  EXPECT_EQ(value("1e5"), "1: a decimal stands for a fraction here");
  EXPECT_EQ(value("\t 1\t+ 2 "), "3");
  EXPECT_EQ(value(std::string(100, '9')), std::string(100, '9'));
  EXPECT_EQ(value(std::string(101, '9')), "1: the number has more than 100 digits");
}

TEST(Expression, PowersAndTheirBounds) {
  EXPECT_EQ(value("0^0"), "1");
  EXPECT_EQ(value("(2/3)^-2"), "9/4");
  EXPECT_EQ(value("2^(1/2)"), "2: the exponent is no integer");
  EXPECT_EQ(value("1^4096"), "1");
  EXPECT_EQ(value("1^4097"), "2: the exponent is beyond 4096");
  EXPECT_EQ(value("1^-4097"), "2: the exponent is beyond 4096");
  EXPECT_EQ(value("1^9999999999999999999"), "2: the exponent is no integer");
  EXPECT_EQ(value("2^4096"), "2: the number is too large");
  EXPECT_EQ(value("0^-1"), "2: division by zero");
}

TEST(Expression, FaultsAreLocated) {
  EXPECT_EQ(value(""), "1: found the end, expected a number, a name or '('");
  EXPECT_EQ(value("(1"), "3: found the end, expected ')'");
  EXPECT_EQ(value("1)"), "2: found ')', expected an operator or the end");
  EXPECT_EQ(value("1 ++ 2"), "4: found '+ 2', expected a number, a name or '('");
  EXPECT_EQ(value("1/(n - 7)"), "2: division by zero");
  EXPECT_EQ(value("1 + 2*foo"), "7: unknown foo");
  EXPECT_EQ(value("1 = 2"), "3: found '= 2', expected an operator or the end");
  // twelve bytes are shown, and no character is cut
  EXPECT_EQ(value("1 €€€€€"), "3: found '€€€€', expected an operator or the end");
  EXPECT_EQ(value("1 x€€€€€"), "3: found 'x€€€€', expected an operator or the end");
}

TEST(Expression, NestingIsBounded) {
  const auto nested = [](int depth) {
    return std::string(static_cast<std::size_t>(depth), '(') + "1" +
           std::string(static_cast<std::size_t>(depth), ')');
  };
  EXPECT_EQ(value(nested(80)), "1");
  EXPECT_NE(value(nested(2000)).find("nested too deeply"), std::string::npos);
  std::string minus(4000, '-');
  EXPECT_EQ(value(minus + "1"), "1");
}

TEST(Expression, NamesInOrderOfFirstUse) {
  const Expression expression = Expression::parse("w + n*k - w/beta + sqrt(k)").value();
  EXPECT_EQ(expression.names(), (std::vector<std::string>{"w", "n", "k", "beta"}));
  EXPECT_EQ(expression.column_of("w"), 1);
  EXPECT_EQ(expression.column_of("k"), 7);
  EXPECT_EQ(expression.column_of("sqrt"), 0);
  EXPECT_EQ(Expression::constant(Rational(3, 8)).text(), "3/8");
}

}  // namespace
}  // namespace limn
