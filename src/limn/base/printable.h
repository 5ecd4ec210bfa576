#pragma once
/// Text that came from outside (names of schemes, paths, what a file says), made fit to be shown on
/// a terminal, in a figure or in a comment of a file. JSON has escapes of its own.

#include <string>
#include <string_view>

namespace limn::base {

/// The text as one line: control characters, those that break a line or turn its direction, and
/// bytes that are not UTF-8 are written as escapes (\n, \t, \x1b, \u{202e}). Text that has none of
/// them is unchanged, so that a text made printable twice is that made so once.
[[nodiscard]] std::string printable(std::string_view text);

/// The same for text of several lines: line feeds and tabs stay.
[[nodiscard]] std::string printable_lines(std::string_view text);

/// As text of a LaTeX document: printable, and with its special characters escaped.
[[nodiscard]] std::string latex_text(std::string_view text);

}  // namespace limn::base
