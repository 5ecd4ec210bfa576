#pragma once
/// Parts of scheme files that limn writes.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "limn/base/error.h"
#include "limn/base/rational.h"
#include "limn/scheme/scheme.h"

namespace limn::scheme {

/// A string of TOML in its quotes. Precondition: UTF-8.
[[nodiscard]] std::string toml_string(std::string_view text);

/// What a scheme file at `path` says after "extends" to mean a scheme: a shipped name, or a path
/// from the file's folder. Fails where a scheme file cannot say it: TOML is UTF-8.
[[nodiscard]] Result<std::string> extended_name(const std::string& name_or_path,
                                                const std::string& path);

/// What is wrong with a scheme file that therefore is not written: no places in it.
[[nodiscard]] Error not_written(const Error& fault, const std::string& path);

/// The title of a scheme made of another: its title, or else its name, and `how`, as "Loop, tuned".
[[nodiscard]] std::string derived_title(const Scheme& scheme, std::string_view how);

/// The table of a parameter with `value` as its default, after an empty line.
[[nodiscard]] std::string parameter_toml(const Parameter& parameter, std::string_view value);

/// A definition by n: these numbers at these valences, `elsewhere` at all others.
[[nodiscard]] std::string definition_by_valence(
    const std::vector<std::pair<int, Rational>>& numbers, const Expression& elsewhere);

/// The line at the head of a file that repeats text of the scheme: `weights` where it has decimals,
/// else nothing.
[[nodiscard]] std::string weights_toml(const Scheme& scheme);

/// What a file that extends the scheme says of parameters and lets: the new definitions of those
/// named, and of the other parameters that an option set the values that they have (the file would
/// else have their defaults).
[[nodiscard]] std::string definitions_toml(
    const Scheme& scheme, const std::vector<std::pair<std::string, std::string>>& definitions = {});

}  // namespace limn::scheme
