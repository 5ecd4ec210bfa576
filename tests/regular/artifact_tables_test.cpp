// [ADS, Tables 1-3], typed from the paper with its misprints mended, against the components that
// limn derives from the masks; and limn's own formulas, read by limn's own parser.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>

#include "limn/regular/formula.h"
#include "limn/scheme/evaluate.h"
#include "limn/scheme/expression.h"
#include "regular/wave_oracle.h"

namespace limn::test {
namespace {

constexpr double kPi = std::numbers::pi;
using Four = std::vector<double>;

/// cos of the phase per refined edge in each direction, and of their differences.
struct Cosines {
  double c1, c2, c3, c12, c13, c23;
};

Cosines cosines_of_phases(double t1, double t2, double t3) {
  return {std::cos(t1),      std::cos(t2),      std::cos(t3),
          std::cos(t1 - t2), std::cos(t1 - t3), std::cos(t2 - t3)};
}

/// X1 = (1, 0), X2 = (-1/2, √3/2), X3 = (-1/2, -√3/2): they sum to 0, where [ADS, Fig. 2] lost a
/// minus.
Cosines cosines(Frequency f) {
  const double x = f[0] / 2, y = f[1] * kSqrt3 / 2;
  return cosines_of_phases(kPi * f[0], kPi * (y - x), kPi * (-x - y));
}

Four table_1(const Cosines& c) {
  const auto [c1, c2, c3, c12, c13, c23] = c;
  return {(3 + c1 + c2 + c3) * std::pow(1 + c1 + c2 + c3, 2) / 96,
          (3 + c1 - c2 - c3) * std::pow(1 + c1 - c2 - c3, 2) / 96,
          (3 - c1 + c2 - c3) * std::pow(1 - c1 + c2 - c3, 2) / 96,
          (3 - c1 - c2 + c3) * std::pow(1 - c1 - c2 + c3, 2) / 96};
}

Four table_2(const Cosines& c) {
  const auto [c1, c2, c3, c12, c13, c23] = c;
  return {(1 + 2 * (c1 + c2 + c3) - (c12 + c13 + c23)) * (1 + c1 + c2 + c3) / 16,
          (1 + 2 * (c1 - c2 - c3) - (-c12 - c13 + c23)) * (1 + c1 - c2 - c3) / 16,
          (1 + 2 * (-c1 + c2 - c3) - (-c12 + c13 - c23)) * (1 - c1 + c2 - c3) / 16,
          (1 + 2 * (-c1 - c2 + c3) - (c12 - c13 - c23)) * (1 - c1 - c2 + c3) / 16};
}

Four table_3(const Cosines& c) {
  const auto [c1, c2, c3, c12, c13, c23] = c;
  return {(5 - c1 - c2 - c3) * std::pow(1 + c1 + c2 + c3, 2) / 32,
          (5 - c1 + c2 + c3) * std::pow(1 + c1 - c2 - c3, 2) / 32,
          (5 + c1 - c2 + c3) * std::pow(1 - c1 + c2 - c3, 2) / 32,
          (5 + c1 + c2 - c3) * std::pow(1 - c1 - c2 + c3, 2) / 32};
}

struct Table {
  std::string scheme;
  Four (*values)(const Cosines&);
};
const std::vector<Table> kTables = {
    {"loop", table_1}, {"butterfly", table_2}, {"interpolating-loop", table_3}};

TEST(AdsTables, AreTheComponentsInTheLimit) {
  for (const Table& table : kTables) {
    const ArtifactAnalysis& analysis = shipped_analysis(table.scheme);
    for (const Frequency& f : some_frequencies(200))
      EXPECT_LT(distance(all(analysis.in_limit(f)), table.values(cosines(f))), 1e-13)
          << table.scheme << " at " << f[0] << ", " << f[1];
  }
}

TEST(AdsTables, AreTheComponentsAfterOneStepWhereTheSchemeInterpolates) {
  for (const Table& table : {kTables[1], kTables[2]})
    for (const Frequency& f : some_frequencies(50))
      EXPECT_LT(
          distance(all(shipped_analysis(table.scheme).after_steps(f, 1)), table.values(cosines(f))),
          1e-13);
}

TEST(AdsTables, StagesAloneMakeTheMatrixRN) {
  for (const Table& table : kTables) {
    const int own = shipped_analysis(table.scheme).factors().stages;
    EXPECT_EQ(own, table.scheme == "butterfly" ? 1 : 2);
    for (const Frequency& f : some_frequencies(20)) {
      const auto [c1, c2, c3, c12, c13, c23] = cosines(f);
      const Four once = {(1 + c1 + c2 + c3) / 4, (1 + c1 - c2 - c3) / 4, (1 - c1 + c2 - c3) / 4,
                         (1 - c1 - c2 + c3) / 4};
      for (int stages = 0; stages <= 4; ++stages) {
        Four power = {1, 1, 1, 1};
        for (int s = 0; s < stages; ++s)
          for (std::size_t i = 0; i < 4; ++i) power[i] *= once[i];
        EXPECT_LT(distance(all(shipped_analysis(table.scheme).after_stages(f, stages)), power),
                  1e-14);
      }
    }
  }
}

/// f with phases t1, t2 per refined edge.
Frequency frequency_of(double t1, double t2) {
  return frequency_along(Lattice::triangle, t1 / kPi, t2 / kPi);
}

TEST(AdsTables, GiveTheNumbersThatWereWorkedOutByHand) {
  const std::vector<Four> generic = {{.263106, .017555, .050043, .002629},
                                     {.635055, .062660, .199576, .102709},
                                     {.646848, .098955, .222722, .031475}};
  const Cosines c = cosines_of_phases(.3 * kPi, .2 * kPi, -.5 * kPi);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(distance(kTables[i].values(c), generic[i]), 6e-7) << kTables[i].scheme;
    const Components found =
        shipped_analysis(kTables[i].scheme).in_limit(frequency_of(.3 * kPi, .2 * kPi));
    EXPECT_LT(distance(all(found), generic[i]), 6e-7) << kTables[i].scheme;
  }
}

TEST(AdsTables, GiveTheNumbersPerpendicularToAnEdge) {
  // c1 = 1, c2 = c3 = cos θ: "c2 = … = 0" in [ADS §2.3] should read so
  for (const double theta : {kPi / 4, kPi / 2, 1., 2.}) {
    const Frequency f = frequency_of(0, theta);
    EXPECT_NEAR(f[0], 0, 1e-16);
    const double c = std::cos(theta);
    for (const char* scheme : {"butterfly", "interpolating-loop"})
      EXPECT_LT(distance(all(shipped_analysis(scheme).in_limit(f)),
                         {(2 - c) * (1 + c) * (1 + c) / 4, (2 + c) * (1 - c) * (1 - c) / 4, 0, 0}),
                1e-14);
  }
  const ArtifactAnalysis& loop = shipped_analysis("loop");
  EXPECT_LT(distance(all(loop.in_limit(frequency_of(0, kPi / 4))), {.657424, .009243, 0, 0}), 6e-7);
  EXPECT_LT(distance(all(loop.in_limit(frequency_of(0, kPi / 2))), {1 / 6., 1 / 6., 0, 0}), 1e-14);
}

TEST(AdsTables, SumsAndMeansAreThePapers) {
  for (const Frequency& f : some_frequencies(20)) {
    const Four t = table_1(cosines(f));
    const Components found = shipped_analysis("loop").in_limit(f);
    const double energy = std::sqrt((t[1] * t[1] + t[2] * t[2] + t[3] * t[3]) / 3);
    EXPECT_NEAR(found.sum(), t[1] + t[2] + t[3], 1e-14);
    EXPECT_NEAR(found.mean_energy(), energy, 1e-14);
    EXPECT_NEAR(found.percent_of_signal() / (100 * energy / t[0]), 1, 1e-10);
  }
  EXPECT_TRUE(std::isinf(Components{0, {1., 0., 0.}}.percent_of_signal()));
  EXPECT_NEAR((Components{-.5, {.3, 0., 0.}}.percent_of_signal()), 60 / kSqrt3, 1e-12);
}

/// The value of a formula in text, with the names that formula_names defines.
double value_of(const std::string& formula, const Mask& mask, Frequency f) {
  const auto& [top, bottom] = mask.dilation.rows;
  const double det = top[0] * bottom[1] - top[1] * bottom[0];
  // the refined basis vectors, M⁻¹ e1 and M⁻¹ e2, in the plane
  const Place r1 = plane(mask.lattice, {bottom[1] / det, -bottom[0] / det});
  const Place r2 = plane(mask.lattice, {-top[1] / det, top[0] / det});
  const double t1 = 2 * kPi * (f[0] * r1[0] + f[1] * r1[1]);
  const double t2 = 2 * kPi * (f[0] * r2[0] + f[1] * r2[1]), t3 = -t1 - t2;
  const Cosines c = cosines_of_phases(t1, t2, t3);
  const std::map<std::string, double> names = {{"t1", t1},     {"t2", t2},     {"t3", t3},
                                               {"c1", c.c1},   {"c2", c.c2},   {"c3", c.c3},
                                               {"c12", c.c12}, {"c13", c.c13}, {"c23", c.c23}};
  const Result<Expression> parsed = Expression::parse(formula);
  EXPECT_TRUE(parsed.ok()) << formula << ": " << parsed.error().text();
  if (!parsed) return std::nan("");
  const Result<double> value =
      limn::scheme::evaluate<double>(*parsed, [&](const std::string& name) -> Result<double> {
        const auto found = names.find(name);
        if (found == names.end()) return Error{"no such name: " + name};
        return found->second;
      });
  EXPECT_TRUE(value.ok()) << formula << ": " << value.error().text();
  return value ? *value : std::nan("");
}

/// Nobody reads a longer one, and Expression::parse does not either.
constexpr std::size_t kLongest = 2000;

void expect_formulas(const std::string& name, const Mask& mask,
                     const std::vector<std::string>& formulas,
                     const std::function<Components(Frequency)>& components) {
  ASSERT_EQ(formulas.size(), static_cast<std::size_t>(mask.dilation.growth())) << name;
  for (const Frequency& f : some_frequencies(8)) {
    std::vector<double> values;
    for (const std::string& formula : formulas) values.push_back(value_of(formula, mask, f));
    EXPECT_LT(distance(values, all(components(f)), is_dual(mask)), 1e-13)
        << name << ": " << formulas[0] << " … " << formulas.back();
  }
}

TEST(ArtifactFormulas, SayWhatTheComponentsAre) {
  for (const auto& [name, mask] : many_masks()) {
    const ArtifactAnalysis analysis = analysis_of(mask);
    const Result<std::vector<std::string>> limit =
        regular::limit_formulas(mask, number::Notation::text);
    ASSERT_TRUE(limit.ok()) << name << ": " << limit.error().text();
    if (name != "random" || limit->back().size() < kLongest)
      expect_formulas(name, mask, *limit, [&](Frequency f) { return analysis.in_limit(f); });
    expect_formulas(name, mask, regular::step_formulas(mask, number::Notation::text),
                    [&](Frequency f) { return analysis.after_steps(f, 1); });
  }
}

TEST(ArtifactFormulas, InLatexHaveTheirBracesAndNoStars) {
  for (const auto& [name, mask] : many_masks()) {
    std::vector<std::string> texts = regular::limit_formulas(mask, number::Notation::latex).value();
    for (const std::string& text : regular::step_formulas(mask, number::Notation::latex))
      texts.push_back(text);
    for (const std::string& text : regular::formula_names(mask, number::Notation::latex))
      texts.push_back(text);
    for (int i = 0; i < mask.dilation.growth(); ++i)
      texts.push_back(regular::component_name(i, number::Notation::latex));
    for (const std::string& text : texts) {
      int depth = 0;
      for (const char letter : text) {
        depth += letter == '{' ? 1 : letter == '}' ? -1 : 0;
        EXPECT_GE(depth, 0) << text;
        EXPECT_NE(letter, '*') << text;
      }
      EXPECT_EQ(depth, 0) << text;
      EXPECT_FALSE(text.empty());
    }
  }
}

TEST(ArtifactFormulas, NameTheComponentsByGreekLetters) {
  EXPECT_EQ(regular::component_name(0, number::Notation::text), "alpha");
  EXPECT_EQ(regular::component_name(1, number::Notation::latex), "\\beta");
  std::set<std::string> names;
  for (int i = 0; i < 9; ++i) names.insert(regular::component_name(i, number::Notation::text));
  EXPECT_EQ(names.size(), 9U);
}

}  // namespace
}  // namespace limn::test
