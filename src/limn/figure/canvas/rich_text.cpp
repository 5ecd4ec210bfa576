#include "limn/figure/canvas/rich_text.h"

#include "limn/base/printable.h"
#include "limn/base/utf8.h"

namespace limn::figure {
namespace {

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
    } else if (const std::size_t length = base::utf8_length(text)) {
      run.text += base::printable(text.substr(0, length));
      taken = length;
    } else {
      run.text += "\uFFFD";
    }
    text.remove_prefix(taken);
  }
  change_font({});
  return runs;
}

}  // namespace limn::figure
