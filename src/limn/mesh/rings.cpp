#include "limn/mesh/rings.h"

#include "limn/base/large_vector.h"
#include "limn/base/parallel.h"

namespace limn::mesh {

std::vector<Index> valences(const Mesh& mesh) {
  std::vector<Index> counts =
      base::large_vector<Index>(static_cast<std::size_t>(mesh.vertex_count()));
  for (Index h = 0; h < mesh.halfedge_count(); ++h) ++counts[mesh.origin(h)];
  // a fan of k faces has k + 1 edges
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (mesh.is_boundary_vertex(v)) ++counts[v];
  return counts;
}

Rings rings(const Mesh& mesh, const std::vector<Index>& valences) {
  Rings rings;
  rings.begin = base::large_vector<Index>(valences.size() + 1);
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    rings.begin[v + 1] = rings.begin[v] + valences[v] - (mesh.is_boundary_vertex(v) ? 1 : 0);
  const auto corners = static_cast<std::size_t>(mesh.halfedge_count());
  rings.halfedges = base::large_vector<Index>(corners);
  rings.targets = base::large_vector<Index>(corners);
  rings.place = base::large_vector<Index>(corners);
  base::parallel_for_each(mesh.vertex_count(), [&](Index v) {
    Index h = mesh.halfedge_of_vertex(v);
    for (Index at = rings.begin[v]; at < rings.begin[v + 1]; ++at, h = mesh.rotate(h)) {
      rings.halfedges[at] = h;
      rings.targets[at] = mesh.target(h);
      rings.place[h] = at;
    }
  });
  return rings;
}

}  // namespace limn::mesh
