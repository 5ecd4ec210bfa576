#pragma once
/// The small markup of text in figures. `_{…}` is a subscript, `^{…}` a superscript, `*{…}` bold
/// and
/// `/{…}` italic; they nest. Without the brace each of these characters stands for itself, so that
/// names of files and schemes need no escapes. A brace that is never closed ends with the text.

#include <string>
#include <string_view>
#include <vector>

namespace limn::figure {

/// A piece of a line of text in one font.
struct TextRun {
  std::string text;
  double scale = 1;  ///< of the line's size
  double rise = 0;   ///< of its baseline over the line's, in units of the line's size
  bool bold = false;
  bool italic = false;
  friend bool operator==(const TextRun&, const TextRun&) = default;
};

/// The runs in order, none of them empty. Bytes that are not UTF-8 become U+FFFD, control
/// characters escapes (base/printable.h).
[[nodiscard]] std::vector<TextRun> parse_rich_text(std::string_view text);

}  // namespace limn::figure
