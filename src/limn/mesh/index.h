#pragma once
/// Indices of meshes as indices of arrays.

#include <cstddef>

#include "limn/mesh/polygons.h"

namespace limn::mesh {

/// The place in an array of what has the number i. Precondition: i ≥ 0.
[[nodiscard]] inline std::size_t at(Index i) { return static_cast<std::size_t>(i); }

}  // namespace limn::mesh
