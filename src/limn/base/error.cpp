#include "limn/base/error.h"

#include "limn/base/printable.h"

namespace limn {

namespace {

/// Whether the message is a list of faults, a line each: in a file that has lines, or (a binary
/// one has none) by what is indented behind each line feed. A line feed in a name is none of these.
bool is_list(const std::string& message, int line) {
  if (line > 0) return true;  // base/faults.h
  for (std::size_t k = message.find('\n'); k != std::string::npos; k = message.find('\n', k + 1))
    if (k + 1 == message.size() || message[k + 1] != ' ') return false;
  return true;
}

}  // namespace

std::string Error::text() const {
  std::string place;
  if (!file.empty()) {
    place = base::printable(file);
    if (line > 0) {
      place += ":" + std::to_string(line);
      if (column > 0) place += ":" + std::to_string(column);
    }
    place += ": ";
  }
  std::string text =
      place + (is_list(message, line) ? base::printable_lines(message) : base::printable(message));
  if (!hint.empty()) text += " (" + base::printable(hint) + ")";
  return text;
}

}  // namespace limn
