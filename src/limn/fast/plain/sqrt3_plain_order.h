#pragma once
/// Where the plain engine's √3 steps put the vertices that sqrt3_layout.h numbers.

#include <vector>

#include "limn/mesh/split.h"

namespace limn::fast {

/// The plain engine's vertex at each number of the level after so many steps, at least one, from a
/// control mesh of triangles. Cost O(size of that level).
[[nodiscard]] std::vector<Index> sqrt3_plain_order(const Mesh& control,
                                                   const std::vector<SplitResult>& steps);

}  // namespace limn::fast
