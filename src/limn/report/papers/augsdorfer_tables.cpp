#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>

#include "limn/regular/formula.h"
#include "limn/regular/regular_mask.h"
#include "limn/regular/sampling_density.h"
#include "limn/report/papers/augsdorfer_parts.h"
#include "limn/scheme/expression.h"

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
  return expression.evaluate<double>([&](const std::string& name) -> Result<double> {
    const auto angle = [&](std::size_t i) {
      return theta[static_cast<std::size_t>(name[i] - '1')];
    };
    return std::cos(name.size() == 2 ? angle(1) : angle(1) - angle(2));
  });
}

std::string table_tex(const std::vector<std::string>& formulas, const std::string& name) {
  std::string text = fmt::format("% magnitudes in the limit, {}\n\\begin{{align*}}\n", name);
  for (std::size_t i = 0; i < formulas.size(); ++i)
    text += fmt::format("  {} &= {} \\\\\n", component_name(static_cast<int>(i), Notation::latex),
                        formulas[i]);
  return text + "\\end{align*}\n";
}

double largest(const DataTable& table, const std::string& name) {
  double most = 0;
  for (const double value : column(table, name)) most = std::max(most, std::abs(value));
  return most;
}

/// The largest of the artifacts that are not perpendicular to f, for f along Y1.
double across_y1(const ArtifactAnalysis& analysis) {
  const DataTable curve = artifact_curve(analysis, {}, 90, 241).value();
  return std::max(largest(curve, "Y2"), largest(curve, "Y3"));
}

std::vector<PaperFinding> claims(const Study& study) {
  std::vector<PaperFinding> list;
  std::string others;
  if (const auto scheme = find_scheme("laplacian-butterfly"))
    if (const auto mask = regular_mask(*scheme))
      if (const auto analysis = ArtifactAnalysis::of(*mask))
        others = fmt::format(" It is no law of all schemes: laplacian-butterfly has up to {:.3g}.",
                             across_y1(*analysis));
  list.push_back({"§2.3", "no artifacts Y2, Y3 where f is along Y1",
                  fmt::format("confirmed: at most {:.1g} (Loop), {:.1g} (butterfly), which is "
                              "rounding.{}",
                              across_y1(study.schemes[0].analysis),
                              across_y1(study.schemes[1].analysis), others)});
  list.push_back({"§2.3", "signal and artifacts both decrease with every smoothing stage",
                  fmt::format("confirmed: a stage multiplies them by factors between {:.4g} and 1 "
                              "(its least value at the corners of the region)",
                              std::min({extremes(study.stages[0], "signal").low,
                                        extremes(study.stages[0], "Y1").low}))});
  std::string percents;
  for (std::size_t i = 0; i < study.schemes.size(); ++i)
    percents +=
        fmt::format("{}{} signal {:.4f}, artifacts {:.2f} %", i == 0 ? "" : "; ",
                    study.schemes[i].name, study.schemes[i].analysis.in_limit({0, 0.4}).signal,
                    study.schemes[i].analysis.in_limit({0, 0.4}).percent_of_signal());
  list.push_back({"§4",
                  "interpolating schemes retain the signal well, but with a higher percentage of "
                  "artifacts",
                  "confirmed; at f = (0, 0.4): " + percents});
  return list;
}

std::vector<PaperFinding> misprints() {
  return {
      {"Fig. 2, caption", "X3 = [-1/(2√3), 1/2]", "[-1/(2√3), -1/2]: the three sum to 0"},
      {"§2.2", "S at 2J+X3 is D T^{Ω·(2J+X2)}", "D T^{Ω·(2J+X3)}"},
      {"§2.2", "Y1 = (X2 - X3)/2, …",
       "with |X| = 1/√3 the phase Y1·X2 is then 1/4, and the wave does not change sign along X2; "
       "2(X2 - X3) makes it 1"},
      {"§2.3", "for Ω = h Y1, c2 = cos(…) = 0 and c3 = cos(…) = 0",
       "c2 = c3 = cos(πω), as the lines below it use"},
      {"(9)", "second form: L N R_N^s", "L_N R_N^s"},
      {"(19), (20)", "K stands with a factor 1/4 inside and before it",
       "once: with both the signal of a constant would be 1/4"},
      {"§3.3", "c1, c2, c3 stand for cos(πΩ·X1/2), …", "cos(πΩ·X1), …, as in Table 3"},
      {"Fig. 4, caption", "scales that differ by a factor of 10", "about 2: see Figure 4 above"},
  };
}

}  // namespace

Status add_table(PaperPage& page, const Study& study, std::size_t which) {
  const ArtifactAnalysis& analysis = study.schemes[which].analysis;
  const Result<std::vector<std::string>> formulas = limit_formulas(analysis.mask(), Notation::text);
  if (!formulas) return formulas.error();
  std::vector<std::vector<std::string>> rows{{"", "the paper", "limn, from the rules"}};
  DataTable numbers{{"fx", "fy"}, {}};
  const TriangleGrid grid = frequency_grid(Lattice::triangle, 12);
  for (const Frequency& f : grid.nodes) numbers.rows.push_back({f[0], f[1]});
  double worst = 0;
  for (std::size_t i = 0; i < formulas->size(); ++i) {
    const std::string name = component_name(static_cast<int>(i), Notation::text);
    const Expression printed = Expression::parse(kPrinted[which][i]).value();
    rows.push_back({name, kPrinted[which][i], (*formulas)[i]});
    numbers.columns.push_back(name + "_printed");
    numbers.columns.push_back(name + "_limn");
    for (std::size_t node = 0; node < grid.nodes.size(); ++node) {
      const Components components = analysis.in_limit(grid.nodes[node]);
      const double ours = i == 0 ? components.signal : components.artifacts[i - 1];
      const double theirs = value_of(printed, grid.nodes[node]).value();
      numbers.rows[node].insert(numbers.rows[node].end(), {theirs, ours});
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
  const Result<std::vector<std::string>> latex = limit_formulas(analysis.mask(), Notation::latex);
  return page.add_file(stem + ".tex", table_tex(*latex, study.schemes[which].name),
                       "the formulas as LaTeX");
}

Status add_words(PaperPage& page, const Study& study) {
  page.add_findings("Claims", claims(study));
  page.add_paragraph(
      "§4: \"the interpolating schemes need a higher density of vertices in the initial sampling "
      "mesh to achieve the same quality of limit surface\". How much higher:");
  std::vector<std::vector<std::string>> rows{
      {"scheme", "all artifacts ≤ 1 %: worst", "best", "mean energy ≤ 1 %: worst", "best"}};
  DataTable numbers{{"scheme", "total_worst", "total_best", "mean_worst", "mean_best"}, {}};
  for (std::size_t i = 0; i < study.schemes.size(); ++i) {
    std::vector<std::string>& row = rows.emplace_back();
    row.push_back(study.schemes[i].name);
    numbers.rows.push_back({static_cast<double>(i + 1)});
    for (const ArtifactMeasure measure :
         {ArtifactMeasure::total_energy, ArtifactMeasure::mean_energy}) {
      const Result<SamplingDensity> density =
          sampling_density(study.schemes[i].analysis, 1, measure);
      if (!density) return density.error();
      for (const DirectionalDensity* d : {&density->worst, &density->best}) {
        row.push_back(fmt::format("{:.3f} at {:.0f}°", d->edges_per_wavelength, d->direction));
        numbers.rows.back().push_back(d->edges_per_wavelength);
      }
    }
  }
  Status status = page.add_table(
      {"Sampling density", "sampling"}, rows, numbers,
      "Control edges per wavelength that keep the artifacts within 1 % of the signal, in the worst "
      "and in the best direction.");
  if (!status) return status;
  page.add_findings("Misprints", misprints());
  return Done{};
}

}  // namespace limn::ads
