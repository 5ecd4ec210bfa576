#pragma once
/// Eigenvalues of a matrix over the field of 2⁶¹ - 1 elements that lie in the field itself.

#include "limn/regular/algebra/echelon.h"
#include "limn/regular/algebra/modular.h"

namespace limn::regular {

/// At most `most` of them; there may be none, and for a rare unlucky start of the search one may
/// be missed. Cost: size³.
[[nodiscard]] std::vector<Modular> eigenvalues_in_field(const FieldMatrix<Modular>& a, int most);

}  // namespace limn::regular
