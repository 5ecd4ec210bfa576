#include "limn/refine/fast/limit_zones.h"

#include <algorithm>
#include <cmath>

namespace limn::fast {
namespace {

/// Weights without the last digits of the eigenvectors that they come from: so those that symmetry
/// makes equal are, and what should be zero is.
std::vector<double> rounded(std::vector<double> weights) {
  double largest = 0;
  for (const double w : weights) largest = std::max(largest, std::abs(w));
  const double unit = std::ldexp(largest, -42);
  if (unit > 0)
    for (double& w : weights) w = unit * std::round(w / unit);
  return weights;
}

}  // namespace

ZoneTable limit_table(const LimitSums& sums, const StarShape& shape) {
  ZoneTable table;
  table.sectors = shape.sectors;
  table.targets = {SectorPoint{}};
  table.rows.sources = static_cast<int>(sums.weights[0].size());
  for (int i = 0; i < table.rows.sources; ++i) table.sources.push_back(sector_point(shape, i));
  for (const std::vector<double>& weights : sums.weights) {
    for (int i = 0; i < table.rows.sources; ++i)
      if (weights[static_cast<std::size_t>(i)] != 0)
        table.rows.terms.push_back({i, weights[static_cast<std::size_t>(i)]});
    table.rows.row_begin.push_back(static_cast<int>(table.rows.terms.size()));
  }
  return table;
}

LimitSums limit_of_isolated() { return {0, {{{1.0}, {0.0}, {0.0}}}}; }

std::vector<Stencil> limit_stencils(const LimitSums& sums, Lattice lattice) {
  const StarShape plane{lattice, plane_sectors(lattice), false};
  std::vector<Stencil> stencils;
  for (const std::vector<double>& exact : sums.weights) {
    const std::vector<double> weights = rounded(exact);
    Stencil& stencil = stencils.emplace_back();
    for (std::size_t i = 0; i < weights.size(); ++i)
      if (weights[i] != 0)
        stencil.push_back(
            {on_plane(lattice, sector_point(plane, static_cast<Index>(i))), weights[i]});
    std::sort(stencil.begin(), stencil.end(),
              [](const Tap& p, const Tap& q) { return p.place < q.place; });
  }
  return stencils;
}

bool near_limit(const LimitSums& sums) {
  return sums.rings <= 1 && sums.weights[1].size() == sums.weights[0].size() &&
         sums.weights[2].size() == sums.weights[0].size();
}

}  // namespace limn::fast
