#include "limn/base/error.h"

namespace limn {

std::string Error::text() const {
  std::string place;
  if (!file.empty()) {
    place = file;
    if (line > 0) {
      place += ":" + std::to_string(line);
      if (column > 0) place += ":" + std::to_string(column);
    }
    place += ": ";
  }
  std::string text = place + message;
  if (!hint.empty()) text += " (" + hint + ")";
  return text;
}

}  // namespace limn
