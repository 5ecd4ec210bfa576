#pragma once
/// What the quick engine makes of a mesh and needs at most, before it does.

#include "limn/refine/refine_estimate.h"

namespace limn::fast {

/// The memory that a result in doubles, of so many vertices, faces and corners of faces, and the
/// work on it take at most, in bytes.
[[nodiscard]] double needed_bytes(double vertices, double faces, double corners);

/// The estimate for a whole mesh, as `fast_refine` makes it, by counting. Cost O(levels).
[[nodiscard]] refine::RefineEstimate estimate_fast(const Split& split, const Mesh& control,
                                                   int levels);

}  // namespace limn::fast
