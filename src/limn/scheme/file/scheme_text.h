#pragma once
/// Parts of scheme files that limn writes.

#include <string>
#include <string_view>

#include "limn/scheme/scheme.h"

namespace limn {

/// A string of TOML in its quotes. Precondition: UTF-8.
[[nodiscard]] std::string toml_string(std::string_view text);

/// The table of a parameter with `value` as its default, after an empty line.
[[nodiscard]] std::string parameter_toml(const Parameter& parameter, std::string_view value);

/// The tables of all parameters that an option set, with the values that they have; a file that
/// extends the scheme would else have its defaults.
[[nodiscard]] std::string set_parameters_toml(const Scheme& scheme);

}  // namespace limn
