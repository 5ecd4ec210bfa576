#include "papers/augsdorfer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "limn/regular/regular_mask.h"
#include "limn/report/lattice/artifact_figures.h"
#include "papers/augsdorfer_parts.h"

namespace limn {
namespace ads {

Result<Study> study() {
  Study result;
  for (const auto& [name, words] : {std::pair{"loop", "Loop"}, std::pair{"butterfly", "butterfly"},
                                    std::pair{"interpolating-loop", "third scheme"}}) {
    const Result<Scheme> scheme = find_scheme(name);
    if (!scheme) return scheme.error();
    const Result<Mask> mask = regular_mask(*scheme);
    if (!mask) return mask.error();
    Result<ArtifactAnalysis> analysis = ArtifactAnalysis::of(*mask);
    if (!analysis) return analysis.error();
    result.schemes.push_back({words, *std::move(analysis)});
  }
  result.grid = report::frequency_grid(Lattice::triangle, 48);
  for (const study::NamedAnalysis& scheme : result.schemes) {
    Result<report::DataTable> table = report::artifact_table(scheme.analysis, {}, result.grid);
    if (!table) return table.error();
    result.limit.push_back(*std::move(table));
  }
  for (const int stages : {1, 2}) {
    Result<report::DataTable> table = report::artifact_table(
        result.schemes.front().analysis, {study::Stage::Kind::smoothing, stages}, result.grid);
    if (!table) return table.error();
    result.stages.push_back(*std::move(table));
  }
  return result;
}

Extremes extremes(const report::DataTable& table, const std::string& name) {
  const std::vector<double> values = report::column(table, name);
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const auto at = static_cast<std::size_t>(high - values.begin());
  const auto snapped = [](double value) { return std::abs(value) < 1e-12 ? 0.0 : value; };
  return {snapped(*low), snapped(*high), {table.rows[at][0], table.rows[at][1]}};
}

double stage_ratio(const Study& study, const std::string& name) {
  return extremes(study.stages[0], name).high / extremes(study.stages[1], name).high;
}

namespace {

const char* const kTitle =
    "Artifact analysis on triangular box-spline and subdivision meshes, made anew";
const char* const kCitation =
    "U. H. Augsdörfer, N. A. Dodgson, M. A. Sabin: Artifact analysis on triangular box-spline and "
    "subdivision meshes. Figures 1 to 12 and tables 1 to 3, computed by limn from the rules in its "
    "scheme files; frequencies are in cycles per control edge, f = Ω/√3.";

/// The wave of Figure 1 on a fine grid, and on the control lattice.
figure::Figure wave_figure(report::DataTable& numbers) {
  const double root3 = std::sqrt(3.0);
  const Frequency f{0.1 / root3, 0.2 / root3};
  constexpr int kSide = 16;  // control edges along a side
  constexpr int kFine = 4;   // grey patches per edge
  const auto place = [&](double a, double b) {
    const std::array<double, 2> x = cartesian(Lattice::triangle, {a, b});
    return std::array<double, 3>{x[0], x[1],
                                 std::cos(2 * std::numbers::pi * (f[0] * x[0] + f[1] * x[1]))};
  };
  figure::SurfacePanel panel;
  const int fine = kSide * kFine + 1;
  for (int j = 0; j < fine; ++j)
    for (int i = 0; i < fine; ++i)
      panel.vertices.push_back(
          place(static_cast<double>(i) / kFine, static_cast<double>(j) / kFine));
  for (int j = 0; j + 1 < fine; ++j)
    for (int i = 0; i + 1 < fine; ++i)
      panel.faces.push_back(
          {j * fine + i, j * fine + i + 1, (j + 1) * fine + i + 1, (j + 1) * fine + i});
  const auto net = [](int i, int j) { return j * (kSide + 1) + i; };
  numbers = {{"x", "y", "z"}, {}};
  for (int j = 0; j <= kSide; ++j)
    for (int i = 0; i <= kSide; ++i) {
      const std::array<double, 3> p = place(i, j);
      panel.net_vertices.push_back(p);
      numbers.rows.push_back({p[0], p[1], p[2]});
      if (i < kSide) panel.net_edges.push_back({net(i, j), net(i + 1, j)});
      if (j < kSide) panel.net_edges.push_back({net(i, j), net(i, j + 1)});
      if (i < kSide && j < kSide) panel.net_edges.push_back({net(i, j), net(i + 1, j + 1)});
    }
  panel.elevation = 35;
  panel.azimuth = -20;
  figure::Figure figure(1, 360);
  figure.add(panel);
  return figure;
}

Status add_wave(PaperPage& page) {
  report::DataTable numbers;
  const figure::Figure figure = wave_figure(numbers);
  const report::DescribedTable described_numbers =
      report::described(numbers, {{"x", "place of the control point [control edges]"},
                                  {"y", "place of the control point [control edges]"},
                                  {"z", "its height, cos 2πf·x [amplitudes of the wave]"}});
  return page.add_figure({"Figure 1", "fig01"}, figure, described_numbers,
                         "a triangular mesh (black) sampled from a sinusoidal surface (grey), Ω = "
                         "[0.1, 0.2].",
                         "the same wave: f = Ω/√3 = (0.0577, 0.1155), 7.75 control edges long.");
}

const std::vector<std::string> kThree{"Y1", "Y2", "Y3"};

/// Three maps of the artifacts on one scale.
figure::Figure artifact_maps(const Study& study, const report::DataTable& table, double high) {
  figure::Figure figure(3);
  const double low = std::min(
      {0.0, extremes(table, "Y1").low, extremes(table, "Y2").low, extremes(table, "Y3").low});
  for (int i = 0; i < 3; ++i)
    figure.add(report::artifact_map_panel(study.grid, table, study::artifact_name(i),
                                          fmt::format("Y_{{{}}}", i + 1), {low, high}));
  return figure;
}

Status add_stage_figures(PaperPage& page, const Study& study) {
  const report::DataTable& one = study.stages[0];
  const report::DataTable& two = study.stages[1];
  const Extremes y1 = extremes(one, "Y1");
  Status status = page.add_figure(
      {"Figure 3", "fig03"}, artifact_maps(study, one, y1.high),
      report::described_artifacts(one, kThree),
      "the three artifacts after one smoothing stage; rotated copies of one another.",
      fmt::format(
          "each from {:.4g} to {:.4g}, the largest in the middle of the sides of the region.",
          y1.low, y1.high));
  if (!status) return status;
  figure::Figure four(2);
  report::DescribedTable numbers = report::described_artifacts(one, {});
  int stages = 0;
  for (const auto& [table, words] : {std::pair{&one, "one stage"}, std::pair{&two, "two stages"}}) {
    ++stages;
    for (const auto& [name, title] :
         {std::pair{"sum", "sum"}, std::pair{"mean_energy", "mean energy"}}) {
      four.add(report::artifact_map_panel(study.grid, *table, name,
                                          fmt::format("{}, {}", title, words)));
      report::append_column(numbers, *table, name,
                            {fmt::format("{}_{}", name, stages),
                             fmt::format("{}, after {}", report::artifact_meaning(name), words)});
    }
  }
  status = page.add_figure(
      {"Figure 4", "fig04"}, four, numbers,
      "sum and mean energy of the artifacts after one and after two smoothing stages; \"note the "
      "difference in scale of a factor of 10\".",
      fmt::format("the sums reach {:.4g} and {:.4g}, the mean energies {:.4g} and {:.4g}: less by "
                  "factors of {:.3g} and {:.3g}.",
                  extremes(one, "sum").high, extremes(two, "sum").high,
                  extremes(one, "mean_energy").high, extremes(two, "mean_energy").high,
                  stage_ratio(study, "sum"), stage_ratio(study, "mean_energy")));
  if (!status) return status;
  figure::Figure five(2);
  five.add(report::artifact_map_panel(study.grid, one, "signal", "signal"));
  five.add(
      report::artifact_map_panel(study.grid, one, "percent_of_signal", "mean energy, % of signal"));
  return page.add_figure(
      {"Figure 5", "fig05"}, five,
      report::described_artifacts(one, {"signal", "percent_of_signal"}),
      "signal and artifacts in percent of it after one step with one smoothing stage.",
      fmt::format("the signal falls to {:.4g}; the artifacts reach {:.4g} % of it.",
                  extremes(one, "signal").low, extremes(one, "percent_of_signal").high));
}

Status add_scheme_figures(PaperPage& page, const Study& study, std::size_t which, int first) {
  const report::DataTable& table = study.limit[which];
  const std::string& name = study.schemes[which].name;
  const Extremes y1 = extremes(table, "Y1");
  const auto item = [&](int number) {
    return PaperItem{fmt::format("Figure {}", number), fmt::format("fig{:02}", number)};
  };
  Status status = page.add_figure(
      item(first), artifact_maps(study, table, y1.high), report::described_artifacts(table, kThree),
      fmt::format("the three artifacts in the limit surface, {}.", name),
      fmt::format("from {:.3g} to {:.4g}, at f = ({:.3f}, {:.3f}).", y1.low, y1.high, y1.at[0],
                  y1.at[1]));
  if (!status) return status;
  figure::Figure figure(3);
  figure.add(report::artifact_map_panel(study.grid, table, "signal", "signal"));
  figure.add(report::artifact_overlay_panel(study.grid, table, "artifacts"));
  figure.add(report::artifact_map_panel(study.grid, table, "percent_of_signal",
                                        "mean energy, % of signal"));
  return page.add_figure(
      item(first + 1), figure, report::described_artifacts(table),
      fmt::format("signal, the three artifacts in red, green and blue, and their energy in percent "
                  "of the signal, in the limit, {}.",
                  name),
      fmt::format(
          "the signal falls to {:.4g} at the corners; the energy reaches {:.4g} % of it. All "
          "waves of the limit surface together (a column of the numbers) reach {:.4g} %.",
          extremes(table, "signal").low, extremes(table, "percent_of_signal").high,
          extremes(table, "total_energy_percent").high));
}

Status add_comparison(PaperPage& page, const Study& study) {
  double high = 0;
  for (const report::DataTable& table : study.limit)
    high = std::max(high, extremes(table, "percent_of_signal").high);
  figure::Figure figure(3);
  report::DescribedTable numbers = report::described_artifacts(study.limit.front(), {});
  for (std::size_t i = 0; i < study.schemes.size(); ++i) {
    figure.add(report::artifact_map_panel(study.grid, study.limit[i], "percent_of_signal",
                                          study.schemes[i].name, {0.0, high}));
    report::append_column(numbers, study.limit[i], "percent_of_signal",
                          {study.schemes[i].name + " percent",
                           report::artifact_meaning("percent_of_signal") + ", in the limit"});
  }
  return page.add_figure(
      {"Figure 12", "fig12"}, figure, numbers,
      "the energy of the artifacts in percent of the signal for the three schemes on one scale.",
      "the same maps; the first row of the claims below compares them node by node.");
}

}  // namespace
}  // namespace ads

Status write_augsdorfer(const std::string& directory, const PaperProgress& progress) {
  if (!figure::figures_available())
    return Error{"this limn draws no figures", "build it with cairo (LIMN_FIGURES)"};
  const Result<ads::Study> study = ads::study();
  if (!study) return study.error();
  PaperPage page(directory, ads::kTitle, ads::kCitation, progress);
  if (Status status = ads::add_wave(page); !status) return status;
  if (Status status = ads::add_lattices(page, *study); !status) return status;
  if (Status status = ads::add_stage_figures(page, *study); !status) return status;
  for (std::size_t which = 0; which < study->schemes.size(); ++which) {
    if (Status status = ads::add_table(page, *study, which); !status) return status;
    const int first = 6 + 2 * static_cast<int>(which);
    if (Status status = ads::add_scheme_figures(page, *study, which, first); !status) return status;
  }
  if (Status status = ads::add_comparison(page, *study); !status) return status;
  if (Status status = ads::add_words(page, *study); !status) return status;
  return page.write_index();
}

}  // namespace limn
