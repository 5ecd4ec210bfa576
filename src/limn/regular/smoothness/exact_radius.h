#pragma once
/// What takes the joint spectral radius of a diagonal block from a bracket to a number: the level
/// in exact numbers, eigenvectors to begin an invariant polytope with, and the polytope.

#include <optional>
#include <vector>

#include "limn/regular/smoothness/exact_polytope.h"
#include "limn/regular/smoothness/product_search.h"

namespace limn::regular {

/// q^(1/n) where it is rational. Precondition: q > 0, n ≥ 1.
[[nodiscard]] std::optional<Rational> rational_root(const Rational& q, int n);

/// Leading eigenvectors, exactly, of the products that `best` has as equals: those with the
/// eigenvalue ±level^length. With eigenvectors v_i and left eigenvectors w_i, w_i v_i = 1, powers
/// of product i take v_j to (w_i v_j) v_i, so the polytope of s_i v_i can only close where |w_i
/// v_j| s_j ≤ s_i; the scales s are chosen so that these quotients are alike for (i, j) and (j, i),
/// in the mean over j [GuglielmiProtasov2016]. Where no product has such an eigenvalue:
/// `best.leading`, rounded.
[[nodiscard]] std::vector<FieldVector<Rational>> balanced_leading_vectors(
    const std::vector<RationalMatrix>& matrices, const Rational& level, const Product& best);

/// Whether an invariant polytope at the level was found, which proves that products of n of the
/// matrices are bounded by a constant times level^n: the number of its vertices. Nothing says
/// nothing.
[[nodiscard]] std::optional<int> bound_exactly(const std::vector<RationalMatrix>& matrices,
                                               const Rational& level, const Product& best,
                                               const ExactPolytopeLimits& limits);

}  // namespace limn::regular
