#include "limn/base/wide_text.h"

#include <cstddef>
#include <cstdint>

namespace limn::base {
namespace {

bool is_control(std::uint32_t c) { return c == 0x7f || (c < 0x20 && (c < 0x09 || c > 0x0d)); }

/// Whether the whole characters of `size` bytes at the head of `content` are text.
bool reads_as(std::string_view content, std::size_t size, bool big_endian) {
  constexpr std::size_t most = 4096, least = 4;
  const std::size_t count = content.substr(0, most).size() / size;
  if (count < least) return false;
  std::size_t ascii = 0;
  for (std::size_t k = 0; k < count; ++k) {
    std::uint32_t c = 0;
    for (std::size_t byte = 0; byte < size; ++byte) {
      const std::size_t place = big_endian ? byte : size - 1 - byte;
      c = c << 8 | static_cast<unsigned char>(content[k * size + place]);
    }
    if (is_control(c) || c > 0x10ffff) return false;
    if (c < 0x80) ++ascii;
  }
  return 8 * ascii >= count;
}

}  // namespace

std::string wide_encoding(std::string_view content) {
  const auto mark = [&](std::string_view bytes) { return content.starts_with(bytes); };
  if (mark(std::string_view("\xFF\xFE\0\0", 4)) || mark(std::string_view("\0\0\xFE\xFF", 4)))
    return "UTF-32";
  if (mark("\xFF\xFE") || mark("\xFE\xFF")) return "UTF-16";
  for (const std::size_t size : {std::size_t{4}, std::size_t{2}})
    for (const bool big : {false, true})
      if (reads_as(content, size, big))
        return std::string(size == 4 ? "UTF-32" : "UTF-16") + (big ? "BE" : "LE");
  return {};
}

std::string wide_text_fault(const std::string& encoding) {
  return "the file is " + encoding.substr(0, 6) + " text";
}

std::string wide_text_remedy(const std::string& encoding) {
  return "convert it to UTF-8: iconv -f " + encoding + " -t UTF-8";
}

}  // namespace limn::base
