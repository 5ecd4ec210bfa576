// Closed formulas of eigenvalues: against the numeric blocks at every valence and frequency with
// random parameters, against the literature's printed forms, and where there is none.

#include "limn/spectrum/eigen_formula.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include <fmt/core.h>

#include "limn/number/polynomial_factors.h"
#include "limn/scheme/scope.h"
#include "limn/spectrum/eigencomponents.h"
#include "support/shipped.h"

namespace limn {

using Complex = std::complex<double>;

namespace number {
/// So that the square root of a negative number is a number.
template <>
struct Arithmetic<Complex> {
  static Complex from(const Rational& q) { return to_double(q); }
  static Complex pi() { return M_PI; }
  static Result<Complex> add(Complex a, Complex b) { return a + b; }
  static Result<Complex> subtract(Complex a, Complex b) { return a - b; }
  static Result<Complex> multiply(Complex a, Complex b) { return a * b; }
  static Result<Complex> divide(Complex a, Complex b) { return a / b; }
  static Result<Complex> cos(Complex a) { return std::cos(a); }
  static Result<Complex> sin(Complex a) { return std::sin(a); }
  static Result<Complex> sqrt(Complex a) { return std::sqrt(a); }
  static Result<int> sign(Complex a) { return Arithmetic<double>::sign(a.real()); }
  static Result<long long> integer(Complex a) { return Arithmetic<double>::integer(a.real()); }
};
}  // namespace number

namespace test {
namespace {

/// A formula's value where the scheme's parameters have their present values.
Complex value(const Scheme& scheme, const EigenFormulas& formulas, const std::string& text, int n,
              int omega, Complex lambda = 0) {
  scheme::Scope<Complex> scope(scheme, n, std::nullopt);
  scope.give(formulas.frequency, omega);
  scope.give(formulas.unknown, lambda);
  for (const RegularName& regular : formulas.regular_names)
    for (const Parameter& parameter : scheme.parameters)
      if (parameter.name == regular.parameter)
        scope.give(
            regular.name,
            scheme::Scope<Complex>(scheme, regular.n, std::nullopt)(parameter.value).value());
  const Result<Expression> expression = Expression::parse(text);
  EXPECT_TRUE(expression.ok()) << text;
  const Result<Complex> result = scope(Formula{expression.value(), {}});
  EXPECT_TRUE(result.ok()) << text << ": " << result.error().text();
  return result ? *result : NAN;
}

const ValenceFormulas* at_valence(const EigenFormulas& formulas, int n) {
  const ValenceFormulas* found = nullptr;
  for (const ValenceFormulas& one : formulas.valences)
    for (const ValenceSpan span : one.valences)
      if (n >= span.first && n <= span.last.value_or(n)) {
        EXPECT_EQ(found, nullptr) << "two sets of formulas at " << n;
        found = &one;
      }
  return found;
}

const FrequencyFormulas* at_frequency(const ValenceFormulas& formulas, int omega) {
  for (const FrequencyFormulas& one : formulas.frequencies)
    if (one.frequency == omega || (one.and_above && one.frequency <= omega)) return &one;
  return nullptr;
}

/// Takes one eigenvalue with this value and ring (or fewer rings) out of the list.
bool take(std::vector<Eigenvalue>& list, Complex value, int ring, bool or_fewer) {
  for (auto one = list.begin(); one != list.end(); ++one)
    if ((one->ring == ring || (or_fewer && one->ring < ring)) &&
        std::abs(one->value - value) < 1e-9) {
      list.erase(one);
      return true;
    }
  return false;
}

std::string described(const std::vector<Eigenvalue>& list) {
  std::string text;
  for (const Eigenvalue& one : list)
    text += fmt::format("{:.12g}{:+.2g}i (ring {}) ", one.value.real(), one.value.imag(), one.ring);
  return text;
}

/// The formulas of one frequency are the eigenvalues of one block, with their rings.
void expect_eigenvalues(const Scheme& scheme, const EigenFormulas& formulas,
                        const FrequencyFormulas& at, std::vector<Eigenvalue> numeric, int n,
                        int omega) {
  const std::string where = fmt::format("{} n = {} omega = {}", scheme.name, n, omega);
  for (const EigenFormula& one : at.eigenvalues) {
    const Complex closed = value(scheme, formulas, one.root.text, n, omega);
    for (int i = 0; i < one.root.multiplicity; ++i)
      EXPECT_TRUE(take(numeric, closed, one.ring, 2 * omega == n))
          << where << ": " << one.root.text << ", " << closed << " of " << described(numeric);
    if (one.by_lets)
      EXPECT_LT(std::abs(value(scheme, formulas, one.by_lets->text, n, omega) - closed), 1e-12)
          << where << ": " << one.by_lets->text;
  }
  // what is left is the product of (lambda - eigenvalue), up to a factor
  const auto ratio = [&](Complex lambda) {
    Complex quotient = 1;
    for (const EigenEquation& one : at.left)
      for (int i = 0; i < one.polynomial.multiplicity; ++i)
        quotient *= value(scheme, formulas, one.polynomial.text, n, omega, lambda);
    for (const Eigenvalue& one : numeric) quotient /= lambda - one.value;
    return quotient;
  };
  std::size_t degrees = 0;
  for (const EigenEquation& one : at.left)
    degrees += static_cast<std::size_t>(one.degree * one.polynomial.multiplicity);
  ASSERT_EQ(degrees, numeric.size()) << where;
  for (const Complex lambda : {Complex(1.5), Complex(-2, 1), Complex(.3, 2)})
    EXPECT_LT(std::abs(ratio(lambda) / ratio(3.) - 1.), 1e-6) << where;
}

void expect_formulas_hold(const Scheme& scheme, const EigenFormulas& formulas, int last = 20) {
  int seen = 0;
  for (int n = 3; n <= last; ++n) {
    const ValenceFormulas* at = at_valence(formulas, n);
    if (at == nullptr) {
      EXPECT_FALSE(FrequencyAnalysis(scheme).blocks(n).ok()) << n;
      continue;
    }
    ++seen;
    FrequencyAnalysis analysis(scheme, at->rings);
    const Eigencomponents numeric = approx_eigencomponents(analysis.blocks(n).value());
    for (const BlockSpectrum& spectrum : numeric.spectra) {
      const FrequencyFormulas* frequency = at_frequency(*at, spectrum.frequency);
      ASSERT_NE(frequency, nullptr) << n << ' ' << spectrum.frequency;
      expect_eigenvalues(scheme, formulas, *frequency, spectrum.eigenvalues, n, spectrum.frequency);
    }
  }
  EXPECT_GT(seen, 0);
}

/// The scheme with other values of its parameters, where others are allowed.
Scheme with_random_parameters(const Scheme& scheme, std::mt19937& random) {
  Scheme changed = scheme;
  for (const Parameter& parameter : scheme.parameters) {
    // small ones in n too
    const std::string text = fmt::format("{}/997 + {}/(499*n)", 1 + random() % 90, random() % 40);
    if (!set_parameter(changed, parameter.name + "=" + text))
      (void)set_parameter(changed, fmt::format("{}={}/997", parameter.name, 1 + random() % 90));
  }
  return changed;
}

class WithFlint : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!number::factor(number::Polynomial(2))) GTEST_SKIP() << "built without FLINT";
  }
};
class EigenFormulaOf : public WithFlint, public ::testing::WithParamInterface<std::string> {};

TEST_P(EigenFormulaOf, IsTheEigenvalueOfTheBlocks) {
  const Scheme& scheme = shipped(GetParam());
  expect_formulas_hold(scheme, eigen_formulas(scheme).value());
}

TEST_P(EigenFormulaOf, HoldsForRandomParameters) {
  std::mt19937 random(7);
  for (int i = 0; i < 3; ++i) {
    const Scheme scheme = with_random_parameters(shipped(GetParam()), random);
    expect_formulas_hold(scheme, eigen_formulas(scheme).value(), 12);
    if (scheme.parameters.empty()) break;
  }
}

TEST_P(EigenFormulaOf, HoldsWithMoreRings) {
  const Scheme& scheme = shipped(GetParam());
  const int rings = eigen_formulas(scheme)->valences.front().rings;
  const Result<EigenFormulas> more = eigen_formulas(scheme, {}, rings + 1);
  ASSERT_TRUE(more.ok()) << more.error().text();
  expect_formulas_hold(scheme, *more, 9);
}

INSTANTIATE_TEST_SUITE_P(Shipped, EigenFormulaOf, ::testing::ValuesIn(lattice_names()),
                         [](const auto& info) { return test_name(info.param); });

class ClosedEigenvalues : public WithFlint {};

std::vector<std::string> texts(const EigenFormulas& formulas, int n, int omega,
                               bool by_lets = false) {
  std::vector<std::string> result;
  for (const EigenFormula& one : at_frequency(*at_valence(formulas, n), omega)->eigenvalues)
    result.push_back(by_lets && one.by_lets ? one.by_lets->text : one.root.text);
  return result;
}
using Texts = std::vector<std::string>;

TEST_F(ClosedEigenvalues, AreThoseOfTheLiterature) {
  const EigenFormulas loop = eigen_formulas(shipped("loop")).value();
  EXPECT_EQ(texts(loop, 7, 0), (Texts{"1", "(3/8 + cos(2*pi/n)/4)^2", "1/8", "1/16"}));
  EXPECT_EQ(texts(loop, 7, 0, true)[1], "5/8 - n*beta");
  EXPECT_EQ(texts(loop, 7, 1), (Texts{"3/8 + cos(2*pi*omega/n)/4", "1/8", "1/16"}));
  const EigenFormulas sqrt3 = eigen_formulas(shipped("sqrt3")).value();
  EXPECT_EQ(texts(sqrt3, 5, 0)[1], "4/9*cos(pi/n)^2");
  EXPECT_EQ(texts(sqrt3, 5, 0, true)[1], "2/3 - alpha");
  EXPECT_EQ(texts(sqrt3, 5, 0)[2], "(1 + sqrt(7))/18");
  EXPECT_EQ(texts(sqrt3, 5, 2)[0], "2/3*cos(pi*omega/n)");
  const EigenFormulas catmull_clark = eigen_formulas(shipped("catmull-clark")).value();
  EXPECT_EQ(texts(catmull_clark, 9, 0)[1], "(3*n - 7 + sqrt(5*n^2 - 30*n + 49))/(8*n)");
  EXPECT_EQ(texts(catmull_clark, 9, 1)[0],
            "(cos(2*pi*omega/n) + 5 + sqrt((cos(2*pi*omega/n) + 9)*(cos(2*pi*omega/n) + 1)))/16");
  const EigenFormulas optimal = eigen_formulas(shipped("optimal")).value();
  EXPECT_EQ(texts(optimal, 5, 1)[0], "1/3 + cos(2*pi*omega/n)/3");
  const EigenFormulas high_pass = eigen_formulas(shipped("laplacian-loop")).value();
  EXPECT_EQ(texts(high_pass, 5, 0, true)[1], "5/8 + a - n*beta");
  const EigenFormulas doo_sabin = eigen_formulas(shipped("doo-sabin")).value();
  EXPECT_EQ(texts(doo_sabin, 5, 1)[0], "1/2");
  EXPECT_EQ(texts(doo_sabin, 5, 2)[0], "1/4");
}

TEST_F(ClosedEigenvalues, AreWrittenAsLatex) {
  const EigenFormulas loop = eigen_formulas(shipped("loop")).value();
  const auto& frequencies = loop.valences.front().frequencies;
  EXPECT_EQ(frequencies[1].eigenvalues[0].root.latex,
            "\\frac{3}{8} + \\frac{1}{4} \\cos\\frac{2 \\pi \\omega}{n}");
  EXPECT_EQ(frequencies[0].eigenvalues[1].by_lets->latex, "\\frac{5}{8} - n \\beta");
}

/// KS: with the default a the high-pass cup is 3/8 + cos(3π/n)/4.
TEST_F(ClosedEigenvalues, PutParametersInThatAreToBeEvaluated) {
  const EigenFormulas formulas = eigen_formulas(shipped("laplacian-loop"), {"a"}).value();
  EXPECT_EQ(texts(formulas, 5, 0)[1], "3/8 + cos(3*pi/n)/4");
  EXPECT_TRUE(formulas.regular_names.empty());
  expect_formulas_hold(shipped("laplacian-loop"), formulas, 12);
  // the regular rules round the centre have the parameter at their own n
  const EigenFormulas symbolic = eigen_formulas(shipped("laplacian-loop")).value();
  ASSERT_EQ(symbolic.regular_names.size(), 1U);
  EXPECT_EQ(symbolic.regular_names.front().name, "a_6");
}

Scheme made(const std::string& rules) {
  Result<Scheme> scheme = parse_scheme(
      "name = \"made\"\nsplit = \"triangle-dyadic\"\nextends = \"loop\"\n" + rules, "made.toml");
  EXPECT_TRUE(scheme.ok()) << scheme.error().text();
  return *scheme;
}

TEST_F(ClosedEigenvalues, TellValencesApartThatAWeightDoes) {
  const Scheme guarded = made(
      "[vertex]\nself = \"5/8 - (n == 4)/8 - (n > 11)/16\"\n"
      "ring = \"(3/8 + (n == 4)/8 + (n > 11)/16)/n\"\n");
  const EigenFormulas formulas = eigen_formulas(guarded).value();
  EXPECT_EQ(formulas.valences.size(), 10U);  // 3, …, 11 and 12 on
  EXPECT_EQ(formulas.valences.back().valences.front().first, 12);
  EXPECT_FALSE(formulas.valences.back().valences.front().last.has_value());
  expect_formulas_hold(guarded, formulas);
}

/// cos(4πk/n) is met by omega = 2 alone from n = 5 on, and by others at n = 3 and 4.
TEST_F(ClosedEigenvalues, TellValencesApartWhereHarmonicsMeet) {
  const Scheme scheme = made(
      "[[edge-end]]\nwhen = \"n != 6\"\nself = \"3/4\"\n"
      "ring = \"(1/4 + cos(2*pi*k/n) + cos(4*pi*k/n)/2)/n\"\n");
  const EigenFormulas formulas = eigen_formulas(scheme).value();
  ASSERT_EQ(formulas.valences.size(), 4U);
  EXPECT_EQ(formulas.valences[2].valences.front().first, 5);
  expect_formulas_hold(scheme, formulas);
}

TEST_F(ClosedEigenvalues, SumWeightsThatTreatSomePositionsApart) {
  const char* const rings[] = {
      "(1/4 + cos(2*pi*k/n) + cos(4*pi*k/n)/2)/n + ((k == 1) + (k == n - 1))/50 - (k == 0)/25",
      "(1/4 + cos(2*pi*k/n)^2 - 1/2)/n + ((k <= 2) + (k > n - 3) - 5*(k == 0))/50 "
      "+ ((k > 2) and (k <= n - 3))*0",
  };
  for (const std::string ring : rings) {
    const Scheme scheme =
        made("[[edge-end]]\nwhen = \"n != 6\"\nself = \"3/4\"\nring = \"" + ring + "\"\n");
    const Result<EigenFormulas> formulas = eigen_formulas(scheme);
    ASSERT_TRUE(formulas.ok()) << formulas.error().text();
    expect_formulas_hold(scheme, *formulas, 14);
  }
}

TEST_F(ClosedEigenvalues, KeepRootsAndFractionsOfAllKinds) {
  for (const std::string beta :
       {"sqrt(2)/(4*n)", "1/(n + sqrt(n))", "sqrt(3 + cos(2*pi/n))/(8*n)",
        "(sin(pi/n)^2 + 1/4)/(2*n)", "(1 + sqrt(3))/(6*n + 2)", "sqrt(2)*sqrt(3)/(10*n)"}) {
    const Scheme scheme =
        made("[let]\nb = \"" + beta + "\"\n[vertex]\nself = \"1 - n*b\"\nring = \"b\"\n");
    const Result<EigenFormulas> formulas = eigen_formulas(scheme);
    ASSERT_TRUE(formulas.ok()) << beta << ": " << formulas.error().text();
    expect_formulas_hold(scheme, *formulas, 9);
  }
}

TEST_F(ClosedEigenvalues, KeepALetThatHasNoFormula) {
  const Scheme scheme =
      made("[let]\nb = \"(3/8 + (n % 2)/16)/n\"\n[vertex]\nself = \"1 - n*b\"\nring = \"b\"\n");
  const EigenFormulas formulas = eigen_formulas(scheme).value();
  EXPECT_EQ(texts(formulas, 7, 0)[1], "5/8 - n*b");
  expect_formulas_hold(scheme, formulas);
}

TEST_F(ClosedEigenvalues, SayWhyThereIsNone) {
  const auto refused = [](const std::string& rules, const std::string& part) {
    const Result<EigenFormulas> formulas = eigen_formulas(made(rules));
    ASSERT_FALSE(formulas.ok());
    EXPECT_NE(formulas.error().text().find(part), std::string::npos) << formulas.error().text();
    EXPECT_GT(formulas.error().line, 0);
  };
  refused("[vertex]\nself = \"5/8 - (n % 2)/16\"\nring = \"(3/8 + (n % 2)/16)/n\"\n", "integers");
  refused(
      "[[edge-end]]\nwhen = \"n > 6\"\nself = \"3/4\"\nring = \"1/(4*n) + ((2*k == n) - "
      "1/n)*((n + 1) % 2)/50\"\n",
      "cannot decide");
  refused(
      "[[edge-end]]\nwhen = \"n > 6\"\nself = \"3/4\"\nring = \"1/(4*n) + (k*(n - k) - (n^2 - "
      "1)/6)/(100*n^2)\"\n",
      "no closed Fourier sum");
}

TEST(EigenFormulas, NeedFlint) {
  if (number::factor(number::Polynomial(2))) GTEST_SKIP() << "built with FLINT";
  const Result<EigenFormulas> formulas = eigen_formulas(shipped("loop"));
  ASSERT_FALSE(formulas.ok());
  EXPECT_NE(formulas.error().message.find("without FLINT"), std::string::npos);
}

}  // namespace
}  // namespace test
}  // namespace limn
