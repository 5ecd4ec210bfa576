#include "limn/fast/sites/vertex_kinds.h"

#include <algorithm>

#include "limn/mesh/rings.h"

namespace limn::fast {

std::vector<VertexKind> vertex_kinds(const Mesh& mesh) {
  const auto count = static_cast<std::size_t>(mesh.vertex_count());
  std::vector<Index> key = valences(mesh);  // → twice the valence, and 1 less in a fan
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    Index& k = key[static_cast<std::size_t>(v)];
    k = mesh.is_boundary_vertex(v) ? 2 * k - 1 : 2 * k;
  }
  const Index largest = count == 0 ? 0 : *std::max_element(key.begin(), key.end());
  std::vector<Index> members(static_cast<std::size_t>(largest) + 1);
  for (const Index k : key) ++members[static_cast<std::size_t>(k)];
  std::vector<VertexKind> kinds;
  std::vector<Index> kind_of(members.size(), kNone);
  for (const Index odd : {0, 1})
    for (Index k = odd; k <= largest; k += 2) {
      if (members[static_cast<std::size_t>(k)] == 0) continue;
      kind_of[static_cast<std::size_t>(k)] = static_cast<Index>(kinds.size());
      kinds.push_back({odd == 1, k / 2, {}});
      kinds.back().vertices.reserve(static_cast<std::size_t>(members[static_cast<std::size_t>(k)]));
    }
  for (std::size_t v = 0; v < count; ++v)
    kinds[static_cast<std::size_t>(kind_of[static_cast<std::size_t>(key[v])])].vertices.push_back(
        static_cast<Index>(v));
  return kinds;
}

}  // namespace limn::fast
