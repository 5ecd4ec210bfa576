// Polynomials in indeterminates: ring laws and values at random points, Chebyshev's polynomials
// against cosines, factors of random products, and what is written.

#include "limn/number/polynomial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "limn/number/closed_roots.h"
#include "limn/number/polynomial_factors.h"
#include "limn/number/polynomial_text.h"
#include "limn/number/symbolic.h"

namespace limn::test {
namespace {

const number::Indeterminate kX = number::variable("x");
const number::Indeterminate kY = number::variable("y");
const number::Indeterminate kN = number::whole_number("n");

number::Polynomial random_polynomial(std::mt19937& random, int terms, int lowest = 0) {
  number::Polynomial sum;
  const auto exponent = [&] { return lowest + static_cast<int>(random() % 4); };
  for (int i = 0; i < terms; ++i) {
    const Rational q(static_cast<int>(random() % 19) - 9, 1 + static_cast<int>(random() % 5));
    number::Monomial monomial = number::power(number::Monomial{{kX, 1}}, exponent());
    monomial = number::product(monomial, number::power(number::Monomial{{kY, 1}}, exponent()));
    if (random() % 2 == 0) monomial = number::product(monomial, {{kN, 1}});
    sum += number::Polynomial(monomial, q);
  }
  return sum;
}

double at(const number::Polynomial& a, double x = .7, double y = 1.3, double n = 5) {
  return number::approx(a, [&](const std::string& name) {
    return name == "x" ? x : name == "y" ? y : n;
  });
}

TEST(Polynomial, SumsAndProductsAreThoseOfTheirValues) {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const number::Polynomial a = random_polynomial(random, 5, -2);
    const number::Polynomial b = random_polynomial(random, 4, -2);
    const number::Polynomial c = random_polynomial(random, 3, -2);
    EXPECT_NEAR(at(a + b), at(a) + at(b), 1e-9 * (1 + std::abs(at(a)) + std::abs(at(b))));
    EXPECT_NEAR(at(a * b), at(a) * at(b), 1e-9 * (1 + std::abs(at(a) * at(b))) + 1e-9);
    EXPECT_EQ((a + b) * c, a * c + b * c);
    EXPECT_EQ(a - a, number::Polynomial());
    EXPECT_EQ(number::power(a, 3), a * a * a);
    number::Polynomial sum;
    for (const auto& [exponent, coefficient] : a.powers_of(kX))
      sum +=
          coefficient * number::Polynomial(number::power(number::Monomial{{kX, 1}}, exponent), 1);
    EXPECT_EQ(sum, a);
  }
}

TEST(Polynomial, ChebyshevsAreThoseOfMultipleAngles) {
  const double angle = .83;
  for (int j = -7; j <= 7; ++j) {
    EXPECT_NEAR(at(number::chebyshev(j, kX), std::cos(angle)), std::cos(j * angle), 1e-12) << j;
    EXPECT_NEAR(at(number::chebyshev_of_sine(j, kX), std::cos(angle)) * std::sin(angle),
                std::sin(j * angle), 1e-12)
        << j;
  }
  std::mt19937 random(2);
  for (int i = 0; i < 50; ++i) {
    const number::Polynomial a = random_polynomial(random, 6);
    number::Polynomial sum;
    for (const auto& [j, coefficient] : number::chebyshev_coefficients(a, kX))
      sum += coefficient * number::chebyshev(j, kX);
    EXPECT_EQ(sum, a);
    EXPECT_NEAR(at(number::substituted(a, kX, number::Polynomial(kY) + 2)), at(a, 3.3), 1e-6);
  }
}

TEST(Polynomial, AnglesMayChangeButNotTheValue) {
  const number::Monomial over_n{{kN, -1}};
  const number::Indeterminate c = number::cosine_indeterminate(1, over_n);
  std::mt19937 random(3);
  for (int i = 0; i < 100; ++i) {
    number::Polynomial a =
        number::substituted(random_polynomial(random, 4), kX, number::Polynomial(c));
    if (i % 2 == 0) a = number::substituted(a, c, number::Polynomial(c) * number::Polynomial(c));
    for (const number::Polynomial& b :
         {number::with_double_angles(a), number::with_multiple_angles(a),
          number::with_best_angles(a)})
      EXPECT_NEAR(at(b), at(a), 1e-9 * (1 + std::abs(at(a))));
  }
  const number::Polynomial square = number::Polynomial(c) * number::Polynomial(c);
  EXPECT_EQ(number::sum_text(number::with_double_angles(number::Polynomial(4) * square + 1),
                             number::Notation::text),
            "2*cos(2*pi/n) + 3");
}

TEST(Polynomial, AreWrittenAsSchemeFilesWouldBe) {
  const number::Polynomial x(kX);
  const number::Polynomial y(kY);
  const number::Polynomial n(kN);
  EXPECT_EQ(number::sum_text(number::Polynomial(), number::Notation::text), "0");
  EXPECT_EQ(number::sum_text(n * n * number::Polynomial(5) - n * number::Polynomial(30) + 49,
                             number::Notation::text),
            "5*n^2 - 30*n + 49");
  EXPECT_EQ(
      number::sum_text(number::Polynomial(Rational(3, 8)) + x * number::Polynomial(Rational(1, 4)),
                       number::Notation::text, number::TermOrder::rising),
      "3/8 + x/4");
  EXPECT_EQ(number::sum_text(number::Polynomial({{kN, -1}, {kX, 2}}, Rational(-2, 3)),
                             number::Notation::text),
            "-2*x^2/(3*n)");
  EXPECT_EQ(number::sum_text(number::Polynomial({{kN, -1}, {kX, 2}}, Rational(-2, 3)),
                             number::Notation::latex),
            "-\\frac{2 x^{2}}{3 n}");
  EXPECT_EQ(number::sum_text(number::Polynomial(1) - x, number::Notation::text,
                             number::TermOrder::falling),
            "1 - x");
  EXPECT_EQ(number::cosine_indeterminate(Rational(2, 3), {{kN, -1}, {kX, 1}})->name,
            "cos(2*pi*x/(3*n))");
  EXPECT_EQ(number::latex_name("omega"), "\\omega");
  EXPECT_EQ(number::latex_name("my_w"), "\\mathit{my\\_w}");
}

class Factors : public ::testing::Test {
  void SetUp() override {
    if (!number::factor(number::Polynomial(2))) GTEST_SKIP() << "built without FLINT";
  }
};

number::Polynomial multiplied(const number::PolynomialFactors& factors) {
  number::Polynomial result(factors.content);
  for (const auto& [base, exponent] : factors.factors)
    result = result * (exponent < 0 ? number::Polynomial(
                                          number::power(base.terms().begin()->first, exponent), 1)
                                    : number::power(base, exponent));
  return result;
}

TEST_F(Factors, OfRandomProductsMultiplyToThem) {
  std::mt19937 random(4);
  for (int i = 0; i < 60; ++i) {
    const number::Polynomial a = random_polynomial(random, 3, -1) + number::Polynomial(kX);
    const number::Polynomial b = random_polynomial(random, 3, -1) + 1;
    const number::Polynomial whole = a * a * b;
    if (whole.is_zero()) continue;
    const number::PolynomialFactors factors = number::factor(whole).value();
    EXPECT_EQ(multiplied(factors), whole);
    for (const auto& [base, exponent] : factors.factors) {
      EXPECT_EQ(number::content(base), 1);
      if (exponent > 0) {
        const number::PolynomialFactors again = number::factor(base).value();
        ASSERT_EQ(again.factors.size(), 1U);
        EXPECT_EQ(again.factors[0].second, 1);
      }
    }
    // two and more equal factors are found
    const auto in_square = number::factor(a).value().factors;
    for (const auto& [base, exponent] : in_square)
      EXPECT_TRUE(std::any_of(factors.factors.begin(), factors.factors.end(), [&](const auto& one) {
        return one.first == base && std::abs(one.second) + 3 >= std::abs(2 * exponent);
      }));
  }
}

TEST_F(Factors, CommonDivisorsAreTakenOutExactly) {
  std::mt19937 random(5);
  for (int i = 0; i < 40; ++i) {
    const number::Polynomial a = random_polynomial(random, 3) + 1;
    const number::Polynomial b = random_polynomial(random, 3) + number::Polynomial(kY);
    const number::Polynomial c =
        random_polynomial(random, 2) + number::Polynomial(kX) * number::Polynomial(kX) + 3;
    const number::Coprime divided = number::without_common_divisor(a * c, b * c).value();
    EXPECT_EQ(divided.a * divided.divisor, a * c);
    EXPECT_EQ(divided.b * divided.divisor, b * c);
    EXPECT_EQ(divided.a * b, divided.b * a);
    EXPECT_TRUE(number::without_common_divisor(divided.a, divided.b).value().divisor.is_rational());
  }
}

TEST_F(Factors, OfDegreeOneAndTwoGiveRoots) {
  const number::Indeterminate unknown = number::variable("lambda");
  const number::Polynomial l(unknown);
  const number::Polynomial x(kX);
  const auto texts = [&](const number::Polynomial& a) {
    std::vector<std::string> result;
    const number::ClosedRoots roots = number::closed_roots(a, unknown).value();
    for (const ClosedRoot& root : roots.roots)
      result.push_back(root.text + (root.multiplicity > 1 ? " twice" : ""));
    for (const number::ClosedRoots::Left& left : roots.left)
      result.push_back("left: " + left.polynomial.text);
    std::sort(result.begin(), result.end());
    return result;
  };
  using Texts = std::vector<std::string>;
  EXPECT_EQ(texts(l * number::Polynomial(3) - 2), Texts{"2/3"});
  EXPECT_EQ(texts(number::power(l * x - 1, 2)), Texts{"1/x twice"});
  EXPECT_EQ(texts(l * l - 2), (Texts{"-sqrt(2)", "sqrt(2)"}));
  EXPECT_EQ(texts(l * l * number::Polynomial(4) - l * x * number::Polynomial(4) - 1),
            (Texts{"(x + sqrt(x^2 + 1))/2", "(x - sqrt(x^2 + 1))/2"}));
  EXPECT_EQ(texts(l * l * x - x * x * x * number::Polynomial(8)),
            (Texts{"-2*x*sqrt(2)", "2*x*sqrt(2)"}));
  EXPECT_EQ(texts(l * l * l - x), Texts{"left: lambda^3 - x"});
  EXPECT_EQ(texts(l * l * l * (x - 1) - l * (x + 1) - 1),
            Texts{"left: (x - 1)*lambda^3 - (x + 1)*lambda - 1"});
}

// FLINT would not end: numbers of 60000 bits in two variables take it minutes.
TEST_F(Factors, OfCoefficientsThatAreTooLongAreRefused) {
  const number::Polynomial x(kX);
  const Rational large(Integer(1) << 30'000);
  const number::Polynomial longest =
      x * x * number::Polynomial(large * large + 1) - x * number::Polynomial(large + 3) + 1;
  EXPECT_FALSE(number::factor(longest));
  EXPECT_FALSE(number::without_common_divisor(longest, x + 1));
  EXPECT_FALSE(number::without_common_divisor(x + 1, longest));
  // short above and below, but over one denominator they are long
  number::Polynomial fractions;
  for (int i = 0; i < 500; ++i)
    fractions +=
        number::power(x, i) * number::Polynomial(Rational(Integer(1), (Integer(1) << 100) + i));
  EXPECT_FALSE(number::factor(fractions));
  EXPECT_TRUE(number::factor(x * x * number::Polynomial(Rational(Integer(1) << 5'000)) - 1));
}

}  // namespace
}  // namespace limn::test
