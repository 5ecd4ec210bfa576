#pragma once
/// Numbers as text: doubles in the shortest form that reads back to the same double.

#include <fmt/compile.h>
#include <fmt/format.h>

#include <string>

#include "limn/mesh/polygons.h"

namespace limn::io {

inline void append(std::string& out, double value) {
  char buffer[64];
  char* const end = fmt::format_to(buffer, FMT_COMPILE("{}"), value);
  out.append(buffer, end);
}

inline void append(std::string& out, Index value) {
  const fmt::format_int text(value);
  out.append(text.data(), text.size());
}

inline void append(std::string& out, Point3 point) {
  append(out, point.x);
  out += ' ';
  append(out, point.y);
  out += ' ';
  append(out, point.z);
}

}  // namespace limn::io
