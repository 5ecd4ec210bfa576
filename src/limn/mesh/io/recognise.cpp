/// Which format a content is in, where no file name tells.

#include <algorithm>
#include <cctype>

#include "limn/mesh/io/formats.h"

namespace limn {
namespace io {
namespace {

bool is_blank_or_end(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// Whether `text` begins with `word` (lower case) in any case, and the word ends there.
bool begins_with_word(std::string_view text, std::string_view word) {
  if (text.size() <= word.size()) return false;
  for (std::size_t k = 0; k < word.size(); ++k) {
    if (std::tolower(static_cast<unsigned char>(text[k])) != word[k]) return false;
  }
  return is_blank_or_end(text[word.size()]);
}

std::string_view without_mark(std::string_view content) {
  if (content.starts_with("\xEF\xBB\xBF")) content.remove_prefix(3);
  return content;
}

bool is_integer(std::string_view word) {
  std::int64_t value = 0;
  return parse_integer(word.data(), word.data() + word.size(), value) == word.data() + word.size();
}

/// Formats of others that come to mind, by the bytes at their head.
const char* foreign_format(std::string_view content) {
  if (content.starts_with("glTF")) return "glb, which limn writes only";
  if (content.starts_with("\x1f\x8b")) return "compressed with gzip";
  if (content.starts_with("PK\x03\x04")) return "a zip archive";
  if (content.starts_with("<?xml")) return "XML";
  if (content.starts_with("Kaydara FBX")) return "FBX";
  return nullptr;
}

/// "off" or "obj" by the first word that is no comment; else empty.
std::string text_format(std::string_view content) {
  TextScanner in(content, "", {.comments = true, .continuation = false});
  // OBJ may have statements that are not listed; one of the listed ones is near, then.
  for (int line = 0; line < 1000 && in.next_content(); ++line) {
    const std::string_view word = in.take_word();
    if (is_obj_keyword(word)) return "obj";
    if (line == 0 && (off_keyword_length(word) > 0 || is_integer(word))) return "off";
    in.skip_line();
  }
  return {};
}

}  // namespace

std::string utf16_fault(std::string_view content) {
  const auto mark = [&](std::string_view bytes) { return content.starts_with(bytes); };
  if (mark(std::string_view("\xFF\xFE\0\0", 4)) || mark(std::string_view("\0\0\xFE\xFF", 4)))
    return "the file is UTF-32 text";
  if (mark("\xFF\xFE") || mark("\xFE\xFF")) return "the file is UTF-16 text";
  // Without a mark: every other byte of what has ASCII characters only is 0.
  const std::size_t size = std::min<std::size_t>(content.size(), 64) / 2 * 2;
  if (size < 8) return {};
  std::size_t zeros[2] = {};
  for (std::size_t k = 0; k < size; ++k) {
    const auto byte = static_cast<unsigned char>(content[k]);
    if (byte >= 0x80) return {};
    zeros[k % 2] += byte == 0 ? 1 : 0;
  }
  const bool other = zeros[0] + zeros[1] == size / 2 && (zeros[0] == 0 || zeros[1] == 0);
  return other ? "the file is UTF-16 text" : std::string();
}

bool is_padding(std::string_view rest) {
  return std::all_of(rest.begin(), rest.end(),
                     [](char c) { return c == '\0' || c == '\x1a' || is_blank_or_end(c); });
}

std::string padding_remark(std::size_t bytes) {
  return count_of(bytes, "byte", "bytes") + " of padding after the data";
}

}  // namespace io

Result<std::string> format_of_content(std::string_view content) {
  const auto fail = [](std::string message, std::string hint) {
    return Error{std::move(message), std::move(hint)};
  };
  if (content.empty()) return fail("there is no content", "");
  const std::string_view text = io::without_mark(content);
  if (io::begins_with_word(text, "ply")) return std::string("ply");
  if (const char* foreign = io::foreign_format(content)) {
    return fail(std::string("the content is ") + foreign, "limn reads obj, off, ply, stl");
  }
  if (io::has_size_of_binary_stl(content)) return std::string("stl");
  if (std::string fault = io::utf16_fault(content); !fault.empty()) {
    return fail(std::move(fault), "convert it to UTF-8");
  }
  if (io::is_binary_stl(content) || io::begins_with_word(text, "solid")) return std::string("stl");
  std::string format = io::text_format(text);
  if (!format.empty()) return format;
  return fail("the content shows no format that limn reads",
              "limn reads obj, off, ply, stl; a file with its extension is read as that");
}

}  // namespace limn
