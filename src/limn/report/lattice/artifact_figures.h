#pragma once
/// Artifacts drawn: maps over the frequencies of the Nyquist region, curves along its principal
/// directions, and the numbers under them.

#include "limn/figure/figure.h"
#include "limn/report/data_table.h"
#include "limn/report/lattice/artifact_report.h"

namespace limn::report {

/// The Nyquist region cut into triangles: each of its sectors (six on triangles, four on quads)
/// into subdivisions² equal ones.
[[nodiscard]] figure::TriangleGrid frequency_grid(Lattice lattice, int subdivisions);

/// A scheme's magnitudes at the nodes of a grid, at one stage. Columns: fx, fy, signal, Y1 …, sum,
/// mean_energy, percent_of_signal, total_energy_percent; a row a node. Fails where
/// StageValuesAt::of does.
[[nodiscard]] Result<DataTable> artifact_table(const ArtifactAnalysis& analysis, study::Stage stage,
                                               const figure::TriangleGrid& grid);

/// The same along a ray from 0 to the border of the Nyquist region, `points` ≥ 2 of them. First
/// column "frequency", |f|; then as above.
[[nodiscard]] Result<DataTable> artifact_curve(const ArtifactAnalysis& analysis, study::Stage stage,
                                               double direction_degrees, int points);

/// The two principal directions, in degrees: towards the nearest point of the border, where waves
/// are perpendicular to a grid line (Y1), and towards a corner.
struct PrincipalDirection {
  double degrees;
  std::string name;
};
[[nodiscard]] std::vector<PrincipalDirection> principal_directions(Lattice lattice);

/// One column of a table, to be drawn.
[[nodiscard]] std::vector<double> column(const DataTable& table, const std::string& name);

/// What a column of artifact_table holds, and in what unit.
[[nodiscard]] std::string artifact_meaning(const std::string& column_name);

/// fx, fy and these columns of an artifact_table, described; all of them without names.
[[nodiscard]] DescribedTable described_artifacts(const DataTable& table);
[[nodiscard]] DescribedTable described_artifacts(const DataTable& table,
                                                 const std::vector<std::string>& names);

/// One more column, its values those of `name` in `table`; both have as many rows.
void append_column(DescribedTable& described, const DataTable& table, const std::string& name,
                   DescribedColumn column);

/// How a map's colours are scaled; without numbers by its own values.
struct ValueScale {
  std::optional<double> low, high;
};
/// A map of one column; the title in the figures' markup.
[[nodiscard]] figure::MapPanel artifact_map_panel(const figure::TriangleGrid& grid,
                                                  const DataTable& table,
                                                  const std::string& column_name,
                                                  const std::string& title, ValueScale scale = {});
/// The artifacts over one another, in red, green and blue [ADS Figs. 7, 9, 11].
[[nodiscard]] figure::OverlayPanel artifact_overlay_panel(const figure::TriangleGrid& grid,
                                                          const DataTable& table,
                                                          const std::string& title);
/// Signal and artifacts along a direction.
[[nodiscard]] figure::ChartPanel artifact_chart_panel(const DataTable& curve,
                                                      const std::string& title);

/// Everything about a scheme at one stage on one page.
[[nodiscard]] Result<figure::Figure> artifact_figure(const study::NamedAnalysis& scheme,
                                                     study::Stage stage);

/// `limn artifacts SCHEME --map FILE`: a .pdf, .svg or .png of artifact_figure, or a .csv or
/// .json of artifact_table.
[[nodiscard]] Status write_artifact_map(const std::string& path, const study::NamedAnalysis& scheme,
                                        study::Stage stage);

}  // namespace limn::report
