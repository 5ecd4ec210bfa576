#include "limn/report/figure/rich_text.h"

#include <cstdint>

namespace limn {
namespace {

/// Length of the UTF-8 sequence at the front of `text`, or 0 if there is none.
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < 0x80) return 1;
  const std::size_t length = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
  if (byte(0) < 0xc2 || byte(0) > 0xf4 || text.size() < length) return 0;
  std::uint32_t code = byte(0) & (0x7fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3fu);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  return overlong || surrogate || code > 0x10ffff ? 0 : length;
}

/// The font of what a mark encloses, given the one around it; `text` of the result is empty.
TextRun marked(const TextRun& around, char mark) {
  TextRun run = around;
  run.text.clear();
  if (mark == '*') run.bold = true;
  if (mark == '/') run.italic = true;
  if (mark == '_' || mark == '^') {
    run.rise += (mark == '_' ? -0.18 : 0.36) * around.scale;
    run.scale *= 0.7;
  }
  return run;
}

}  // namespace

std::vector<TextRun> parse_rich_text(std::string_view text) {
  std::vector<TextRun> runs;
  std::vector<TextRun> open{TextRun{}};  // the fonts of the marks that are open, the last innermost
  TextRun run;
  const auto change_font = [&](const TextRun& font) {
    if (!run.text.empty()) runs.push_back(run);
    run = font;
  };
  while (!text.empty()) {
    const bool mark = text.size() >= 2 && text[1] == '{' &&
                      std::string_view("_^*/").find(text[0]) != std::string_view::npos;
    std::size_t taken = 1;
    if (mark) {
      open.push_back(marked(open.back(), text[0]));
      change_font(open.back());
      taken = 2;
    } else if (text[0] == '}' && open.size() > 1) {
      open.pop_back();
      change_font(open.back());
    } else if (static_cast<unsigned char>(text[0]) < 0x20 || text[0] == 0x7f) {
      run.text += ' ';
    } else if (const std::size_t length = sequence_length(text)) {
      run.text += text.substr(0, length);
      taken = length;
    } else {
      run.text += "\uFFFD";
    }
    text.remove_prefix(taken);
  }
  change_font({});
  return runs;
}

}  // namespace limn
