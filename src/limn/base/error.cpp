#include "limn/base/error.h"

#include "limn/base/printable.h"

namespace limn {

std::string Error::text() const {
  std::string place;
  if (!file.empty()) {
    place = printable(file);
    if (line > 0) {
      place += ":" + std::to_string(line);
      if (column > 0) place += ":" + std::to_string(column);
    }
    place += ": ";
  }
  // several faults of one file are lines (base/faults.h); elsewhere a line feed is part of a name
  std::string text = place + (line > 0 ? printable_lines(message) : printable(message));
  if (!hint.empty()) text += " (" + printable(hint) + ")";
  return text;
}

}  // namespace limn
