/// All LaTeX that limn prints is held to its structure.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "limn/report/eigen/eigen_formula_report.h"
#include "limn/report/eigen/eigen_table.h"
#include "limn/report/scheme_report.h"
#include "support/latex_structure.h"
#include "support/shipped.h"

namespace limn::test {
namespace {

TEST(LatexStructure, FindsWhatIsWrong) {
  const auto fault = [](const std::string& text) { return latex_fault(text); };
  EXPECT_EQ(fault("% anything { & $\n\\[\\left[\\begin{array}{cc} 1 & \\frac{1}{2} \\\\ & 3 "
                  "\\end{array}\\right]\\]"),
            "");
  EXPECT_NE(fault("\\begin{array}{cc} 1 & 2 \\\\ 3 & 4 \\\\ \\end{array}"), "");
  EXPECT_NE(fault("\\begin{array}{ccc} 1 & & 2 \\\\ 3 & & 4 \\end{array}"), "");
  EXPECT_NE(fault("\\begin{array}{ccc} 1 & 2 \\\\ 3 & 4 & 5 \\end{array}"), "");
  EXPECT_NE(fault("\\begin{align*} a && b \\\\ c && d \\end{align*}"), "");
  for (const char* text :
       {"{", "}", "$x", "\\[ x", "\\left( x", "\\begin{array}{c} 1 \\end{tabular}", "a & b",
        "a \\\\ b", "a_b", "50 # 3", "\x1b", "\\begin{align*}\\end{align*}"})
    EXPECT_NE(fault(text), "") << text;
}

TEST(Latex, EveryShippedSchemeIsDescribed) {
  for (const std::string& name : shipped_schemes()) {
    const Result<std::string> latex = report::describe_latex(shipped(name));
    ASSERT_TRUE(latex.ok()) << latex.error().text();
    EXPECT_EQ(latex_fault(*latex), "") << name << "\n" << *latex;
  }
}

TEST(Latex, EveryShippedSchemesFormulas) {
  for (const std::string& name : lattice_names()) {
    const Result<EigenFormulas> formulas = eigen_formulas(shipped(name), {}, 0);
    if (!formulas) continue;  // no rules, or no FLINT
    const std::string latex = report::eigen_formulas_text(name, *formulas, number::Notation::latex);
    EXPECT_EQ(latex_fault(latex), "") << name << "\n" << latex;
  }
}

std::vector<Eigencomponents> components(const Scheme& scheme, int first, int last) {
  std::vector<Eigencomponents> list;
  FrequencyAnalysis analysis(scheme);
  for (int n = first; n <= last; ++n)
    list.push_back(approx_eigencomponents(analysis.blocks(n).value()));
  return list;
}

TEST(Latex, TablesOfEigenvalues) {
  for (const std::string& name : lattice_names()) {
    const Scheme& scheme = shipped(name);
    if (scheme.mask || scheme.factors) continue;
    const std::string latex = report::eigenvalue_latex(
        "a_b & {" + name, report::eigenvalue_table(components(scheme, 3, 8)));
    EXPECT_EQ(latex_fault(latex), "") << name << "\n" << latex;
  }
}

TEST(Latex, ANameIsNoMarkup) {
  Scheme scheme = shipped("loop");
  scheme.name = "loop\n\\input{evil}\n\x1b[31m%&_";
  const std::string shown = report::describe_latex(scheme).value();
  EXPECT_EQ(shown.find("\n\\input"), std::string::npos) << shown;
  EXPECT_EQ(latex_fault(shown), "") << shown;
  const std::string table =
      report::eigenvalue_latex(scheme.name, report::eigenvalue_table(components(scheme, 5, 6)));
  EXPECT_EQ(latex_fault(table), "") << table;
}

/// Loop's eigenvalues in closed form [Loop 1987]: tangent 3/8 + cos(2π/n)/4, cup its square.
TEST(EigenvalueTable, IsLoopsClosedForm) {
  const report::DataTable table = report::eigenvalue_table(components(shipped("loop"), 3, 12));
  ASSERT_EQ(table.columns[1], "tangent");
  ASSERT_EQ(table.columns[3], "cup");
  for (const std::vector<double>& row : table.rows) {
    const double tangent = 3 / 8. + std::cos(2 * std::acos(-1.0) / row[0]) / 4;
    EXPECT_NEAR(row[1], tangent, 1e-14);
    EXPECT_NEAR(row[2], tangent * tangent, 1e-14);
    EXPECT_NEAR(row[3], std::max(tangent * tangent, 1 / 8.), 1e-14);  // 1/8 is the second ring's
    EXPECT_EQ(std::isnan(row[4]), row[0] == 3);
    EXPECT_EQ(row.size(), table.columns.size());
  }
  EXPECT_FALSE(report::has_complex(table));
}

/// A complex pair: weights round a dual face that turn it, so that frequency 1 has no real leader.
TEST(EigenvalueTable, ComplexEigenvaluesAreModuliAndSaidSo) {
  Eigencomponents found;
  found.valence = 5;
  found.spectra.resize(3);
  for (int frequency = 0; frequency < 3; ++frequency)
    found.spectra[static_cast<std::size_t>(frequency)].frequency = frequency;
  const auto eigenvalue = [](std::complex<double> value) {
    Eigenvalue one;
    one.value = value;
    return one;
  };
  found.spectra[0].eigenvalues = {eigenvalue(1), eigenvalue({0.3, 0.4}), eigenvalue({0.3, -0.4})};
  found.spectra[1].eigenvalues = {eigenvalue(0.6)};
  found.spectra[2].eigenvalues = {eigenvalue(-0.25)};
  const report::DataTable table = report::eigenvalue_table({found});
  EXPECT_TRUE(report::has_complex(table));
  const std::vector<double> row{5, 0.6, 0.36, 0.5, -0.25, 0.5, 0, 1, 0, 1};
  ASSERT_EQ(table.rows.front().size(), row.size());
  for (std::size_t i = 0; i < row.size(); ++i)
    EXPECT_NEAR(table.rows.front()[i], row[i], 1e-15) << i;
  const std::string latex = report::eigenvalue_latex("turned", table);
  EXPECT_NE(latex.find("$|0.500000|$"), std::string::npos) << latex;
  EXPECT_NE(latex.find("moduli of complex"), std::string::npos) << latex;
}

}  // namespace
}  // namespace limn::test
