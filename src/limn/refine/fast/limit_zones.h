#pragma once
/// The limit surface at vertices, from sums over the star or fan round them.

#include "limn/refine/fast/family.h"
#include "limn/refine/fast/zones.h"

namespace limn::fast {

/// The limit surface at a vertex that so many sectors meet in, `level` steps on: its sums as a
/// table of one target, which has three rows. Nothing where there are no such sums.
[[nodiscard]] Result<std::optional<ZoneTable>> read_limit_zone(LimitReader& reader, int level,
                                                               const StarShape& shape);

/// Sums at a regular interior vertex, on the lattice round it.
[[nodiscard]] std::vector<Stencil> limit_stencils(const ZoneTable& plane, Lattice lattice);

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
                                                              int level, LimitReader& reader,
                                                              MakePatches make_patches) {
  using Found = std::optional<StepPlan>;
  if (groups.empty()) return Found();
  for (const bool open : {false, true}) {
    if (open && sides.empty()) continue;
    const Result<Index> rings = reader.regular_rings(open);
    if (!rings) return rings.error();
    if (*rings > 1) return Found();
  }
  const StarShape whole{lattice, plane_sectors(lattice), false};
  const Result<std::optional<ZoneTable>> plane = read_limit_zone(reader, level, whole);
  if (!plane) return plane.error();
  if (!*plane) return Found();
  StepPlan plan;
  plan.patches = make_patches(limit_stencils(**plane, lattice));
  if (!sides.empty()) {
    const StarShape half{lattice, half_plane_sectors(lattice), true};
    const Result<std::optional<ZoneTable>> side = read_limit_zone(reader, level, half);
    if (!side) return side.error();
    if (!*side) return Found();
    plan.rows.push_back(limit_sides(**side, sides, at, lattice));
  }
  for (const ZoneGroup& group : groups) {
    const StarShape shape{lattice, group.kind.faces, group.kind.open};
    const Result<std::optional<ZoneTable>> table = read_limit_zone(reader, level, shape);
    if (!table) return table.error();
    if (!*table) return Found();
    plan.rows.push_back({(*table)->rows, number_points(group, at, (*table)->sources),
                         number_points(group, at, (*table)->targets), false});
  }
  return Found(std::move(plan));
}

}  // namespace limn::fast
