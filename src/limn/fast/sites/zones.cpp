#include "limn/fast/sites/zones.h"

namespace limn::fast {
namespace {

/// A vertex that no face uses keeps its place.
const ZoneTable& identity_table() {
  static const ZoneTable table{0, {SectorPoint{}}, {SectorPoint{}}, {1, {0, 1}, {{0, 1.0}}}};
  return table;
}

void find_sectors(ZoneGroup& group, const Mesh& control) {
  constexpr Index kVertexGrain = 1024;
  const auto sectors = static_cast<std::size_t>(group.kind.faces);
  const std::size_t size = group.kind.vertices.size() * sectors;
  group.sectors.resize(size);
  group.codes.resize(size);
  group.ends.resize(size);
  parallel_for(
      Index{0}, static_cast<Index>(group.kind.vertices.size()),
      [&](Index first, Index last) {
        std::size_t at = static_cast<std::size_t>(first) * sectors;
        for (Index i = first; i < last; ++i) {
          Index h = control.halfedge_of_vertex(group.kind.vertices[static_cast<std::size_t>(i)]);
          for (std::size_t s = 0; s < sectors; ++s, ++at, h = control.rotate(h)) {
            group.sectors[at] = h;
            group.codes[at] = edge_code(control, h);
            group.ends[at] = control.target(h);
          }
        }
      },
      kVertexGrain);
}

}  // namespace

std::vector<ZoneGroup> group_vertices(const std::map<Index, ZoneTable>& stars,
                                      const std::map<Index, ZoneTable>& fans,
                                      std::vector<VertexKind> kinds, const Mesh& control) {
  std::vector<ZoneGroup> groups;
  groups.reserve(kinds.size());
  for (VertexKind& kind : kinds) {
    const ZoneTable& table = kind.faces == 0 ? identity_table()
                             : kind.open     ? fans.at(kind.faces)
                                             : stars.at(kind.faces);
    groups.push_back({&table, std::move(kind), {}, {}, {}});
    find_sectors(groups.back(), control);
  }
  return groups;
}

}  // namespace limn::fast
