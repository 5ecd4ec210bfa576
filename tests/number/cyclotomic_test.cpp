#include "limn/number/cyclotomic.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace limn::test {
namespace {

using Polynomial = std::vector<Integer>;

number::Cyclotomic whole(long long value) { return {Rational(value)}; }
number::Cyclotomic cosine(long long p, long long q) { return number::Cyclotomic::cos_turn(p, q); }

/// A few cosines with rational coefficients, of one order or of two.
number::Cyclotomic random_number(std::mt19937& random) {
  static constexpr int kOrders[] = {1, 3, 4, 5, 7, 8, 9, 12, 15};
  const int order = kOrders[random() % std::size(kOrders)];
  number::Cyclotomic sum;
  for (int i = 0; i < 3; ++i) {
    const Rational factor(static_cast<int>(random() % 19) - 9, 1 + static_cast<int>(random() % 6));
    const int q = random() % 4 == 0 ? 5 : order;
    sum += number::Cyclotomic(factor) * cosine(static_cast<int>(random() % 30), q);
  }
  return sum;
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial result(a.size() + b.size() - 1, Integer(0));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  return result;
}

TEST(CyclotomicPolynomial, IsTheKnownOne) {
  EXPECT_EQ(number::cyclotomic_polynomial(1), (Polynomial{-1, 1}));
  EXPECT_EQ(number::cyclotomic_polynomial(2), (Polynomial{1, 1}));
  EXPECT_EQ(number::cyclotomic_polynomial(3), (Polynomial{1, 1, 1}));
  EXPECT_EQ(number::cyclotomic_polynomial(4), (Polynomial{1, 0, 1}));
  EXPECT_EQ(number::cyclotomic_polynomial(6), (Polynomial{1, -1, 1}));
  EXPECT_EQ(number::cyclotomic_polynomial(7), (Polynomial{1, 1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(number::cyclotomic_polynomial(8), (Polynomial{1, 0, 0, 0, 1}));
  EXPECT_EQ(number::cyclotomic_polynomial(9), (Polynomial{1, 0, 0, 1, 0, 0, 1}));
  EXPECT_EQ(number::cyclotomic_polynomial(10), (Polynomial{1, -1, 1, -1, 1}));
  EXPECT_EQ(number::cyclotomic_polynomial(12), (Polynomial{1, 0, -1, 0, 1}));
  EXPECT_EQ(number::cyclotomic_polynomial(15), (Polynomial{1, -1, 0, 1, -1, 1, 0, -1, 1}));
  // the first with a coefficient other than 0 and ±1
  EXPECT_EQ(number::cyclotomic_polynomial(105)[7], -2);
  EXPECT_EQ(number::cyclotomic_polynomial(105)[41], -2);
}

TEST(CyclotomicPolynomial, MultiplyToRootsOfUnity) {
  for (int n = 1; n <= 60; ++n) {
    Polynomial all{1};
    for (int d = 1; d <= n; ++d)
      if (n % d == 0) all = product(all, number::cyclotomic_polynomial(d));
    Polynomial expected(static_cast<std::size_t>(n) + 1, Integer(0));
    expected.front() = -1;
    expected.back() = 1;
    EXPECT_EQ(all, expected) << n;
  }
}

TEST(Cyclotomic, KnowsRationalCosines) {
  const auto is = [](const number::Cyclotomic& number, const Rational& value) {
    return number.is_rational() && number.rational() == value;
  };
  EXPECT_TRUE(is(cosine(0, 1), 1));
  EXPECT_TRUE(is(cosine(1, 2), -1));
  EXPECT_TRUE(is(cosine(1, 3), Rational(-1, 2)));
  EXPECT_TRUE(is(cosine(1, 4), 0));
  EXPECT_TRUE(is(cosine(5, 6), Rational(1, 2)));
  EXPECT_TRUE(is(cosine(-7, 6), Rational(1, 2)));
  EXPECT_TRUE(is(cosine(1'000'000'000'002, 4), -1));
  // Niven: no others
  for (int q = 1; q <= 40; ++q)
    for (int p = 0; p < q; ++p) {
      const int order = q / std::gcd(p, q);
      EXPECT_EQ(cosine(p, q).is_rational(), order <= 4 || order == 6) << p << "/" << q;
    }
}

TEST(Cyclotomic, AgreesWithDoubles) {
  for (int q = 1; q <= 40; ++q)
    for (int p = -q; p <= 2 * q; ++p)
      EXPECT_NEAR(cosine(p, q).approx(), std::cos(2 * std::numbers::pi * p / q), 1e-14);
  EXPECT_TRUE(rc::check([](unsigned seed) {
    std::mt19937 random(seed);
    const number::Cyclotomic a = random_number(random), b = random_number(random);
    RC_ASSERT(std::abs((a + b).approx() - (a.approx() + b.approx())) < 1e-12);
    RC_ASSERT(std::abs((a - b).approx() - (a.approx() - b.approx())) < 1e-12);
    RC_ASSERT(std::abs((a * b).approx() - a.approx() * b.approx()) < 1e-10);
    if (!a.is_zero()) RC_ASSERT(std::abs(a.approx()) > 0);
  }));
}

TEST(Cyclotomic, IsAField) {
  EXPECT_TRUE(rc::check([](unsigned seed) {
    std::mt19937 random(seed);
    const number::Cyclotomic a = random_number(random), b = random_number(random),
                             c = random_number(random);
    RC_ASSERT(a + b == b + a);
    RC_ASSERT(a * b == b * a);
    RC_ASSERT((a + b) + c == a + (b + c));
    RC_ASSERT((a * b) * c == a * (b * c));
    RC_ASSERT(a * (b + c) == a * b + a * c);
    RC_ASSERT((a - a).is_zero());
    RC_ASSERT((a - b) + b == a);
    RC_ASSERT(a * whole(0) == whole(0));
    RC_ASSERT(a * whole(1) == a);
    RC_ASSERT((a * b).is_zero() == (a.is_zero() || b.is_zero()));
    if (!a.is_zero()) {
      RC_ASSERT(a * a.inverse() == whole(1));
      RC_ASSERT(a.inverse().inverse() == a);
      RC_ASSERT((b * a) * a.inverse() == b);
    }
  }));
}

TEST(Cyclotomic, ObeysTheAdditionTheorems) {
  EXPECT_TRUE(rc::check([](unsigned seed) {
    std::mt19937 random(seed);
    const int q = 1 + static_cast<int>(random() % 24);
    const int a = static_cast<int>(random() % 50) - 25, b = static_cast<int>(random() % 50) - 25;
    // 2 cos a cos b = cos(a + b) + cos(a - b)
    RC_ASSERT(whole(2) * cosine(a, q) * cosine(b, q) == cosine(a + b, q) + cosine(a - b, q));
    RC_ASSERT(cosine(2 * a, q) == whole(2) * cosine(a, q) * cosine(a, q) - whole(1));
    RC_ASSERT(cosine(-a, q) == cosine(a, q));
    RC_ASSERT(cosine(a + q, q) == cosine(a, q));
    RC_ASSERT(cosine(3 * a, 3 * q) == cosine(a, q));
    // sin² + cos² = 1, the sine being a cosine a quarter turn on
    const number::Cyclotomic cos = cosine(4 * a, 4 * q), sin = cosine(4 * a - q, 4 * q);
    RC_ASSERT(cos * cos + sin * sin == whole(1));
  }));
}

TEST(Cyclotomic, KnowsZerosThatDoublesDoNot) {
  for (int n = 2; n <= 40; ++n) {
    number::Cyclotomic roots, squares;
    for (int k = 0; k < n; ++k) {
      roots += cosine(k, n);
      squares += cosine(k, n) * cosine(k, n);
    }
    EXPECT_TRUE(roots.is_zero()) << n;  // all n-th roots of unity
    EXPECT_TRUE(squares == number::Cyclotomic(n == 2 ? Rational(2) : Rational(n, 2))) << n;
  }
  const number::Cyclotomic five = whole(4) * cosine(1, 5) + whole(1);  // √5
  EXPECT_TRUE(five * five == whole(5));
  const number::Cyclotomic c = cosine(1, 7);
  EXPECT_TRUE((whole(8) * c * c * c + whole(4) * c * c - whole(4) * c - whole(1)).is_zero());
  // Morrie's law, at 20°, 40° and 80°
  EXPECT_TRUE(cosine(1, 18) * cosine(2, 18) * cosine(4, 18) == number::Cyclotomic(Rational(1, 8)));
  // of unlike orders: cos 36° - cos 72° = 1/2, √2 + √8 = 3√2
  EXPECT_TRUE(cosine(1, 10) - cosine(1, 5) == number::Cyclotomic(Rational(1, 2)));
  // close to zero, but not zero
  EXPECT_FALSE((cosine(1, 97) - number::Cyclotomic(Rational(99790, 100000))).is_zero());
}

TEST(Cyclotomic, IsWrittenInItsField) {
  // φ(N) coefficients of 1, ζ, …
  EXPECT_EQ(cosine(1, 7).order(), 7);
  EXPECT_EQ(cosine(1, 7).coefficients().size(), 6U);
  EXPECT_EQ(whole(3).order(), 1);
  EXPECT_EQ(whole(3).coefficients(), std::vector<Rational>{3});
  for (const number::Cyclotomic& number :
       {cosine(1, 5), cosine(1, 9) + cosine(1, 8), cosine(2, 15)}) {
    double real = 0;
    for (std::size_t i = 0; i < number.coefficients().size(); ++i)
      real += to_double(number.coefficients()[i]) *
              std::cos(2 * std::numbers::pi * static_cast<double>(i) / number.order());
    EXPECT_NEAR(real, number.approx(), 1e-13);
  }
}

}  // namespace
}  // namespace limn::test
