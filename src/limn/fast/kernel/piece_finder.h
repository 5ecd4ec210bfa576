#pragma once
/// Which piece of a step (step_pieces.h) makes a vertex.

#include <cstddef>
#include <vector>

#include "limn/mesh/polygons.h"

namespace limn::fast {

/// Vertices with consecutive numbers.
struct Extent {
  Index first = 0, count = 0;
};

class PieceFinder {
 public:
  PieceFinder() = default;
  /// Of `vertices`, each in one extent; piece p has the extents begin[p] … begin[p + 1] - 1.
  PieceFinder(const std::vector<Extent>& extents, const std::vector<Index>& begin, Index vertices);

  [[nodiscard]] Index piece(Index vertex) const { return owned_[extent_of(vertex)].piece; }
  /// The vertex after the extent that this one is in.
  [[nodiscard]] Index extent_end(Index vertex) const { return owned_[extent_of(vertex) + 1].first; }

 private:
  /// An extent, by its first vertex.
  struct Owned {
    Index first = 0, piece = 0;
  };
  static constexpr unsigned kShift = 10;

  [[nodiscard]] std::size_t extent_of(Index vertex) const {
    std::size_t extent = near_[static_cast<std::size_t>(vertex) >> kShift];
    while (owned_[extent + 1].first <= vertex) ++extent;
    return extent;
  }

  std::vector<Owned> owned_;       // ascending; then one past the last vertex
  std::vector<std::size_t> near_;  // the extent of every 1024th vertex
};

}  // namespace limn::fast
