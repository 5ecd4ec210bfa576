#pragma once
/// One scheme file into one Scheme, its rules not yet checked; private to scheme/.

#include <functional>
#include <string>
#include <string_view>

#include "limn/scheme/scheme.h"

namespace limn {

/// Finds the scheme that a file `extends`.
using ExtendedScheme = std::function<Result<Scheme>(const std::string& name_or_path)>;

[[nodiscard]] Result<Scheme> read_scheme_text(std::string_view text, const std::string& file,
                                              const ExtendedScheme& extended);

}  // namespace limn
