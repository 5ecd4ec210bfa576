#pragma once
/// Signs of exact determinants, by residues modulo as many primes as the determinant's size needs
/// [CohenCANT §2.2]: rational elimination has entries of thousands of digits from a hundred rows
/// on.

#include <optional>

#include "limn/base/budget.h"
#include "limn/regular/algebra/invariant_subspaces.h"

namespace limn::regular {

/// -1, 0 or 1; nothing where `stop` asked for an end. Cost: size³ for each 61 bits that Hadamard's
/// bound of the determinant has; the primes are looked at in parallel.
[[nodiscard]] std::optional<int> sign_of_determinant(const RationalMatrix& a,
                                                     const Stop& stop = {});

/// Whether the determinant is 0. The cost is that of one prime where it is not.
[[nodiscard]] std::optional<bool> is_singular(const RationalMatrix& a, const Stop& stop = {});

/// a[0] … a[k], multiplied in integers. Precondition: at least one, square, of one size.
[[nodiscard]] RationalMatrix product_of(const std::vector<const RationalMatrix*>& factors);

}  // namespace limn::regular
