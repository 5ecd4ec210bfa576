#include "options/valences.h"

#include <charconv>

#include <fmt/core.h>

namespace limn::app {
namespace {

constexpr int kLargestValence = 2000;

bool read_integer(std::string_view text, int& value) {
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size();
}

}  // namespace

Result<Valences> read_valences(const std::string& text, int least) {
  Valences range{};
  const std::size_t dots = text.find("..");
  const bool one = dots == std::string::npos;
  const std::string_view view = text;
  const bool read = read_integer(view.substr(0, dots), range.first) &&
                    read_integer(one ? view : view.substr(dots + 2), range.last);
  const std::string hint = "a valence, as 7, or a range, as 3..12";
  if (!read) return Error{fmt::format("--valence: '{}' is no valence", text), hint};
  if (range.first > range.last)
    return Error{fmt::format("--valence: the range {} is empty", text), hint};
  if (range.first < least || range.last > kLargestValence)
    return Error{
        fmt::format("--valence: {} is not between {} and {}", text, least, kLargestValence), hint};
  return range;
}

}  // namespace limn::app
