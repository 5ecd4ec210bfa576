#include "limn/report/lattice/artifact_figures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <fmt/core.h>

#include "limn/base/parallel.h"

namespace limn::report {
namespace {

constexpr int kSubdivisions = 48;  // so that contour lines look smooth at a page's width
constexpr int kCurvePoints = 241;
constexpr const char* kLabelX = "f_{x}, cycles per edge";
constexpr const char* kLabelY = "f_{y}, cycles per edge";
constexpr double kSide = 40;  // so that maps and overlays in a row have one size

std::vector<std::string> value_columns(const ArtifactAnalysis& analysis) {
  std::vector<std::string> names{"signal"};
  for (int i = 0; i < analysis.artifact_count(); ++i) names.push_back(study::artifact_name(i));
  for (const char* name : {"sum", "mean_energy", "percent_of_signal", "total_energy_percent"})
    names.emplace_back(name);
  return names;
}

void append_values(const study::StageValues& values, std::vector<double>& row) {
  const Components& components = values.components;
  row.push_back(components.signal);
  row.insert(row.end(), components.artifacts.begin(), components.artifacts.end());
  row.push_back(components.sum());
  row.push_back(components.mean_energy());
  row.push_back(components.percent_of_signal());
  row.push_back(values.total_energy_percent);
}

/// Rows that begin as given, followed by the values at their frequencies.
Result<DataTable> with_values(const ArtifactAnalysis& analysis, study::Stage stage, DataTable table,
                              const std::vector<Frequency>& frequencies) {
  const Result<study::StageValuesAt> values_at = study::StageValuesAt::of(analysis, stage);
  if (!values_at) return values_at.error();
  for (std::string& name : value_columns(analysis)) table.columns.push_back(std::move(name));
  constexpr std::ptrdiff_t kGrain = 64;
  base::parallel_for(
      std::size_t{0}, frequencies.size(),
      [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
          append_values((*values_at)(frequencies[i]), table.rows[i]);
      },
      kGrain);
  return table;
}

}  // namespace

figure::TriangleGrid frequency_grid(Lattice lattice, int subdivisions) {
  figure::TriangleGrid grid;
  const std::vector<Frequency> corners = nyquist_region(lattice);
  const int sectors = static_cast<int>(corners.size());
  std::map<std::array<int, 3>, int> known;  // rays belong to the sector that they begin
  const auto node = [&](int sector, int i, int j) {
    if (i == 0 && j > 0) {
      sector = (sector + 1) % sectors;
      std::swap(i, j);
    }
    if (i == 0 && j == 0) sector = 0;
    const auto [entry, fresh] =
        known.try_emplace({sector, i, j}, static_cast<int>(grid.nodes.size()));
    if (fresh) {
      const Frequency& a = corners[static_cast<std::size_t>(sector)];
      const Frequency& b = corners[static_cast<std::size_t>((sector + 1) % sectors)];
      const double u = static_cast<double>(i) / subdivisions;
      const double v = static_cast<double>(j) / subdivisions;
      grid.nodes.push_back({u * a[0] + v * b[0], u * a[1] + v * b[1]});
    }
    return entry->second;
  };
  for (int s = 0; s < sectors; ++s)
    for (int i = 0; i < subdivisions; ++i)
      for (int j = 0; i + j < subdivisions; ++j) {
        grid.triangles.push_back({node(s, i, j), node(s, i + 1, j), node(s, i, j + 1)});
        if (i + j + 1 < subdivisions)
          grid.triangles.push_back({node(s, i + 1, j), node(s, i + 1, j + 1), node(s, i, j + 1)});
      }
  return grid;
}

Result<DataTable> artifact_table(const ArtifactAnalysis& analysis, study::Stage stage,
                                 const figure::TriangleGrid& grid) {
  DataTable table{{"fx", "fy"}, {}};
  for (const auto& [fx, fy] : grid.nodes) table.rows.push_back({fx, fy});
  return with_values(analysis, stage, std::move(table), grid.nodes);
}

Result<DataTable> artifact_curve(const ArtifactAnalysis& analysis, study::Stage stage,
                                 double direction_degrees, int points) {
  const double angle = direction_degrees * std::numbers::pi / 180;
  const double far = nyquist_distance(analysis.mask().lattice, direction_degrees);
  DataTable table{{"frequency"}, {}};
  std::vector<Frequency> frequencies;
  for (int i = 0; i < points; ++i) {
    const double length = far * i / (points - 1);
    table.rows.push_back({length});
    frequencies.push_back({length * std::cos(angle), length * std::sin(angle)});
  }
  return with_values(analysis, stage, std::move(table), frequencies);
}

std::vector<PrincipalDirection> principal_directions(Lattice lattice) {
  if (lattice == Lattice::triangle)
    return {{90, "f perpendicular to an edge"}, {0, "f along an edge"}};
  return {{90, "f along an edge"}, {45, "f along a diagonal"}};
}

std::vector<double> column(const DataTable& table, const std::string& name) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), name);
  std::vector<double> values;
  values.reserve(table.rows.size());
  for (const auto& row : table.rows)
    values.push_back(row[static_cast<std::size_t>(found - table.columns.begin())]);
  return values;
}

std::string artifact_meaning(const std::string& column_name) {
  static const std::map<std::string, std::string> meanings{
      {"fx", "frequency along x, where an edge lies [cycles per control edge]"},
      {"fy", "frequency along y [cycles per control edge]"},
      {"frequency", "|f| [cycles per control edge]"},
      {"signal", "signed magnitude of the signal [amplitudes of the sampled wave]"},
      {"sum", "sum of the artifacts [amplitudes of the sampled wave]"},
      {"mean_energy", "root mean square of the artifacts [amplitudes of the sampled wave]"},
      {"percent_of_signal", "mean energy of the artifacts [percent of the signal]"},
      {"total_energy_percent",
       "all other waves of the surface together, root of their energy [percent of the signal]"}};
  if (const auto found = meanings.find(column_name); found != meanings.end()) return found->second;
  return fmt::format("signed magnitude of artifact {} [amplitudes of the sampled wave]",
                     column_name);
}

DescribedTable described_artifacts(const DataTable& table, const std::vector<std::string>& names) {
  std::vector<DescribedColumn> columns;
  for (const char* name : {"fx", "fy"}) columns.push_back({name, artifact_meaning(name)});
  for (const std::string& name : names) columns.push_back({name, artifact_meaning(name)});
  return described(table, columns);
}

DescribedTable described_artifacts(const DataTable& table) {
  return described_artifacts(table, {table.columns.begin() + 2, table.columns.end()});
}

void append_column(DescribedTable& described, const DataTable& table, const std::string& name,
                   DescribedColumn column_described) {
  described.columns.push_back(std::move(column_described));
  const std::vector<double> values = column(table, name);
  for (std::size_t i = 0; i < values.size(); ++i) described.rows[i].emplace_back(values[i]);
}

namespace {

/// A column for drawing: where a magnitude vanishes, rounding must not draw contours of its own.
std::vector<double> drawn_column(const DataTable& table, const std::string& name) {
  std::vector<double> values = column(table, name);
  for (double& value : values)
    if (std::abs(value) < 1e-13) value = 0;
  return values;
}

}  // namespace

figure::MapPanel artifact_map_panel(const figure::TriangleGrid& grid, const DataTable& table,
                                    const std::string& column_name, const std::string& title,
                                    ValueScale scale) {
  figure::MapPanel panel;
  panel.grid = grid;
  panel.values = drawn_column(table, column_name);
  panel.title = title;
  panel.x_label = kLabelX;
  panel.y_label = kLabelY;
  panel.side = kSide;
  panel.low = scale.low;
  panel.high = scale.high;
  return panel;
}

figure::OverlayPanel artifact_overlay_panel(const figure::TriangleGrid& grid,
                                            const DataTable& table, const std::string& title) {
  figure::OverlayPanel panel;
  panel.grid = grid;
  panel.title = title;
  panel.x_label = kLabelX;
  panel.y_label = kLabelY;
  panel.side = kSide;
  double highest = 0;
  for (int i = 0; i < 3; ++i) {
    const std::string name = study::artifact_name(i);
    if (std::find(table.columns.begin(), table.columns.end(), name) == table.columns.end()) break;
    figure::OverlayPanel::Layer layer;
    layer.name = fmt::format("Y_{{{}}}", i + 1);
    layer.values = drawn_column(table, name);
    highest = std::max(highest, *std::max_element(layer.values.begin(), layer.values.end()));
    panel.layers.push_back(std::move(layer));
  }
  // one scale for all; what is 0 or less stays white
  for (figure::OverlayPanel::Layer& layer : panel.layers) {
    layer.low = highest / 1000;
    layer.high = highest;
  }
  return panel;
}

figure::ChartPanel artifact_chart_panel(const DataTable& curve, const std::string& title) {
  figure::ChartPanel panel;
  panel.title = title;
  panel.x_label = "|f|, cycles per control edge";
  const std::vector<double> x = column(curve, "frequency");
  for (const std::string& name : curve.columns) {
    if (name != "signal" && name[0] != 'Y') continue;
    figure::ChartPanel::Series series;
    series.name = name[0] == 'Y' ? fmt::format("Y_{{{}}}", name.substr(1)) : name;
    series.x = x;
    series.y = column(curve, name);
    panel.series.push_back(std::move(series));
  }
  return panel;
}

Result<figure::Figure> artifact_figure(const study::NamedAnalysis& scheme, study::Stage stage) {
  const ArtifactAnalysis& analysis = scheme.analysis;
  const figure::TriangleGrid grid = frequency_grid(analysis.mask().lattice, kSubdivisions);
  const Result<DataTable> table = artifact_table(analysis, stage, grid);
  if (!table) return table.error();
  figure::Figure figure(3);
  figure.title(fmt::format("{}: signal and artifacts {}", scheme.name, study::to_string(stage)));
  figure.add(artifact_map_panel(grid, *table, "signal", "signal"));
  figure.add(artifact_overlay_panel(grid, *table, "artifacts"));
  figure.add(artifact_map_panel(grid, *table, "percent_of_signal", "mean energy, % of signal"));
  ValueScale common{0.0, 0.0};
  for (int i = 0; i < analysis.artifact_count(); ++i)
    for (const double value : column(*table, study::artifact_name(i))) {
      common.low = std::min(*common.low, value);
      common.high = std::max(*common.high, value);
    }
  for (int i = 0; i < analysis.artifact_count(); ++i)
    figure.add(artifact_map_panel(grid, *table, study::artifact_name(i),
                                  fmt::format("artifact Y_{{{}}}", i + 1), common));
  figure.add(
      artifact_map_panel(grid, *table, "total_energy_percent", "all artifacts, % of signal"));
  for (const auto& [degrees, name] : principal_directions(analysis.mask().lattice)) {
    const Result<DataTable> curve = artifact_curve(analysis, stage, degrees, kCurvePoints);
    if (!curve) return curve.error();
    figure.add(artifact_chart_panel(*curve, name));
  }
  return figure;
}

Status write_artifact_map(const std::string& path, const study::NamedAnalysis& scheme,
                          study::Stage stage) {
  if (is_table_path(path)) {
    const figure::TriangleGrid grid = frequency_grid(scheme.analysis.mask().lattice, kSubdivisions);
    const Result<DataTable> table = artifact_table(scheme.analysis, stage, grid);
    if (!table) return table.error();
    return write_table(path, *table);
  }
  if (const Result<figure::FigureFormat> format = figure::figure_format(path); !format) {
    Error error = format.error();
    error.hint += error.hint.empty() ? ".csv and .json hold the numbers"
                                     : "; .csv and .json hold the numbers";
    return error;
  }
  const Result<figure::Figure> figure = artifact_figure(scheme, stage);
  if (!figure) return figure.error();
  return figure->write(path);
}

}  // namespace limn::report
