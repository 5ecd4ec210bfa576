#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "limn/report/eigen/eigen_formula_report.h"
#include "limn/spectrum/eigen_formula.h"
#include "limn/spectrum/frequency_blocks.h"
#include "limn/tune/solve.h"
#include "papers/barthe_parts.h"

namespace limn::bgsk {
namespace {

constexpr int kFirst = 3;
constexpr double kRounding = 1e-12;

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
  report::DescribedTable numbers{{{"valence", "v, edges of the vertex"},
                                  {"frequency", "ω, rotational"},
                                  {"largest difference", "of an entry from the printed one"}},
                                 {}};
  for (const char* whose : {"printed", "limn"})
    for (int i = 0; i < 9; ++i)
      numbers.columns.push_back(
          {fmt::format("{}{}_{}", "bcd"[i / 3], "BCD"[i % 3], whose),
           fmt::format("weight of orbit {} in the new orbit {}{}, {}", "BCD"[i % 3], "bcd"[i / 3],
                       ", relative to the centre where ω = 0",
                       std::string(whose) == "limn" ? "from the rules" : "by the paper")});
  FrequencyAnalysis analysis(scheme, 2);
  double worst = 0;
  for (int n = kFirst; n <= kLastValence; ++n) {
    const Result<FrequencyBlocks> blocks = analysis.blocks(n);
    if (!blocks) return blocks.error();
    for (int omega = 0; omega <= n / 2; ++omega) {
      const Eigen::Matrix3d printed = printed_block(n, omega);
      const Eigen::Matrix3cd ours = found_block(*blocks, omega);
      const double difference = (ours - printed.cast<std::complex<double>>()).cwiseAbs().maxCoeff();
      std::vector<report::Cell>& row = numbers.rows.emplace_back(std::vector<report::Cell>{
          static_cast<double>(n), static_cast<double>(omega), difference});
      for (int i = 0; i < 9; ++i) row.emplace_back(printed(i / 3, i % 3));
      for (int i = 0; i < 9; ++i) row.emplace_back(ours(i / 3, i % 3).real());
      worst = std::max(worst, difference);
    }
  }
  const std::string equal = worst < kRounding ? "equal" : "different";
  return page.add_table(
      {"§4, frequency blocks", "sqrt3-blocks"},
      {{"block", "printed", "limn"},
       {"ω = 0", "[2/3 − α, 0, 0; 7/9 − α, 1/9, 1/18; 2/3 − α, 1/3, 0]", equal},
       {"ω > 0", "[2/3 k_ω, 0, 0; 2/3 + 1/9 k_2ω, 1/9 k_ω, 1/18; 2/3 k_ω, 1/3, 0]", equal}},
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
  report::DescribedTable numbers{
      {{"frequency", "ω, rotational"},
       {"and_above", "whether it holds for every larger one too"},
       {"ring", "the least that is invariant and has it"},
       {"eigenvalue", "a formula in the valence n, ω and the let alpha"}},
      {}};
  for (const FrequencyFormulas& frequency : formulas->valences.front().frequencies)
    for (const EigenFormula& one : frequency.eigenvalues) {
      const ClosedRoot& root = one.by_lets ? *one.by_lets : one.root;
      rows.push_back(
          {fmt::format("{}{}", frequency.frequency, frequency.and_above ? " and above" : ""),
           fmt::format("{}", one.ring), root.text});
      numbers.rows.push_back({static_cast<double>(frequency.frequency),
                              frequency.and_above ? "yes" : "no", static_cast<double>(one.ring),
                              root.text});
    }
  return page.add_table({"(13), derived", "sqrt3-formulas"}, rows, numbers,
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
  report::DescribedTable numbers{
      {{"valence", "v, edges of the vertex"},
       {"alpha", "the vertex rule's parameter, solved from μ0 = μ1²"},
       {"paper", "the same by the paper's formula"},
       {"difference", "of the two"},
       {"holds", "whether the cup's eigenvalue is then the tangent's squared"},
       {"remark", "of the solver"}},
      {}};
  std::vector<std::vector<std::string>> rows{{"n", "α printed", "α solved", "remark"}};
  for (int n = kFirst; n <= kLastValence; ++n) {
    const double printed = 2 / 9. * (2 - std::cos(2 * std::numbers::pi / n));
    const Result<ValenceSolutions> found = solve_at(*freed, *requirement, n, &*range);
    if (!found) return found.error();
    for (const Solution& solution : found->solutions) {
      numbers.rows.push_back({static_cast<double>(n), solution.value, printed,
                              solution.value - printed, std::string(to_string(solution.holds)),
                              solution.reason});
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

}  // namespace limn::bgsk
