#include "limn/fast/sites/zones.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "limn/base/parallel.h"
#include "limn/mesh/rings.h"

namespace limn::fast {
namespace {

constexpr Index kVertexGrain = 1024;

void find_sectors(const Mesh& control, ZoneGroup& group) {
  const auto sectors = static_cast<std::size_t>(group.kind.sectors);
  const std::size_t size = group.vertices.size() * sectors;
  group.sectors.resize(size);
  group.codes.resize(size);
  group.ends.resize(size);
  base::parallel_for(
      Index{0}, static_cast<Index>(group.vertices.size()),
      [&](Index first, Index last) {
        std::size_t at = static_cast<std::size_t>(first) * sectors;
        for (Index i = first; i < last; ++i) {
          Index h = control.halfedge_of_vertex(group.vertices[static_cast<std::size_t>(i)]);
          for (std::size_t s = 0; s < sectors; ++s, ++at, h = control.rotate(h)) {
            group.sectors[at] = h;
            group.codes[at] = edge_code(control, h);
            group.ends[at] = control.target(h);
          }
        }
      },
      kVertexGrain);
}

/// A point round any vertex of a group: where its number is found.
struct ZoneFinder {
  enum From { vertex, spoke, patch, beyond } from = vertex;
  std::size_t sector = 0;
  Index x = 0, y = 0;
  GridLayout::Spot spot{};    ///< in the sector's frame
  std::array<Index, 4> at{};  ///< inside, by the number of the sector's half-edge in its face
};

ZoneFinder make_finder(const GridLayout& layout, const SectorPoint& p) {
  ZoneFinder finder{ZoneFinder::vertex, static_cast<std::size_t>(p.sector), p.x, p.y};
  if (p.x == 0 && p.y == 0) return finder;
  if (!patch_holds(layout.lattice(), layout.side(), {p.x, p.y})) {
    finder.from = ZoneFinder::beyond;
    return finder;
  }
  finder.spot = layout.spot(0, p.x, p.y);
  finder.from = p.y == 0 ? ZoneFinder::spoke : ZoneFinder::patch;
  for (Index k = 0; k < layout.sides(); ++k)
    finder.at[static_cast<std::size_t>(k)] = layout.spot(k, p.x, p.y).at;
  return finder;
}

/// The number of a point in the frame of h.
Index number_in_patch(const GridLayout& layout, Index h, const ZoneFinder& p) {
  using Spot = GridLayout::Spot;
  if (p.spot.on == Spot::corner) return layout.control().origin(layout.turned(h, p.spot.side));
  if (p.spot.on == Spot::edge) return layout.edge_point(layout.turned(h, p.spot.side), p.spot.at);
  const Index f = layout.control().face(h);
  const Index at = p.at[static_cast<std::size_t>(h - layout.sides() * f)];
  return at + (p.spot.on == Spot::inner ? layout.face_begin(f) : layout.centre_begin(f));
}

/// The numbers of the points round each of a group's vertices.
base::HugeArray<Index> number_points(const ZoneGroup& group, GridLayout layout,
                                     std::vector<SectorPoint> points) {
  if (layout.unit() > 1 && !layout.has_centres()) {
    for (SectorPoint& p : points) p = {p.sector, p.x / layout.unit(), p.y / layout.unit()};
    layout = layout.grid();
  }
  std::vector<ZoneFinder> list;
  list.reserve(points.size());
  for (const SectorPoint& point : points) list.push_back(make_finder(layout, point));
  base::HugeArray<Index> numbers(group.vertices.size() * points.size());
  base::parallel_for(
      Index{0}, static_cast<Index>(group.vertices.size()),
      [&](Index first, Index last) {
        Index* number = numbers.data() + first * std::ssize(list);
        for (Index i = first; i < last; ++i) {
          const auto at = static_cast<std::size_t>(i);
          const auto sector = at * static_cast<std::size_t>(group.kind.sectors);
          for (const ZoneFinder& p : list) {
            const std::size_t s = sector + p.sector;
            switch (p.from) {
              case ZoneFinder::vertex: *number++ = group.vertices[at]; break;
              case ZoneFinder::spoke:
                *number++ = p.spot.on == GridLayout::Spot::corner
                                ? group.ends[s]
                                : layout.point_along(group.codes[s], p.spot.at);
                break;
              case ZoneFinder::patch:
                *number++ = number_in_patch(layout, group.sectors[s], p);
                break;
              case ZoneFinder::beyond: *number++ = layout.point_beyond(group.sectors[s], p.x, p.y);
            }
          }
        }
      },
      kVertexGrain);
  return numbers;
}

}  // namespace

std::vector<ZoneGroup> group_vertices(const Mesh& control, Lattice lattice) {
  const auto at = [](Index i) { return static_cast<std::size_t>(i); };
  std::vector<Index> key = mesh::valences(control);  // → twice the valence, and 1 less in a fan
  for (Index v = 0; v < control.vertex_count(); ++v)
    key[at(v)] = 2 * key[at(v)] - (control.is_boundary_vertex(v) ? 1 : 0);
  const Index largest = key.empty() ? 0 : *std::max_element(key.begin(), key.end());
  std::vector<std::size_t> members(at(largest) + 1);
  for (const Index k : key) ++members[at(k)];
  std::vector<ZoneGroup> groups;
  std::vector<std::size_t> group_of(members.size());
  for (const Index odd : {0, 1})
    for (Index k = odd; k <= largest; k += 2) {
      if (members[at(k)] == 0) continue;
      group_of[at(k)] = groups.size();
      groups.push_back({{lattice, k / 2, odd == 1}, {}, {}, {}, {}});
      groups.back().vertices.reserve(members[at(k)]);
    }
  for (Index v = 0; v < control.vertex_count(); ++v)
    groups[group_of[at(key[at(v)])]].vertices.push_back(v);
  for (ZoneGroup& group : groups) find_sectors(control, group);
  return groups;
}

RowPlan zone_rows(const ZoneTable& table, const ZoneGroup& group, const GridLayout& old_points,
                  const GridLayout& new_points, bool overlap) {
  return {table.rows, number_points(group, old_points, table.sources),
          number_points(group, new_points, table.targets), overlap};
}

void add_side_rows(const StencilTables& tables, const std::vector<Index>& sides,
                   const GridLayout& old_points, const GridLayout& new_points,
                   std::vector<RowPlan>& plans) {
  const Mesh& mesh = new_points.control();
  const Lattice lattice = new_points.lattice();
  const Index side = new_points.side();
  const auto zone_at = [&](Index v) { return tables.fans.at(mesh.valence(v) - 1).zone; };
  for (const SideRow& row : tables.strips) {
    std::vector<Index> sources, targets;
    for (const Index h : sides) {
      const Zone left = zone_at(mesh.origin(h)), right = zone_at(mesh.target(h));
      for (Index x = row.phase; mirrored(lattice, side, x, row.y) > 0; x += row.period) {
        if (x == 0 || left.has(x, row.y) || right.has(row.y, mirrored(lattice, side, x, row.y)))
          continue;
        for (const Offset& place : row.sources) {
          sources.push_back(old_points.point_beyond(h, x + place.a, row.y + place.b));
          assert(sources.back() != kNone);
        }
        targets.push_back(new_points.point(h, x, row.y));
      }
    }
    if (!targets.empty())
      plans.push_back(
          {row.table, base::HugeArray<Index>(sources), base::HugeArray<Index>(targets), false});
  }
}

}  // namespace limn::fast
