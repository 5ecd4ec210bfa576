#include "limn/mesh/io/ply_header.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

namespace limn::io {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};

/// The names of the original format, and those with the size in bits.
constexpr TypeName kTypeNames[] = {
    {"char", PlyType::int8},       {"uchar", PlyType::uint8},    {"short", PlyType::int16},
    {"ushort", PlyType::uint16},   {"int", PlyType::int32},      {"uint", PlyType::uint32},
    {"float", PlyType::float32},   {"double", PlyType::float64}, {"int8", PlyType::int8},
    {"uint8", PlyType::uint8},     {"int16", PlyType::int16},    {"uint16", PlyType::uint16},
    {"int32", PlyType::int32},     {"uint32", PlyType::uint32},  {"float32", PlyType::float32},
    {"float64", PlyType::float64},
};

class HeaderReader {
 public:
  HeaderReader(TextScanner& in, PlyHeader& header) : in_(in), header_(header) {}

  bool read() {
    if (!magic()) return false;
    for (;;) {
      in_.skip_line();
      if (!in_.next_content()) {
        return in_.fail(in_.place(), "expected end_header, found the end of the file");
      }
      const std::string_view keyword = in_.take_word();
      if (keyword == "comment" || keyword == "obj_info") continue;
      if (keyword == "end_header") break;
      if (!statement(keyword) || !line_ends()) return false;
    }
    if (!has_format_) {
      return in_.fail(in_.last_place(),
                      "the header names no format, expected format ascii 1.0, "
                      "binary_little_endian or binary_big_endian");
    }
    if (!line_ends()) return false;
    in_.skip_line();
    return true;
  }

 private:
  bool magic() {
    if (!in_.line_has_more() || in_.take_word() != "ply") {
      return in_.fail(in_.last_place(),
                      "expected the word ply, found " + in_quotes(in_.last_word()));
    }
    return line_ends();
  }

  bool line_ends() {
    if (!in_.line_has_more()) return true;
    in_.take_word();
    return in_.fail(in_.last_place(),
                    "expected the end of the line, found " + in_quotes(in_.last_word()));
  }

  bool statement(std::string_view keyword) {
    if (keyword == "format") return format();
    if (keyword == "element") return element();
    if (keyword == "property") return property();
    return in_.fail(
        in_.last_place(),
        "expected format, element, property, comment or end_header, found " + in_quotes(keyword));
  }

  bool format() {
    if (has_format_) return in_.fail(in_.last_place(), "a second format");
    has_format_ = true;
    if (!in_.skip_word("a format")) return false;
    const std::string_view word = in_.last_word();
    if (word == "ascii") {
      header_.format = PlyFormat::ascii;
    } else if (word == "binary_little_endian") {
      header_.format = PlyFormat::binary_little_endian;
    } else if (word == "binary_big_endian") {
      header_.format = PlyFormat::binary_big_endian;
    } else {
      return in_.fail(in_.last_place(),
                      "expected ascii, binary_little_endian or "
                      "binary_big_endian, found " +
                          in_quotes(word));
    }
    if (!in_.skip_word("the version 1.0")) return false;
    if (in_.last_word() == "1.0") return true;
    return in_.fail(in_.last_place(),
                    "expected the version 1.0, found " + in_quotes(in_.last_word()));
  }

  bool element() {
    PlyElement element;
    if (!in_.skip_word("the name of an element")) return false;
    element.name = in_.last_word();
    element.place = in_.last_place();
    if (!element_names_.insert(element.name).second) {
      return in_.fail(element.place, "a second element " + in_quotes(element.name));
    }
    if (!in_.read_integer(element.count, "the count of the element")) return false;
    element.count_place = in_.last_place();
    if (element.count < 0) return in_.fail(element.count_place, "a negative count");
    header_.elements.push_back(std::move(element));
    property_names_.clear();
    return true;
  }

  bool property() {
    if (header_.elements.empty()) {
      return in_.fail(in_.last_place(), "a property before the first element");
    }
    PlyProperty property;
    if (!in_.skip_word("the type of the property")) return false;
    property.is_list = in_.last_word() == "list";
    if (property.is_list) {
      if (!in_.skip_word("the type of the list's length") || !type(property.count_type)) {
        return false;
      }
      if (!in_.skip_word("the type of the list's items")) return false;
    }
    if (!type(property.type) || !in_.skip_word("the name of the property")) return false;
    property.name = in_.last_word();
    property.place = in_.last_place();
    if (!property_names_.insert(property.name).second) {
      return in_.fail(property.place, "a second property " + in_quotes(property.name));
    }
    header_.elements.back().properties.push_back(std::move(property));
    return true;
  }

  /// The type that the word read last names.
  bool type(PlyType& type) {
    for (const TypeName& known : kTypeNames) {
      if (known.name != in_.last_word()) continue;
      type = known.type;
      return true;
    }
    return in_.fail(in_.last_place(),
                    "expected a type (char, uchar, short, ushort, int, uint, "
                    "float or double), found " +
                        in_quotes(in_.last_word()));
  }

  TextScanner& in_;
  PlyHeader& header_;
  bool has_format_ = false;
  std::set<std::string> element_names_;
  std::set<std::string> property_names_;  ///< of the element read last
};

}  // namespace

const char* name_of(PlyType type) {
  const auto found = std::find_if(std::begin(kTypeNames), std::end(kTypeNames),
                                  [&](const TypeName& one) { return one.type == type; });
  return found->name.data();  // each type has a name, which is a literal
}

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8: return 1;
    case PlyType::int16:
    case PlyType::uint16: return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32: return 4;
    case PlyType::float64: return 8;
  }
  return 8;
}

namespace {

template <class Number>
bool within(double value) {
  using Limits = std::numeric_limits<Number>;
  return value >= Limits::lowest() && value <= Limits::max() &&
         (!Limits::is_integer || value == std::trunc(value));
}

}  // namespace

bool holds(PlyType type, double value) {
  switch (type) {
    case PlyType::int8: return within<std::int8_t>(value);
    case PlyType::uint8: return within<std::uint8_t>(value);
    case PlyType::int16: return within<std::int16_t>(value);
    case PlyType::uint16: return within<std::uint16_t>(value);
    case PlyType::int32: return within<std::int32_t>(value);
    case PlyType::uint32: return within<std::uint32_t>(value);
    case PlyType::float32: return within<float>(value) || !std::isfinite(value);
    case PlyType::float64: break;
  }
  return true;
}

const PlyElement* PlyHeader::find(const std::string& name) const {
  const auto found = std::find_if(elements.begin(), elements.end(),
                                  [&](const PlyElement& element) { return element.name == name; });
  return found == elements.end() ? nullptr : &*found;
}

bool read_ply_header(TextScanner& in, PlyHeader& header) { return HeaderReader(in, header).read(); }

}  // namespace limn::io
