#pragma once
/// Characters of UTF-8 text.

#include <cstddef>
#include <string_view>

namespace limn::base {

/// Length in bytes of the character at the front of `text`, 1 to 4; 0 where there is none: the text
/// is empty, cut off, a detour (a longer form than need be), half of a surrogate pair, or beyond
/// U+10FFFF.
[[nodiscard]] std::size_t utf8_length(std::string_view text);

}  // namespace limn::base
