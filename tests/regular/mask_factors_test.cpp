// Factors of masks against the papers, and of random products against what went into them.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "limn/regular/regular_mask.h"
#include "limn/scheme/mask_rules.h"
#include "regular/wave_oracle.h"

namespace limn::test {
namespace {

using Counts = std::vector<std::pair<LatticeVector, int>>;

constexpr LatticeMatrix kDyadic{{{{2, 0}, {0, 2}}}};
constexpr LatticeMatrix kTernary{{{{3, 0}, {0, 3}}}};

/// a times (1 + … + z^{(p-1) d})/p, by twice the offset, centred.
Laurent smoothed(const Laurent& a, LatticeVector d, int p) {
  Laurent result;
  for (const auto& [k, value] : a)
    for (int i = 0; i < p; ++i)
      result[{k[0] + (2 * i - p + 1) * d[0], k[1] + (2 * i - p + 1) * d[1]}] += value / p;
  for (auto term = result.begin(); term != result.end();)
    term = term->second == 0 ? result.erase(term) : std::next(term);
  return result;
}

Laurent hexagon(const Rational& centre, const Rational& ring) {
  Laurent a = {{{0, 0}, centre}};
  for (const Exponents k : {Exponents{2, 0}, {0, 2}, {2, 2}}) a[k] = a[{-k[0], -k[1]}] = ring;
  return a;
}

TEST(MaskFactors, MakeTheMaskAgain) {
  for (const auto& [name, mask] : many_masks())
    EXPECT_EQ(expand(factor(mask), mask), mask.coefficients) << name;
}

TEST(MaskFactors, AreThoseOfThePapers) {
  const Laurent one = {{{0, 0}, Rational(1)}};
  const Factorization loop = factor(shipped_mask("loop"));
  EXPECT_EQ(loop.stages, 2);
  EXPECT_TRUE(loop.directions.empty());
  EXPECT_EQ(loop.kernel, one);

  // (14): 1/8 of 2 at the centre and the ring, and -1 at the six beyond the edges
  Laurent kernel14 = hexagon(Rational(1, 4), Rational(1, 4));
  for (const Exponents k : {Exponents{4, 2}, {2, 4}, {2, -2}})
    kernel14[k] = kernel14[{-k[0], -k[1]}] = Rational(-1, 8);
  const Factorization butterfly = factor(shipped_mask("butterfly"));
  EXPECT_EQ(butterfly.stages, 1);
  EXPECT_TRUE(butterfly.directions.empty());
  EXPECT_EQ(butterfly.kernel, kernel14);

  const Factorization third = factor(shipped_mask("interpolating-loop"));  // (18)
  EXPECT_EQ(third.stages, 2);
  EXPECT_TRUE(third.directions.empty());
  EXPECT_EQ(third.kernel, hexagon(Rational(10, 4), Rational(-1, 4)));

  for (const auto& [name, stages] : {std::pair{"catmull-clark", 4}, {"doo-sabin", 3}}) {
    const Factorization spline = factor(shipped_mask(name));
    EXPECT_EQ(spline.stages, stages) << name;
    EXPECT_TRUE(spline.directions.empty()) << name;
    EXPECT_EQ(spline.kernel, one) << name;
  }
  const Factorization ternary = factor(ternary_box_spline());
  EXPECT_EQ(ternary.stages, 2);
  EXPECT_TRUE(ternary.directions.empty());
  EXPECT_EQ(ternary.kernel, one);
}

TEST(MaskFactors, TheStageIsThePapersMask) {
  // (3): 1/8 of 2 at the centre and 1 at the six
  EXPECT_EQ(smoothing_stage(Lattice::triangle, kDyadic), hexagon(Rational(1, 4), Rational(1, 8)));
  const Laurent one = {{{0, 0}, Rational(1)}};
  EXPECT_EQ(smoothing_stage(Lattice::quad, kDyadic), smoothed(smoothed(one, {1, 0}, 2), {0, 1}, 2));
  EXPECT_EQ(scheme::smoothing_direction({1, -2}, kTernary), smoothed(one, {1, -2}, 3));
}

/// Counts of the kind that factor gives, from counts of all directions.
Counts left_over(Counts counts, Lattice lattice, int& stages) {
  std::vector<LatticeVector> edges = {{1, 0}, {0, 1}};
  if (lattice == Lattice::triangle) edges.push_back({1, 1});
  const auto is_edge = [&](LatticeVector d) {
    return std::find(edges.begin(), edges.end(), d) != edges.end();
  };
  stages = 1000;
  for (const auto& [d, count] : counts)
    if (is_edge(d)) stages = std::min(stages, count);
  Counts left;
  for (const auto& [d, count] : counts)
    if (const int rest = count - (is_edge(d) ? stages : 0); rest > 0) left.emplace_back(d, rest);
  return left;
}

Counts normalized(Counts counts) {
  for (auto& [d, count] : counts)
    if (d[0] < 0 || (d[0] == 0 && d[1] < 0)) d = {-d[0], -d[1]};
  std::sort(counts.begin(), counts.end());
  return counts;
}

RC_GTEST_PROP(MaskFactors, AreFoundAgainInProducts, ()) {
  const bool ternary = *rc::gen::inRange(0, 3) == 0;
  const Lattice lattice = *rc::gen::element(Lattice::triangle, Lattice::quad);
  // point-symmetric, and nowhere 0 on |z1| = |z2| = 1, where all the boxes have their zeros
  Laurent mask;
  Rational sum = 0;
  for (const Exponents k : {Exponents{2, 0}, {0, 2}, {2, 2}, {4, -2}}) {
    const Rational w(*rc::gen::inRange(-3, 4), 5);
    if (w != 0) mask[k] = mask[{-k[0], -k[1]}] = w;
    sum += 2 * w;
  }
  mask[{0, 0}] = 20;
  sum += 20;
  const Laurent kernel = scaled(mask, 1 / sum);
  Counts counts;
  mask = scaled(kernel, ternary ? 9 : 4);
  for (const LatticeVector d :
       {LatticeVector{1, 0}, {0, 1}, {1, 1}, {1, -1}, {2, 1}, {1, 2}, {1, -2}}) {
    int count = *rc::gen::inRange(0, 3);
    if (d[0] + d[1] == 1 && d[0] * d[1] == 0) ++count;  // so that it is a mask: sum rules
    counts.emplace_back(d, count);
    for (int i = 0; i < count; ++i) mask = smoothed(mask, d, ternary ? 3 : 2);
  }
  const Mask product{lattice, ternary ? kTernary : kDyadic, mask};
  const Factorization found = factor(product);
  int stages = 0;
  const Counts directions = left_over(counts, lattice, stages);
  RC_ASSERT(found.stages == stages);
  RC_ASSERT(normalized(found.directions) == normalized(directions));
  RC_ASSERT(found.kernel == kernel);
  RC_ASSERT(expand(found, product) == mask);
}

}  // namespace
}  // namespace limn::test
