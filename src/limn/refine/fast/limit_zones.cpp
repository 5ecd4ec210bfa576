#include "limn/refine/fast/limit_zones.h"

#include <algorithm>

namespace limn::fast {
namespace {

constexpr Index kRegular = 6, kHalfPlane = 3;  // faces at a regular vertex

}  // namespace

ZoneTable limit_table(const LimitSums& sums, Index faces, bool open) {
  ZoneTable table;
  table.sectors = faces;
  table.targets = {SectorPoint{}};
  table.rows.sources = static_cast<int>(sums.weights[0].size());
  for (int i = 0; i < table.rows.sources; ++i)
    table.sources.push_back(sector_point(faces, open, i));
  for (const std::vector<double>& weights : sums.weights) {
    for (int i = 0; i < table.rows.sources; ++i)
      if (weights[static_cast<std::size_t>(i)] != 0)
        table.rows.terms.push_back({i, weights[static_cast<std::size_t>(i)]});
    table.rows.row_begin.push_back(static_cast<int>(table.rows.terms.size()));
  }
  return table;
}

LimitSums limit_of_isolated() { return {0, {{{1.0}, {0.0}, {0.0}}}}; }

std::vector<Stencil> limit_stencils(const LimitSums& sums, bool open) {
  std::vector<Stencil> stencils;
  for (const std::vector<double>& weights : sums.weights) {
    Stencil& stencil = stencils.emplace_back();
    for (std::size_t i = 0; i < weights.size(); ++i)
      if (weights[i] != 0)
        stencil.push_back(
            {on_plane(sector_point(open ? kHalfPlane : kRegular, open, static_cast<Index>(i))),
             weights[i]});
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
