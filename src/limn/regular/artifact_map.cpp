#include "limn/regular/artifact_map.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "limn/base/interrupt.h"

namespace limn::regular {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// Σ weight cos(x fx + y fy + shift) over the terms of one y: weight cos(x fx + shift) and the
/// same with sin are tabulated over fx.
struct WaveRow {
  double y;
  std::vector<double> cosine, sine;
};

/// The rows of one component's symbol. `shift`: the component's phase per refined basis vector.
std::vector<WaveRow> rows_of(const Symbol& symbol, const Mask& mask, LatticeVector kappa,
                             const FrequencyGrid& grid) {
  const Phase shift = mask.dilation.refined_phase({kTurn * kappa[0], kTurn * kappa[1]});
  // θ is linear in f: its values at the unit frequencies
  const Phase per_x = mask.dilation.refined_phase(control_phase(mask.lattice, {1, 0}));
  const Phase per_y = mask.dilation.refined_phase(control_phase(mask.lattice, {0, 1}));
  const auto dot = [](std::array<double, 2> k, Phase theta) {
    return k[0] * theta[0] + k[1] * theta[1];
  };
  std::map<long long, WaveRow> rows;  // by y in units too small to tell two rows apart
  for (const auto& [k, weight] : symbol.terms()) {
    const double y = dot(k, per_y);
    // cos is even: rows below the axis join those above
    const double sign = y < -1e-9 ? -1 : 1;
    WaveRow& row = rows[std::llround(std::abs(y) * 1e6)];
    row.y = std::abs(y);
    row.cosine.resize(static_cast<std::size_t>(grid.nx));
    row.sine.resize(static_cast<std::size_t>(grid.nx));
    for (std::size_t i = 0; i < row.cosine.size(); ++i) {
      const double fx = grid.x0 + static_cast<double>(i) * grid.dx;
      const double angle = sign * (dot(k, per_x) * fx + dot(k, shift));
      row.cosine[i] += weight * std::cos(angle);
      row.sine[i] += weight * std::sin(angle);
    }
  }
  std::vector<WaveRow> list;
  list.reserve(rows.size());
  for (auto& [key, row] : rows) list.push_back(std::move(row));
  return list;
}

void add_scaled(double* sum, const std::vector<double>& values, double factor) {
  for (std::size_t i = 0; i < values.size(); ++i) sum[i] += factor * values[i];
}

}  // namespace

FrequencyGrid nyquist_grid(Lattice lattice, int nx, int ny) {
  double width = 0;
  double height = 0;
  for (const Frequency& corner : nyquist_region(lattice)) {
    width = std::max(width, 2 * corner[0]);
    height = std::max(height, 2 * corner[1]);
  }
  const double dx = width / nx;
  const double dy = height / ny;
  return {(dx - width) / 2, (dy - height) / 2, dx, dy, nx, ny};
}

std::vector<std::vector<double>> limit_map(const ArtifactAnalysis& analysis,
                                           const FrequencyGrid& grid) {
  const Mask& mask = analysis.mask();
  const Symbol symbol = product(analysis.symbol(), analysis.limit_symbol());
  const auto nx = static_cast<std::size_t>(grid.nx);
  std::vector<std::vector<double>> map;
  for (const LatticeVector kappa : dual_cosets(mask.dilation)) {
    const std::vector<WaveRow> rows = rows_of(symbol, mask, kappa, grid);
    std::vector<double> values(nx * static_cast<std::size_t>(grid.ny));
    for (int j = 0; j < grid.ny; ++j) {
      base::check_interrupt();
      const double fy = grid.y0 + j * grid.dy;
      double* line = values.data() + nx * static_cast<std::size_t>(j);
      for (const WaveRow& row : rows) {
        add_scaled(line, row.cosine, std::cos(row.y * fy));
        if (row.y > 0) add_scaled(line, row.sine, -std::sin(row.y * fy));
      }
    }
    map.push_back(std::move(values));
  }
  return map;
}

}  // namespace limn::regular
