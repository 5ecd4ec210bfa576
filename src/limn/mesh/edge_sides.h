#pragma once
/// The edges of polygons that may be no surface: all sides of each, whatever their number and
/// direction. Private to mesh/.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "limn/mesh/polygons.h"

namespace limn::mesh::detail {

/// One face's side along an edge: from `corner` (of all corners) to the next of its face.
struct EdgeSide {
  std::uint64_t edge;  ///< the same for all sides between the same two vertices
  Index face, corner;
};

/// The ends of an edge, the smaller vertex first.
inline Index low_end(std::uint64_t edge) { return static_cast<Index>(edge >> 32U); }
inline Index high_end(std::uint64_t edge) { return static_cast<Index>(edge & 0xFFFFFFFFU); }
inline std::uint64_t edge_between(Index v, Index w) {
  const auto a = static_cast<std::uint64_t>(v), b = static_cast<std::uint64_t>(w);
  return std::min(a, b) << 32U | std::max(a, b);
}

/// The corner after `corner` in face f.
inline Index next_corner(const Polygons& polygons, Index f, Index corner) {
  return corner + 1 < polygons.face_begin[f + 1] ? corner + 1 : polygons.face_begin[f];
}

/// The sides of all faces but those that `out` marks, edge by edge, in the order of corners within
/// each. Precondition: the corners of the others are vertices. Cost O(corners log corners).
inline std::vector<EdgeSide> sorted_sides(const Polygons& polygons, const std::vector<char>& out) {
  std::vector<EdgeSide> sides;
  sides.reserve(polygons.corners.size());
  for (Index f = 0; f < polygons.face_count(); ++f) {
    if (out[f] != 0) continue;
    for (Index c = polygons.face_begin[f]; c < polygons.face_begin[f + 1]; ++c)
      sides.push_back(
          {edge_between(polygons.corners[c], polygons.corners[next_corner(polygons, f, c)]), f, c});
  }
  std::sort(sides.begin(), sides.end(), [](const EdgeSide& a, const EdgeSide& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.corner < b.corner;
  });
  return sides;
}

/// Calls use(first, last) for the sides first … last - 1 of each edge.
template <class Use>
void for_each_edge(const std::vector<EdgeSide>& sides, const Use& use) {
  for (std::size_t k = 0, last = 0; k < sides.size(); k = last) {
    last = k + 1;
    while (last < sides.size() && sides[last].edge == sides[k].edge) ++last;
    use(k, last);
  }
}

/// Whether the two sides of an edge run the same way.
inline bool is_flipped(const Polygons& polygons, const EdgeSide& a, const EdgeSide& b) {
  return polygons.corners[a.corner] == polygons.corners[b.corner];
}

/// Joins the corners that the two sides of an edge have at each of its ends: of one fan each.
template <class Sets>
void join_fans(const Polygons& polygons, const EdgeSide& a, const EdgeSide& b, Sets& fans) {
  const bool flipped = is_flipped(polygons, a, b);
  const Index a_end = next_corner(polygons, a.face, a.corner);
  const Index b_end = next_corner(polygons, b.face, b.corner);
  fans.join(a.corner, flipped ? b.corner : b_end, false);
  fans.join(a_end, flipped ? b_end : b.corner, false);
}

}  // namespace limn::mesh::detail
