#pragma once
/// Reads a text file word by word and knows the line and column of everything it meets.
/// The first fault is kept and ends the reading: functions that can meet one return false.

#include <cstdint>
#include <string>
#include <string_view>

#include "limn/base/error.h"

namespace limn::io {

struct Place {
  int line = 0;    ///< 1-based
  int column = 0;  ///< 1-based, in bytes
};

struct TextStyle {
  bool comments = false;      ///< '#' to the end of the line is no content
  bool non_finite = false;    ///< nan, inf and what is too large for a double are numbers
  bool continuation = false;  ///< a backslash joins its line to the next; blanks may follow it
};

/// Lines end with LF, CR LF or CR. A UTF-8 byte order mark at the head is skipped.
/// `text` must outlive the scanner.
class TextScanner {
 public:
  TextScanner(std::string_view text, std::string path, TextStyle style);

  /// Moves to the next word of this line; false at its end.
  bool line_has_more();
  /// Moves to the next word of the text, over line ends; false at the end of the text.
  bool next_content();
  /// Moves behind the end of this line (and of the lines it continues on). A line whose first word
  /// `begins_statement` is no continuation: the backslash before it ends a name.
  void skip_line(bool (*begins_statement)(std::string_view word) = nullptr);
  /// Moves back into the word that was read last, behind its first `size` bytes.
  void keep_of_last(std::size_t size) { cursor_ = last_ + size; }

  /// What is left of this line, without blanks at its ends and without a comment, which begins with
  /// a blank and '#'. A line that `begins_statement` is no continuation, as in skip_line.
  std::string take_rest(bool (*begins_statement)(std::string_view word));

  /// The word at the cursor; empty at the end of a line.
  std::string_view take_word();
  /// The next word of this line as a finite number (see TextStyle::non_finite). `what` ("the x
  /// coordinate") is for messages.
  bool read_number(double& value, const char* what);
  /// The next word of this line as an integer; beyond ±2^62 it saturates.
  bool read_integer(std::int64_t& value, const char* what);
  /// Moves over the next word of this line, whatever it is.
  bool skip_word(const char* what);

  [[nodiscard]] Place place() const { return place_of(cursor_, line_begin_, line_); }
  /// The word that was read last, and where it begins.
  [[nodiscard]] std::string_view last_word() const {
    return {last_, static_cast<std::size_t>(last_end_ - last_)};
  }
  [[nodiscard]] Place last_place() const { return place_of(last_, last_line_begin_, last_line_); }
  [[nodiscard]] std::size_t offset() const { return static_cast<std::size_t>(cursor_ - begin_); }
  [[nodiscard]] std::size_t remaining() const { return static_cast<std::size_t>(end_ - cursor_); }
  [[nodiscard]] std::string_view rest() const { return {cursor_, remaining()}; }
  [[nodiscard]] const std::string& path() const { return path_; }

  /// Records a fault and returns false.
  bool fail(Place place, std::string message, std::string hint = {});
  /// The fault; precondition: there was one.
  [[nodiscard]] Error error() const { return error_; }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  static Place place_of(const char* position, const char* line_begin, std::int64_t line);
  [[nodiscard]] bool is_line_end(const char* p) const {
    return p < end_ && (*p == '\n' || *p == '\r');
  }
  [[nodiscard]] const char* behind_blanks(const char* p) const {
    while (p < end_ && is_blank(*p)) ++p;
    return p;
  }
  [[nodiscard]] bool continues(const char* p) const {
    return style_.continuation && *p == '\\' && is_line_end(behind_blanks(p + 1));
  }
  [[nodiscard]] bool ends_word(const char* p) const;
  void pass_line_end();
  /// Moves from a backslash that continues its line to the beginning of the next.
  void join_next_line();
  /// The first word of the line after the one that ends behind `p`.
  [[nodiscard]] std::string_view first_word_after(const char* p) const;
  /// Of 1.#IND, 1.#INF, 1.#QNAN, which old C libraries print, the '#' begins no comment.
  void take_old_special_number();
  bool bad_number(double value, bool parsed, const char* what);

  const char* begin_;
  const char* end_;
  const char* cursor_;
  const char* line_begin_;
  std::int64_t line_ = 1;
  const char* last_;
  const char* last_end_;
  const char* last_line_begin_;
  std::int64_t last_line_ = 1;
  TextStyle style_;
  std::string path_;
  Error error_;
};

/// Reads [+-]digits at `first`; returns the end of it, or null if there is none. Beyond ±2^62
/// the value saturates, which is out of range for any index or count.
const char* parse_integer(const char* first, const char* last, std::int64_t& value);

/// `word` in quotes for a message: at most 40 bytes, unprintable ones as \xNN.
std::string in_quotes(std::string_view word);

}  // namespace limn::io
