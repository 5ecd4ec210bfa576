#pragma once
/// By which power of n products of n matrices exceed the n-th power of their joint spectral radius.

#include <optional>
#include <vector>

#include "limn/base/budget.h"
#include "limn/regular/algebra/invariant_subspaces.h"

namespace limn::regular {

/// A p for which products of n of the matrices are at most a constant times n^p level^n, exactly;
/// nothing where none was found, which says nothing.
///
/// The matrices are block triangular along a chain of invariant subspaces. Of each diagonal block
/// it is proved that its products are bounded by level^n (it leads) or that its radius is below the
/// level (exact_polytope.h). Blocks are uncoupled where a change of basis does that, which is a
/// linear system. An entry of a product is then a sum over ways through coupled blocks of products
/// of their entries, and over the moments of passage; those between k leading blocks are at most
/// n^(k-1), as time in blocks below the level costs a power of a number less than 1. So p is one
/// less than the number of leading blocks on one way, at most. Cost: a second for 30 rows.
///
/// Precondition: level > 0. `length`: of products that may have the radius.
[[nodiscard]] std::optional<int> bound_growth_power(const std::vector<RationalMatrix>& matrices,
                                                    const Rational& level, int length,
                                                    const Stop& stop = {});

}  // namespace limn::regular
