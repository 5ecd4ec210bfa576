#include "limn/regular/algebra/determinant.h"

#include <gtest/gtest.h>

#include <random>

namespace limn {
namespace {

regular::RationalMatrix random_matrix(std::mt19937& random, std::size_t size) {
  std::uniform_int_distribution<int> above(-9, 9);
  std::uniform_int_distribution<int> below(1, 12);
  regular::RationalMatrix a(size);
  for (auto& row : a)
    for (std::size_t j = 0; j < size; ++j) row.emplace_back(above(random), below(random));
  return a;
}

/// By expansion along the first row: no division, no residue.
Rational expanded(const regular::RationalMatrix& a) {
  if (a.size() == 1) return a[0][0];
  Rational sum = 0;
  for (std::size_t j = 0; j < a.size(); ++j) {
    regular::RationalMatrix minor;
    for (std::size_t i = 1; i < a.size(); ++i) {
      minor.push_back(a[i]);
      minor.back().erase(minor.back().begin() + static_cast<std::ptrdiff_t>(j));
    }
    const Rational part = a[0][j] * expanded(minor);
    sum += j % 2 == 0 ? part : Rational(-part);
  }
  return sum;
}

TEST(Determinant, HasTheSignOfTheExpansion) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 200; ++trial) {
    const regular::RationalMatrix a =
        random_matrix(random, 1 + static_cast<std::size_t>(trial % 6));
    const Rational value = expanded(a);
    EXPECT_EQ(regular::sign_of_determinant(a), value.sign());
    EXPECT_EQ(regular::is_singular(a), value == 0);
  }
}

TEST(Determinant, SeesTheSmallestDifferenceFromASingularMatrix) {
  // two rows equal but for one part in 10⁶⁰: doubles, or one prime's residue, tell no sign
  std::mt19937 random(6);
  for (const int way : {-1, 0, 1}) {
    regular::RationalMatrix a = random_matrix(random, 40);
    for (std::size_t i = 0; i < 40; ++i) a[i][i] += 100;  // dominant, so of positive determinant
    a[1] = a[0];
    // the determinant is linear in row 1, so this is way·10⁻⁶⁰ times a cofactor's
    regular::RationalMatrix unit = a;
    unit[1].assign(40, Rational(0));
    unit[1][1] = 1;
    a[1][1] += Rational(way, pow(Integer(10), 60));
    EXPECT_EQ(regular::sign_of_determinant(a), way * *regular::sign_of_determinant(unit));
    EXPECT_EQ(regular::is_singular(a), way == 0);
  }
}

TEST(Determinant, EndsWhereAsked) {
  std::mt19937 random(7);
  EXPECT_EQ(regular::sign_of_determinant(random_matrix(random, 8), [] { return true; }),
            std::nullopt);
}

TEST(Determinant, ProductsAreThoseOfRationals) {
  std::mt19937 random(8);
  const regular::RationalMatrix a = random_matrix(random, 5), b = random_matrix(random, 5),
                                c = random_matrix(random, 5);
  EXPECT_EQ(regular::product_of({&a, &b, &c}), regular::product(regular::product(a, b), c));
}

}  // namespace
}  // namespace limn
