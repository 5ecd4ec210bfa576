// Several names at once: blocks and their slopes against difference quotients, solutions against
// closed forms and against one name after another.

#include "limn/tune/solve_system.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "limn/tune/closed_form.h"
#include "tuned.h"

namespace limn::test {
namespace {

double cosine(int n) { return std::cos(2 * M_PI / n); }

tune::SystemSolutions solved_system(const Scheme& scheme, const std::vector<std::string>& names,
                                    int n, const std::vector<std::string>& texts,
                                    const std::vector<std::string>& between = {}) {
  tune::FreedNames freed = tune::FreedNames::make(scheme, names).value();
  std::vector<Requirement> requirements;
  for (const std::string& text : texts)
    requirements.push_back(Requirement::parse(text, scheme).value());
  std::vector<SearchRange> ranges;
  for (const std::string& text : between) ranges.push_back(SearchRange::parse(text).value());
  std::vector<const SearchRange*> searched(names.size(), nullptr);
  for (std::size_t j = 0; j < ranges.size(); ++j) searched[j] = &ranges[j];
  return tune::solve_system_at(freed, requirements, n, searched).value();
}

std::vector<int> all_frequencies(int n) {
  std::vector<int> list;
  for (int omega = 0; omega <= n / 2; ++omega) list.push_back(omega);
  return list;
}

/// Of every shipped scheme the names that can be freed, three at most.
TEST(FreedNames, BlocksAndSlopesOfEveryScheme) {
  int tried = 0;
  for (const std::string& name : lattice_names()) {
    const Scheme scheme = shipped(name);
    std::vector<std::string> names = freeable_names(scheme);
    if (names.empty()) continue;
    names.resize(std::min<std::size_t>(names.size(), 3));
    tune::FreedNames freed = tune::FreedNames::make(scheme, names).value();
    for (const int n : {3, 5, 6, 9}) {
      std::vector<double> x;
      for (std::size_t j = 0; j < names.size(); ++j) x.push_back(freed.own_value(j, n).value());
      const Result<FrequencyBlocks> plain = freed.blocks(n, x);
      if (!plain) continue;
      const spectrum::BlockSlopes slopes = freed.slopes(n, x, all_frequencies(n)).value();
      ++tried;
      for (int omega = 0; omega <= n / 2; ++omega) {
        const auto at = static_cast<std::size_t>(omega);
        ASSERT_EQ(slopes.blocks.blocks[at].rows(), plain->blocks[at].rows()) << name << n;
        EXPECT_LT((slopes.blocks.blocks[at] - plain->blocks[at]).cwiseAbs().maxCoeff(), 1e-13)
            << name << " at valence " << n;
      }
      for (std::size_t j = 0; j < names.size(); ++j) {
        const double h = 1e-4;
        std::vector<double> above = x, below = x;
        above[j] += h;
        below[j] -= h;
        const spectrum::BlockSlopes up = freed.slopes(n, above, all_frequencies(n)).value();
        const spectrum::BlockSlopes down = freed.slopes(n, below, all_frequencies(n)).value();
        for (std::size_t at = 0; at < slopes.slopes.size(); ++at)
          EXPECT_LT(
              (slopes.slopes[at][j] - (up.blocks.blocks[at] - down.blocks.blocks[at]) / (2 * h))
                  .cwiseAbs()
                  .maxCoeff(),
              1e-6)
              << name << " at valence " << n << ", by " << names[j];
      }
    }
  }
  EXPECT_GT(tried, 20);
}

TEST(EigenvalueJet, HasTheSlopesOfClosedForms) {
  // of the Loop type: tangent b + 2c cos, cup b + 2c - n beta, c = 1/2 - b
  tune::FreedNames freed = tune::FreedNames::make(shipped("loop-type"), {"b", "beta"}).value();
  for (int n = 4; n <= 9; ++n) {
    const spectrum::BlockSlopes slopes = freed.slopes(n, {0.36, 0.25 / n}, {0, 1}).value();
    for (const int omega : {0, 1}) {
      const BlockSpectrum spectrum = approx_spectrum(slopes.blocks, omega);
      const number::Jet jet =
          spectrum::eigenvalue_jet(slopes, spectrum.eigenvalues[omega == 0 ? 1 : 0]).value();
      if (omega == 1) {
        EXPECT_NEAR(jet.value, 0.36 + 0.28 * cosine(n), 1e-14);
        EXPECT_NEAR(jet.slope(0), 1 - 2 * cosine(n), 1e-12);
        EXPECT_NEAR(jet.slope(1), 0, 1e-12);
      } else {
        EXPECT_NEAR(jet.value, 0.64 - 0.25, 1e-14);
        EXPECT_NEAR(jet.slope(0), -1, 1e-12);
        EXPECT_NEAR(jet.slope(1), -n, 1e-11);
      }
    }
  }
}

TEST(SolveSystem, FindsTheLoopTypeOfATangentAndACup) {
  for (const int n : {4, 5, 7, 8, 9}) {  // at 6 the tangent is 1/2 for every b
    const tune::SystemSolutions found =
        solved_system(shipped("loop-type"), {"b", "beta"}, n,
                      {"tangent = 2/5 + cos(2*pi/n)/5", "cup = 1/5"}, {"1/4,1/2", "0,1/n"});
    ASSERT_EQ(found.solutions.size(), 1U) << n << ": " << found.reason;
    // b + (1 - 2b) cos = 2/5 + cos/5 for b = 2/5; beta = (1 - b - 1/5)/n
    const tune::SystemSolution& one = found.solutions.front();
    EXPECT_NEAR(one.values[0], 2. / 5, 1e-13);
    EXPECT_NEAR(one.values[1], 2. / 5 / n, 1e-13);
    EXPECT_EQ(one.rationals[0], Rational(2, 5));
    EXPECT_EQ(one.rationals[1], Rational(2, 5 * n));
    EXPECT_EQ(one.holds, Truth::yes) << one.reason;
    EXPECT_LT(one.residual, 1e-15);
  }
}

TEST(SolveSystem, AgreesWithOneNameAlone) {
  for (int n = 4; n <= 8; ++n) {
    const std::vector<double> alone =
        holding(solved(shipped("sqrt3"), "alpha", "cup = tangent^2", n));
    const tune::SystemSolutions found =
        solved_system(shipped("sqrt3"), {"alpha"}, n, {"cup = tangent^2", "c1"});
    std::vector<double> values;
    for (const tune::SystemSolution& one : found.solutions)
      if (one.holds == Truth::yes) values.push_back(one.values[0]);
    ASSERT_FALSE(alone.empty());
    EXPECT_TRUE(std::any_of(values.begin(), values.end(), [&](double value) {
      return std::abs(value - alone.front()) < 1e-13;
    })) << n;
  }
}

TEST(SolveSystem, AsksTheRegularLatticeAboutFractions) {
  const tune::SystemSolutions found = solved_system(
      shipped("sqrt3"), {"alpha"}, 6, {"cup = tangent^2", "bounded-curvature"}, {"1/4,1/2"});
  ASSERT_EQ(found.solutions.size(), 1U) << found.reason;
  EXPECT_EQ(found.solutions[0].rationals[0], Rational(1, 3));
  EXPECT_EQ(found.solutions[0].holds, Truth::yes) << found.solutions[0].reason;
}

TEST(SolveSystem, TakesTheNearestOfManySolutions) {
  const int n = 7;
  const tune::SystemSolutions found =
      solved_system(shipped("loop-type"), {"b", "beta"}, n, {"cup = 1/5"}, {"0,1/2", "0,1/n"});
  ASSERT_EQ(found.solutions.size(), 1U) << found.reason;
  EXPECT_EQ(found.starts, 1);
  const double b = found.solutions[0].values[0], beta = found.solutions[0].values[1];
  EXPECT_NEAR(1 - b - n * beta, 1. / 5, 1e-13);
  // the least step from Loop's b = 3/8 along the gradient (-1/2, -1) in units of the ranges
  const double c = cosine(n), own = (5 / 8. - std::pow(3 / 8. + c / 4, 2)) / n;
  EXPECT_NEAR((b - 3 / 8.) / (1 / 2.) / ((beta - own) * n), 0.5, 1e-6);
}

TEST(SolveSystem, AsksTheOthersOfEachSolution) {
  const tune::SystemSolutions no =
      solved_system(shipped("loop-type"), {"b", "beta"}, 7,
                    {"tangent = 11/20", "cup = 1/4", "cup > tangent^2"}, {"1/4,1/2", "0,1/n"});
  ASSERT_EQ(no.solutions.size(), 1U);
  EXPECT_EQ(no.solutions[0].holds, Truth::no);
  EXPECT_NE(no.solutions[0].reason.find("is missed by 0.0525"), std::string::npos)
      << no.solutions[0].reason;
}

TEST(SolveSystem, LeavesOutWhatAValenceDoesNotHave) {
  const tune::SystemSolutions three = solved_system(shipped("loop-type"), {"beta"}, 3,
                                                    {"cup = 1/5", "saddle < tangent"}, {"0,1/n"});
  ASSERT_EQ(three.solutions.size(), 1U);
  EXPECT_EQ(three.solutions[0].holds, Truth::yes);
  const tune::SystemSolutions none =
      solved_system(shipped("loop-type"), {"beta"}, 3, {"saddle = 1/5"}, {"0,1/n"});
  EXPECT_TRUE(none.solutions.empty());
  EXPECT_FALSE(none.reason.empty());
}

TEST(SolveSystem, RefusesWhatCannotBeSolved) {
  const Scheme scheme = shipped("loop-type");
  EXPECT_FALSE(tune::FreedNames::make(scheme, {"b", "b"}));
  EXPECT_FALSE(tune::FreedNames::make(scheme, {}));
  tune::FreedNames freed = tune::FreedNames::make(scheme, {"beta"}).value();
  const auto refused = [&](const std::vector<std::string>& texts) {
    std::vector<Requirement> requirements;
    for (const std::string& text : texts)
      requirements.push_back(Requirement::parse(text, scheme).value());
    return tune::solve_system_at(freed, requirements, 5, {nullptr}).error().message;
  };
  EXPECT_NE(refused({"c1"}).find("no requirement is an equation"), std::string::npos);
  EXPECT_NE(refused({"cup = 1/4", "tangent = 1/2"}).find("2 equations"), std::string::npos);
}

TEST(ClosedForm, OfManyValences) {
  const std::vector<int> valences{3, 4, 5, 6, 7, 8, 9, 10};
  const auto form = [&](auto value) {
    std::vector<double> values;
    for (const int n : valences) values.push_back(value(n));
    return tune::closed_form(valences, values).value_or("none");
  };
  EXPECT_EQ(form([](int n) { return 3. / 8 / n; }), "(3/8)/n");
  EXPECT_EQ(form([](int) { return 5. / 9; }), "5/9");
  EXPECT_EQ(form([](int n) { return (4 - 2 * cosine(n)) / 9; }), "4/9 - 2/9*cos(2*pi/n)");
  EXPECT_EQ(form([](int n) { return (5 / 8. - std::pow(3 / 8. + cosine(n) / 4, 2)) / n; }),
            "(31/64 - 3/16*cos(2*pi/n) - 1/16*cos(2*pi/n)^2)/n");
  EXPECT_EQ(form([](int n) { return 1 / (3. + n); }), "none");
  EXPECT_EQ(form([](int n) { return std::sqrt(2.) * cosine(n); }), "none");
  EXPECT_FALSE(tune::closed_form({3, 4, 5, 6}, {1, 1, 1, 1}));
}

TEST(ClosedForm, OfOneValence) {
  EXPECT_EQ(tune::closed_form_at(5, (4 - 2 * cosine(5)) / 8).value_or("none"),
            "1/2 - 1/4*cos(2*pi/n)");
  EXPECT_EQ(tune::closed_form_at(7, (3 / 8. + cosine(7) / 4) / 7).value_or("none"),
            "(3/8 + 1/4*cos(2*pi/n))/n");
  EXPECT_FALSE(tune::closed_form_at(7, std::sqrt(2.) / 3));
}

}  // namespace
}  // namespace limn::test
