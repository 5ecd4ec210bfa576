#include "limn/report/lattice/artifact_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "limn/regular/regular_mask.h"
#include "limn/report/lattice/artifact_figures.h"
#include "limn/report/lattice/lattice_report.h"
#include "support/shipped.h"

namespace limn {
namespace {

study::NamedAnalysis named(const std::string& name) {
  return {name, ArtifactAnalysis::of(regular_mask(find_scheme(name).value()).value()).value()};
}

TEST(SamplingDensities, AreFoundOnceForEachMask) {
  // five schemes of Loop's mask, and the butterfly twice
  std::vector<study::NamedAnalysis> schemes;
  for (const char* name : {"loop", "loop-warren", "loop-7-flat", "butterfly", "loop-7-bounded",
                           "loop-7-shrinking", "butterfly-modified"})
    schemes.push_back(named(name));
  study::SamplingDensities densities;
  const std::string text = report::sampling_text(schemes, 1, densities).value();
  EXPECT_EQ(densities.computed(), 4U);  // two masks, two measures
  for (const study::NamedAnalysis& scheme : schemes) {
    const SamplingDensity alone =
        sampling_density(scheme.analysis, 1, ArtifactMeasure::mean_energy).value();
    const SamplingDensity shared =
        densities.at(scheme.analysis, 1, ArtifactMeasure::mean_energy).value();
    EXPECT_EQ(shared.worst.frequency, alone.worst.frequency) << scheme.name;
    EXPECT_EQ(shared.best.direction, alone.best.direction) << scheme.name;
  }
  EXPECT_EQ(densities.computed(), 4U);
  EXPECT_NE(densities.at(schemes[0].analysis, 2, ArtifactMeasure::mean_energy)->worst.frequency,
            densities.at(schemes[0].analysis, 1, ArtifactMeasure::mean_energy)->worst.frequency);
}

double area(const figure::TriangleGrid& grid) {
  double sum = 0;
  for (const auto& [a, b, c] : grid.triangles) {
    const auto at = [&](int i) { return grid.nodes[static_cast<std::size_t>(i)]; };
    const double part = ((at(b)[0] - at(a)[0]) * (at(c)[1] - at(a)[1]) -
                         (at(c)[0] - at(a)[0]) * (at(b)[1] - at(a)[1])) /
                        2;
    EXPECT_GT(part, 0);  // counterclockwise
    sum += part;
  }
  return sum;
}

TEST(FrequencyGrid, FillsTheNyquistRegionOnce) {
  // one cell of the dual lattice: area 1 / area of a control cell
  EXPECT_NEAR(area(report::frequency_grid(Lattice::triangle, 7)), 2 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(area(report::frequency_grid(Lattice::quad, 5)), 1, 1e-12);
  const figure::TriangleGrid hexagon = report::frequency_grid(Lattice::triangle, 4);
  EXPECT_EQ(hexagon.nodes.size(), 1U + 6 * (4 * 5 / 2));  // none twice
}

TEST(ArtifactTable, HoldsWhatTheAnalysisSays) {
  const study::NamedAnalysis loop = named("loop");
  const figure::TriangleGrid grid = report::frequency_grid(Lattice::triangle, 3);
  const report::DataTable table = report::artifact_table(loop.analysis, {}, grid).value();
  ASSERT_EQ(table.rows.size(), grid.nodes.size());
  const std::vector<double> y2 = report::column(table, "Y2");
  const std::vector<double> total = report::column(table, "total_energy_percent");
  for (std::size_t i = 0; i < grid.nodes.size(); ++i) {
    EXPECT_EQ(y2[i], loop.analysis.in_limit(grid.nodes[i]).artifacts[1]);
    EXPECT_EQ(total[i], loop.analysis.energy_percent(grid.nodes[i]));
  }
}

TEST(ArtifactCurve, EndsAtTheRim) {
  const report::DataTable along = report::artifact_curve(named("loop").analysis, {}, 0, 11).value();
  EXPECT_NEAR(along.rows.back().front(), 2.0 / 3, 1e-12);
  const report::DataTable across =
      report::artifact_curve(named("catmull-clark").analysis, {}, 45, 11).value();
  EXPECT_NEAR(across.rows.back().front(), std::sqrt(0.5), 1e-12);
}

TEST(ArtifactJson, HasNullWhereTheSignalVanishes) {
  // linear interpolation's signal vanishes at the corners' double: use a scheme with m(θ) = 0
  const study::NamedAnalysis spline = named("box-spline-quad");
  const auto json = report::artifacts_json(spline, {1, 0}, {study::Stage::Kind::steps, 1}).value();
  EXPECT_NEAR(json.at("signal").get<double>(), 0, 1e-15);
  const auto zero = report::artifacts_json(spline, {0, 0}, {}).value();
  EXPECT_EQ(zero.at("percent_of_signal").get<double>(), 0);
}

TEST(DataTable, ReadsBack) {
  const double inf = std::numeric_limits<double>::infinity();
  const report::DataTable table{{"a", "b"}, {{0.1, 1e300}, {-inf, std::nan("")}}};
  EXPECT_EQ(report::csv_text(table), "a,b\n0.1,1e+300\n,\n");
  const auto json = nlohmann::json::parse(report::json_text(table));
  EXPECT_EQ(json.at("rows")[0][0].get<double>(), 0.1);
  EXPECT_TRUE(json.at("rows")[1][1].is_null());
  EXPECT_FALSE(report::write_table("x.txt", table).ok());
}

TEST(Factors, AreSaidInWords) {
  const auto words = [](const std::string& name, const std::vector<std::string>& parameters = {}) {
    Scheme scheme = find_scheme(name).value();
    EXPECT_TRUE(set_parameters(scheme, parameters).ok());
    return report::factors_in_words(regular_mask(scheme).value());
  };
  EXPECT_EQ(words("loop"), "2 smoothing stages");
  EXPECT_EQ(words("butterfly"), "1 smoothing stage, a kernel");
  EXPECT_EQ(words("interpolating-loop"), "2 smoothing stages, a kernel");
  EXPECT_EQ(words("catmull-clark"), "4 smoothing stages");
  EXPECT_EQ(words("box-spline-triangle", {"i=4"}), "2 smoothing stages, direction (1, 0) 2 times");
  EXPECT_EQ(words("sqrt3"), "none; the mask is its own kernel");
}

TEST(LatticeLatex, BalancesItsBraces) {
  for (const std::string& name : test::lattice_names()) {
    const std::string latex =
        report::lattice_latex(name, regular_mask(test::shipped(name)).value());
    int open = 0;
    for (const char c : latex) {
      open += c == '{' ? 1 : c == '}' ? -1 : 0;
      ASSERT_GE(open, 0) << name;
    }
    EXPECT_EQ(open, 0) << name;
    EXPECT_NE(latex.find("\\begin{align*}"), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace limn
