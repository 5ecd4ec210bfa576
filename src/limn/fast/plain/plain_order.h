#pragma once
/// Where the plain engine has the vertices of a level.

#include <span>
#include <vector>

#include "limn/fast/layout/kites.h"
#include "limn/fast/layout/lattice_step.h"
#include "limn/mesh/split/split.h"

namespace limn::fast {

/// The plain engine's vertex at each number of the level (grid_layout.h) that `steps`, one or more,
/// make of a mesh whose faces are the patches.
[[nodiscard]] std::vector<Index> grid_order(const Mesh& control, const GridCycle& cycle,
                                            std::span<const SplitResult> steps);

/// The same for a level of kites. `fine` is what the plain split makes of the layout's control mesh
/// by as many steps as give its n points along a patch's side; at n = 1 it is not looked at.
[[nodiscard]] std::vector<Index> kite_order(const KiteLayout& layout, const Mesh& fine);

}  // namespace limn::fast
