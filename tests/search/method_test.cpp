#include "limn/search/method.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "toy.h"

namespace limn::test {
namespace {

search::SearchSpace space_of(std::size_t dimension, std::size_t objectives = 1) {
  search::SearchSpace space;
  space.dimension = dimension;
  space.objectives = objectives;
  space.start.assign(dimension, Rational(Integer(1), Integer(2)));
  space.steps.assign(dimension, 3);
  return space;
}

std::unique_ptr<search::Method> made(search::MethodKind kind, const search::SearchSpace& space,
                                     long long points, int batch, std::uint64_t seed = 1) {
  return *search::make_method({kind, seed, points, batch}, space);
}

/// Least at (0.2, 0.7, 0.2, …), 0 there.
double valley(const std::vector<double>& x) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += std::pow(x[i] - (i % 2 == 0 ? 0.2 : 0.7), 2);
  return sum;
}

TEST(Method, GridHasEveryCombinationOnce) {
  const auto grid = made(search::MethodKind::grid, space_of(3), 27, 10);
  std::set<search::UnitPoint> met;
  std::vector<std::size_t> sizes;
  for (auto batch = grid->next(); !batch.empty(); batch = grid->next()) {
    sizes.push_back(batch.size());
    met.insert(batch.begin(), batch.end());
    grid->tell({});
  }
  EXPECT_EQ(sizes, (std::vector<std::size_t>{10, 10, 7}));
  EXPECT_EQ(met.size(), 27U);
  for (const search::UnitPoint& point : met)
    for (const Rational& u : point) EXPECT_TRUE(u * 2 == 0 || u * 2 == 1 || u * 2 == 2);
}

TEST(Method, SobolFillsEachIntervalEvenly) {
  // of a net in base 2 each dyadic interval of length 1/64 has one of the first 64 points; the
  // corner and the centre are left out
  const std::vector<search::UnitPoint> points = search::sobol_points(5, 62);
  for (std::size_t i = 0; i < 5; ++i) {
    std::set<int> cells;
    for (const search::UnitPoint& point : points)
      cells.insert(static_cast<int>(to_double(point[i]) * 64));
    EXPECT_EQ(cells.size(), 62U) << "coordinate " << i;
  }
}

TEST(Method, RandomFollowsItsSeed) {
  const search::SearchSpace space = space_of(4);
  const auto one = made(search::MethodKind::random, space, 20, 20, 7)->next();
  EXPECT_EQ(one, made(search::MethodKind::random, space, 20, 20, 7)->next());
  EXPECT_NE(one, made(search::MethodKind::random, space, 20, 20, 8)->next());
  EXPECT_EQ(one.size(), 20U);
}

TEST(Method, LocalGoesDownhill) {
  const auto local = made(search::MethodKind::local, space_of(2), 1000, 1);
  const auto [best, asked] = least(*local, valley, 1000);
  EXPECT_LT(best, 1e-9);
  EXPECT_LT(asked, 400);
}

TEST(Method, LocalFromSeveralStartsFindsTheDeeperOfTwoValleys) {
  // from the middle it goes down to 0.1 at 0.6; the deeper one is narrow, at 0.1
  const auto two = [](const std::vector<double>& x) {
    return std::min(0.1 + std::pow(x[0] - 0.6, 2), 4 * std::abs(x[0] - 0.1));
  };
  const auto alone = made(search::MethodKind::local, space_of(1), 1000, 1);
  EXPECT_NEAR(least(*alone, two, 1000).first, 0.1, 1e-6);
  const auto many = made(search::MethodKind::local, space_of(1), 1000, 16);
  EXPECT_LT(least(*many, two, 1000).first, 1e-4);
}

TEST(Method, GlobalFindsTheLeastOfManyValleys) {
  // Rastrigin's function, with its least at 0.4
  const auto ripples = [](const std::vector<double>& x) {
    double sum = 0;
    for (const double u : x) {
      const double z = 10 * (u - 0.4);
      sum += z * z + 3 * (1 - std::cos(2 * M_PI * z));
    }
    return sum;
  };
  const auto global = made(search::MethodKind::global, space_of(3), 4000, 40, 3);
  EXPECT_LT(least(*global, ripples, 6000).first, 1e-3);
}

/// Schaffer's problem: the front is f1 = z², f2 = (z - 2)² for z in [0, 2].
TEST(Method, ParetoCoversAKnownFront) {
  const search::SearchSpace space = space_of(2, 2);
  const auto pareto = made(search::MethodKind::pareto, space, 2000, 40, 5);
  std::vector<std::vector<double>> last;
  for (int generation = 0; generation < 40; ++generation) {
    last.clear();
    for (const search::UnitPoint& point : pareto->next()) {
      const double z = 6 * to_double(point[0]) - 2, off = to_double(point[1]);
      last.push_back({z * z + off, (z - 2) * (z - 2) + off});
    }
    ASSERT_EQ(last.size(), 40U);
    pareto->tell(last);
  }
  int near = 0;
  double low = 9, high = 0;
  for (const auto& f : last) {
    const double on_front = std::pow(std::sqrt(f[0]) - 2, 2);
    near += std::abs(f[1] - on_front) < 0.05 ? 1 : 0;
    low = std::min(low, f[0]);
    high = std::max(high, f[0]);
  }
  EXPECT_GE(near, 30);
  EXPECT_LT(low, 0.05);
  EXPECT_GT(high, 3);
}

class Replayed : public testing::TestWithParam<search::MethodKind> {};

/// What resuming rests on: a method that begins anew and hears the same asks the same.
TEST_P(Replayed, AsksTheSameAfterTheSameAnswers) {
  const bool pareto = GetParam() == search::MethodKind::pareto;
  const search::SearchSpace space = space_of(2, pareto ? 2 : 1);
  const auto first = made(GetParam(), space, 200, 8), second = made(GetParam(), space, 200, 8);
  for (int generation = 0; generation < 6; ++generation) {
    const auto batch = first->next();
    ASSERT_EQ(batch, second->next()) << generation;
    if (batch.empty()) break;
    std::vector<std::vector<double>> worth;
    for (const search::UnitPoint& point : batch) {
      const std::vector<double> x{to_double(point[0]), to_double(point[1])};
      worth.push_back(pareto ? std::vector<double>{valley(x), x[0]}
                             : std::vector<double>{valley(x)});
    }
    first->tell(worth);
    second->tell(worth);
  }
}
INSTANTIATE_TEST_SUITE_P(Methods, Replayed,
                         testing::Values(search::MethodKind::grid, search::MethodKind::random,
                                         search::MethodKind::sobol, search::MethodKind::local,
                                         search::MethodKind::global, search::MethodKind::pareto));

}  // namespace
}  // namespace limn::test
