/// Which format a content is in, where no file name tells.

#include <algorithm>
#include <cctype>

#include "limn/base/wide_text.h"
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

/// JSON with the entry that every glTF file has.
bool seems_gltf(std::string_view content) {
  const std::size_t first = content.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && content[first] == '{' &&
         content.find("\"asset\"") != std::string_view::npos;
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

const char* foreign_format(std::string_view content) {
  struct Head {
    std::string_view bytes;
    const char* what;
  };
  static constexpr Head heads[] = {
      {"\x1f\x8b", "compressed with gzip"},
      {"BZh", "compressed with bzip2"},
      {"\xfd\x37zXZ", "compressed with xz"},
      {"\x28\xb5\x2f\xfd", "compressed with zstd"},
      {"PK\x03\x04", "a zip archive"},
      {"<?xml", "XML"},
      {"<!DOCTYPE html", "a page of the web (HTML)"},
      {"<html", "a page of the web (HTML)"},
      {"Kaydara FBX", "FBX"},
      {"\x89PNG", "a picture (PNG)"},
      {"%PDF", "PDF"},
      {"version https://git-lfs", "a pointer of Git LFS, not the file itself (git lfs pull)"},
  };
  for (const Head& head : heads) {
    if (content.starts_with(head.bytes)) return head.what;
  }
  return nullptr;
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
  if (content.starts_with("glTF")) return std::string("glb");
  if (const char* foreign = io::foreign_format(content)) {
    return fail(std::string("the content is ") + foreign,
                "limn reads obj, off, ply, stl, glb, gltf");
  }
  if (io::has_size_of_binary_stl(content)) return std::string("stl");
  if (const std::string wide = base::wide_encoding(content); !wide.empty()) {
    return fail(base::wide_text_fault(wide), base::wide_text_remedy(wide));
  }
  if (io::seems_gltf(text)) return std::string("gltf");
  if (io::is_binary_stl(content) || io::begins_with_word(text, "solid")) return std::string("stl");
  std::string format = io::text_format(text);
  if (!format.empty()) return format;
  return fail(
      "the content shows no format that limn reads",
      "limn reads obj, off, ply, stl, glb, gltf; a file with its extension is read as that");
}

}  // namespace limn
