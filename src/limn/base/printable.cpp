#include "limn/base/printable.h"

#include <cstdint>
#include <cstdio>

#include "limn/base/utf8.h"

namespace limn::base {
namespace {

std::uint32_t code_point(std::string_view character) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  if (character.size() == 1) return byte(0);
  std::uint32_t code = byte(0) & (0x7FU >> character.size());
  for (std::size_t i = 1; i < character.size(); ++i) code = code << 6U | (byte(i) & 0x3FU);
  return code;
}

/// Controls (C0, DEL, C1), separators of lines and paragraphs, marks of direction, and the mark of
/// byte order.
bool is_shown(std::uint32_t code) {
  const auto among = [code](std::uint32_t first, std::uint32_t last) {
    return code >= first && code <= last;
  };
  return !(code < 0x20U || among(0x7FU, 0x9FU) || code == 0x61CU || among(0x200EU, 0x200FU) ||
           among(0x2028U, 0x202EU) || among(0x2066U, 0x2069U) || code == 0xFEFFU);
}

std::string escape(std::uint32_t code) {
  if (code == '\n') return "\\n";
  if (code == '\r') return "\\r";
  if (code == '\t') return "\\t";
  char text[16];
  (void)std::snprintf(text, sizeof text, code < 0x80U ? "\\x%02x" : "\\u{%x}",
                      static_cast<unsigned>(code));
  return text;
}

std::string escape_byte(char byte) {
  char text[8];
  (void)std::snprintf(text, sizeof text, "\\x%02x",
                      static_cast<unsigned>(static_cast<unsigned char>(byte)));
  return text;
}

std::string made_printable(std::string_view text, std::string_view kept) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const std::string_view character = text.substr(0, length);
    if (length == 0)
      result += escape_byte(text[0]);
    else if (const std::uint32_t code = code_point(character);
             is_shown(code) || (length == 1 && kept.find(text[0]) != kept.npos))
      result += character;
    else
      result += escape(code);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return result;
}

}  // namespace

std::string printable(std::string_view text) { return made_printable(text, {}); }

std::string printable_lines(std::string_view text) { return made_printable(text, "\n\t"); }

std::string latex_text(std::string_view text) {
  std::string result;
  for (const char c : printable(text)) {
    switch (c) {
      case '\\': result += "\\textbackslash{}"; break;
      case '~': result += "\\textasciitilde{}"; break;
      case '^': result += "\\textasciicircum{}"; break;
      case '&':
      case '%':
      case '$':
      case '#':
      case '_':
      case '{':
      case '}': result += '\\'; [[fallthrough]];
      default: result += c;
    }
  }
  return result;
}

}  // namespace limn::base
