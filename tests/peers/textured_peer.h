#pragma once
/// Texture coordinates as OpenSubdiv refines them.

#include <array>
#include <vector>

#include "peer.h"

namespace limn::peers {

/// Texture coordinates in OpenSubdiv's terms: a face-varying channel.
struct PeerTexture {
  std::vector<std::array<double, 2>> points;
  std::vector<Index> of_corner;
  int rule = 2;  ///< 0 none, 1 corners only, 2 and 3 plus 1 and 2, 4 boundaries, 5 all
};

/// A mesh whose corners have points of a texture.
struct PeerTextured {
  Polygons polygons;  ///< in the library's own order
  PeerTexture texture;
};

/// What `levels` steps make of texture coordinates, with the positions of the same mesh.
[[nodiscard]] PeerTextured opensubdiv_textured(Method method, const Polygons& control,
                                               const PeerTags& tags, const PeerTexture& texture,
                                               int levels);

/// The same as a peer, for benchmarks: positions and texture coordinates as floats, and the last
/// level's connectivity of both. nullptr where the library has no such method.
[[nodiscard]] std::unique_ptr<Peer> opensubdiv_textured_peer(Method method, const Polygons& control,
                                                             const PeerTexture& texture);

}  // namespace limn::peers
