#pragma once
/// Whether two meshes are the same but for the order of vertices and faces.

#include <string>

#include "limn/mesh/polygons.h"

namespace limn::peers {

/// The first difference, in words; empty where there is none. Vertices are paired one to one,
/// each with its nearest within `tolerance` times the diagonal of our bounding box; then the
/// faces, as oriented cycles of paired vertices, must be the same ones.
[[nodiscard]] std::string difference(const Polygons& ours, const Polygons& theirs,
                                     double tolerance = 1e-12);

}  // namespace limn::peers
