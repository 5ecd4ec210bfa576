#include "answer.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <string_view>

namespace limn::page {
namespace {

Json error_json(int line, int column, const std::string& message, const std::string& hint) {
  return {{"line", line}, {"column", column}, {"message", message}, {"hint", hint}};
}

/// A number and the colon after it, taken off the front of `text`; -1: there is none.
int take_number(std::string_view& text) {
  std::size_t digits = 0;
  while (digits < text.size() && std::isdigit(static_cast<unsigned char>(text[digits])) != 0)
    ++digits;
  if (digits == 0 || digits > 9 || digits == text.size() || text[digits] != ':') return -1;
  const int value = std::atoi(std::string(text.substr(0, digits)).c_str());
  text.remove_prefix(digits + 1);
  return value;
}

/// A further fault, a line as Error::text writes it: "file:line:column: message (hint)".
Json further_json(std::string_view text, const std::string& file) {
  std::string_view rest = text;
  int line = 0, column = 0;
  if (!file.empty() && rest.starts_with(file + ":")) {
    rest.remove_prefix(file.size() + 1);
    line = std::max(take_number(rest), 0);
    column = std::max(take_number(rest), 0);
    if (rest.starts_with(' ')) rest.remove_prefix(1);
  }
  return error_json(line, column, std::string(rest), "");
}

}  // namespace

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json accepted(const Json& rest) {
  Json json{{"ok", true}};
  json.update(rest);
  return json;
}

Json refused(const Error& error) {
  Json errors = Json::array();
  std::string_view rest = error.message;
  const std::size_t end = std::min(rest.find('\n'), rest.size());
  errors.push_back(
      error_json(error.line, error.column, std::string(rest.substr(0, end)), error.hint));
  for (std::size_t begin = end; begin < rest.size();) {
    const std::size_t next = std::min(rest.find('\n', begin + 1), rest.size());
    errors.push_back(further_json(rest.substr(begin + 1, next - begin - 1), error.file));
    begin = next;
  }
  return {{"ok", false}, {"errors", std::move(errors)}};
}

Json errors_json(const Warnings& errors) {
  Json list = Json::array();
  for (const Error& one : errors)
    list.push_back(error_json(one.line, one.column, one.message, one.hint));
  return list;
}

}  // namespace limn::page
