#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>

#include "limn/regular/artifacts.h"
#include "limn/regular/formula.h"
#include "limn/regular/regular_mask.h"
#include "limn/scheme/evaluate.h"
#include "limn/scheme/expression.h"
#include "papers/augsdorfer_parts.h"

namespace limn::ads {
namespace {

/// The expressions as the paper prints them, α β γ δ, in the notation of scheme files: what
/// limn's derivation is held against, and no source of any number.
constexpr std::array<std::array<const char*, 4>, 3> kPrinted{
    {{"(3 + c1 + c2 + c3)*(1 + c1 + c2 + c3)^2/96", "(3 + c1 - c2 - c3)*(1 + c1 - c2 - c3)^2/96",
      "(3 - c1 + c2 - c3)*(1 - c1 + c2 - c3)^2/96", "(3 - c1 - c2 + c3)*(1 - c1 - c2 + c3)^2/96"},
     {"(1 + 2*(c1 + c2 + c3) - (c12 + c13 + c23))*(1 + c1 + c2 + c3)/16",
      "(1 + 2*(c1 - c2 - c3) - (-c12 - c13 + c23))*(1 + c1 - c2 - c3)/16",
      "(1 + 2*(-c1 + c2 - c3) - (-c12 + c13 - c23))*(1 - c1 + c2 - c3)/16",
      "(1 + 2*(-c1 - c2 + c3) - (c12 - c13 - c23))*(1 - c1 - c2 + c3)/16"},
     {"(5 - c1 - c2 - c3)*(1 + c1 + c2 + c3)^2/32", "(5 - c1 + c2 + c3)*(1 + c1 - c2 - c3)^2/32",
      "(5 + c1 - c2 + c3)*(1 - c1 + c2 - c3)^2/32", "(5 + c1 + c2 - c3)*(1 - c1 - c2 + c3)^2/32"}}};

/// The value of an expression in c1, …, c23 at a frequency.
Result<double> value_of(const Expression& expression, Frequency f) {
  const Phase t = control_phase(Lattice::triangle, f);
  const std::array<double, 3> theta{t[0] / 2, t[1] / 2, -(t[0] + t[1]) / 2};
  return limn::scheme::evaluate<double>(expression, [&](const std::string& name) -> Result<double> {
    const auto angle = [&](std::size_t i) {
      return theta[static_cast<std::size_t>(name[i] - '1')];
    };
    return std::cos(name.size() == 2 ? angle(1) : angle(1) - angle(2));
  });
}

std::string table_tex(const std::vector<std::string>& formulas, const std::string& name) {
  std::string text = fmt::format("% magnitudes in the limit, {}\n\\begin{{align*}}\n", name);
  for (std::size_t i = 0; i < formulas.size(); ++i)
    text += fmt::format("  {} &= {} \\\\\n",
                        regular::component_name(static_cast<int>(i), number::Notation::latex),
                        formulas[i]);
  return text + "\\end{align*}\n";
}

std::vector<PaperFinding> misprints(const Study& study) {
  return {
      {"Fig. 2, caption", "X3 = [-1/(2√3), 1/2]", "[-1/(2√3), -1/2]: the three sum to 0"},
      {"§2.2", "S at 2J+X3 is D T^{Ω·(2J+X2)}", "D T^{Ω·(2J+X3)}"},
      {"§2.2", "Y1 = (X2 - X3)/2, …",
       "with |X| = 1/√3 the phase Y1·X2 is then 1/4, and the wave does not change sign along X2; "
       "2(X2 - X3) makes it 1"},
      {"§2.3", "for Ω = h Y1, c2 = cos(…) = 0 and c3 = cos(…) = 0",
       "c2 = c3 = cos(πω), as the lines below it use"},
      {"(9)", "second form: L N R_N^s", "L_N R_N^s"},
      {"(20)", "K_N = NKN/4, with the K of (19), which is 4 times the map",
       "NKN/16, or K with (19)'s factor 1/4 in it: else the signal of a constant is 4. The lines "
       "below (20) have the factor"},
      {"§3.3", "c1, c2, c3 stand for cos(πΩ·X1/2), …", "cos(πΩ·X1), …, as in Table 3"},
      {"Fig. 4, caption", "scales that differ by a factor of 10",
       fmt::format("{:.3g} for the sums, {:.3g} for the mean energies: see Figure 4 above",
                   stage_ratio(study, "sum"), stage_ratio(study, "mean_energy"))},
  };
}

}  // namespace

Status add_table(PaperPage& page, const Study& study, std::size_t which) {
  const ArtifactAnalysis& analysis = study.schemes[which].analysis;
  const Result<std::vector<std::string>> formulas =
      regular::limit_formulas(analysis.mask(), number::Notation::text);
  if (!formulas) return formulas.error();
  std::vector<std::vector<std::string>> rows{{"", "the paper", "limn, from the rules"}};
  report::DescribedTable numbers{
      {{"fx", report::artifact_meaning("fx")}, {"fy", report::artifact_meaning("fy")}}, {}};
  const figure::TriangleGrid grid = report::frequency_grid(Lattice::triangle, 12);
  for (const Frequency& f : grid.nodes) numbers.rows.push_back({f[0], f[1]});
  double worst = 0;
  for (std::size_t i = 0; i < formulas->size(); ++i) {
    const std::string name = regular::component_name(static_cast<int>(i), number::Notation::text);
    const Expression printed = Expression::parse(kPrinted[which][i]).value();
    rows.push_back({name, kPrinted[which][i], (*formulas)[i]});
    const std::string what =
        report::artifact_meaning(i == 0 ? "signal" : study::artifact_name(static_cast<int>(i) - 1));
    numbers.columns.push_back({name + "_printed", what + ", by the paper's expression"});
    numbers.columns.push_back({name + "_limn", what + ", from the rules"});
    for (std::size_t node = 0; node < grid.nodes.size(); ++node) {
      const Components components = analysis.in_limit(grid.nodes[node]);
      const double ours = i == 0 ? components.signal : components.artifacts[i - 1];
      const double theirs = value_of(printed, grid.nodes[node]).value();
      numbers.rows[node].insert(numbers.rows[node].end(),
                                {report::Cell{theirs}, report::Cell{ours}});
      worst = std::max(worst, std::abs(theirs - ours));
    }
  }
  const std::string stem = fmt::format("table{}", which + 1);
  Status status = page.add_table(
      {fmt::format("Table {}", which + 1), stem}, rows, numbers,
      fmt::format("Magnitudes in the limit, {}. The two columns differ by at most {:.1g} over the "
                  "region.",
                  study.schemes[which].name, worst));
  if (!status) return status;
  const Result<std::vector<std::string>> latex =
      regular::limit_formulas(analysis.mask(), number::Notation::latex);
  return page.add_file(stem + ".tex", table_tex(*latex, study.schemes[which].name),
                       "the formulas as LaTeX");
}

Status add_words(PaperPage& page, const Study& study) {
  const Result<std::vector<PaperFinding>> judged = claims(study);
  if (!judged) return judged.error();
  if (Status status = page.add_findings({"Claims", "claims"}, *judged); !status) return status;
  page.add_paragraph(
      "§4: \"the interpolating schemes need a higher density of vertices in the initial sampling "
      "mesh to achieve the same quality of limit surface\". How much higher:");
  std::vector<std::vector<std::string>> rows{
      {"scheme", "all artifacts ≤ 1 %: worst", "best", "mean energy ≤ 1 %: worst", "best"}};
  const std::string edges = "control edges per wavelength in the ";
  report::DescribedTable numbers{
      {{"scheme", "its name"},
       {"total_worst", edges + "worst direction that keep all artifacts within 1 % of the signal"},
       {"total_best", edges + "best direction that keep all artifacts within 1 % of the signal"},
       {"mean_worst", edges + "worst direction that keep the mean energy within 1 % of the signal"},
       {"mean_best", edges + "best direction that keep the mean energy within 1 % of the signal"}},
      {}};
  for (const study::NamedAnalysis& scheme : study.schemes) {
    std::vector<std::string>& row = rows.emplace_back();
    row.push_back(scheme.name);
    numbers.rows.push_back({scheme.name});
    for (const ArtifactMeasure measure :
         {ArtifactMeasure::total_energy, ArtifactMeasure::mean_energy}) {
      const Result<SamplingDensity> density = sampling_density(scheme.analysis, 1, measure);
      if (!density) return density.error();
      for (const DirectionalDensity* d : {&density->worst, &density->best}) {
        row.push_back(fmt::format("{:.3f} at {:.0f}°", d->edges_per_wavelength, d->direction));
        numbers.rows.back().emplace_back(d->edges_per_wavelength);
      }
    }
  }
  Status status = page.add_table(
      {"Sampling density", "sampling"}, rows, numbers,
      "Control edges per wavelength that keep the artifacts within 1 % of the signal, in the worst "
      "and in the best direction.");
  if (!status) return status;
  return page.add_findings({"Misprints", "misprints"}, misprints(study));
}

}  // namespace limn::ads
