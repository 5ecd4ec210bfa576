#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "limn/regular/artifact_map.h"
#include "limn/report/json_number.h"
#include "limn/report/lattice/artifact_report.h"
#include "page_state.h"

namespace limn::page {
namespace {

constexpr double kLargestFrequency = 1000;
constexpr int kMostSize = 512;
constexpr int kMostWaveLevels = 4;
constexpr double kWavesWithin =
    7;  // cycles per control edge: waves beyond are left out of a surface

Status check_frequency(double fx, double fy) {
  if (std::hypot(fx, fy) <= kLargestFrequency) return Done{};
  return Error{
      fmt::format("the frequency is not within {} cycles per control edge", kLargestFrequency)};
}

/// Whether f is in the region with these corners, counterclockwise.
bool is_within(const std::vector<Frequency>& corners, Frequency f) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Frequency a = corners[i], b = corners[(i + 1) % corners.size()];
    if ((b[0] - a[0]) * (f[1] - a[1]) - (b[1] - a[1]) * (f[0] - a[0]) < -1e-12) return false;
  }
  return true;
}

/// Artifacts in percent of the signal at each frequency of a grid.
std::vector<double> percents(const ArtifactAnalysis& analysis, const regular::FrequencyGrid& grid,
                             bool by_energy) {
  const auto nx = static_cast<std::size_t>(grid.nx), ny = static_cast<std::size_t>(grid.ny);
  std::vector<double> values(nx * ny);
  if (by_energy) {
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = analysis.energy_percent({grid.x0 + static_cast<double>(i % nx) * grid.dx,
                                           grid.y0 + static_cast<double>(i / nx) * grid.dy});
    return values;
  }
  const std::vector<std::vector<double>> map = regular::limit_map(analysis, grid);
  Components components;
  components.artifacts.resize(map.size() - 1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    components.signal = map[0][i];
    for (std::size_t c = 1; c < map.size(); ++c) components.artifacts[c - 1] = map[c][i];
    values[i] = components.percent_of_signal();
  }
  return values;
}

/// A wave of the limit surface.
struct Harmonic {
  Frequency frequency;
  double amplitude;
};

/// Those of the wave f in the limit, the signal first; without what is too fine to see.
std::vector<Harmonic> harmonics(const ArtifactAnalysis& analysis, Lattice lattice, Frequency f) {
  std::vector<Harmonic> waves{{f, analysis.amplitude(f)}};
  const int reach = static_cast<int>(kWavesWithin) + 2;
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j) {
      const double turn = 2 * std::numbers::pi;
      const Frequency step = frequency_of_phase(lattice, {turn * i, turn * j});
      const Frequency g{f[0] + step[0], f[1] + step[1]};
      if ((i != 0 || j != 0) && std::hypot(g[0] - f[0], g[1] - f[1]) <= kWavesWithin)
        waves.push_back({g, analysis.amplitude(g)});
    }
  return waves;
}

/// A square of points, `size` a side, the middle one at 0.
struct Square {
  double half = 0;
  std::size_t size = 0;
  [[nodiscard]] double at(std::size_t i) const {
    return half * (2 * static_cast<double>(i) / static_cast<double>(size - 1) - 1);
  }
};

/// Adds the wave at the points of the square, row by row.
void add_wave(const Harmonic& wave, const Square& square, std::vector<double>& heights) {
  const double turn = 2 * std::numbers::pi;
  std::vector<std::complex<double>> along(square.size);
  for (std::size_t i = 0; i < square.size; ++i)
    along[i] = std::polar(wave.amplitude, turn * wave.frequency[0] * square.at(i));
  for (std::size_t j = 0; j < square.size; ++j) {
    const std::complex<double> across = std::polar(1.0, turn * wave.frequency[1] * square.at(j));
    double* row = heights.data() + j * square.size;
    for (std::size_t i = 0; i < square.size; ++i)
      row[i] += along[i].real() * across.real() - along[i].imag() * across.imag();
  }
}

std::vector<std::uint32_t> triangles_of(const Square& square) {
  std::vector<std::uint32_t> triangles;
  const auto n = static_cast<std::uint32_t>(square.size);
  for (std::uint32_t j = 0; j + 1 < n; ++j)
    for (std::uint32_t i = 0; i + 1 < n; ++i) {
      const std::uint32_t a = j * n + i, b = a + 1, c = a + n + 1, d = a + n;
      triangles.insert(triangles.end(), {a, b, c, a, c, d});
    }
  return triangles;
}

/// Two wavelengths, or as much of the control mesh as shows its edges.
double shown_half(Frequency f) {
  const double length = std::hypot(f[0], f[1]);
  return length == 0 ? 4 : std::clamp(1 / length, 2.0, 8.0);
}

Json made_wave(const std::vector<Harmonic>& waves, const Square& square, WaveAnswer& made) {
  const std::size_t points = square.size * square.size;
  std::vector<double> signal(points), errors(points);
  add_wave(waves.front(), square, signal);
  for (std::size_t w = 1; w < waves.size(); ++w) add_wave(waves[w], square, errors);
  double largest = 0;
  for (std::size_t p = 0; p < points; ++p) {
    made.positions.push_back(static_cast<float>(square.at(p % square.size)));
    made.positions.push_back(static_cast<float>(square.at(p / square.size)));
    made.positions.push_back(static_cast<float>(signal[p] + errors[p]));
    made.errors.push_back(static_cast<float>(errors[p]));
    largest = std::max(largest, std::abs(errors[p]));
  }
  made.triangles = triangles_of(square);
  return {{"extent", {-square.half, -square.half, square.half, square.half}},
          {"size", square.size},
          {"signal", waves.front().amplitude},
          {"waves", waves.size()},
          {"largest_error", largest}};
}

}  // namespace

std::string PageCore::artifacts(int scheme, double fx, double fy) {
  return answer([&]() -> Result<Json> {
    const auto loaded = state_->schemes.find(scheme);
    if (!loaded) return loaded.error();
    if (Status status = check_frequency(fx, fy); !status) return status.error();
    const Result<const study::NamedAnalysis*> lattice = lattice_of(**loaded);
    if (!lattice) return lattice.error();
    return report::artifacts_json(**lattice, {fx, fy}, study::Stage{});
  });
}

std::string PageCore::sampling(int scheme, double percent) {
  return answer([&]() -> Result<Json> {
    const auto loaded = state_->schemes.find(scheme);
    if (!loaded) return loaded.error();
    if (!(percent >= kLeastTolerance && percent <= 100))
      return Error{fmt::format("the tolerance is not between {} and 100 percent", kLeastTolerance)};
    const Result<const study::NamedAnalysis*> lattice = lattice_of(**loaded);
    if (!lattice) return lattice.error();
    return report::sampling_json(**lattice, percent, (*loaded)->densities);
  });
}

FieldAnswer PageCore::artifact_map(int scheme, int size, const std::string& measure) {
  FieldAnswer made;
  made.json = answer([&]() -> Result<Json> {
    const auto loaded = state_->schemes.find(scheme);
    if (!loaded) return loaded.error();
    const bool by_energy = measure == "total_energy";
    if (!by_energy && measure != "mean_energy")
      return Error{"the measure is neither mean_energy nor total_energy"};
    if (size < 2 || size > kMostSize)
      return Error{fmt::format("the size {} is not between 2 and {}", size, kMostSize)};
    const Result<const study::NamedAnalysis*> lattice = lattice_of(**loaded);
    if (!lattice) return lattice.error();
    const ArtifactAnalysis& analysis = (*lattice)->analysis;
    const Status& known = by_energy ? analysis.energy_status() : analysis.limit_status();
    if (!known) return known.error();
    const Lattice kind = (*loaded)->scheme.split->lattice;
    const regular::FrequencyGrid grid = regular::nyquist_grid(kind, size, size);
    const std::vector<Frequency> cell = nyquist_region(kind);
    const std::vector<double> values = percents(analysis, grid, by_energy);
    double largest = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto side = static_cast<std::size_t>(size);
      const Frequency f{grid.x0 + static_cast<double>(i % side) * grid.dx,
                        grid.y0 + static_cast<double>(i / side) * grid.dy};
      const bool inside = is_within(cell, f);
      if (inside && std::isfinite(values[i])) largest = std::max(largest, values[i]);
      made.values.push_back(inside ? static_cast<float>(values[i])
                                   : std::numeric_limits<float>::quiet_NaN());
    }
    const double x0 = grid.x0 - grid.dx / 2, y0 = grid.y0 - grid.dy / 2;
    return Json{{"size", size},
                {"extent", {x0, y0, x0 + size * grid.dx, y0 + size * grid.dy}},
                {"lattice", kind == Lattice::triangle ? "triangles" : "quads"},
                {"cell", pairs_json(cell)},
                {"measure", measure},
                {"largest", report::finite(largest)}};
  });
  return made;
}

WaveAnswer PageCore::wave(int scheme, double fx, double fy, int levels) {
  WaveAnswer made;
  made.json = answer([&]() -> Result<Json> {
    const auto loaded = state_->schemes.find(scheme);
    if (!loaded) return loaded.error();
    if (Status status = check_frequency(fx, fy); !status) return status.error();
    if (levels < 0 || levels > kMostWaveLevels)
      return Error{fmt::format("{} levels are not between 0 and {}", levels, kMostWaveLevels)};
    const Result<const study::NamedAnalysis*> lattice = lattice_of(**loaded);
    if (!lattice) return lattice.error();
    const ArtifactAnalysis& analysis = (*lattice)->analysis;
    if (!analysis.limit_status()) return analysis.limit_status().error();
    const std::vector<Harmonic> waves =
        harmonics(analysis, (*loaded)->scheme.split->lattice, {fx, fy});
    return made_wave(waves, {shown_half({fx, fy}), (std::size_t{16} << levels) + 1}, made);
  });
  return made;
}

}  // namespace limn::page
