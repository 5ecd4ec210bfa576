#include "limn/fast/sites/kite_rows.h"

#include <algorithm>

#include "limn/base/parallel.h"

namespace limn::fast {
namespace {

/// How a face touches the boundary; empty where it does not.
RimPattern pattern_of(const Kites& kites, Index f) {
  const Mesh& mesh = kites.control();
  RimPattern pattern;
  bool whole = true;
  for (Index h = mesh.face_begin(f); h < mesh.face_begin(f + 1); ++h) {
    pattern.push_back((kites.has_y_arm(h) ? 1 : 0) + (kites.is_whole(h) ? 2 : 0));
    whole = whole && kites.is_whole(h);
  }
  return whole ? RimPattern() : pattern;
}

/// Turns the pattern to the least of its turns; returns which side comes first.
Index turn_to_least(RimPattern& pattern) {
  RimPattern least = pattern, turned = pattern;
  Index first = 0;
  for (Index i = 1; i < std::ssize(pattern); ++i) {
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    if (turned < least) {
      least = turned;
      first = i;
    }
  }
  pattern = std::move(least);
  return first;
}

/// The numbers of the points round each centre; seen from a vertex, a patch's far corner is its
/// first point.
base::HugeArray<Index> number_points(const KiteCentres& centres, const KiteLevel& level,
                                     std::vector<SectorPoint> points) {
  const KiteLayout& layout = level.layout;
  const Index last = layout.n() - 1;
  for (auto& [sector, x, y] : points) {
    x = centres.vertices ? last - x / level.edge : x / level.edge;
    y = centres.vertices ? last - y / level.edge : y / level.edge;
  }
  const Index count = static_cast<Index>(centres.sectors.size()) / centres.sides;
  base::HugeArray<Index> numbers(static_cast<std::size_t>(count) * points.size());
  base::parallel_for(
      Index{0}, count,
      [&](Index first, Index end) {
        Index* number = numbers.data() + first * std::ssize(points);
        for (Index i = first; i < end; ++i)
          for (const auto& [sector, x, y] : points)
            *number++ = layout.point(
                centres.sectors[static_cast<std::size_t>(i * centres.sides + sector)], x, y);
      },
      std::max<std::ptrdiff_t>(1, kNumberGrain / std::ssize(points)));
  return numbers;
}

/// Point (x, y) of a line, as rows along sides have it.
Index line_point(const KiteLevel& level, Index h, Index x, Index y) {
  const Index above = y < 0 ? (y + 1) / level.edge - 1 : y / level.edge;
  return level.layout.line_point(h, x / level.edge, -1 - above);
}

void add_line_rows(const std::vector<SideRow>& rows, const std::vector<Index>& lines, Index near,
                   const KiteLevel& old, const KiteLevel& made, std::vector<RowPlan>& plans) {
  const Index begin = near * made.edge, end = 2 * made.layout.n() * made.edge - begin;
  for (const SideRow& row : rows) {
    std::vector<Index> sources, targets;
    for (const Index h : lines)
      for (Index x = row.phase; x < end; x += row.period) {
        if (x < begin) continue;
        for (const Offset& from : row.sources)
          sources.push_back(line_point(old, h, x + from.a, row.y + from.b));
        targets.push_back(line_point(made, h, x, row.y));
      }
    if (!targets.empty())
      plans.push_back(
          {row.table, base::HugeArray<Index>(sources), base::HugeArray<Index>(targets), false});
  }
}

}  // namespace

KiteGroups group_kites(const Kites& kites) {
  const Mesh& mesh = kites.control();
  KiteGroups groups;
  std::map<std::pair<Index, bool>, std::vector<Index>> centres;  // by sides
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index sides = mesh.degree(f), begin = mesh.face_begin(f);
    if (sides == 4 && !kites.has_rims()) continue;
    groups.sides.insert(sides);
    RimPattern pattern = kites.has_rims() ? pattern_of(kites, f) : RimPattern();
    if (pattern.empty() && sides == 4) continue;
    const Index first = turn_to_least(pattern);
    std::vector<Index>* sectors = &centres[{sides, false}];
    if (!pattern.empty()) {
      KiteCentres& rim = groups.rims[pattern];
      rim.sides = sides;
      sectors = &rim.sectors;
    }
    for (Index s = 0; s < sides; ++s) sectors->push_back(begin + (first + s) % sides);
  }
  for (Index i = 0; i < std::ssize(kites.inner_vertices()); ++i) {
    const Index sides = kites.vertex_begin(i + 1) - kites.vertex_begin(i);
    if (sides == 4) continue;
    groups.sides.insert(sides);
    Index h = mesh.halfedge_of_vertex(kites.inner_vertices()[static_cast<std::size_t>(i)]);
    for (Index s = 0; s < sides; ++s, h = mesh.rotate(h)) centres[{sides, true}].push_back(h);
  }
  for (auto& [kind, sectors] : centres)
    if (!sectors.empty()) groups.centres.push_back({kind.first, kind.second, std::move(sectors)});
  return groups;
}

RowPlan centre_rows(const ZoneTable& table, const KiteCentres& centres, const KiteLevel& old,
                    const KiteLevel& made, bool overlap) {
  return {table.rows, number_points(centres, old, table.sources),
          number_points(centres, made, table.targets), overlap};
}

void add_rim_rows(const RimTables& rims, const KiteGroups& groups, const KiteLevel& old,
                  const KiteLevel& made, std::vector<RowPlan>& plans) {
  const Kites& kites = old.layout.kites();
  const Mesh& mesh = kites.control();
  std::vector<Index> wide, narrow;
  for (const Index h : kites.lines()) {
    if (kites.is_whole(mesh.next(h)))
      wide.push_back(h);
    else if (h < mesh.twin(h))
      narrow.push_back(h);
  }
  add_line_rows(rims.wide, wide, rims.near, old, made, plans);
  add_line_rows(rims.narrow, narrow, rims.near, old, made, plans);
  for (const auto& [pattern, faces] : groups.rims)
    plans.push_back(centre_rows(rims.zones.at(pattern), faces, old, made, false));
}

}  // namespace limn::fast
