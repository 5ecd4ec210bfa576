#include <array>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "limn/extraordinary/eigen_formula.h"
#include "limn/extraordinary/frequency_blocks.h"
#include "limn/report/eigen_formula_report.h"
#include "limn/report/papers/barthe_parts.h"
#include "limn/tune/solve.h"

namespace limn::bgsk {
namespace {

constexpr int kFirst = 3;

/// The blocks as the paper prints them, of the orbits B, C, D; that of frequency 0 for differences
/// from the centre.
Eigen::Matrix3d printed_block(int n, int omega) {
  const double alpha = 2 / 9. * (2 - std::cos(2 * std::numbers::pi / n));
  const auto k = [&](int multiple) { return std::cos(std::numbers::pi * multiple / n); };
  Eigen::Matrix3d block;
  if (omega == 0)
    block << 2 / 3. - alpha, 0, 0, 7 / 9. - alpha, 1 / 9., 1 / 18., 2 / 3. - alpha, 1 / 3., 0;
  else
    block << 2 / 3. * k(omega), 0, 0, 2 / 3. + k(2 * omega) / 9, k(omega) / 9, 1 / 18.,
        2 / 3. * k(omega), 1 / 3., 0;
  return block;
}

/// limn's block in the paper's order of orbits and, for frequency 0, relative to the centre.
Eigen::Matrix3cd found_block(const FrequencyBlocks& blocks, int omega) {
  const Eigen::MatrixXcd& block = blocks.blocks[static_cast<std::size_t>(omega)];
  const int shift = omega == 0 ? 1 : 0;
  std::array<int, 3> order{};  // of B, C, D
  for (int i = 0; i < 3; ++i) {
    const Orbit& orbit = blocks.orbits[static_cast<std::size_t>(i)];
    order[orbit.ring == 1 ? 0 : orbit.angle == 0.5 ? 1 : 2] = i + shift;
  }
  Eigen::Matrix3cd result;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int row = order[static_cast<std::size_t>(i)];
      const int column = order[static_cast<std::size_t>(j)];
      result(i, j) = block(row, column) - (omega == 0 ? block(0, column) : 0.0);
    }
  return result;
}

Status add_blocks(PaperPage& page, const Scheme& scheme) {
  DataTable numbers{{"valence", "frequency", "largest difference"}, {}};
  FrequencyAnalysis analysis(scheme, 2);
  double worst = 0;
  for (int n = kFirst; n <= kLastValence; ++n) {
    const Result<FrequencyBlocks> blocks = analysis.blocks(n);
    if (!blocks) return blocks.error();
    for (int omega = 0; omega <= n / 2; ++omega) {
      const double difference =
          (found_block(*blocks, omega) - printed_block(n, omega).cast<std::complex<double>>())
              .cwiseAbs()
              .maxCoeff();
      numbers.rows.push_back({static_cast<double>(n), static_cast<double>(omega), difference});
      worst = std::max(worst, difference);
    }
  }
  return page.add_table(
      {"§4, frequency blocks", "sqrt3-blocks"},
      {{"block", "printed", "limn"},
       {"ω = 0", "[2/3 − α, 0, 0; 7/9 − α, 1/9, 1/18; 2/3 − α, 1/3, 0]", "equal"},
       {"ω > 0", "[2/3 k_ω, 0, 0; 2/3 + 1/9 k_2ω, 1/9 k_ω, 1/18; 2/3 k_ω, 1/3, 0]", "equal"}},
      numbers,
      fmt::format("entry by entry at the valences 3 … {} and every frequency, the largest "
                  "difference is {:.1e}.",
                  kLastValence, worst));
}

/// The eigenvalues as formulas in alpha, which is a let of the scheme file.
Status add_formulas(PaperPage& page, const Scheme& scheme) {
  const Result<EigenFormulas> formulas = eigen_formulas(scheme, {}, 2);
  if (!formulas) {
    page.add_paragraph("This limn derives no formulas: " + formulas.error().message);
    return Done{};
  }
  std::vector<std::vector<std::string>> rows{{"frequency", "ring", "eigenvalue"}};
  for (const FrequencyFormulas& frequency : formulas->valences.front().frequencies)
    for (const EigenFormula& one : frequency.eigenvalues) {
      const ClosedRoot& root = one.by_lets ? *one.by_lets : one.root;
      rows.push_back(
          {fmt::format("{}{}", frequency.frequency, frequency.and_above ? " and above" : ""),
           fmt::format("{}", one.ring), root.text});
    }
  return page.add_table({"(13), derived", "sqrt3-formulas"}, rows, {{"row"}, {}},
                        "the factors of the characteristic polynomials: the paper's (13), and the "
                        "eigenvalues of the second ring, which it does not print.");
}

Status add_parameter(PaperPage& page, const Scheme& scheme) {
  const Result<Requirement> requirement = Requirement::parse("cup = tangent^2", scheme);
  if (!requirement) return requirement.error();
  Result<FreedScheme> freed = FreedScheme::make(scheme, "alpha");
  if (!freed) return freed.error();
  const Result<SearchRange> range = SearchRange::parse("0,3/5");
  if (!range) return range.error();
  DataTable numbers{{"valence", "alpha", "paper", "difference", "is the cup"}, {}};
  std::vector<std::vector<std::string>> rows{{"n", "α printed", "α solved", "remark"}};
  for (int n = kFirst; n <= kLastValence; ++n) {
    const double printed = 2 / 9. * (2 - std::cos(2 * std::numbers::pi / n));
    const Result<ValenceSolutions> found = solve_at(*freed, *requirement, n, &*range);
    if (!found) return found.error();
    for (const Solution& solution : found->solutions) {
      numbers.rows.push_back({static_cast<double>(n), solution.value, printed,
                              solution.value - printed, solution.holds == Truth::yes ? 1.0 : 0.0});
      rows.push_back({fmt::format("{}", n), fmt::format("{:.15f}", printed),
                      fmt::format("{:.15f}", solution.value), solution.reason});
    }
  }
  return page.add_table(
      {"§4, the parameter α", "sqrt3-alpha"}, rows, numbers,
      "α from μ0 = μ1² for each valence, as `limn tune sqrt3 --free alpha --require "
      "\"cup = tangent^2\"` solves it.");
}

}  // namespace

Status add_sqrt3(PaperPage& page) {
  page.add_heading("The example: Kobbelt's √3 scheme");
  const Result<Scheme> scheme = find_scheme("sqrt3");
  if (!scheme) return scheme.error();
  for (const auto& add : {add_blocks, add_formulas, add_parameter})
    if (Status status = add(page, *scheme); !status) return status;
  return Done{};
}

Status add_words(PaperPage& page) {
  page.add_findings(
      "Claims",
      {{"§2.1", "a bare list of eigenvalues does not say which configuration each belongs to",
        "Figure 1: three schemes with one list; the verdicts of `limn eigen` differ, because it "
        "knows the frequencies."},
       {"§4, (13)", "μ0 = 2/3 − α, μ1 = 2/3 k_1, μ2 = 2/3 k_2 are the dominant eigenvalues",
        "at n = 3 block 0 is led by (1 + √7)/18 = .2025 of the second ring, more than μ1² = 1/9: "
        "curvature is unbounded in spite of α. At n = 4 block 2 is led by 1/√54 = .1361, not by "
        "μ2 = 0."},
       {"§4", "the scheme's curvature is bounded by the choice of α",
        "of the cup only: from n = 7 on the saddle μ2 exceeds μ1² (see the table of sqrt3)."}});
  page.add_findings(
      "Misprints",
      {{"(10)", "exp(−2πiωl/n), divided by n", "by v: the valence is called v there."},
       {"(11), DFT of a", "the sum over B_j runs from 0 to v", "to v − 1: v points."},
       {"§2.2, (7)", "blocks S_{i,j} with i, j to n", "to v − 1 (or to the number of orbits)."}});
  return Done{};
}

}  // namespace limn::bgsk
