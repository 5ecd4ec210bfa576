#pragma once
/// Jordan blocks of rational matrices at rational eigenvalues, exactly.

#include "limn/regular/algebra/invariant_subspaces.h"

namespace limn::regular {

/// Rows of the largest Jordan block of a at the eigenvalue; 0 where it is none. Powers of a grow
/// like n^(rows - 1) times the eigenvalue's, at least. Cost: size³ in rationals for each row.
[[nodiscard]] int largest_jordan_block(RationalMatrix a, const Rational& eigenvalue);

}  // namespace limn::regular
