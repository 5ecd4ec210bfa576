#include "limn/refine/fast/zones.h"

namespace limn::fast {
namespace {

/// A vertex that no face uses keeps its place.
const ZoneTable& identity_table() {
  static const ZoneTable table{0, {SectorPoint{}}, {SectorPoint{}}, {1, {0, 1}, {{0, 1.0}}}};
  return table;
}

void find_sectors(ZoneGroup& group, const Mesh& control) {
  constexpr Index kVertexGrain = 1024;
  const Index sectors = group.kind.faces;
  group.sectors.resize(group.kind.vertices.size() * static_cast<std::size_t>(sectors));
  parallel_for(
      Index{0}, static_cast<Index>(group.kind.vertices.size()),
      [&](Index first, Index last) {
        Index* out = group.sectors.data() + std::ptrdiff_t{first} * sectors;
        for (Index i = first; i < last; ++i) {
          Index h = control.halfedge_of_vertex(group.kind.vertices[static_cast<std::size_t>(i)]);
          for (Index s = 0; s < sectors; ++s, h = control.rotate(h)) *out++ = h;
        }
      },
      kVertexGrain);
}

}  // namespace

std::vector<ZoneGroup> group_vertices(const StencilTables& tables, std::vector<VertexKind> kinds,
                                      const Mesh& control) {
  std::vector<ZoneGroup> groups;
  groups.reserve(kinds.size());
  for (VertexKind& kind : kinds) {
    const ZoneTable& table = kind.faces == 0 ? identity_table()
                             : kind.open     ? tables.fans.at(kind.faces)
                                             : tables.stars.at(kind.faces);
    groups.push_back({&table, std::move(kind), {}, {}});
    find_sectors(groups.back(), control);
  }
  return groups;
}

}  // namespace limn::fast
