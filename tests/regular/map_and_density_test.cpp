// The quick map against the components one by one, and sampling densities against the measure.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "limn/regular/artifact_map.h"
#include "limn/regular/artifacts.h"
#include "limn/regular/regular_mask.h"
#include "regular/wave_oracle.h"

namespace limn::test {
namespace {

void expect_map(const std::string& name, const ArtifactAnalysis& analysis,
                const regular::FrequencyGrid& grid) {
  const std::vector<std::vector<double>> map = regular::limit_map(analysis, grid);
  ASSERT_EQ(map.size(), static_cast<std::size_t>(analysis.artifact_count()) + 1) << name;
  for (const std::vector<double>& component : map)
    ASSERT_EQ(component.size(),
              static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny));
  for (int j = 0; j < grid.ny; ++j) {
    for (int i = 0; i < grid.nx; ++i) {
      std::vector<double> here;
      for (const std::vector<double>& component : map)
        here.push_back(component[static_cast<std::size_t>(j * grid.nx + i)]);
      const Frequency f = {grid.x0 + i * grid.dx, grid.y0 + j * grid.dy};
      EXPECT_LT(distance(here, all(analysis.in_limit(f)), is_dual(analysis.mask())), 1e-13)
          << name << " at " << f[0] << ", " << f[1];
    }
  }
}

TEST(LimitMap, IsTheComponentsOneByOne) {
  std::mt19937 random(4);
  const auto draw = [&](double size) { return size * (random() % 20001 / 10000. - 1); };
  for (const auto& [name, mask] : many_masks()) {
    const ArtifactAnalysis analysis = analysis_of(mask);
    for (const auto& [nx, ny] : {std::pair{1, 1}, {1, 5}, {7, 1}, {9, 6}}) {
      const double x0 = draw(3), y0 = draw(3), dx = draw(.5);  // far beyond Nyquist, too
      expect_map(name, analysis, {x0, y0, dx, draw(.5), nx, ny});
    }
    expect_map(name, analysis, regular::nyquist_grid(analysis.mask().lattice, 6, 5));
  }
}

TEST(NyquistGrid, FillsTheBoxOfTheNyquistRegion) {
  const regular::FrequencyGrid hexagon = regular::nyquist_grid(Lattice::triangle, 4, 3);
  EXPECT_EQ(hexagon.nx, 4);
  EXPECT_EQ(hexagon.ny, 3);
  EXPECT_NEAR(hexagon.dx, 4 / 3. / 4, 1e-15);
  EXPECT_NEAR(hexagon.dy, 2 / kSqrt3 / 3, 1e-15);
  EXPECT_NEAR(hexagon.x0, -2 / 3. + hexagon.dx / 2, 1e-15);
  EXPECT_NEAR(hexagon.y0, -1 / kSqrt3 + hexagon.dy / 2, 1e-15);
  const regular::FrequencyGrid square = regular::nyquist_grid(Lattice::quad, 1, 2);
  EXPECT_NEAR(square.x0, 0, 1e-15);
  EXPECT_NEAR(square.y0, -.25, 1e-15);
  EXPECT_NEAR(square.dx, 1, 1e-15);
  EXPECT_NEAR(square.dy, .5, 1e-15);
}

double measured(const ArtifactAnalysis& analysis, ArtifactMeasure measure, double degrees,
                double size) {
  const double angle = degrees * M_PI / 180;
  const Frequency f = {size * std::cos(angle), size * std::sin(angle)};
  return measure == ArtifactMeasure::total_energy ? analysis.energy_percent(f)
                                                  : analysis.in_limit(f).percent_of_signal();
}

/// |f| at the rim of the Nyquist region: half-way to the nearest dual lattice point beyond it.
double rim(Lattice lattice, double degrees) {
  double least = 1e9;
  const double angle = degrees * M_PI / 180;
  for (const auto& [p, q] : {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}}) {
    const Frequency k = frequency_along(lattice, p, q);
    const double dot = std::abs(k[0] * std::cos(angle) + k[1] * std::sin(angle));
    if (dot > 1e-12) least = std::min(least, (k[0] * k[0] + k[1] * k[1]) / 2 / dot);
  }
  return least;
}

void expect_density(const std::string& name, double tolerance, ArtifactMeasure measure) {
  const ArtifactAnalysis& analysis = shipped_analysis(name);
  const Lattice lattice = analysis.mask().lattice;
  const Result<SamplingDensity> density = sampling_density(analysis, tolerance, measure);
  ASSERT_TRUE(density.ok()) << name << density.error().text();
  EXPECT_EQ(density->tolerance, tolerance);
  ASSERT_EQ(density->directions.size(), 180U);
  const std::size_t sector = lattice == Lattice::triangle ? 60 : 90;
  for (std::size_t d = 0; d < 180; ++d) {
    const DirectionalDensity& here = density->directions[d];
    EXPECT_NEAR(here.direction, static_cast<double>(d), 1e-12);
    EXPECT_NEAR(here.frequency * here.edges_per_wavelength, 1, 1e-12);
    const double limit = rim(lattice, here.direction);
    if (here.reached) {
      const double at = measured(analysis, measure, here.direction, here.frequency);
      EXPECT_NEAR(at / tolerance, 1, 1e-5) << name << " " << d;
      EXPECT_GT(measured(analysis, measure, here.direction, here.frequency * (1 + 1e-5)),
                tolerance);
      EXPECT_LE(here.frequency, limit + 1e-12);
    } else {
      EXPECT_NEAR(here.frequency, limit, 1e-12) << name << " " << d;
    }
    for (int i = 1; i < 40; ++i)
      EXPECT_LE(measured(analysis, measure, here.direction, here.frequency * i / 40),
                tolerance * (1 + 1e-9))
          << name << " " << d;
    const DirectionalDensity& turned = density->directions[(d + sector) % 180];
    EXPECT_NEAR(here.frequency, turned.frequency, 1e-9) << name << " " << d;
    EXPECT_LE(density->worst.frequency, here.frequency + 1e-12);
    EXPECT_GE(density->best.frequency, here.frequency - 1e-12);
  }
}

TEST(SamplingDensity, IsWhereTheMeasureMeetsTheTolerance) {
  for (const char* name : {"loop", "sqrt3", "doo-sabin", "butterfly", "interpolating-loop",
                           "laplacian-butterfly", "laplacian-loop", "optimal-high"})
    expect_density(name, 1, ArtifactMeasure::mean_energy);
  for (const char* name : {"loop", "sqrt3", "doo-sabin", "catmull-clark", "four-eight"})
    expect_density(name, 1, ArtifactMeasure::total_energy);
  for (const double tolerance : {.05, 5., 30., 100.}) {
    expect_density("loop", tolerance, ArtifactMeasure::total_energy);
    expect_density("interpolating-loop", tolerance, ArtifactMeasure::mean_energy);
  }
}

TEST(SamplingDensity, OfMasksWithoutTheLatticesSymmetriesIsThatOfEachDirection) {
  for (const std::vector<std::string>& counts : std::vector<std::vector<std::string>>{
           {"i=3", "j=1", "k3=1"}, {"i=2", "j=2", "k3=4"}, {"i=5", "j=3", "k3=1"}}) {
    Scheme scheme = find_scheme("box-spline-triangle").value();
    ASSERT_TRUE(set_parameters(scheme, counts).ok());
    const ArtifactAnalysis analysis = ArtifactAnalysis::of(regular_mask(scheme).value()).value();
    for (const ArtifactMeasure measure :
         {ArtifactMeasure::mean_energy, ArtifactMeasure::total_energy})
      for (const SamplingDensity density = sampling_density(analysis, 2, measure).value();
           const DirectionalDensity& here : density.directions)
        if (here.reached) {
          EXPECT_NEAR(measured(analysis, measure, here.direction, here.frequency), 2, 1e-4)
              << here.direction;
        }
  }
}

TEST(SamplingDensity, IsWorstInADirectionThatItNames) {
  for (const char* name : {"loop", "catmull-clark", "sqrt3", "four-eight"}) {
    const SamplingDensity density =
        sampling_density(shipped_analysis(name), 1, ArtifactMeasure::total_energy).value();
    for (const DirectionalDensity& end : {density.worst, density.best}) {
      EXPECT_NEAR(measured(shipped_analysis(name), ArtifactMeasure::total_energy, end.direction,
                           end.frequency),
                  1, 1e-5);
      EXPECT_GE(end.direction, 0);
      EXPECT_LT(end.direction, 180);
    }
  }
}

TEST(SamplingDensity, RefusesTolerancesWithoutMeaning) {
  for (const double tolerance : {0., -1., 1000., 100.001, kLeastTolerance / 2, std::nan(""),
                                 std::numeric_limits<double>::infinity()}) {
    const Result<SamplingDensity> density =
        sampling_density(shipped_analysis("loop"), tolerance, ArtifactMeasure::total_energy);
    ASSERT_FALSE(density.ok()) << tolerance;
    EXPECT_NE(density.error().message.find("tolerance"), std::string::npos);
  }
}

TEST(SamplingDensity, IsWhereTheToleranceIsFirstExceededNotLast) {
  // tensor mask (1+z)²/4 · (-c/2, 1+c, -c/2) with c = -.586: the artifact along the axis rises,
  // vanishes again half way to the rim, and rises anew
  const Rational c(-586, 1000);
  const Laurent line = product(power(centred_box({1, 0}, 2), 2),
                               Laurent{{{-2, 0}, -c / 2}, {{0, 0}, 1 + c}, {{2, 0}, -c / 2}});
  Laurent across;
  for (const auto& [k, value] : line) across[{k[1], k[0]}] = value;
  const Mask mask{
      Lattice::quad, {{{{2, 0}, {0, 2}}}}, scaled(product(line, across), Rational(1, 4))};
  ASSERT_EQ(total(mask.coefficients), 4);
  const ArtifactAnalysis analysis = ArtifactAnalysis::of(mask).value();
  const auto percent = [&](double f) { return analysis.in_limit({f, 0}).percent_of_signal(); };
  const double top = percent(0.16);
  const double tolerance = top / 2;
  ASSERT_LT(percent(0.25), tolerance / 10);  // it vanishes there
  ASSERT_GT(percent(0.45), top);
  const SamplingDensity density =
      sampling_density(analysis, tolerance, ArtifactMeasure::mean_energy).value();
  EXPECT_LT(density.directions.front().frequency, 0.16);
  EXPECT_NEAR(percent(density.directions.front().frequency), tolerance, 1e-9);
}

}  // namespace
}  // namespace limn::test
