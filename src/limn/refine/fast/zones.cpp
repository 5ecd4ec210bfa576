#include "limn/refine/fast/zones.h"

#include <algorithm>

namespace limn::fast {
namespace {

/// A vertex that no face uses keeps its place.
const ZoneTable& identity_table() {
  static const ZoneTable table{0, {SectorPoint{}}, {SectorPoint{}}, {1, {0, 1}, {{0, 1.0}}}};
  return table;
}

void find_sectors(ZoneGroup& group, const Mesh& control) {
  constexpr Index kVertexGrain = 1024;
  const Index sectors = group.table->sectors;
  group.sectors.resize(group.vertices.size() * static_cast<std::size_t>(sectors));
  parallel_for(
      Index{0}, static_cast<Index>(group.vertices.size()),
      [&](Index first, Index last) {
        Index* out = group.sectors.data() + std::ptrdiff_t{first} * sectors;
        for (Index i = first; i < last; ++i) {
          Index h = control.halfedge_of_vertex(group.vertices[static_cast<std::size_t>(i)]);
          for (Index s = 0; s < sectors; ++s, h = control.rotate(h)) *out++ = h;
        }
      },
      kVertexGrain);
}

}  // namespace

std::vector<ZoneGroup> group_vertices(const StencilTables& tables, const Mesh& control) {
  std::map<const ZoneTable*, std::vector<Index>> members;
  for (Index v = 0; v < control.vertex_count(); ++v) {
    const bool open = control.is_boundary_vertex(v);
    const ZoneTable& table = control.is_isolated(v) ? identity_table()
                             : open                 ? tables.fans.at(control.valence(v) - 1)
                                                    : tables.stars.at(control.valence(v));
    members[&table].push_back(v);
  }
  std::vector<ZoneGroup> groups;
  groups.reserve(members.size());
  for (auto& [table, vertices] : members) groups.push_back({table, std::move(vertices), {}});
  // not in the order of addresses, which differs from run to run
  std::sort(groups.begin(), groups.end(), [](const ZoneGroup& a, const ZoneGroup& b) {
    return a.vertices.front() < b.vertices.front();
  });
  for (ZoneGroup& group : groups) find_sectors(group, control);
  return groups;
}

}  // namespace limn::fast
