#include "limn/refine/fast/limit_zones.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "limn/mesh/lattice.h"

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

Result<std::optional<ZoneTable>> read_limit_zone(LimitReader& reader, int level,
                                                 const StarShape& shape) {
  constexpr Index kRings = 2;
  using Found = std::optional<ZoneTable>;
  if (shape.sectors == 0)  // it stays, without tangents
    return Found({0, {SectorPoint{}}, {SectorPoint{}}, {1, {0, 1, 1, 1}, {{0, 1.0}}}});
  const Mesh mesh = shape.open ? fan(shape.lattice, shape.sectors, kRings)
                               : star(shape.lattice, shape.sectors, kRings);
  const Result<std::vector<std::optional<LimitForms>>> forms =
      reader.read(mesh, level, !shape.open, {0});
  if (!forms) return forms.error();
  if (!forms->front()) return Found();
  std::map<Index, int> slots;
  for (const auto& form : *forms->front())
    for (const auto& [vertex, weight] : form.terms)
      if (weight != 0) slots.emplace(vertex, 0);
  ZoneTable table;
  table.sectors = shape.sectors;
  table.targets = {SectorPoint{}};
  for (auto& [vertex, slot] : slots) {
    slot = table.rows.sources++;
    table.sources.push_back(sector_point(shape, vertex));
  }
  for (const auto& form : *forms->front()) {
    for (const auto& [vertex, weight] : form.terms)
      if (weight != 0) table.rows.terms.push_back({slots.at(vertex), weight});
    table.rows.row_begin.push_back(static_cast<int>(table.rows.terms.size()));
  }
  return Found(std::move(table));
}

std::vector<Stencil> limit_stencils(const ZoneTable& plane, Lattice lattice) {
  std::vector<Stencil> stencils;
  for (int row = 0; row < plane.rows.targets(); ++row) {
    std::vector<double> weights(plane.sources.size(), 0.0);
    for (int i = plane.rows.row_begin[row]; i < plane.rows.row_begin[row + 1]; ++i)
      weights[plane.rows.terms[i].source] = plane.rows.terms[i].weight;
    weights = rounded(std::move(weights));
    Stencil& stencil = stencils.emplace_back();
    for (std::size_t i = 0; i < weights.size(); ++i)
      if (weights[i] != 0) stencil.push_back({on_plane(lattice, plane.sources[i]), weights[i]});
    std::sort(stencil.begin(), stencil.end(),
              [](const Tap& p, const Tap& q) { return p.place < q.place; });
  }
  return stencils;
}

}  // namespace limn::fast
