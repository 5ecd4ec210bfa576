#pragma once
/// The data behind a PLY header, value by value: one interface over ascii and binary, so that
/// the reader of elements (ply.cpp) exists once.

#include <cstdint>
#include <string>
#include <string_view>

#include "limn/mesh/io/bytes.h"
#include "limn/mesh/io/formats.h"
#include "limn/mesh/io/ply_header.h"
#include "limn/mesh/io/text_scanner.h"

namespace limn::io {

/// One instance of an element a line, or word by word, whatever the lines are. Values are read as
/// text: "0.1" declared float is the double nearest to 0.1.
class AsciiBody {
 public:
  AsciiBody(TextScanner& in, bool by_word) : in_(in), by_word_(by_word) {}

  bool begin(const PlyElement& element, std::int64_t number) {
    if (in_.next_content()) return true;
    return in_.fail(in_.place(), "expected " + element.name + " " + std::to_string(number + 1) +
                                     " of " + std::to_string(element.count) +
                                     ", found the end of the file");
  }
  bool end() {
    if (by_word_) return true;
    if (in_.line_has_more()) {
      in_.take_word();
      return fail("expected the end of the line, found " + in_quotes(in_.last_word()),
                  "are there more values than properties in the header?");
    }
    in_.skip_line();
    return true;
  }
  bool read(PlyType, double& value, const char* what) {
    if (by_word_) in_.next_content();
    return in_.read_number(value, what);
  }
  /// Whether the value that was read last is of its type.
  bool check_type(PlyType type, double value, const char* what) {
    if (holds(type, value)) return true;
    return fail(
        std::string(what) + " is " + in_quotes(in_.last_word()) + ", which is no " + name_of(type),
        "should the header name another type, say 'double'?");
  }
  bool skip(PlyType, std::int64_t count) {
    for (std::int64_t k = 0; k < count; ++k) {
      if (by_word_) in_.next_content();
      if (!in_.skip_word("the value of a property")) return false;
    }
    return true;
  }
  /// At the end of the data: nothing may follow.
  bool finish(Remarks&) {
    return !in_.next_content() || is_padding(in_.rest()) ||
           fail_at_rest("expected the end of the file");
  }
  /// The line of the instance that is read; 0: there are no lines.
  [[nodiscard]] int line() const { return in_.place().line; }

  /// Of the value read last.
  bool fail(std::string message, std::string hint = {}) {
    return in_.fail(in_.last_place(), std::move(message), std::move(hint));
  }
  /// Of a place in the header.
  bool fail_at(Place place, std::string message) { return in_.fail(place, std::move(message)); }
  [[nodiscard]] std::size_t remaining() const { return in_.remaining(); }
  /// The least number of bytes that a value takes: a digit and a blank.
  static std::size_t least_size(PlyType) { return 2; }
  [[nodiscard]] Error error() const { return in_.error(); }

 private:
  bool fail_at_rest(const char* expected) {
    return in_.fail(in_.place(), std::string(expected) + ", found more lines",
                    "are the counts in the header right?");
  }

  TextScanner& in_;
  bool by_word_;
};

class BinaryBody {
 public:
  /// `content`: the whole file, `offset`: where the data begin.
  /// `non_finite`: infinity and NaN are numbers.
  BinaryBody(std::string_view content, std::size_t offset, PlyFormat format, std::string path,
             bool non_finite)
      : content_(content),
        offset_(offset),
        last_(offset),
        swap_((format == PlyFormat::binary_little_endian) != kLittleEndianHost),
        path_(std::move(path)),
        non_finite_(non_finite) {}

  bool begin(const PlyElement& element, std::int64_t number) {
    element_ = &element;
    number_ = number;
    return true;
  }
  bool end() { return true; }
  bool read(PlyType type, double& value, const char* what) {
    last_ = offset_;
    if (size_of(type) > remaining()) return truncated();
    value = decode(type, content_.data() + offset_);
    offset_ += size_of(type);
    // Only the floating types can fail this, and only on infinity and NaN.
    if (non_finite_ || value - value == 0) return true;
    return fail(std::string(what) + " is not finite");
  }
  static bool check_type(PlyType, double, const char*) { return true; }
  /// Precondition: `count` is at most 2^53.
  bool skip(PlyType type, std::int64_t count) {
    last_ = offset_;
    if (static_cast<std::uint64_t>(count) > remaining() / size_of(type)) return truncated();
    offset_ += static_cast<std::size_t>(count) * size_of(type);
    return true;
  }
  bool finish(Remarks& remarks) {
    last_ = offset_;
    if (remaining() == 0) return true;
    if (is_padding(content_.substr(offset_))) {
      remarks.warn({}, padding_remark(remaining()) + " at byte " + std::to_string(offset_));
      return true;
    }
    return fail(
        "expected the end of the file, found " + std::to_string(remaining()) + " more bytes",
        "are the counts in the header right?");
  }
  [[nodiscard]] static int line() { return 0; }

  bool fail(const std::string& message, std::string hint = {}) {
    error_ = {message + " at byte " + std::to_string(last_), std::move(hint), path_, 0, 0};
    return false;
  }
  bool fail_at(Place place, std::string message) {
    error_ = {std::move(message), {}, path_, place.line, place.column};
    return false;
  }
  [[nodiscard]] std::size_t remaining() const { return content_.size() - offset_; }
  static std::size_t least_size(PlyType type) { return size_of(type); }
  [[nodiscard]] Error error() const { return error_; }

 private:
  bool truncated() {
    return fail("the file ends inside " + element_->name + " " + std::to_string(number_ + 1) +
                " of " + std::to_string(element_->count));
  }

  [[nodiscard]] double decode(PlyType type, const char* from) const {
    switch (type) {
      case PlyType::int8: return load<std::int8_t>(from, swap_);
      case PlyType::uint8: return load<std::uint8_t>(from, swap_);
      case PlyType::int16: return load<std::int16_t>(from, swap_);
      case PlyType::uint16: return load<std::uint16_t>(from, swap_);
      case PlyType::int32: return load<std::int32_t>(from, swap_);
      case PlyType::uint32: return load<std::uint32_t>(from, swap_);
      case PlyType::float32: return double{load<float>(from, swap_)};
      case PlyType::float64: break;
    }
    return load<double>(from, swap_);
  }

  std::string_view content_;
  std::size_t offset_;
  std::size_t last_;  ///< where the value read last begins
  bool swap_;
  std::string path_;
  bool non_finite_;
  const PlyElement* element_ = nullptr;
  std::int64_t number_ = 0;
  Error error_;
};

}  // namespace limn::io
