#include "limn/base/rational.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace limn {
namespace {

__extension__ using Wide = __int128;

/// Digit by digit, by what the compiler knows of its own integers.
std::string decimal(Wide value) {
  if (value == 0) return "0";
  const bool negative = value < 0;
  std::string text;
  for (; value != 0; value /= 10) {
    const int digit = static_cast<int>(value % 10);
    text.insert(text.begin(), static_cast<char>('0' + (negative ? -digit : digit)));
  }
  return negative ? "-" + text : text;
}

Wide greatest_common_divisor(Wide a, Wide b) {
  while (b != 0) a = std::exchange(b, a % b);
  return a < 0 ? -a : a;
}

std::string fraction_text(Wide above, Wide below) {
  const Wide common = greatest_common_divisor(above, below) * (below < 0 ? -1 : 1);
  above /= common;
  below /= common;
  return below == 1 ? decimal(above) : decimal(above) + "/" + decimal(below);
}

class Pairs : public testing::Test {
 protected:
  /// From a few bits to 63, of either sign, now and then 0.
  long long draw() {
    const auto bits = static_cast<long long>(random_());
    return bits >> (random_() % 64);
  }
  std::mt19937_64 random_{11};
};

TEST_F(Pairs, IntegersAreAsTheMachinesOwn) {
  for (int trial = 0; trial < 5000; ++trial) {
    const long long x = draw(), y = draw();
    const Integer a = x, b = y;
    EXPECT_EQ((a + b).str(), decimal(Wide{x} + y));
    EXPECT_EQ((a - b).str(), decimal(Wide{x} - y));
    EXPECT_EQ((a * b).str(), decimal(Wide{x} * y));
    EXPECT_EQ((-a).str(), decimal(-Wide{x}));
    EXPECT_EQ(abs(a).str(), decimal(x < 0 ? -Wide{x} : Wide{x}));
    EXPECT_EQ(a < b, x < y);
    EXPECT_EQ(a == b, x == y);
    EXPECT_EQ(a.sign(), x < 0 ? -1 : x > 0 ? 1 : 0);
    EXPECT_EQ(gcd(a, b).str(), decimal(greatest_common_divisor(x, y)));
    EXPECT_EQ(a.convert_to<long long>(), x);
    EXPECT_EQ(a.convert_to<double>(), static_cast<double>(x));
    if (x > 0) {
      EXPECT_EQ(msb(a),
                63 - static_cast<std::size_t>(__builtin_clzll(static_cast<unsigned long long>(x))));
    }
    if (y == 0) continue;
    EXPECT_EQ((a / b).str(), decimal(Wide{x} / y));
    EXPECT_EQ((a % b).str(), decimal(Wide{x} % y));
    if (x != 0) {
      const Wide common = greatest_common_divisor(x, y);
      const Wide least = Wide{x} / common * y;
      EXPECT_EQ(lcm(a, b).str(), decimal(least < 0 ? -least : least));
    }
  }
}

TEST_F(Pairs, FractionsAreInLowestTerms) {
  for (int trial = 0; trial < 5000; ++trial) {
    // 30 bits, so that a common denominator and its numerators fit in 128
    const auto small = [&] { return static_cast<int>(draw() >> 34); };
    const Wide p = small(), r = small();
    const Wide q = small() | 1, s = small() | 1;
    const Rational a(static_cast<long long>(p), static_cast<long long>(q));
    const Rational b(static_cast<long long>(r), static_cast<long long>(s));
    EXPECT_EQ(a.str(), fraction_text(p, q));
    EXPECT_EQ((a + b).str(), fraction_text(p * s + r * q, q * s));
    EXPECT_EQ((a - b).str(), fraction_text(p * s - r * q, q * s));
    EXPECT_EQ((a * b).str(), fraction_text(p * r, q * s));
    EXPECT_EQ((-a).str(), fraction_text(-p, q));
    EXPECT_EQ(a == b, p * s == r * q);
    EXPECT_EQ(a < b, (p * s < r * q) == (q * s > 0) && p * s != r * q);
    const auto whole = static_cast<int>(r);
    EXPECT_EQ(a < whole, a < Rational(whole));
    EXPECT_EQ(a == whole, a == Rational(whole));
    EXPECT_EQ(whole < a, Rational(whole) < a);
    EXPECT_EQ(is_integer(a), p % q == 0);
    EXPECT_GT(denominator(a), 0);
    EXPECT_EQ(Rational(numerator(a), denominator(a)), a);
    EXPECT_EQ(Rational(a.str()), a);
    EXPECT_NEAR(to_double(a), static_cast<double>(p) / static_cast<double>(q),
                std::abs(to_double(a)) * std::numeric_limits<double>::epsilon());
    if (r != 0) {
      EXPECT_EQ((a / b).str(), fraction_text(p * s, q * r));
    }
  }
}

TEST(LongNumbers, KeepAllDigits) {
  Integer factorial = 1;
  for (int i = 2; i <= 30; ++i) factorial *= i;
  EXPECT_EQ(factorial.str(), "265252859812191058636308480000000");
  EXPECT_EQ(Integer("265252859812191058636308480000000"), factorial);
  EXPECT_EQ(pow(Integer(2), 100).str(), "1267650600228229401496703205376");
  EXPECT_EQ(Integer(1) << 100, pow(Integer(2), 100));
  EXPECT_EQ(msb(pow(Integer(2), 100)), 100U);
  EXPECT_EQ(sqrt(factorial * factorial), factorial);
  EXPECT_EQ(sqrt(factorial * factorial - 1), factorial - 1);
  EXPECT_EQ(Integer(std::numeric_limits<std::uint64_t>::max()).str(), "18446744073709551615");
  EXPECT_EQ(Integer(std::numeric_limits<std::uint64_t>::max()).convert_to<std::uint64_t>(),
            std::numeric_limits<std::uint64_t>::max());
  EXPECT_DOUBLE_EQ(to_double(Rational(factorial * 2, factorial * 3)), 2.0 / 3);
  EXPECT_EQ(Rational(0.375), Rational(3, 8));
  EXPECT_EQ(static_cast<double>(Rational(3, 8)), 0.375);
  EXPECT_EQ(Rational(0.1).str(), "3602879701896397/36028797018963968");
  // numerator and denominator beyond what a double holds
  EXPECT_DOUBLE_EQ(to_double(Rational(pow(Integer(10), 400), pow(Integer(10), 399) * 4)), 2.5);
}

TEST(LongNumbers, MoveAndAssign) {
  const Rational original(pow(Integer(7), 80), pow(Integer(5), 90));
  Rational copy = original;
  Rational moved = std::move(copy);
  EXPECT_EQ(moved, original);
  copy = moved;
  EXPECT_EQ(copy, original);
  moved = 3;
  EXPECT_EQ(copy, original);
  EXPECT_EQ(moved.str(), "3");
  copy += copy;
  EXPECT_EQ(copy, original * 2);
  copy -= copy;
  EXPECT_EQ(copy, 0);
  EXPECT_EQ(Rational(), 0);
  std::ostringstream text;
  text << Rational(-7, 24) << ' ' << Integer(-7);
  EXPECT_EQ(text.str(), "-7/24 -7");
}

TEST(LongNumbers, RefuseWhatIsNone) {
  EXPECT_THROW(Rational(1, 0), std::overflow_error);
  EXPECT_THROW(Rational(1) /= Rational(0), std::overflow_error);
  EXPECT_THROW(Integer(std::string("12a")), std::runtime_error);
  EXPECT_THROW(Rational(std::string("1/x")), std::runtime_error);
}

}  // namespace
}  // namespace limn
