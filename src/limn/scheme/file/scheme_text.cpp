#include "limn/scheme/file/scheme_text.h"

#include <fmt/core.h>

namespace limn {

std::string toml_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      result += std::string("\\") + c;
    else if (c == '\n')
      result += "\\n";
    else if (static_cast<unsigned char>(c) < ' ' || c == '\x7f')
      result += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      result += c;
  }
  return result + '"';
}

std::string parameter_toml(const Parameter& parameter, std::string_view value) {
  std::string text =
      fmt::format("\n[parameter.{}]\ndefault = {}\n", parameter.name, toml_string(value));
  if (parameter.low && parameter.high)
    text += fmt::format("range   = [{}, {}]\n", toml_string(parameter.low->expression.text()),
                        toml_string(parameter.high->expression.text()));
  if (!parameter.meaning.empty())
    text += fmt::format("meaning = {}\n", toml_string(parameter.meaning));
  return text;
}

std::string set_parameters_toml(const Scheme& scheme) {
  std::string text;
  for (const Parameter& parameter : scheme.parameters)
    if (parameter.value.place.line == 0)
      text += parameter_toml(parameter, parameter.value.expression.text());
  return text;
}

}  // namespace limn
