#pragma once
/// OpenSubdiv with sharp vertices and edges, behind the interface of peer.h.

#include <array>
#include <memory>
#include <vector>

#include "peer.h"

namespace limn::peers {

/// Vertices that stay where they are, and edges, by their ends, that are boundaries seen from
/// either side.
struct SharpParts {
  std::vector<Index> vertices;
  std::vector<std::array<Index, 2>> edges;
};

/// nullptr where OpenSubdiv has no such method. In double precision.
[[nodiscard]] std::unique_ptr<Peer> sharp_opensubdiv_peer(Method method, const Polygons& control,
                                                          const SharpParts& sharp);

}  // namespace limn::peers
