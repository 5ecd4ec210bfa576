#pragma once
/// Sums of the limit surface, as forms, stencils and rows.

#include <span>

#include "limn/fast/kernel/stencil.h"

namespace limn::fast {

/// At one vertex: position, then the vectors of LimitForms or LimitChain.
using LimitSums = std::vector<refine::LinearForm<double>>;

/// Position and two tangents as sums over the lattice, by offsets from the vertex.
using LimitStencils = std::array<Stencil, 3>;

/// Leaves out what is only rounding of the eigenvectors that sums come from.
void drop_rounding(refine::LinearForm<double>& form);

/// A stencil of these weights without the last digits of the eigenvectors that they come from: so
/// those that symmetry makes equal are, and what should be zero is not there.
[[nodiscard]] Stencil rounded_stencil(const std::vector<Offset>& places,
                                      std::vector<double> weights);

/// Whether two vertices have the same limit position and the same oriented tangent plane, by their
/// sums, which are three each.
[[nodiscard]] bool same_limit(std::span<const refine::LinearForm<double>> a,
                              std::span<const refine::LinearForm<double>> b);

/// Three rows over the places that the stencils take from, which are sorted.
[[nodiscard]] std::pair<RowTable, std::vector<Offset>> limit_rows(const LimitStencils& stencils);

/// The rows of an isolated vertex, which stays and has no tangents.
[[nodiscard]] RowTable isolated_limit_rows();

}  // namespace limn::fast
