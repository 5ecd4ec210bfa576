#pragma once
/// The limit surface at the vertices of a level of grids: patches inside, rows along boundary
/// sides and round control vertices.

#include "limn/fast/limit/limit_tables.h"

namespace limn::fast {

/// The rows along boundary sides but for those in zones.
template <class Layout>
void add_limit_strips(const LimitTables& tables, const std::vector<Index>& sides, const Layout& at,
                      Lattice lattice, std::vector<RowPlan>& plans) {
  const Mesh& mesh = at.control();
  const Index n = at.n();
  const auto radius = [&](Index v) {  // faces: one fewer than edges
    return tables.fans.at(mesh.valence(v) - 1).radius;
  };
  for (Index y = 0; y < std::ssize(tables.strips); ++y) {
    auto [rows, places] = limit_rows(tables.strips[static_cast<std::size_t>(y)]);
    std::vector<Index> sources, targets;
    for (const Index h : sides) {
      const Index left = radius(mesh.origin(h)), right = radius(mesh.target(h));
      for (Index x = 1; mirrored(lattice, n, x, y) > 0; ++x) {
        if (ring_of(lattice, x, y) <= left ||
            ring_of(lattice, mirrored(lattice, n, x, y), y) <= right)
          continue;
        for (const Offset& place : places) {
          sources.push_back(at.point_beyond(h, x + place.a, y + place.b));
          assert(sources.back() != kNone);
        }
        targets.push_back(at.point(h, x, y));
      }
    }
    if (!targets.empty())
      plans.push_back(
          {std::move(rows), HugeArray<Index>(sources), HugeArray<Index>(targets), false});
  }
}

/// The limit surface at the vertices of a level. `groups` are the control vertices, `sides` the
/// boundary half-edges, and make_patches(stencils, halo) plans the patches' points by three
/// stencils, with `halo` rows beyond each side. Nothing where the sums are of no use (LimitTables),
/// or take more than the level's grid has: where a vertex's sums take from its own ring only, every
/// level has a plan.
template <class Layout, class MakePatches>
[[nodiscard]] Result<std::optional<StepPlan>> grid_limit_plan(const std::vector<ZoneGroup>& groups,
                                                              const std::vector<Index>& sides,
                                                              const Layout& at, Lattice lattice,
                                                              int level, LimitReader& reader,
                                                              MakePatches make_patches) {
  using Found = std::optional<StepPlan>;
  if (groups.empty()) return Found();
  const Result<std::optional<LimitTables>> read = read_limit_tables(reader, lattice, level, groups);
  if (!read) return read.error();
  if (!*read || (*read)->smallest_grid > at.n()) return Found();
  const LimitTables& tables = **read;
  StepPlan plan;
  plan.patches = make_patches({tables.interior.begin(), tables.interior.end()}, tables.halo);
  add_limit_strips(tables, sides, at, lattice, plan.rows);
  for (const ZoneGroup& group : groups) {
    const LimitZone& zone = (group.kind.open ? tables.fans : tables.stars).at(group.kind.faces);
    for (const ZoneTable& table : zone.tables)
      plan.rows.push_back(zone_rows(table, group, at, at, false));
  }
  return Found(std::move(plan));
}

}  // namespace limn::fast
