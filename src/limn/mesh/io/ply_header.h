#pragma once
/// The header of a PLY file: which elements follow, of which properties, in which encoding.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "limn/mesh/attributes/attributes.h"
#include "limn/mesh/io/text_scanner.h"

namespace limn::io {

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };
using PlyType = NumberType;

/// Bytes of one value in a binary file.
std::size_t size_of(PlyType type);
/// Whether a number that is given as text is one of that type: within its range, of an integer
/// type an integer.
bool holds(PlyType type, double value);
/// As headers that limn writes name it: "uchar", "double".
const char* name_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;  ///< of the value, or of the items of a list
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  ///< of the length of a list
  Place place;
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;  ///< as declared, 0 or more; not yet compared with the size of the file
  std::vector<PlyProperty> properties;
  Place place;
  Place count_place;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;

  /// The element of that name, or null.
  [[nodiscard]] const PlyElement* find(const std::string& name) const;
};

/// Reads from "ply" to "end_header" and leaves the scanner at the first byte of the data.
bool read_ply_header(TextScanner& in, PlyHeader& header);

}  // namespace limn::io
