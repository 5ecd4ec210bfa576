#pragma once
/// Where the plain engine has the vertices of a level of grids.

#include <span>
#include <vector>

#include "limn/fast/layout/lattice_step.h"
#include "limn/mesh/split/split.h"

namespace limn::fast {

/// The plain engine's vertex at each number of the level (grid_layout.h) that `steps`, one or more,
/// make of a mesh whose faces are the patches.
[[nodiscard]] std::vector<Index> grid_order(const Mesh& control, const GridCycle& cycle,
                                            std::span<const SplitResult> steps);

}  // namespace limn::fast
