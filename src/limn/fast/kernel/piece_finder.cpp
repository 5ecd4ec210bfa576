#include "limn/fast/kernel/piece_finder.h"

#include <algorithm>

namespace limn::fast {

PieceFinder::PieceFinder(const std::vector<Extent>& extents, const std::vector<Index>& begin,
                         Index vertices) {
  owned_.reserve(extents.size() + 1);
  for (std::size_t piece = 0; piece + 1 < begin.size(); ++piece)
    for (Index e = begin[piece]; e < begin[piece + 1]; ++e)
      owned_.push_back({extents[static_cast<std::size_t>(e)].first, static_cast<Index>(piece)});
  std::sort(owned_.begin(), owned_.end(),
            [](const Owned& a, const Owned& b) { return a.first < b.first; });
  owned_.push_back({vertices, kNone});
  std::size_t extent = 0;
  for (Index vertex = 0; vertex < vertices; vertex += Index{1} << kShift) {
    while (owned_[extent + 1].first <= vertex) ++extent;
    near_.push_back(extent);
    if (vertices - vertex <= Index{1} << kShift) break;  // the sum might be too large
  }
}

}  // namespace limn::fast
