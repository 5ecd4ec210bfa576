#pragma once
/// A shipped scheme, quickly.

#include <string>

#include "limn/scheme/scheme.h"

namespace limn::scheme {

/// What find_scheme gives for a shipped name. The weights of shipped files, which the tests have
/// checked, are not checked again: nearly all of the cost of reading them. Fails where no scheme of
/// that name is shipped.
[[nodiscard]] Result<Scheme> shipped_scheme(const std::string& name);

}  // namespace limn::scheme
