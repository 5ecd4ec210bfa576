#pragma once
/// The limit surface at vertices, from sums over the star or fan round them.

#include "limn/refine/fast/family.h"
#include "limn/refine/fast/stencil_tables.h"

namespace limn::fast {

/// Sums as a table of one target, which has three rows.
[[nodiscard]] ZoneTable limit_table(const LimitSums& sums, Index faces, bool open);

/// At an isolated vertex: it stays, without tangents.
[[nodiscard]] LimitSums limit_of_isolated();

/// Sums at a regular vertex, on the lattice round it; `open`: on the boundary of half the plane,
/// along the first axis.
[[nodiscard]] std::vector<Stencil> limit_stencils(const LimitSums& sums, bool open);

/// Whether the sums are of use: they look no farther than one ring, and there are tangents.
[[nodiscard]] bool near_limit(const LimitSums& sums);

}  // namespace limn::fast
