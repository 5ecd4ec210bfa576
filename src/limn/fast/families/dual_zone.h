#pragma once
/// Tables for the points round a centre.

#include <vector>

#include "limn/fast/kernel/step_plan.h"
#include "limn/fast/layout/dual_layout.h"
#include "limn/fast/sites/dual_places.h"

namespace limn::fast {

/// The fine points round a centre, as sums over the old points round it.
struct DualZone {
  std::vector<SectorPoint> sources, targets;  ///< dual_places.h
  RowTable table;
  Index rings = 1;  ///< of old points that the rules look at, weights aside
};

/// Sets sources and table from the forms of the targets; place_of(vertex) is the place of a vertex
/// that the forms are over.
template <class PlaceOf>
void fill_zone(DualZone& zone, const std::vector<LinearForm<double>>& forms, PlaceOf place_of) {
  auto [rows, vertices] = to_rows(forms);
  zone.table = std::move(rows);
  for (const Index v : vertices) zone.sources.push_back(place_of(v));
}

/// Numbers of points round a face's centre, or (`vertex`) round a vertex, seen from which a patch's
/// far corner is its first; sectors[s] is the half-edge whose patch is sector s.
void number_zone(const DualLayout& layout, const std::vector<Index>& sectors, bool vertex,
                 const std::vector<SectorPoint>& points, Index* out);

/// The inner vertices with so many sides, a half-edge out of each.
[[nodiscard]] std::vector<Index> vertices_of_sides(const DualCorners& corners, Index sides);

/// Rows for the zones round faces and inner vertices of so many sides, which are given by a
/// half-edge each.
[[nodiscard]] RowPlan plan_dual_zones(const DualZone& zone, Index sides,
                                      const std::vector<Index>& faces,
                                      const std::vector<Index>& vertices, const DualLayout& coarse,
                                      const DualLayout& fine, bool overlap);

}  // namespace limn::fast
