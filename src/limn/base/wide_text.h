#pragma once
/// Text in characters of 16 or 32 bits, which readers of UTF-8 would take for a binary file.

#include <string>
#include <string_view>

namespace limn::base {

/// How `content` is encoded, in the name that iconv has for it: "UTF-16" or "UTF-32" where a byte
/// order mark says so; "UTF-16LE", "UTF-16BE", "UTF-32LE" or "UTF-32BE" where there is no mark but
/// the first 4 KiB read as text in it, an eighth of it ASCII. Else empty.
[[nodiscard]] std::string wide_encoding(std::string_view content);

/// "the file is UTF-16 text".
[[nodiscard]] std::string wide_text_fault(const std::string& encoding);

/// "convert it to UTF-8: iconv -f UTF-16 -t UTF-8".
[[nodiscard]] std::string wide_text_remedy(const std::string& encoding);

}  // namespace limn::base
