#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "limn/certify/all/range_proof.h"
#include "limn/certify/all/turn_range.h"
#include "limn/regular/regular_mask.h"
#include "limn/spectrum/eigencomponents.h"

namespace limn::certify {
namespace {

number::Ball ball_near(double value) {
  return number::Ball(value).widened(1e-12 * (1 + std::abs(value)));
}

bool holds(const number::Ball& enclosure, double value) {
  return enclosure.overlaps(ball_near(value));
}

/// An expression in n over a range of valences.
PowerBall over_range(const std::string& text) {
  const Result<Expression> expression = Expression::parse(text);
  EXPECT_TRUE(expression) << text;
  const auto lookup = [](const std::string&) -> Result<PowerBall> { return PowerBall::valence(); };
  const Result<PowerBall> value = scheme::evaluate<PowerBall>(*expression, lookup);
  EXPECT_TRUE(value) << text << ": " << (value ? "" : value.error().message);
  return value ? *value : PowerBall();
}

double at_valence(const std::string& text, double n) {
  const auto lookup = [n](const std::string&) -> Result<double> { return n; };
  return scheme::evaluate<double>(Expression::parse(text).value(), lookup).value();
}

constexpr const char* kExpressions[] = {
    "n",
    "1/n^2*n",
    "(n - 2)/n",
    "cos(2*pi/n)",
    "sin(pi/n)*n",
    "1/4 - cos(3*pi/n)/4",
    "(5/8 - (3/8 + cos(2*pi/n)/4)^2)/n",
    "sqrt(5*n^2 - 30*n + 49)/(8*n)",
    "(cos(2*pi/n) + 5 + sqrt((cos(2*pi/n) + 9)*(cos(2*pi/n) + 1)))/16",
    "(1 - cos(1/n))/(2 - 2*cos(1/n))",
    "(n^2 - 1)/(n + 1)",
    "2*pi/n - sin(2*pi/n)"};

RC_GTEST_PROP(PowerBall, HoldsTheValuesOfAllValences, ()) {
  const int first = *rc::gen::inRange(7, 400);
  const int width = *rc::gen::inRange(0, 60);
  const bool to_infinity = *rc::gen::arbitrary<bool>();
  const Rational end(Integer(1), Integer(first));
  const Rational begin = to_infinity ? Rational(0) : Rational(Integer(1), Integer(first + width));
  const ValenceRange range(interval_ball(begin, end));
  for (const char* text : kExpressions) {
    const PowerBall value = over_range(text);
    for (const int n : {first, first + width / 2, first + width}) {
      const double expected = at_valence(text, n) * std::pow(n, value.power());
      RC_ASSERT(holds(value.factor(), expected));
    }
  }
}

TEST(PowerBall, KnowsThePowerOfWhatTendsToZero) {
  const ValenceRange range(interval_ball(0, Rational(1, 20)));
  EXPECT_EQ(over_range("n").power(), -1);
  EXPECT_EQ(over_range("1/n^2*n").power(), 1);
  EXPECT_EQ(over_range("1/4 - cos(3*pi/n)/4").power(), 2);
  EXPECT_EQ(over_range("1 - (n - 2)/n").power(), 1);
  EXPECT_TRUE(over_range("1 - (n - 2)/n").factor().is_positive());
  EXPECT_EQ(over_range("(1 - cos(1/n))*n^2").power(), 0);
  EXPECT_TRUE(over_range("n - n").is_zero());
}

TEST(PowerBall, DecidesGuardsForAllValencesOrNotAtAll) {
  const ValenceRange range(interval_ball(0, Rational(1, 20)));
  using A = number::Arithmetic<PowerBall>;
  EXPECT_EQ(A::approx(over_range("n == 3")), 0);
  EXPECT_EQ(A::approx(over_range("n >= 12 and n != 6")), 1);
  const auto lookup = [](const std::string&) -> Result<PowerBall> { return PowerBall::valence(); };
  EXPECT_FALSE(scheme::evaluate<PowerBall>(Expression::parse("n < 30").value(), lookup));
  EXPECT_FALSE(scheme::evaluate<PowerBall>(Expression::parse("n % 2").value(), lookup));
  EXPECT_FALSE(scheme::evaluate<PowerBall>(Expression::parse("cos(n)").value(), lookup));
}

RC_GTEST_PROP(TurnRange, HoldsTheTurnsOfAllAngles, ()) {
  const double low = *rc::gen::inRange(0, 3'000) * 1e-3;
  const double width = std::pow(10.0, -*rc::gen::inRange(0, 9));
  const number::Ball w = number::Ball::between(low, low + width);
  const int numerator = *rc::gen::inRange(-5, 6);
  const int denominator = *rc::gen::inRange(1, 7);
  const double x = static_cast<double>(numerator) / denominator;
  const Turn<number::Ball> turn = turns_of(w)(numerator, denominator);
  const Turn<number::Ball> slope = turn_slopes_of(w)(numerator, denominator);
  const Turn<number::Ball> loss = turn_losses_of(w)(numerator, denominator);
  for (const double share : {0.01, 0.4, 0.97}) {
    const double at = low + share * width;
    const double angle = std::sqrt(at);
    const auto imaginary = [&](double u) { return std::sin(x * std::sqrt(u)) / std::sqrt(u); };
    RC_ASSERT(holds(turn.cosine, std::cos(x * angle)));
    RC_ASSERT(holds(turn.to_imaginary, imaginary(at)));
    RC_ASSERT(holds(turn.to_real, std::sin(x * angle) * angle));
    const double sinc = x == 0 ? 0 : std::sin(x * angle) / angle;
    const double change = at < 1e-3 ? -x * x * x / 6 : (x * std::cos(x * angle) - sinc) / (2 * at);
    const double rough = 1e-4;
    RC_ASSERT(slope.cosine.widened(rough).overlaps(number::Ball(-x * sinc / 2)));
    RC_ASSERT(slope.to_imaginary.widened(at < 1e-3 ? 1e-2 : rough).overlaps(number::Ball(change)));
    RC_ASSERT(
        slope.to_real.widened(at < 1e-3 ? 1e-2 : rough).overlaps(number::Ball(sinc + at * change)));
    const double half = std::sin(x * angle / 2);
    RC_ASSERT(loss.cosine.widened(1e-9).overlaps(number::Ball(2 * half * half / at)));
    RC_ASSERT(holds(loss.to_real, -sinc));
  }
}

TEST(TurnRange, NarrowSlopesAreDifferences) {
  const double at = 0.7;
  const double step = 1e-6;
  const auto turn = [](double w) { return turns_of(number::Ball(w))(3, 2); };
  const Turn<number::Ball> slope = turn_slopes_of(number::Ball(at))(3, 2);
  const auto expect = [&](const number::Ball& found, auto&& part) {
    const double difference = (part(turn(at + step)) - part(turn(at - step))).approx() / (2 * step);
    EXPECT_NEAR(found.approx(), difference, 1e-8);
  };
  expect(slope.cosine, [](const Turn<number::Ball>& t) { return t.cosine; });
  expect(slope.to_imaginary, [](const Turn<number::Ball>& t) { return t.to_imaginary; });
  expect(slope.to_real, [](const Turn<number::Ball>& t) { return t.to_real; });
}

/// Blocks of one valence from the weights one by one, imaginary parts over θ.
number::BallMatrix single_block(const Scheme& scheme, int n, int frequency) {
  const spectrum::SectorPattern pattern = exact_pattern(scheme, n).value();
  const RealBasis basis = real_basis(pattern);
  const NamedValues<number::Ball> values = named_values<number::Ball>(scheme, pattern, n).value();
  const number::Ball theta =
      number::Ball(2 * std::max(frequency, 1)) * number::Ball::pi() / number::Ball(n);
  const Phase<number::Ball> phase = [&](int numerator, int denominator) {
    const number::Ball angle =
        number::Ball(2 * frequency) * number::Ball::pi() *
        number::Ball(Rational(Integer(numerator), Integer(denominator) * Integer(n)));
    return Turn<number::Ball>(number::cos(angle), number::sin(angle) / theta,
                              number::sin(angle) * theta);
  };
  return RealBlock<number::Ball>(pattern, basis, values, phase, frequency == 0).make();
}

void expect_held(const number::BallMatrix& enclosure, const number::BallMatrix& single,
                 const std::string& what) {
  ASSERT_EQ(enclosure.rows(), single.rows()) << what;
  for (std::size_t i = 0; i < single.rows(); ++i)
    for (std::size_t j = 0; j < single.rows(); ++j)
      EXPECT_TRUE(single(i, j).widened(1e-25).overlaps(enclosure(i, j)))
          << what << ", row " << i << ", column " << j;
}

TEST(IntervalBlocks, HoldTheBlocksOfEachValence) {
  for (const char* name : {"loop", "catmull-clark", "sqrt3", "doo-sabin", "optimal-high",
                           "butterfly-modified", "laplacian-loop"}) {
    const Scheme scheme = find_scheme(name).value();
    const RangeRules rules = RangeRules::make(scheme, 12).value();
    for (const int n : {12, 17, 40, 63}) {
      const std::string what = std::string(name) + " at " + std::to_string(n);
      const Rational near(Integer(1), Integer(n));
      for (const Rational& begin : {Rational(0), Rational(near * Rational(99, 100))}) {
        const auto blocks = IntervalBlocks::make(rules, begin, near * Rational(101, 100));
        ASSERT_TRUE(blocks) << what << ": " << blocks.error().message;
        expect_held(blocks->tangent(), single_block(scheme, n, 1), what);
        const number::BallMatrix whole = single_block(scheme, n, 0);
        EnclosedPair one{number::Ball(1), std::vector<number::Ball>(whole.rows(), number::Ball(1)),
                         0};
        const std::size_t shift = rules.basis().has_center ? 1 : 0;
        for (const RealOrbit& orbit : rules.basis().orbits)
          if (orbit.imaginary != orbit.real) one.vector[orbit.imaginary + shift] = number::Ball(0);
        expect_held(blocks->constant(), deflated(whole, one), what);
        for (int frequency = 2; frequency <= rules.last_special(); ++frequency)
          expect_held(blocks->special(frequency).value(), single_block(scheme, n, frequency), what);
      }
      for (int frequency = rules.last_special() + 1; frequency <= n / 2; ++frequency) {
        const Rational turn(Integer(4 * frequency * frequency), Integer(n * n));  // θ²/π²
        const TurnBlocks blocks =
            turn_blocks(rules, turn * Rational(99, 100), turn * Rational(101, 100)).value();
        expect_held(blocks.block, single_block(scheme, n, frequency), what);
      }
    }
  }
}

/// The leader of a matrix's middle.
EnclosedPair leader(const number::BallMatrix& a) {
  const auto size = static_cast<Eigen::Index>(a.rows());
  Eigen::MatrixXd middle(size, size);
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < size; ++j)
      middle(i, j) = a(static_cast<std::size_t>(i), static_cast<std::size_t>(j)).approx();
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(middle);
  Eigen::Index k = 0;
  for (Eigen::Index i = 1; i < size; ++i)
    if (solver.eigenvalues()(i).real() > solver.eigenvalues()(k).real()) k = i;
  std::vector<double> vector;
  for (Eigen::Index i = 0; i < size; ++i) vector.push_back(solver.eigenvectors()(i, k).real());
  return enclose_eigenpair(a, solver.eigenvalues()(k).real(), vector).value();
}

// Against the other engine and closed forms.
TEST(IntervalBlocks, EncloseTangentAndItsDistanceFromTheCup) {
  const Scheme scheme = find_scheme("catmull-clark").value();
  const RangeRules rules = RangeRules::make(scheme, 12).value();
  FrequencyAnalysis analysis(scheme);
  for (const int n : {30, 100, 1000}) {
    const Eigencomponents at = approx_eigencomponents(analysis.blocks(n).value());
    const Rational end(Integer(1001), Integer(1000 * n));
    for (const Rational& begin : {Rational(0), Rational(end * Rational(998, 1000))}) {
      if (begin == 0 && n < 100) continue;
      const IntervalBlocks blocks = IntervalBlocks::make(rules, begin, end).value();
      const EnclosedPair tangent = leader(blocks.tangent());
      EXPECT_TRUE(holds(tangent.value, *at.tangent)) << n;
      const EnclosedPair cup = leader(blocks.cup_transposed());
      EXPECT_TRUE(holds(cup.value, *at.cup)) << n;
      const number::Ball gap = blocks.cup_gap(cup, tangent);
      EXPECT_TRUE(gap.widened(1e-9).overlaps(number::Ball((*at.tangent - *at.cup) * n)))
          << n << ": " << gap.to_string();
      EXPECT_LT(gap.radius(), 1);
    }
  }
}

bool agree(IntervalRing& ring, const CellSigns& signs, const CellMap& map, int cuts) {
  if (ring.agrees(map)) return true;
  if (cuts == 0) return false;
  for (std::size_t digit = 0; digit < 4; ++digit)
    if (!agree(ring, signs, signs.part(map, digit), cuts - 1)) return false;
  return true;
}

// The map of frequency 1's leading eigenvector winds once and is regular, that of its second folds.
TEST(IntervalRing, TellsARegularMapFromAFoldedOne) {
  const Scheme scheme = find_scheme("catmull-clark").value();
  const RangeRules rules = RangeRules::make(scheme, 12).value();
  const CellMatrices cells = cell_matrices(regular_mask(scheme).value()).value();
  const Contraction bounds = enclose_contraction(cells, kContracted, 100'000).value();
  const CellSigns signs(cells, bounds);
  const Rational t(1, 20);
  const IntervalBlocks blocks = IntervalBlocks::make(rules, t, t).value();
  const EnclosedPair first = leader(blocks.tangent());
  EnclosedPair second = leader(deflated(blocks.tangent(), first));
  const auto is_regular = [&](const EnclosedPair& pair) {
    IntervalRing ring(cells, signs, rules, blocks, pair);
    for (const LatticeVector cell : ring_cells(cells).value().cells)
      if (!agree(ring, signs, ring.map_on(cell).value(), 5)) return false;
    return true;
  };
  EXPECT_TRUE(is_regular(first));
  // an eigenvector of the deflated matrix is one of the whole matrix less a multiple of the first
  number::Ball share;
  for (std::size_t j = 0, column = 0; j < blocks.tangent().rows(); ++j)
    if (j != first.pivot)
      share.add_product(blocks.tangent()(first.pivot, j), second.vector[column++]);
  share /= second.value - first.value;
  std::vector<number::Ball> whole;
  for (std::size_t j = 0, row = 0; j < blocks.tangent().rows(); ++j)
    whole.push_back((j == first.pivot ? number::Ball(0) : second.vector[row++]) +
                    share * first.vector[j]);
  second.vector = whole;
  EXPECT_FALSE(is_regular(second));
}

TEST(TurnBlocks, SlopeOfTheLeadingEigenvalue) {
  // Loop: λ = 3/8 + cos(θ)/4, by θ²: -sin(θ)/(8θ)
  const Scheme scheme = find_scheme("loop").value();
  const RangeRules rules = RangeRules::make(scheme, 12).value();
  for (const int share : {0, 1, 3, 6}) {
    const TurnBlocks blocks =
        turn_blocks(rules, Rational(share, 10), Rational(100 * share + 1, 1000)).value();
    const double theta = std::numbers::pi * std::sqrt(share / 10.0 + 0.0005);
    const number::Ball slope =
        eigenvalue_slope(blocks, leader(blocks.block), leader(transposed(blocks.block)));
    EXPECT_TRUE(slope.overlaps(number::Ball(-std::sin(theta) / (8 * theta)))) << slope.to_string();
    EXPECT_LT(slope.radius(), 0.05);
  }
}

}  // namespace
}  // namespace limn::certify
