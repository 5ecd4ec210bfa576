// Hölder exponents in closed form, against the literature and against refined data.

#include "limn/regular/smoothness/attainment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "limn/regular/algebra/jordan.h"
#include "limn/regular/regular_mask.h"
#include "limn/regular/smoothness/growth_power.h"
#include "limn/regular/smoothness/transition_operators.h"
#include "shipped_mask.h"
#include "tensor_mask.h"

namespace limn {
namespace {

using test::mask_of;
using test::tensor;

HolderBracket holder_of(const Mask& mask, int budget = RegularityOptions().budget) {
  RegularityOptions options;
  options.budget = budget;
  return enclose_regularity(mask, options).value().holder;
}

Mask four_point() { return tensor({-1, 0, 9, 16, 9, 0, -1}, 16, 2); }

struct Stated {
  std::string name;
  std::vector<std::string> parameters;
  std::string exact;
  double value;
  Truth attained;
  int logarithm;
};

class ExactExponent : public ::testing::TestWithParam<Stated> {};

TEST_P(ExactExponent, IsNamedAndProved) {
  const HolderBracket found = holder_of(mask_of(GetParam().name, GetParam().parameters));
  EXPECT_EQ(found.exact, GetParam().exact);
  ASSERT_TRUE(found.upper.has_value());
  EXPECT_LE(found.lower, GetParam().value);
  EXPECT_GE(*found.upper, GetParam().value);
  EXPECT_LE(*found.upper - found.lower, 1e-13);
  EXPECT_TRUE(found.radius.exact);
  EXPECT_EQ(found.attained.verdict, GetParam().attained) << found.attained.reason;
  EXPECT_EQ(found.attained.logarithm, GetParam().logarithm);
  EXPECT_EQ(found.attained.order, static_cast<int>(std::ceil(GetParam().value)));
  EXPECT_FALSE(found.attained.reason.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Shipped, ExactExponent,
    ::testing::Values(
        // the derivative is almost Lipschitz, with the square of a logarithm
        // [GuglielmiProtasov2016]
        Stated{"butterfly", {}, "2", 2, Truth::no, 2},
        Stated{"butterfly-modified", {}, "2", 2, Truth::no, 2},
        Stated{"interpolating-loop", {}, "2", 2, Truth::no, 1},
        Stated{"optimal-high", {}, "log2(3)", std::log2(3), Truth::yes, 0},
        Stated{"laplacian-loop", {}, "log2(8/3)", std::log2(8. / 3), Truth::yes, 0},
        Stated{"laplacian-loop-low", {}, "log2(24/7)", std::log2(24. / 7), Truth::yes, 0},
        Stated{"loop", {}, "3", 3, Truth::yes, 0},
        Stated{"catmull-clark", {}, "3", 3, Truth::yes, 0},
        Stated{"doo-sabin", {}, "2", 2, Truth::yes, 0},
        Stated{"box-spline-triangle", {"i=3", "j=1", "k3=1"}, "1", 1, Truth::yes, 0},
        Stated{"box-spline-quad", {"i=6", "j=6"}, "5", 5, Truth::yes, 0}),
    [](const auto& of) {
      std::string name = of.param.name;
      std::replace(name.begin(), name.end(), '-', '_');
      return name + std::to_string(of.index);
    });

TEST(ExactExponent, OfTheFourPointSchemeHasALogarithm) {
  // [Dubuc1986]: the derivative's modulus of continuity is h log h
  const HolderBracket found = holder_of(four_point());
  EXPECT_EQ(found.exact, "2");
  EXPECT_EQ(found.lower, 2);
  EXPECT_EQ(*found.upper, 2);
  EXPECT_EQ(found.attained.verdict, Truth::no);
  EXPECT_EQ(found.attained.logarithm, 1);
  EXPECT_TRUE(found.attained.sharp);
}

TEST(ExactExponent, IsAnotherWhereAWeightIs) {
  EXPECT_EQ(holder_of(mask_of("laplacian-loop", {"a=1/8"})).exact, "log2(8/3)");
  EXPECT_EQ(holder_of(mask_of("laplacian-loop", {"a=1/8+1/1000"})).exact, "log2(125/47)");
  EXPECT_NE(holder_of(mask_of("butterfly", {"w=1/16+1/1000"}), 300).exact, "2");
  const Scheme wrong = parse_scheme(
                           "split = \"triangle-dyadic\"\nextends = \"loop\"\n[edge]\n"
                           "end = \"3/8 + 1/1000\"\nwing = \"1/8 - 1/1000\"\n",
                           "wrong.toml")
                           .value();
  EXPECT_NE(holder_of(regular_mask(wrong).value(), 300).exact, "3");
}

TEST(ExactExponent, IsNotNamedWhereNothingCloses) {
  for (const char* name : {"optimal", "sqrt3"}) {
    const HolderBracket found = holder_of(mask_of(name));
    EXPECT_EQ(found.exact, "") << name;
    EXPECT_EQ(found.attained.verdict, Truth::undecided) << name;
    EXPECT_EQ(found.attained.order, 0) << name;
    EXPECT_FALSE(found.attained.reason.empty()) << name;
  }
  // of unstable shifts differences tell a lower end alone; the directions tell the exponent
  const HolderBracket unstable = holder_of(mask_of("box-spline-quad", {"p=2", "q=2"}));
  EXPECT_FALSE(unstable.upper.has_value());
  EXPECT_NE(unstable.exact_reason, "");
}

/// Largest differences over h^order of the refined impulse, level by level.
std::vector<double> measured(const Mask& mask, int order, int levels) {
  const Laurent a = regular::integer_offsets(mask);
  int reach = 0;
  for (const auto& [k, value] : a) reach = std::max({reach, std::abs(k[0]), std::abs(k[1])});
  std::vector<double> values{1};
  int half = 0;
  std::vector<double> largest;
  for (int level = 1; level <= levels; ++level) {
    const int fine_half = 2 * half + reach;
    const int width = 2 * fine_half + 1;
    std::vector<double> fine(static_cast<std::size_t>(width * width), 0);
    const auto at = [](int x, int y, int side) { return static_cast<std::size_t>(x * side + y); };
    for (int x = -half; x <= half; ++x)
      for (int y = -half; y <= half; ++y)
        for (const auto& [k, value] : a)
          fine[at(2 * x + k[0] + fine_half, 2 * y + k[1] + fine_half, width)] +=
              to_double(value) * values[at(x + half, y + half, 2 * half + 1)];
    double most = 0;
    for (const Laurent& difference :
         regular::unit_differences(edge_directions(mask.lattice), order))
      for (int x = order; x < width - order; ++x)
        for (int y = order; y < width - order; ++y) {
          double sum = 0;
          for (const auto& [k, value] : difference)
            sum += to_double(value) * fine[at(x + k[0], y + k[1], width)];
          most = std::max(most, std::abs(sum));
        }
    largest.push_back(most * std::pow(2, order * level));
    values = std::move(fine);
    half = fine_half;
  }
  return largest;
}

/// Σ by levels of what grows like a polynomial of the level: its differences.
std::vector<double> increments(const std::vector<double>& values) {
  std::vector<double> result;
  for (std::size_t i = 1; i < values.size(); ++i) result.push_back(values[i] - values[i - 1]);
  return result;
}

TEST(Attainment, LogarithmsAreWhatRefinedDataShow) {
  const std::vector<double> butterfly =
      increments(increments(measured(mask_of("butterfly"), 2, 7)));
  for (std::size_t i = 2; i < butterfly.size(); ++i) EXPECT_NEAR(butterfly[i], 0.5, 1e-6);
  const std::vector<double> four = increments(measured(four_point(), 2, 6));
  for (std::size_t i = 1; i < four.size(); ++i) EXPECT_NEAR(four[i], 1.5, 1e-6);
  const std::vector<double> interpolating =
      increments(increments(measured(mask_of("interpolating-loop"), 2, 7)));
  EXPECT_LT(std::abs(interpolating.back()), 0.05);
  EXPECT_LT(std::abs(interpolating.back()), 0.9 * std::abs(interpolating[3]));
  const std::vector<double> loop = measured(mask_of("loop"), 3, 6);
  for (const double value : loop) EXPECT_LE(value, 4);
}

TEST(ExponentText, IsShort) {
  EXPECT_EQ(regular::exponent_text(Rational(-1, 4), 1, 4), "2");
  EXPECT_EQ(regular::exponent_text(Rational(1, 8), 2, 4), "3/2");
  EXPECT_EQ(regular::exponent_text(Rational(49, 576), 2, 4), "log2(24/7)");
  EXPECT_EQ(regular::exponent_text(Rational(1, 5), 3, 4), "log2(5)/3");
  EXPECT_EQ(regular::exponent_text(Rational(1, 9), 1, 3), "4");
  EXPECT_EQ(regular::exponent_text(Rational(1, 7), 1, 3), "2*log3(7)");
  EXPECT_EQ(regular::exponent_text(Rational(1, 27), 1, 9), "3");
}

regular::RationalMatrix matrix(const std::vector<std::vector<int>>& rows) {
  regular::RationalMatrix result;
  for (const std::vector<int>& row : rows) {
    result.emplace_back();
    for (const int entry : row) result.back().emplace_back(entry);
  }
  return result;
}

/// The same in another basis.
regular::RationalMatrix hidden(const regular::RationalMatrix& a) {
  const regular::RationalMatrix show = matrix({{1, 0, 0}, {2, 1, 0}, {-1, 3, 1}});
  const regular::RationalMatrix hide = matrix({{1, 0, 0}, {-2, 1, 0}, {7, -3, 1}});
  return regular::product(regular::product(show, a), hide);
}

TEST(JordanBlocks, AreCountedExactly) {
  EXPECT_EQ(regular::largest_jordan_block(hidden(matrix({{2, 1, 0}, {0, 2, 1}, {0, 0, 2}})), 2), 3);
  EXPECT_EQ(regular::largest_jordan_block(hidden(matrix({{2, 1, 0}, {0, 2, 0}, {0, 0, 2}})), 2), 2);
  EXPECT_EQ(regular::largest_jordan_block(hidden(matrix({{2, 1, 0}, {0, 3, 0}, {0, 0, 2}})), 2), 1);
  EXPECT_EQ(regular::largest_jordan_block(hidden(matrix({{2, 1, 0}, {0, 3, 0}, {0, 0, 2}})), 5), 0);
  EXPECT_EQ(regular::largest_jordan_block(matrix({{0, 0}, {0, 0}}), 0), 1);
}

TEST(GrowthPower, IsThatOfBlocksWhichActOnEachOther) {
  const auto power = [](const std::vector<regular::RationalMatrix>& matrices) {
    std::vector<regular::RationalMatrix> others;
    for (const regular::RationalMatrix& one : matrices) others.push_back(hidden(one));
    return regular::bound_growth_power(others, 1, 1);
  };
  const regular::RationalMatrix identity = matrix({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  // unlike diagonal blocks, so that the couplings are no matter of the basis
  EXPECT_EQ(power({matrix({{1, 0, 0}, {0, -1, 0}, {0, 0, 1}}), identity}), 0);
  EXPECT_EQ(power({matrix({{1, 1, 0}, {0, 1, 0}, {0, 0, 0}}), identity}), 1);
  EXPECT_EQ(power({matrix({{1, 1, 0}, {0, 1, 1}, {0, 0, 1}}), identity}), 2);
  // a change of basis takes the coupling away
  EXPECT_EQ(power({matrix({{1, 5, 0}, {0, -1, 0}, {0, 0, 0}})}), 0);
  // by way of a smaller block
  const std::vector<regular::RationalMatrix> through{matrix({{1, 1, 0}, {0, 0, 1}, {0, 0, 1}}),
                                                     matrix({{1, 0, 0}, {0, 0, 1}, {0, 0, 1}})};
  EXPECT_EQ(power(through), 1);
  EXPECT_EQ(power({matrix({{2, 0, 0}, {0, 1, 0}, {0, 0, 1}})}), std::nullopt);
}

}  // namespace
}  // namespace limn
