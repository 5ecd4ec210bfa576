#pragma once
/// The words of scheme files; private to scheme/.

#include <string>
#include <string_view>
#include <vector>

namespace limn {

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

}  // namespace limn
