#include "limn/certify/certificate/certificate_words.h"

#include <algorithm>

namespace limn::certify {

std::string parts_text(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts)
    text += (text.empty() ? "" : " ") + (part.empty() ? "-" : part);
  return text;
}

std::vector<std::string> read_parts(JsonReader& reader, const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    if (part.empty() || (part != "-" && part.find_first_not_of("0123456789") != std::string::npos))
      reader.fail("'parts' is to be words of digits, or '-'");
    parts.push_back(part == "-" ? std::string() : part);
    begin = end + 1;
  }
  return parts;
}

}  // namespace limn::certify
