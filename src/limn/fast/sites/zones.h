#pragma once
/// Rows for the points round control vertices, from the tables of their valences, and for those
/// along boundaries, with the numbers that a layout gives them.

#include <cassert>

#include "limn/base/parallel.h"
#include "limn/fast/kernel/step_plan.h"
#include "limn/fast/layout/edge_points.h"
#include "limn/fast/sites/stencil_tables.h"
#include "limn/mesh/mesh.h"

namespace limn::fast {

/// Control vertices of one table.
struct ZoneGroup {
  const ZoneTable* table = nullptr;
  VertexKind kind;
  /// The half-edges out of its vertices, counterclockwise, as many for each as it has faces.
  std::vector<Index> sectors;
  std::vector<EdgeCode> codes;  ///< of these half-edges
  std::vector<Index> ends;      ///< their targets
};

/// All vertices of the control mesh; the tables must outlive the groups. An isolated vertex stays.
[[nodiscard]] std::vector<ZoneGroup> group_vertices(const std::map<Index, ZoneTable>& stars,
                                                    const std::map<Index, ZoneTable>& fans,
                                                    std::vector<VertexKind> kinds,
                                                    const Mesh& control);
[[nodiscard]] inline std::vector<ZoneGroup> group_vertices(const StencilTables& tables,
                                                           std::vector<VertexKind> kinds,
                                                           const Mesh& control) {
  return group_vertices(tables.stars, tables.fans, std::move(kinds), control);
}

/// The numbers of the points round each of a group's vertices, which have their own. A layout
/// numbers point (x, y) in the frame of half-edge h: `Index point(h, x, y) const`; those on the
/// half-edge also from its code, without a look at the mesh: `point_along(code, x)`, 0 < x < n().
template <class Layout>
[[nodiscard]] HugeArray<Index> number_points(const ZoneGroup& group, const Layout& layout,
                                             const std::vector<SectorPoint>& points) {
  constexpr Index kVertexGrain = 1024;
  HugeArray<Index> numbers(group.kind.vertices.size() * points.size());
  parallel_for(
      Index{0}, static_cast<Index>(group.kind.vertices.size()),
      [&](Index first, Index last) {
        Index* number = numbers.data() + first * std::ssize(points);
        for (Index i = first; i < last; ++i) {
          const auto at = static_cast<std::size_t>(i);
          const auto sector = at * static_cast<std::size_t>(group.kind.faces);
          for (const SectorPoint& p : points) {
            const std::size_t s = sector + static_cast<std::size_t>(p.sector);
            *number++ = p.x + p.y == 0                 ? group.kind.vertices[at]
                        : p.y != 0 || p.x > layout.n() ? layout.point(group.sectors[s], p.x, p.y)
                        : p.x < layout.n()             ? layout.point_along(group.codes[s], p.x)
                                                       : group.ends[s];
          }
        }
      },
      kVertexGrain);
  return numbers;
}

/// A table's rows round each vertex of a group.
template <class Coarse, class Fine>
[[nodiscard]] RowPlan zone_rows(const ZoneTable& table, const ZoneGroup& group,
                                const Coarse& coarse, const Fine& fine, bool overlap) {
  return {table.rows, number_points(group, coarse, table.sources),
          number_points(group, fine, table.targets), overlap};
}

/// The points of zones, group by group.
template <class Coarse, class Fine>
void add_zones(const std::vector<ZoneGroup>& groups, const Coarse& coarse, const Fine& fine,
               bool overlap, std::vector<RowPlan>& plans) {
  for (const ZoneGroup& group : groups)
    plans.push_back(zone_rows(*group.table, group, coarse, fine, overlap));
}

/// The points along boundary sides but for those in zones; `sides` are the boundary half-edges.
template <class Coarse, class Fine>
void add_strips(const StencilTables& tables, const std::vector<Index>& sides, const Coarse& coarse,
                const Fine& fine, std::vector<RowPlan>& plans) {
  const Mesh& mesh = fine.control();
  const Lattice lattice = tables.lattice;
  const auto zone_of = [&](Index v) {  // of two edges: one face
    return mesh.valence(v) == 2 ? tables.reach.corner_zone : tables.reach.fan_zone;
  };
  struct Strip {
    std::vector<Index> sources, targets;
  };
  std::vector<Strip> strips(tables.strips.size());
  for (const Index h : sides) {
    const Index left = zone_of(mesh.origin(h)), right = zone_of(mesh.target(h)), n = fine.n();
    for (Index y = 0; y <= tables.reach.strip_depth; ++y)
      for (Index x = 1; mirrored(lattice, n, x, y) > 0; ++x) {
        if (ring_of(lattice, x, y) <= left ||
            ring_of(lattice, mirrored(lattice, n, x, y), y) <= right)
          continue;
        const auto c = static_cast<std::size_t>(2 * y + (x & 1));
        for (const Tap& tap : tables.strips[c]) {
          const Index source = coarse.point_beyond(h, x / 2 + tap.place.a, y / 2 + tap.place.b);
          assert(source != kNone);
          strips[c].sources.push_back(source);
        }
        strips[c].targets.push_back(fine.point(h, x, y));
      }
  }
  for (std::size_t c = 0; c < strips.size(); ++c)
    if (!strips[c].targets.empty())
      plans.push_back({to_rows(tables.strips[c]), HugeArray<Index>(strips[c].sources),
                       HugeArray<Index>(strips[c].targets), false});
}

}  // namespace limn::fast
