#pragma once
/// The words of scheme files; private to scheme/.

#include <string>
#include <string_view>
#include <vector>

#include "limn/base/error.h"

namespace limn::scheme {

inline constexpr std::string_view kBoundary = "boundary.";  ///< of rules in the table [boundary]

/// Keys of the file itself; rules at a boundary are in the table [boundary].
[[nodiscard]] std::vector<std::string> known_keys();
/// Their names there.
[[nodiscard]] std::vector<std::string> boundary_keys();
[[nodiscard]] std::vector<std::string> rule_names();

/// Whether a let or a parameter can be called so: letters, digits and _, not first a digit …
[[nodiscard]] bool is_identifier(std::string_view name);
/// … and no word of expressions.
[[nodiscard]] bool is_reserved(std::string_view name);

/// "extends 'a.toml': a.toml:3:1: what is wrong", or where that file only extends what is wrong,
/// "extends 'a.toml', which extends 'b.toml': b.toml:3:1: what is wrong". Of a longer chain the
/// first file and the last.
[[nodiscard]] std::string fault_of_base(const std::string& name, const Error& fault);

}  // namespace limn::scheme
