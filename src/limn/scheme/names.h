#pragma once
/// What the names in a scheme's expressions mean; private to scheme/.

#include "limn/scheme/scheme.h"

namespace limn {

/// Every name in every expression of the scheme, used or not, is n, k, a parameter or a let, and
/// no let or parameter is defined in terms of itself.
[[nodiscard]] Status check_names(const Scheme& scheme);

}  // namespace limn
