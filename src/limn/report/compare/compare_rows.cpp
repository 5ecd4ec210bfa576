#include "limn/report/compare/compare_rows.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <fmt/core.h>

#include "limn/report/lattice/regularity_report.h"

namespace limn::report {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TableCell missing() { return {"–"}; }
TableCell known(std::string text, double value) { return {std::move(text), Between{value, value}}; }

/// The row of a property that some schemes lack.
template <class T>
TableRow row(const Comparison& comparison, const std::string& name, Better better,
             Result<T> study::SchemeRecord::*part, const std::function<TableCell(const T&)>& cell) {
  TableRow row{name, better};
  for (const study::SchemeRecord& scheme : comparison.schemes)
    row.cells.push_back(scheme.*part ? cell(*(scheme.*part)) : missing());
  return row;
}

TableCell truth_cell(Truth truth) {
  return {std::string(to_string(truth)),
          Between{truth == Truth::yes ? 1.0 : 0.0, truth == Truth::no ? 0.0 : 1.0}};
}

TableCell holder_cell(const Regularity& regularity) {
  const HolderBracket& holder = regularity.holder;
  const char* attained = holder.attained.verdict == Truth::no ? ", not attained" : "";
  const double most = holder.exact.empty() ? kInfinity : holder.lower;
  return {to_string(holder) + attained, Between{holder.lower, holder.upper.value_or(most)}};
}

/// Cr. The list ends with the first that is not proved; what is refuted there is so further on.
TableCell smoothness_cell(const Regularity& regularity, std::size_t r) {
  const std::vector<Smoothness>& list = regularity.smoothness;
  return truth_cell(list[std::min(r, list.size() - 1)].verdict);
}

/// How many of C0, C1, … some scheme has an answer for.
std::size_t most_smoothness(const Comparison& comparison) {
  std::size_t most = 0;
  for (const study::SchemeRecord& scheme : comparison.schemes)
    if (scheme.regularity) most = std::max(most, scheme.regularity->smoothness.size());
  return most;
}

TableCell integer_cell(int value) { return known(std::to_string(value), value); }

TableRow split_row(const Comparison& comparison) {
  TableRow split{"split"};
  for (const study::SchemeRecord& scheme : comparison.schemes)
    split.cells.push_back({scheme.split});
  return split;
}

TableRow interpolating_row(const Comparison& comparison) {
  return row<bool>(comparison, "interpolating", Better::none, &study::SchemeRecord::interpolating,
                   [](bool yes) { return TableCell{yes ? "yes" : "no"}; });
}

TableRow holder_row(const Comparison& comparison) {
  return row<Regularity>(comparison, "Hölder exponent", Better::more,
                         &study::SchemeRecord::regularity, holder_cell);
}

TableSection regularity_rows(const Comparison& comparison) {
  TableSection section{"regular lattice", {}};
  section.rows.push_back(interpolating_row(comparison));
  const auto add = [&](const std::string& name,
                       const std::function<TableCell(const Regularity&)>& cell) {
    section.rows.push_back(
        row<Regularity>(comparison, name, Better::more, &study::SchemeRecord::regularity, cell));
  };
  add("sum rules, order", [](const Regularity& one) { return integer_cell(one.orders.sum_rules); });
  add("reproduces polynomials of degree",
      [](const Regularity& one) { return integer_cell(one.orders.reproduction); });
  const std::size_t most = std::max<std::size_t>(most_smoothness(comparison), 3);
  for (std::size_t r = 0; r < most; ++r)
    add("C" + std::to_string(r), [r](const Regularity& one) { return smoothness_cell(one, r); });
  section.rows.push_back(holder_row(comparison));
  TableRow curvature{"bounded curvature", Better::more};
  for (const study::SchemeRecord& scheme : comparison.schemes)
    curvature.cells.push_back(truth_cell(scheme.regular_part.bounded));
  section.rows.push_back(std::move(curvature));
  return section;
}

TableCell percent_cell(double percent) {
  return known(std::isfinite(percent) ? fmt::format("{:.4g}", percent) : "no signal", percent);
}

TableSection artifact_rows(const Comparison& comparison) {
  using Waves = std::vector<study::WaveArtifacts>;
  TableSection section{"artifacts of waves, % of the signal", {}};
  for (std::size_t i = 0; i < std::size(study::kWavelengths); ++i)
    for (const bool worst : {true, false})
      section.rows.push_back(
          row<Waves>(comparison,
                     fmt::format("{:g} edges long, {} direction", study::kWavelengths[i],
                                 worst ? "worst" : "best"),
                     Better::less, &study::SchemeRecord::artifacts, [i, worst](const Waves& waves) {
                       return percent_cell(worst ? waves[i].worst : waves[i].best);
                     }));
  return section;
}

TableCell edges_cell(const DirectionalDensity& density) {
  return known(fmt::format("{}{:.3f}", density.reached ? "" : "≤ ", density.edges_per_wavelength),
               density.edges_per_wavelength);
}

TableRow sampling_row(const Comparison& comparison, const std::string& name,
                      Result<SamplingDensity> study::SchemeRecord::*part,
                      DirectionalDensity SamplingDensity::*direction) {
  return row<SamplingDensity>(
      comparison, name, Better::less, part,
      [direction](const SamplingDensity& density) { return edges_cell(density.*direction); });
}

TableSection sampling_rows(const Comparison& comparison) {
  TableSection section{fmt::format("control edges per wavelength for {:g} %", comparison.tolerance),
                       {}};
  for (const auto& [name, part] : {std::pair{"all artifacts", &study::SchemeRecord::sampling},
                                   std::pair{"mean energy", &study::SchemeRecord::mean_sampling}})
    for (const auto& [which, direction] :
         {std::pair{"worst", &SamplingDensity::worst}, std::pair{"best", &SamplingDensity::best}})
      section.rows.push_back(
          sampling_row(comparison, fmt::format("{}, {} direction", name, which), part, direction));
  return section;
}

/// A row for each valence that has this eigenvalue.
TableSection eigenvalue_rows(const Comparison& comparison, const std::string& title,
                             std::optional<double> Eigencomponents::*part) {
  TableSection section{title, {}};
  const std::size_t count =
      comparison.schemes.empty() ? 0 : comparison.schemes.front().valences.size();
  for (std::size_t i = 0; i < count; ++i) {
    TableRow row{fmt::format("n = {}", comparison.schemes.front().valences[i].valence)};
    bool any = false;
    for (const study::SchemeRecord& scheme : comparison.schemes) {
      const Result<Eigencomponents>& components = scheme.valences[i].components;
      const bool has = components && (*components).*part;
      row.cells.push_back(has ? TableCell{fmt::format("{:.6f}", *((*components).*part))}
                              : missing());
      any = any || has;
    }
    if (any) section.rows.push_back(std::move(row));
  }
  return section;
}

/// At which valences a verdict is yes, and at which it is undecided.
TableCell verdict_cell(const study::SchemeRecord& scheme, Truth Verdict::*part) {
  std::vector<int> yes, undecided;
  bool any = false;
  for (const study::ValenceRecord& one : scheme.valences) {
    if (!one.components) continue;
    any = true;
    const Truth truth = one.components->verdict.*part;
    if (truth == Truth::yes) yes.push_back(one.valence);
    if (truth == Truth::undecided) undecided.push_back(one.valence);
  }
  if (!any) return missing();
  std::string text = numbers_text(yes);
  if (!undecided.empty()) text += " (undecided: " + numbers_text(undecided) + ")";
  const auto sure = static_cast<double>(yes.size());
  return {text, Between{sure, sure + static_cast<double>(undecided.size())}};
}

/// At which valences C1 is proved, and at which refuted.
TableCell proof_cell(const study::SchemeRecord& scheme) {
  std::vector<int> proved, refuted, undecided;
  for (const study::ValenceRecord& one : scheme.valences)
    (one.c1 == certify::Answer::proved    ? proved
     : one.c1 == certify::Answer::refuted ? refuted
                                          : undecided)
        .push_back(one.valence);
  std::string text = numbers_text(proved);
  if (!refuted.empty()) text += " (refuted: " + numbers_text(refuted) + ")";
  const auto sure = static_cast<double>(proved.size());
  return {text, Between{sure, sure + static_cast<double>(undecided.size())}};
}

TableRow verdict_row(const Comparison& comparison, const std::string& name, Truth Verdict::*part) {
  TableRow row{name, Better::more};
  for (const study::SchemeRecord& scheme : comparison.schemes)
    row.cells.push_back(verdict_cell(scheme, part));
  return row;
}

TableRow proof_row(const Comparison& comparison) {
  TableRow row{"C1 is proved (limn certify)", Better::more};
  for (const study::SchemeRecord& scheme : comparison.schemes)
    row.cells.push_back(proof_cell(scheme));
  return row;
}

TableRow bounded_curvature_row(const Comparison& comparison) {
  return verdict_row(comparison, "curvature is bounded, if C1", &Verdict::bounded_curvature);
}

/// Eigenvalues tell convergence, and of C1 what is necessary alone; bounded curvature takes in the
/// regular surface and presupposes C1.
TableSection verdict_rows(const Comparison& comparison) {
  return {"valences n at which, by the eigenvalues,",
          {verdict_row(comparison, "the scheme converges at the vertex", &Verdict::convergent),
           verdict_row(comparison, "C1 is not ruled out", &Verdict::c1_necessary),
           bounded_curvature_row(comparison), proof_row(comparison)}};
}

/// An energy that grows without bound has no value that could be the least.
TableCell energy_cell(double value, double rounding, const fairness::Trend& trend) {
  const std::string number = fmt::format("{:.5g}", value);
  switch (trend.converges) {
    case Truth::yes: return {number, Between{value, value}, rounding};
    case Truth::no: return known(number + ", grows", kInfinity);
    case Truth::undecided: break;
  }
  return {number + " ?", Between{value, kInfinity}, rounding};
}

/// Σ|Lp|² can be compared at one level of one split only.
bool comparable_laplacians(const std::vector<Result<study::FairnessRecord>>& fairness) {
  const study::FairnessRecord* first = nullptr;
  for (const Result<study::FairnessRecord>& one : fairness) {
    if (!one) continue;
    if (first == nullptr) first = &*one;
    if (one->split != first->split || one->last().level != first->last().level) return false;
  }
  return true;
}

TableSection fairness_rows(const MeshComparison& on_mesh) {
  TableSection section{"fairness of the limit surface over " + on_mesh.mesh, {}};
  const auto add = [&](const std::string& name, Better better, const auto& cell) {
    TableRow row{name, better};
    for (const Result<study::FairnessRecord>& one : on_mesh.fairness)
      row.cells.push_back(one ? cell(*one) : missing());
    section.rows.push_back(std::move(row));
  };
  add("level", Better::none,
      [](const study::FairnessRecord& one) { return TableCell{std::to_string(one.last().level)}; });
  add("Laplacian, sum of squares",
      comparable_laplacians(on_mesh.fairness) ? Better::less : Better::none,
      [](const study::FairnessRecord& one) {
        const double value = one.last().laplacian_energy;
        return TableCell{fmt::format("{:.5g}", value), Between{value, value},
                         one.last().laplacian_rounding};
      });
  add("thin plate", Better::less, [](const study::FairnessRecord& one) {
    return energy_cell(one.last().energies.thin_plate, one.last().energies.rounding.thin_plate,
                       one.thin_plate);
  });
  add("variation of curvature", Better::less, [](const study::FairnessRecord& one) {
    return energy_cell(one.last().energies.curvature_variation,
                       one.last().energies.rounding.curvature_variation, one.curvature_variation);
  });
  return section;
}

}  // namespace

std::string numbers_text(const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    if (last == i + 1) last = i;  // "3, 4", not "3…4"
    text += (text.empty() ? "" : ", ") + std::to_string(numbers[i]);
    if (last > i) text += "…" + std::to_string(numbers[last]);
    i = last + 1;
  }
  return text.empty() ? "none" : text;
}

std::vector<TableSection> compare_sections(const Comparison& comparison) {
  std::vector<TableSection> sections = {
      {"", {split_row(comparison)}},
      regularity_rows(comparison),
      artifact_rows(comparison),
      sampling_rows(comparison),
      eigenvalue_rows(comparison, "tangent eigenvalue", &Eigencomponents::tangent),
      eigenvalue_rows(comparison, "cup eigenvalue", &Eigencomponents::cup),
      eigenvalue_rows(comparison, "saddle eigenvalue", &Eigencomponents::saddle),
      verdict_rows(comparison)};
  if (comparison.on_mesh) sections.push_back(fairness_rows(*comparison.on_mesh));
  return sections;
}

std::vector<TableRow> field_rows(const Comparison& comparison) {
  std::vector<TableRow> rows = {
      split_row(comparison),
      interpolating_row(comparison),
      holder_row(comparison),
      sampling_row(comparison, fmt::format("edges per wavelength, {:g} %", comparison.tolerance),
                   &study::SchemeRecord::sampling, &SamplingDensity::worst),
      proof_row(comparison),
      bounded_curvature_row(comparison)};
  for (TableRow& row : rows) row.better = Better::none;  // no one scheme is the best of the field
  return rows;
}

}  // namespace limn::report
