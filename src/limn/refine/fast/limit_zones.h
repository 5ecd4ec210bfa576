#pragma once
/// The limit surface at vertices, from sums over the star or fan round them.

#include "limn/refine/fast/family.h"
#include "limn/refine/fast/zones.h"

namespace limn::fast {

/// Sums as a table of one target, which has three rows.
[[nodiscard]] ZoneTable limit_table(const LimitSums& sums, const StarShape& shape);

/// At an isolated vertex: it stays, without tangents.
[[nodiscard]] LimitSums limit_of_isolated();

/// Sums at a regular interior vertex, on the lattice round it.
[[nodiscard]] std::vector<Stencil> limit_stencils(const LimitSums& sums, Lattice lattice);

/// Whether the sums are of use: they look no farther than one ring, and there are tangents.
[[nodiscard]] bool near_limit(const LimitSums& sums);

/// The rows at the inner points of boundary sides.
template <class Layout>
[[nodiscard]] RowPlan limit_sides(const ZoneTable& table, const std::vector<Index>& sides,
                                  const Layout& at, Lattice lattice) {
  std::vector<Index> sources, targets;
  for (const Index h : sides)
    for (Index t = 1; t < at.n(); ++t) {
      for (const SectorPoint& source : table.sources) {
        const Offset place = on_plane(lattice, source);
        sources.push_back(at.point_beyond(h, t + place.a, place.b));
      }
      targets.push_back(at.point(h, t, 0));
    }
  return {table.rows, HugeArray<Index>(sources), HugeArray<Index>(targets), false};
}

/// The limit surface at the vertices of a level of grids. `groups` are the control vertices,
/// `sides` the boundary half-edges, and make_patches(stencils) plans the patches' points by three
/// stencils. Nothing where the sums are of no use.
template <class Layout, class MakePatches>
[[nodiscard]] Result<std::optional<StepPlan>> grid_limit_plan(const std::vector<ZoneGroup>& groups,
                                                              const std::vector<Index>& sides,
                                                              const Layout& at, Lattice lattice,
                                                              const LimitSumsOf& of,
                                                              MakePatches make_patches) {
  using Found = std::optional<StepPlan>;
  if (groups.empty()) return Found();
  const Result<LimitSums> regular = of(false, plane_sectors(lattice));
  if (!regular) return regular.error();
  if (!near_limit(*regular)) return Found();
  StepPlan plan;
  plan.patches = make_patches(limit_stencils(*regular, lattice));
  if (!sides.empty()) {
    const StarShape half{lattice, half_plane_sectors(lattice), true};
    const Result<LimitSums> side = of(true, half.sectors);
    if (!side) return side.error();
    if (!near_limit(*side)) return Found();
    plan.rows.push_back(limit_sides(limit_table(*side, half), sides, at, lattice));
  }
  for (const ZoneGroup& group : groups) {
    const bool isolated = group.kind.faces == 0;
    const Result<LimitSums> sums =
        isolated ? limit_of_isolated() : of(group.kind.open, group.kind.faces);
    if (!sums) return sums.error();
    if (!near_limit(*sums)) return Found();
    ZoneTable table = limit_table(*sums, {lattice, group.kind.faces, group.kind.open});
    plan.rows.push_back({std::move(table.rows), number_points(group, at, table.sources),
                         number_points(group, at, table.targets), false});
  }
  return Found(std::move(plan));
}

}  // namespace limn::fast
