#include "limn/mesh/sharpness/cut_tags.h"

namespace limn {

SharpnessTags cut_tags(const Repaired& repaired) {
  SharpnessTags tags;
  for (const Index v : repaired.sharp_vertices) tags.corners.push_back({v, kInfinitelySharp});
  for (const auto& [a, b] : repaired.sharp_edges)
    tags.creases.push_back({{a, b}, {kInfinitelySharp}});
  return tags;
}

}  // namespace limn
