#include "limn/number/exact.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "limn/number/arithmetic.h"

namespace limn::test {
namespace {

number::Exact fraction(int p, int q) { return {Rational(p, q)}; }
number::Exact root(const number::Exact& square) { return number::Exact::sqrt(square).value(); }
number::Exact pi_times(int p, int q) { return number::Exact::pi() * fraction(p, q); }
number::Exact cosine(int p, int q) { return number::Exact::cos(pi_times(p, q)).value(); }
number::Exact sine(int p, int q) { return number::Exact::sin(pi_times(p, q)).value(); }

/// What went wrong; empty where nothing did.
std::string fault(const Result<number::Exact>& result) {
  return result ? std::string() : result.error().message;
}
::testing::AssertionResult says(const Result<number::Exact>& result, const std::string& words) {
  if (fault(result).find(words) != std::string::npos) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "'" << fault(result) << "' without '" << words << "'";
}

/// Rationals, cosines and square roots of primes, added and multiplied. The cosines' fields (up to
/// that of 80th roots of unity) hold the roots of 2 and 5, but none of these.
number::Exact random_number(std::mt19937& random, int terms = 3) {
  static constexpr int kPrimes[] = {3, 7, 11, 13};
  number::Exact sum;
  for (int i = 0; i < terms; ++i) {
    number::Exact term =
        fraction(static_cast<int>(random() % 19) - 9, 1 + static_cast<int>(random() % 6));
    if (random() % 2 == 0)
      term = term * cosine(static_cast<int>(random() % 20), random() % 2 == 0 ? 5 : 8);
    if (random() % 2 == 0) term = term * root(kPrimes[random() % std::size(kPrimes)]);
    sum += term;
  }
  return sum;
}

TEST(Exact, IsAField) {
  EXPECT_TRUE(rc::check([](unsigned seed) {
    std::mt19937 random(seed);
    const number::Exact a = random_number(random), b = random_number(random),
                        c = random_number(random);
    RC_ASSERT(a + b == b + a);
    RC_ASSERT(a * b == b * a);
    RC_ASSERT((a + b) + c == a + (b + c));
    RC_ASSERT((a * b) * c == a * (b * c));
    RC_ASSERT(a * (b + c) == a * b + a * c);
    RC_ASSERT((a - a).is_zero());
    RC_ASSERT((a - b) + b == a);
    RC_ASSERT(a * number::Exact(1) == a);
    RC_ASSERT((a * number::Exact(0)).is_zero());
  }));
}

TEST(Exact, DividesWhatItMultiplied) {
  EXPECT_TRUE(rc::check([](unsigned seed) {
    std::mt19937 random(seed);
    const number::Exact a = random_number(random), b = random_number(random, 2);
    if (b.is_zero()) return;
    const Result<number::Exact> quotient = number::Exact::divide(a, b);
    RC_ASSERT(quotient.ok());
    RC_ASSERT(*quotient * b == a);
    // what is too long for it may be refused
    const Result<number::Exact> back = number::Exact::divide(a * b, b);
    if (back) RC_ASSERT(*back == a);
  }));
}

TEST(Exact, AgreesWithDoubles) {
  EXPECT_TRUE(rc::check([](unsigned seed) {
    std::mt19937 random(seed);
    const number::Exact a = random_number(random), b = random_number(random);
    const double x = a.approx(), y = b.approx();
    const double size = (1 + a.magnitude()) * (1 + b.magnitude());
    RC_ASSERT(a.magnitude() >= std::abs(x) * (1 - 1e-14));
    RC_ASSERT(std::abs((a + b).approx() - (x + y)) < 1e-14 * size);
    RC_ASSERT(std::abs((a - b).approx() - (x - y)) < 1e-14 * size);
    RC_ASSERT(std::abs((a * b).approx() - x * y) < 1e-13 * size);
  }));
  EXPECT_DOUBLE_EQ(number::Exact::pi().approx(), std::numbers::pi);
  EXPECT_DOUBLE_EQ(root(2).approx(), std::numbers::sqrt2);
  for (int q = 1; q <= 24; ++q) {
    for (int p = -3 * q; p <= 3 * q; ++p) {
      EXPECT_NEAR(cosine(p, q).approx(), std::cos(std::numbers::pi * p / q), 1e-14);
      EXPECT_NEAR(sine(p, q).approx(), std::sin(std::numbers::pi * p / q), 1e-14);
    }
  }
}

TEST(Exact, ObeysTheAdditionTheorems) {
  EXPECT_TRUE(rc::check([](unsigned seed) {
    std::mt19937 random(seed);
    const int q = 1 + static_cast<int>(random() % 12);
    const int a = static_cast<int>(random() % 50) - 25, b = static_cast<int>(random() % 50) - 25;
    RC_ASSERT(cosine(a + b, q) == cosine(a, q) * cosine(b, q) - sine(a, q) * sine(b, q));
    RC_ASSERT(sine(a + b, q) == sine(a, q) * cosine(b, q) + cosine(a, q) * sine(b, q));
    RC_ASSERT(cosine(a, q) * cosine(a, q) + sine(a, q) * sine(a, q) == number::Exact(1));
  }));
  EXPECT_EQ(sine(1, 6), fraction(1, 2));
  EXPECT_EQ(sine(1, 2), number::Exact(1));
  EXPECT_EQ(sine(-1, 2), number::Exact(-1));
  EXPECT_EQ(number::Exact::cos(number::Exact(0)).value(), number::Exact(1));
  EXPECT_TRUE(number::Exact::sin(number::Exact(0)).value().is_zero());
}

TEST(Exact, HasSquareRoots) {
  EXPECT_EQ(root(0), number::Exact(0));
  EXPECT_EQ(root(fraction(49, 16)), fraction(7, 4));  // rational where it can be
  EXPECT_TRUE(root(fraction(49, 16)).is_rational());
  EXPECT_FALSE(root(2).is_rational());
  EXPECT_TRUE((root(2) * root(2)).is_rational());
  EXPECT_EQ((root(2) * root(2)).rational(), 2);
  EXPECT_TRUE((root(2) - root(2)).is_zero());
  EXPECT_EQ((number::Exact(1) + root(2)) * (number::Exact(1) - root(2)), number::Exact(-1));
  EXPECT_EQ(number::Exact::divide(1, root(2) + root(3)).value(), root(3) - root(2));
  EXPECT_EQ(root(2) * root(3) * root(2) * root(3), number::Exact(6));
  // of cosines, and of numbers that hold roots themselves
  for (int n = 3; n <= 12; ++n) {
    const number::Exact c = cosine(2, n), square = (c + number::Exact(9)) * (c + number::Exact(1));
    EXPECT_EQ(root(square) * root(square), square) << n;
    EXPECT_NEAR(root(square).approx(), std::sqrt(square.approx()), 1e-14);
  }
  const number::Exact nested = root(number::Exact(2) + root(2));
  EXPECT_EQ(nested * nested, number::Exact(2) + root(2));
  EXPECT_EQ((nested * nested - number::Exact(2)) * (nested * nested - number::Exact(2)),
            number::Exact(2));
  EXPECT_NEAR(nested.approx(), std::sqrt(2 + std::sqrt(2)), 1e-15);
  EXPECT_EQ(number::Exact::divide(1, nested).value() * nested, number::Exact(1));
}

TEST(Exact, NeverCallsDifferentNumbersEqual) {
  EXPECT_FALSE(root(2) == fraction(665857, 470832));  // 1e-12 apart
  EXPECT_FALSE(root(2) == root(3));
  EXPECT_FALSE(root(2) == number::Exact(0) - root(2));
  EXPECT_FALSE(cosine(2, 7) == cosine(4, 7));
  // unlike roots of related numbers: a missed equality is allowed, a wrong quotient is not
  for (const number::Exact& hidden_zero :
       {root(2) * root(3) - root(6), root(2) + root(2) - root(8)}) {
    EXPECT_NEAR(hidden_zero.approx(), 0, 1e-15);
    EXPECT_FALSE(number::Exact::divide(1, hidden_zero).ok());
  }
  EXPECT_EQ(number::Exact::divide(root(8), root(2)).value() * root(2), root(8));
  // 4√2 and 2√2, written so that their conjugates are zero
  for (const number::Exact& number :
       {root(2) + root(2) + root(8), root(2) + number::Exact(2) * cosine(1, 4)}) {
    const Result<number::Exact> inverse = number::Exact::divide(1, number);
    ASSERT_TRUE(inverse.ok()) << inverse.error().text();
    EXPECT_NEAR(inverse->approx() * number.approx(), 1, 1e-14);
  }
}

TEST(Exact, SaysWhyItCannot) {
  EXPECT_TRUE(says(number::Exact::divide(1, 0), "division by zero"));
  EXPECT_TRUE(says(number::Exact::divide(1, root(2) - root(2)), "division by zero"));
  EXPECT_TRUE(says(number::Exact::divide(1, number::Exact::pi()), "pi"));
  EXPECT_TRUE(says(number::Exact::sqrt(-2), "square root of a negative number"));
  EXPECT_TRUE(says(number::Exact::sqrt(cosine(2, 3)), "square root of a negative number"));
  EXPECT_TRUE(says(number::Exact::sqrt(cosine(4, 5)), "square root of a negative number"));
  EXPECT_TRUE(says(number::Exact::sqrt(number::Exact::pi()), "pi"));
  EXPECT_TRUE(says(number::Exact::multiply(number::Exact::pi(), number::Exact::pi()), "pi"));
  EXPECT_TRUE(says(number::Exact::multiply(number::Exact::pi(), root(2)), "pi"));
  for (const number::Exact& angle :
       {number::Exact(1), root(2), number::Exact::pi() + number::Exact(1), cosine(2, 7)}) {
    EXPECT_TRUE(says(number::Exact::cos(angle), "rational multiple of pi"));
    EXPECT_TRUE(says(number::Exact::sin(angle), "rational multiple of pi"));
  }
  EXPECT_EQ(fault(number::Exact::divide(number::Exact::pi(), 3)),
            "");  // what cos needs goes through
}

TEST(ExactArithmetic, DecidesSignsAndIntegers) {
  using A = number::Arithmetic<number::Exact>;
  EXPECT_EQ(A::sign(fraction(-1, 1000)).value(), -1);
  EXPECT_EQ(A::sign(cosine(2, 5) - cosine(1, 5)).value(), -1);
  EXPECT_EQ(A::sign(root(2) * root(2) - number::Exact(2)).value(), 0);
  EXPECT_EQ(A::sign(root(2) - fraction(141421, 100000)).value(), 1);
  // a zero that it does not know is not taken for a positive or a negative number
  EXPECT_FALSE(A::sign(root(2) * root(3) - root(6)).ok());
  EXPECT_EQ(A::integer(fraction(12, 4)).value(), 3);
  EXPECT_EQ(A::integer(number::Exact(4) * cosine(1, 3)).value(), 2);
  EXPECT_FALSE(A::integer(fraction(1, 3)).ok());
  EXPECT_FALSE(A::integer(root(2)).ok());
}

}  // namespace
}  // namespace limn::test
