#pragma once
/// One scheme file into one Scheme, its rules not yet checked; private to scheme/.

#include <array>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "limn/base/faults.h"
#include "limn/scheme/scheme.h"

namespace limn::scheme {

/// What of a file could not be read: nothing is said of what depends on it, or one fault would be
/// told as several.
struct Unread {
  bool everything = false;            ///< no TOML, or what it extends is missing
  bool something = false;             ///< there were faults at all
  bool tables = false;                ///< tables of unknown names: they may hold anything
  std::set<std::string> definitions;  ///< lets and parameters, by name
  std::array<bool, kRuleKinds> rules{};

  [[nodiscard]] bool rule(RuleKind kind) const { return rules[static_cast<std::size_t>(kind)]; }
};

/// What was read, perhaps without a split; faultless where `unread` is empty and no fault was
/// added.
struct Draft {
  Scheme scheme;
  Unread unread;
};

/// Finds the scheme that a file `extends`; nothing, and its faults, where it has some.
using ExtendedScheme =
    std::function<std::optional<Scheme>(const std::string& name_or_path, base::Faults& faults)>;

/// Reads all that can be read; each fault is added to `faults`.
[[nodiscard]] Draft read_scheme_text(std::string_view text, const std::string& file,
                                     const ExtendedScheme& extended, base::Faults& faults);

}  // namespace limn::scheme
