#include "limn/search/point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <sstream>

#include "limn/search/front.h"
#include "support/temporary_folder.h"
#include "toy.h"

namespace limn::test {
namespace {

search::Study study_of(const std::string& text) {
  Result<search::Study> study = search::parse_study(text, "toy.toml");
  EXPECT_TRUE(study) << study.error().text();
  return study ? *std::move(study) : search::Study{};
}

/// Loop's family with b and, at some valences, beta free; this quantity alone.
std::string with_beta(const std::string& quantity) {
  return "scheme = \"loop-type\"\nvalences = \"5, 7, 8\"\n"
         "[[free]]\nname = \"b\"\nlow = 0\nhigh = 1\n"
         "[[free]]\nname = \"beta\"\nvalences = \"5, 7\"\nlow = 0\nhigh = \"1/4\"\n"
         "[[objective]]\nvalue = \"" +
         quantity + "\"\ngoal = \"min\"\n";
}

const search::Point kPoint{Rational("5/16"), Rational("3/32"), Rational("1/16")};

double value_at(const std::string& quantity, const search::Point& point) {
  const search::Outcome outcome = search::evaluate_point(study_of(with_beta(quantity)), point);
  EXPECT_TRUE(outcome.feasible) << outcome.reason;
  return outcome.objectives[0].value_or(NAN);
}

/// [Kawaharada, Sugihara 2006]: tangent = b + 2c cos(2π/n), cup = b + 2c − nβ, c = 1/2 − b.
TEST(Point, HasTheEigenvaluesOfTheLiterature) {
  const double b = 5 / 16., c = 1 / 2. - b;
  for (const int n : {5, 7}) {
    const std::string at = "(" + std::to_string(n) + ")";
    const double beta = n == 5 ? 3 / 32. : 1 / 16.;
    EXPECT_NEAR(value_at("tangent" + at, kPoint), b + 2 * c * std::cos(2 * M_PI / n), 1e-13);
    EXPECT_NEAR(value_at("cup" + at, kPoint), b + 2 * c - n * beta, 1e-13);
    // at 5 a ring further out leads frequency 2
    if (n == 7)
      EXPECT_NEAR(value_at("saddle(7)", kPoint), b + 2 * c * std::cos(4 * M_PI / n), 1e-13);
  }
  // where beta is not free the scheme's own definition makes the cup tangent²
  EXPECT_NEAR(value_at("cup(8)", kPoint), std::pow(b + 2 * c * std::cos(M_PI / 4), 2), 1e-13);
  const double at5 =
      std::abs(b + 2 * c - 15 / 32. - std::pow(b + 2 * c * std::cos(2 * M_PI / 5), 2));
  const double at7 =
      std::abs(b + 2 * c - 7 / 16. - std::pow(b + 2 * c * std::cos(2 * M_PI / 7), 2));
  EXPECT_NEAR(value_at("cup_gap()", kPoint), std::max(at5, at7), 1e-13);
}

/// The family at Loop's and at the optimal scheme's parameter has the shipped schemes' numbers.
TEST(Point, IsTheShippedSchemeAtItsParameter) {
  const search::Study study = study_of(kLoopStudy);
  for (const auto& [b, name] : {std::pair{"3/8", "loop"}, std::pair{"1/3", "optimal"}}) {
    const search::Outcome point = search::evaluate_point(study, {Rational(b)});
    const search::Outcome shipped = search::evaluate_scheme(study, *find_scheme(name));
    ASSERT_TRUE(point.feasible) << point.reason;
    EXPECT_EQ(point.objectives, shipped.objectives) << name;
  }
  // the quartic box spline: second derivatives are Lipschitz and no more
  EXPECT_NEAR(*search::evaluate_point(study, {Rational("3/8")}).objectives[1], 3, 1e-2);
}

/// A quantity of Loop's surface over an octahedron of this size.
double energy_at(const std::string& quantity, double size) {
  const TemporaryFolder folder;
  std::ofstream mesh(folder / "octahedron.obj");
  for (const char* place : {"1 0 0", "0 1 0", "0 0 1", "-1 0 0", "0 -1 0", "0 0 -1"}) {
    std::istringstream numbers(place);
    mesh << "v";
    for (double x = 0; numbers >> x;) mesh << " " << size * x;
    mesh << "\n";
  }
  mesh << "f 1 2 3\nf 2 4 3\nf 4 5 3\nf 5 1 3\nf 2 1 6\nf 4 2 6\nf 5 4 6\nf 1 5 6\n";
  mesh.close();
  const Result<search::Study> study = search::parse_study(with_beta(quantity), folder / "toy.toml");
  EXPECT_TRUE(study) << study.error().text();
  EXPECT_EQ(study->files().size(), quantity.find("obj") == std::string::npos ? 0U : 1U);
  const search::Outcome outcome =
      search::evaluate_point(*study, {Rational("3/8"), Rational("3/32"), Rational("1/16")});
  EXPECT_TRUE(outcome.feasible) << outcome.reason;
  return outcome.objectives[0].value_or(NAN);
}

TEST(Point, TellsEnergiesOfSurfaces) {
  // k1² + k2² = (k1 - k2)² + 2 k1 k2, and the integral of k1 k2 is 4π of whatever sphere it is
  const double plate = energy_at("thin_plate(octahedron.obj, 4)", 1);
  EXPECT_GT(plate, 8 * M_PI * 0.995);
  EXPECT_LT(plate, 8 * M_PI * 1.5);
  EXPECT_NEAR(energy_at("thin_plate(octahedron.obj, 4)", 2), plate, 1e-9 * plate);
  const double variation = energy_at("curvature_variation(octahedron.obj, 4)", 1);
  EXPECT_GT(variation, 0);
  EXPECT_NEAR(energy_at("curvature_variation(octahedron.obj, 4)", 2), variation / 4,
              1e-9 * variation);
}

TEST(Point, TellsTheDistanceToAnotherScheme) {
  // at b = 3/8 the family is Loop's scheme, whose surface over an octahedron lies well inside
  EXPECT_NEAR(energy_at("distance(loop, octahedron.obj, 3)", 1), 0, 1e-12);
  const double apart = energy_at("distance(butterfly, octahedron.obj, 3)", 1);
  EXPECT_GT(apart, 5);
  EXPECT_LT(apart, 30);
  EXPECT_NEAR(energy_at("distance(butterfly, octahedron.obj, 3)", 3), apart, 1e-9 * apart);
}

TEST(Point, IsInfeasibleWithAReasonWhereThereIsNoScheme) {
  const search::Study study = study_of(with_beta("cup(5)"));
  const search::Outcome outcome = search::evaluate_point(
      study, {Rational("3/4"), Rational("1/16"), Rational("1/16")});  // range of b
  EXPECT_FALSE(outcome.feasible);
  EXPECT_NE(outcome.reason.find("3/4"), std::string::npos) << outcome.reason;
  EXPECT_GT(outcome.violation, 0);
  EXPECT_FALSE(outcome.objectives[0]);
}

TEST(Point, IsInfeasibleWhereADemandFails) {
  const search::Study study =
      study_of(with_beta("tangent(5)") +
               "[[require]]\nthat = \"cup = tangent^2\"\n"
               "[[require]]\nvalue = \"cup(5)\"\nat_most = 1\nat_least = \"1/8\"\n");
  const search::Outcome outcome = search::evaluate_point(study, kPoint);
  EXPECT_FALSE(outcome.feasible);
  EXPECT_EQ(outcome.demands[0], Truth::no);
  EXPECT_EQ(outcome.demands[1], Truth::yes);
  EXPECT_NE(outcome.reason.find("valence 5"), std::string::npos) << outcome.reason;
}

TEST(Point, IsCertifiedWhereLoopIs) {
  search::Study study =
      study_of(replaced(kLoopStudy, "that = \"c1\"", "that = \"c1\"\ncertified = true"));
  const search::Outcome loop = search::evaluate_point(study, {Rational("3/8")});
  EXPECT_TRUE(loop.feasible) << loop.reason;
  EXPECT_EQ(loop.demands[0], Truth::yes);
  // without work there is no proof, and what is not proved does not count
  study.effort.certificate_parts = 1;
  const search::Outcome hasty = search::evaluate_point(study, {Rational("3/8")});
  EXPECT_FALSE(hasty.feasible);
  EXPECT_EQ(hasty.demands[0], Truth::undecided);
}

TEST(Point, WritesWhatItEvaluates) {
  const search::Study study = study_of(with_beta("cup(5)"));
  const Result<Scheme> back =
      parse_scheme(search::point_text(study, kPoint, "loop-type"), "back.toml");
  ASSERT_TRUE(back) << back.error().text();
  EXPECT_EQ(search::evaluate_scheme(study, *back).objectives,
            search::evaluate_point(study, kPoint).objectives);
}

TEST(Point, SnapsToShortFractions) {
  EXPECT_EQ(search::snapped(0.5), Rational("1/2"));
  EXPECT_EQ(search::snapped(-1), 0);
  EXPECT_EQ(search::snapped(7), 1);
  EXPECT_NEAR(to_double(search::snapped(0.3)), 0.3, 1e-6);
}

TEST(Front, IsThatOfBruteForce) {
  const search::Study study = study_of(kLoopStudy);  // the first small, the second large
  std::vector<search::Evaluated> points;
  std::uint32_t state = 5;
  const auto draw = [&state] {
    return static_cast<double>((state = state * 1664525U + 1013904223U) >> 28);
  };
  for (int i = 0; i < 200; ++i) {
    search::Evaluated one;
    one.place = i;
    one.outcome.feasible = i % 5 != 0;
    one.outcome.objectives = {draw(), draw()};
    points.push_back(one);
  }
  const auto worth = [&](std::size_t i) { return search::fitness(study, points[i].outcome); };
  const std::vector<std::size_t> front = search::best_points(study, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].outcome.feasible) continue;
    bool covered = false;
    for (std::size_t j = 0; j < points.size(); ++j)
      if (points[j].outcome.feasible && worth(j)[0] <= worth(i)[0] && worth(j)[1] <= worth(i)[1] &&
          (worth(j) != worth(i) || j < i))
        covered = true;
    EXPECT_EQ(std::count(front.begin(), front.end(), i), covered ? 0 : 1) << i;
  }
  const std::vector<std::size_t> some = search::spread(study, points, front, 3);
  ASSERT_GE(some.size(), 2U);
  EXPECT_EQ(some.front(), front.front());
  EXPECT_EQ(some.back(), front.back());
}

}  // namespace
}  // namespace limn::test
