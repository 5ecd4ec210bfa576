#pragma once
/// Tags as the peers take them, for limn.

#include <array>

#include "limn/mesh/sharpness/sharpness.h"
#include "peer.h"

namespace limn::peers {

/// Its sharp edges and vertices.
inline SharpnessTags stated_by(const PeerTags& tags) {
  SharpnessTags stated;
  for (std::size_t i = 0; i < tags.edges.size(); ++i)
    stated.creases.push_back(
        {{tags.edges[i][0], tags.edges[i][1]}, {static_cast<double>(tags.edge_sharpness[i])}, 0});
  for (std::size_t i = 0; i < tags.corners.size(); ++i)
    stated.corners.push_back({tags.corners[i], static_cast<double>(tags.corner_sharpness[i]), 0});
  return stated;
}

inline BoundaryMode boundary_mode_of(const PeerTags& tags) {
  constexpr std::array modes{BoundaryMode::none, BoundaryMode::edge_only,
                             BoundaryMode::edge_and_corner};
  return modes.at(static_cast<std::size_t>(tags.boundary));
}

/// Without faces that are holes, but with all vertices, as the peer has them.
inline Polygons without(const Polygons& all, const std::vector<bool>& holes) {
  Polygons result;
  result.positions = all.positions;
  for (Index f = 0; f < all.face_count(); ++f) {
    if (!holes.empty() && holes[static_cast<std::size_t>(f)]) continue;
    for (Index c = all.face_begin[static_cast<std::size_t>(f)];
         c < all.face_begin[static_cast<std::size_t>(f) + 1]; ++c)
      result.corners.push_back(all.corners[static_cast<std::size_t>(c)]);
    result.face_begin.push_back(static_cast<Index>(result.corners.size()));
  }
  return result;
}

}  // namespace limn::peers
