#include <algorithm>

#include "limn/base/parallel.h"
#include "limn/mesh/split/split_list.h"

namespace limn::mesh::detail {

void squeeze_two_gons(Mesh::Arrays& arrays, const std::vector<std::pair<Index, Index>>& sides) {
  if (sides.empty()) return;
  std::vector<Index> lost;
  for (const auto& [a, b] : sides) {
    arrays.twin[a] = b;
    arrays.twin[b] = a;
    lost.push_back(std::max(arrays.edge[a], arrays.edge[b]));
    arrays.edge[a] = arrays.edge[b] = std::min(arrays.edge[a], arrays.edge[b]);
  }
  std::sort(lost.begin(), lost.end());
  arrays.edge_count -= static_cast<Index>(lost.size());
  base::parallel_for_each(static_cast<Index>(arrays.edge.size()), [&](Index i) {
    const auto below = std::lower_bound(lost.begin(), lost.end(), arrays.edge[i]);
    arrays.edge[i] -= static_cast<Index>(below - lost.begin());
  });
}

}  // namespace limn::mesh::detail
