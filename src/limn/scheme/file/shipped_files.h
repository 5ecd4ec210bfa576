#pragma once
/// The scheme files of schemes/, embedded in the library when it is built.

#include <string_view>
#include <vector>

namespace limn::scheme {

struct ShippedFile {
  std::string_view name;  ///< the file's name without ".toml": what users call the scheme
  std::string_view text;  ///< its whole text, lines ended by '\n'
};

/// All of them, sorted by name.
[[nodiscard]] const std::vector<ShippedFile>& shipped_files();

}  // namespace limn::scheme
