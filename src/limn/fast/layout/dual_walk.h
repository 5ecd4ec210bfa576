#pragma once
/// Where the plain engine has the vertices of a dual layout.

#include "limn/fast/layout/dual_layout.h"

namespace limn::fast {

/// The vertex of `fine` at each number of the layout. `fine` is what the plain split makes of the
/// layout's control mesh by as many steps as give its n points along a patch's side.
[[nodiscard]] std::vector<Index> dual_order(const DualLayout& layout, const Mesh& fine);

}  // namespace limn::fast
