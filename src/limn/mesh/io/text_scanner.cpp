#include "limn/mesh/io/text_scanner.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>

namespace limn::io {
namespace {

int clamp_to_int(std::int64_t value) {
  return static_cast<int>(std::min<std::int64_t>(value, std::numeric_limits<int>::max()));
}

}  // namespace

TextScanner::TextScanner(std::string_view text, std::string path, TextStyle style)
    : begin_(text.data()),
      end_(text.data() + text.size()),
      cursor_(begin_),
      line_begin_(begin_),
      last_(begin_),
      last_end_(begin_),
      last_line_begin_(begin_),
      style_(style),
      path_(std::move(path)) {
  if (text.starts_with("\xEF\xBB\xBF")) cursor_ = line_begin_ = begin_ + 3;
}

Place TextScanner::place_of(const char* position, const char* line_begin, std::int64_t line) {
  return {clamp_to_int(line), clamp_to_int(position - line_begin + 1)};
}

bool TextScanner::ends_word(const char* p) const {
  if (p == end_ || is_blank(*p) || *p == '\n' || *p == '\r') return true;
  return (style_.comments && *p == '#') || continues(p);
}

void TextScanner::pass_line_end() {
  if (*cursor_ == '\r' && cursor_ + 1 < end_ && cursor_[1] == '\n') ++cursor_;
  ++cursor_;
  ++line_;
  line_begin_ = cursor_;
}

void TextScanner::join_next_line() {
  cursor_ = behind_blanks(cursor_ + 1);
  pass_line_end();
}

bool TextScanner::line_has_more() {
  for (;;) {
    cursor_ = behind_blanks(cursor_);
    if (cursor_ == end_ || is_line_end(cursor_)) return false;
    if (style_.comments && *cursor_ == '#') return false;
    if (!continues(cursor_)) return true;
    join_next_line();
  }
}

bool TextScanner::next_content() {
  while (!line_has_more()) {
    if (cursor_ == end_) return false;
    skip_line();
  }
  return true;
}

std::string_view TextScanner::first_word_after(const char* p) const {
  p = behind_blanks(p);
  if (p < end_ && *p == '\r') ++p;
  if (p < end_ && *p == '\n') ++p;
  const char* const word = behind_blanks(p);
  const char* word_end = word;
  while (!ends_word(word_end)) ++word_end;
  return {word, static_cast<std::size_t>(word_end - word)};
}

void TextScanner::skip_line(bool (*begins_statement)(std::string_view word)) {
  // A comment does not continue: "# C:\models\" must not swallow the line after it.
  bool comment = false;
  while (cursor_ < end_) {
    if (is_line_end(cursor_)) return pass_line_end();
    comment = comment || (style_.comments && *cursor_ == '#');
    if (!comment && continues(cursor_) &&
        (begins_statement == nullptr || !begins_statement(first_word_after(cursor_ + 1)))) {
      join_next_line();
    } else {
      ++cursor_;
    }
  }
}

std::string TextScanner::take_rest(bool (*begins_statement)(std::string_view word)) {
  std::string text;
  cursor_ = behind_blanks(cursor_);
  while (cursor_ < end_ && !is_line_end(cursor_)) {
    if (style_.comments && *cursor_ == '#' && (text.empty() || is_blank(text.back()))) break;
    if (continues(cursor_) && !begins_statement(first_word_after(cursor_ + 1))) {
      join_next_line();
      text += ' ';
    } else {
      text += *cursor_++;
    }
  }
  while (!text.empty() && is_blank(text.back())) text.pop_back();
  return text;
}

std::string_view TextScanner::take_word() {
  last_ = cursor_;
  last_line_begin_ = line_begin_;
  last_line_ = line_;
  while (!ends_word(cursor_)) ++cursor_;
  last_end_ = cursor_;
  return last_word();
}

bool TextScanner::read_number(double& value, const char* what) {
  if (!skip_word(what)) return false;
  if (last_word().ends_with('.') && cursor_ < end_ && *cursor_ == '#') take_old_special_number();
  const char* first = last_;
  if (*first == '+' && first + 1 < cursor_ && first[1] != '-') ++first;
  const auto [stop, code] = fast_float::from_chars(first, cursor_, value);
  // Some versions report an overflow (or underflow) as a code, others just return inf (or 0).
  const bool parsed =
      (code == std::errc() || code == std::errc::result_out_of_range) && stop == cursor_;
  if (parsed && std::isfinite(value)) return true;
  if (style_.non_finite && (parsed || last_word().find(".#") != std::string_view::npos)) {
    if (!parsed) value = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  return bad_number(value, parsed, what);
}

void TextScanner::take_old_special_number() {
  for (const std::string_view name : {"#IND", "#INF", "#QNAN", "#SNAN"}) {
    if (!std::string_view(cursor_, remaining()).starts_with(name)) continue;
    while (cursor_ < end_ && !is_blank(*cursor_) && !is_line_end(cursor_)) ++cursor_;
    last_end_ = cursor_;
    return;
  }
}

bool TextScanner::bad_number(double value, bool parsed, const char* what) {
  const std::string word = in_quotes(last_word());
  const bool old_special = last_word().find(".#") != std::string_view::npos;
  if (!parsed && !old_special)
    return fail(last_place(), "expected " + std::string(what) + ", found " + word);
  // "inf" and "nan" begin with a letter behind the sign; an overflow with a digit or a point.
  const char head = *last_ == '-' || *last_ == '+' ? last_[1] : *last_;
  const bool overflow =
      parsed && !std::isnan(value) && (head == '.' || (head >= '0' && head <= '9'));
  if (overflow) {
    return fail(last_place(), std::string(what) + " " + word + " is too large for a double");
  }
  return fail(last_place(), std::string(what) + " is " + word + ", expected a finite number");
}

bool TextScanner::read_integer(std::int64_t& value, const char* what) {
  if (!skip_word(what)) return false;
  if (parse_integer(last_, cursor_, value) == cursor_) return true;
  return fail(last_place(),
              "expected " + std::string(what) + " (an integer), found " + in_quotes(last_word()));
}

bool TextScanner::skip_word(const char* what) {
  if (!line_has_more()) {
    const char* end = cursor_ == end_ ? "file" : "line";
    return fail(place(), "expected " + std::string(what) + ", found the end of the " + end);
  }
  take_word();
  return true;
}

bool TextScanner::fail(Place place, std::string message, std::string hint) {
  error_.message = std::move(message);
  error_.hint = std::move(hint);
  error_.file = path_;
  error_.line = place.line;
  error_.column = place.column;
  return false;
}

const char* parse_integer(const char* first, const char* last, std::int64_t& value) {
  constexpr std::int64_t limit = std::int64_t{1} << 62;
  const bool negative = first < last && *first == '-';
  if (first < last && (*first == '-' || *first == '+')) ++first;
  if (first == last || *first < '0' || *first > '9') return nullptr;
  std::int64_t magnitude = 0;
  for (; first < last && *first >= '0' && *first <= '9'; ++first) {
    magnitude = magnitude >= limit / 10 ? limit : 10 * magnitude + (*first - '0');
  }
  value = negative ? -magnitude : magnitude;
  return first;
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t longest = 40;
  constexpr const char* digits = "0123456789abcdef";
  std::string text = "'";
  for (const char c : word.substr(0, longest)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      text += c;
    } else {
      text += {'\\', 'x', digits[byte >> 4], digits[byte & 15]};
    }
  }
  return text + (word.size() > longest ? "…'" : "'");
}

}  // namespace limn::io
