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

const Indeterminate kX = variable("x");
const Indeterminate kY = variable("y");
const Indeterminate kN = whole_number("n");

Polynomial random_polynomial(std::mt19937& random, int terms, int lowest = 0) {
  Polynomial sum;
  const auto exponent = [&] { return lowest + static_cast<int>(random() % 4); };
  for (int i = 0; i < terms; ++i) {
    const Rational q(static_cast<int>(random() % 19) - 9, 1 + static_cast<int>(random() % 5));
    Monomial monomial = power(Monomial{{kX, 1}}, exponent());
    monomial = product(monomial, power(Monomial{{kY, 1}}, exponent()));
    if (random() % 2 == 0) monomial = product(monomial, {{kN, 1}});
    sum += Polynomial(monomial, q);
  }
  return sum;
}

double at(const Polynomial& a, double x = .7, double y = 1.3, double n = 5) {
  return approx(a, [&](const std::string& name) { return name == "x" ? x : name == "y" ? y : n; });
}

TEST(Polynomial, SumsAndProductsAreThoseOfTheirValues) {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const Polynomial a = random_polynomial(random, 5, -2);
    const Polynomial b = random_polynomial(random, 4, -2);
    const Polynomial c = random_polynomial(random, 3, -2);
    EXPECT_NEAR(at(a + b), at(a) + at(b), 1e-9 * (1 + std::abs(at(a)) + std::abs(at(b))));
    EXPECT_NEAR(at(a * b), at(a) * at(b), 1e-9 * (1 + std::abs(at(a) * at(b))) + 1e-9);
    EXPECT_EQ((a + b) * c, a * c + b * c);
    EXPECT_EQ(a - a, Polynomial());
    EXPECT_EQ(power(a, 3), a * a * a);
    Polynomial sum;
    for (const auto& [exponent, coefficient] : a.powers_of(kX))
      sum += coefficient * Polynomial(power(Monomial{{kX, 1}}, exponent), 1);
    EXPECT_EQ(sum, a);
  }
}

TEST(Polynomial, ChebyshevsAreThoseOfMultipleAngles) {
  const double angle = .83;
  for (int j = -7; j <= 7; ++j) {
    EXPECT_NEAR(at(chebyshev(j, kX), std::cos(angle)), std::cos(j * angle), 1e-12) << j;
    EXPECT_NEAR(at(chebyshev_of_sine(j, kX), std::cos(angle)) * std::sin(angle),
                std::sin(j * angle), 1e-12)
        << j;
  }
  std::mt19937 random(2);
  for (int i = 0; i < 50; ++i) {
    const Polynomial a = random_polynomial(random, 6);
    Polynomial sum;
    for (const auto& [j, coefficient] : chebyshev_coefficients(a, kX))
      sum += coefficient * chebyshev(j, kX);
    EXPECT_EQ(sum, a);
    EXPECT_NEAR(at(substituted(a, kX, Polynomial(kY) + 2)), at(a, 3.3), 1e-6);
  }
}

TEST(Polynomial, AnglesMayChangeButNotTheValue) {
  const Monomial over_n{{kN, -1}};
  const Indeterminate c = cosine_indeterminate(1, over_n);
  std::mt19937 random(3);
  for (int i = 0; i < 100; ++i) {
    Polynomial a = substituted(random_polynomial(random, 4), kX, Polynomial(c));
    if (i % 2 == 0) a = substituted(a, c, Polynomial(c) * Polynomial(c));
    for (const Polynomial& b :
         {with_double_angles(a), with_multiple_angles(a), with_best_angles(a)})
      EXPECT_NEAR(at(b), at(a), 1e-9 * (1 + std::abs(at(a))));
  }
  const Polynomial square = Polynomial(c) * Polynomial(c);
  EXPECT_EQ(sum_text(with_double_angles(Polynomial(4) * square + 1), Notation::text),
            "2*cos(2*pi/n) + 3");
}

TEST(Polynomial, AreWrittenAsSchemeFilesWouldBe) {
  const Polynomial x(kX);
  const Polynomial y(kY);
  const Polynomial n(kN);
  EXPECT_EQ(sum_text(Polynomial(), Notation::text), "0");
  EXPECT_EQ(sum_text(n * n * Polynomial(5) - n * Polynomial(30) + 49, Notation::text),
            "5*n^2 - 30*n + 49");
  EXPECT_EQ(sum_text(Polynomial(Rational(3, 8)) + x * Polynomial(Rational(1, 4)), Notation::text,
                     TermOrder::rising),
            "3/8 + x/4");
  EXPECT_EQ(sum_text(Polynomial({{kN, -1}, {kX, 2}}, Rational(-2, 3)), Notation::text),
            "-2*x^2/(3*n)");
  EXPECT_EQ(sum_text(Polynomial({{kN, -1}, {kX, 2}}, Rational(-2, 3)), Notation::latex),
            "-\\frac{2 x^{2}}{3 n}");
  EXPECT_EQ(sum_text(Polynomial(1) - x, Notation::text, TermOrder::falling), "1 - x");
  EXPECT_EQ(cosine_indeterminate(Rational(2, 3), {{kN, -1}, {kX, 1}})->name, "cos(2*pi*x/(3*n))");
  EXPECT_EQ(latex_name("omega"), "\\omega");
  EXPECT_EQ(latex_name("my_w"), "\\mathit{my\\_w}");
}

class Factors : public ::testing::Test {
  void SetUp() override {
    if (!factor(Polynomial(2))) GTEST_SKIP() << "built without FLINT";
  }
};

Polynomial multiplied(const PolynomialFactors& factors) {
  Polynomial result(factors.content);
  for (const auto& [base, exponent] : factors.factors)
    result = result * (exponent < 0 ? Polynomial(power(base.terms().begin()->first, exponent), 1)
                                    : power(base, exponent));
  return result;
}

TEST_F(Factors, OfRandomProductsMultiplyToThem) {
  std::mt19937 random(4);
  for (int i = 0; i < 60; ++i) {
    const Polynomial a = random_polynomial(random, 3, -1) + Polynomial(kX);
    const Polynomial b = random_polynomial(random, 3, -1) + 1;
    const Polynomial whole = a * a * b;
    if (whole.is_zero()) continue;
    const PolynomialFactors factors = factor(whole).value();
    EXPECT_EQ(multiplied(factors), whole);
    for (const auto& [base, exponent] : factors.factors) {
      EXPECT_EQ(content(base), 1);
      if (exponent > 0) {
        const PolynomialFactors again = factor(base).value();
        ASSERT_EQ(again.factors.size(), 1U);
        EXPECT_EQ(again.factors[0].second, 1);
      }
    }
    // two and more equal factors are found
    const auto in_square = factor(a).value().factors;
    for (const auto& [base, exponent] : in_square)
      EXPECT_TRUE(std::any_of(factors.factors.begin(), factors.factors.end(), [&](const auto& one) {
        return one.first == base && std::abs(one.second) + 3 >= std::abs(2 * exponent);
      }));
  }
}

TEST_F(Factors, CommonDivisorsAreTakenOutExactly) {
  std::mt19937 random(5);
  for (int i = 0; i < 40; ++i) {
    const Polynomial a = random_polynomial(random, 3) + 1;
    const Polynomial b = random_polynomial(random, 3) + Polynomial(kY);
    const Polynomial c = random_polynomial(random, 2) + Polynomial(kX) * Polynomial(kX) + 3;
    const Coprime divided = without_common_divisor(a * c, b * c).value();
    EXPECT_EQ(divided.a * divided.divisor, a * c);
    EXPECT_EQ(divided.b * divided.divisor, b * c);
    EXPECT_EQ(divided.a * b, divided.b * a);
    EXPECT_TRUE(without_common_divisor(divided.a, divided.b).value().divisor.is_rational());
  }
}

TEST_F(Factors, OfDegreeOneAndTwoGiveRoots) {
  const Indeterminate unknown = variable("lambda");
  const Polynomial l(unknown);
  const Polynomial x(kX);
  const auto texts = [&](const Polynomial& a) {
    std::vector<std::string> result;
    const ClosedRoots roots = closed_roots(a, unknown).value();
    for (const ClosedRoot& root : roots.roots)
      result.push_back(root.text + (root.multiplicity > 1 ? " twice" : ""));
    for (const ClosedRoots::Left& left : roots.left)
      result.push_back("left: " + left.polynomial.text);
    std::sort(result.begin(), result.end());
    return result;
  };
  using Texts = std::vector<std::string>;
  EXPECT_EQ(texts(l * Polynomial(3) - 2), Texts{"2/3"});
  EXPECT_EQ(texts(power(l * x - 1, 2)), Texts{"1/x twice"});
  EXPECT_EQ(texts(l * l - 2), (Texts{"-sqrt(2)", "sqrt(2)"}));
  EXPECT_EQ(texts(l * l * Polynomial(4) - l * x * Polynomial(4) - 1),
            (Texts{"(x + sqrt(x^2 + 1))/2", "(x - sqrt(x^2 + 1))/2"}));
  EXPECT_EQ(texts(l * l * x - x * x * x * Polynomial(8)), (Texts{"-2*x*sqrt(2)", "2*x*sqrt(2)"}));
  EXPECT_EQ(texts(l * l * l - x), Texts{"left: lambda^3 - x"});
  EXPECT_EQ(texts(l * l * l * (x - 1) - l * (x + 1) - 1),
            Texts{"left: (x - 1)*lambda^3 - (x + 1)*lambda - 1"});
}

// FLINT would not end: numbers of 60000 bits in two variables take it minutes.
TEST_F(Factors, OfCoefficientsThatAreTooLongAreRefused) {
  const Polynomial x(kX);
  const Rational large(Integer(1) << 30'000);
  const Polynomial longest = x * x * Polynomial(large * large + 1) - x * Polynomial(large + 3) + 1;
  EXPECT_FALSE(factor(longest));
  EXPECT_FALSE(without_common_divisor(longest, x + 1));
  EXPECT_FALSE(without_common_divisor(x + 1, longest));
  // short above and below, but over one denominator they are long
  Polynomial fractions;
  for (int i = 0; i < 500; ++i)
    fractions += power(x, i) * Polynomial(Rational(Integer(1), (Integer(1) << 100) + i));
  EXPECT_FALSE(factor(fractions));
  EXPECT_TRUE(factor(x * x * Polynomial(Rational(Integer(1) << 5'000)) - 1));
}

}  // namespace
}  // namespace limn::test
