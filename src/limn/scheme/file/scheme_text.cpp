#include "limn/scheme/file/scheme_text.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/core.h>

#include "limn/base/utf8.h"

namespace limn::scheme {

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

Result<std::string> extended_name(const std::string& name_or_path, const std::string& path) {
  namespace fs = std::filesystem;
  const std::vector<std::string> shipped = shipped_schemes();
  if (std::find(shipped.begin(), shipped.end(), name_or_path) != shipped.end()) return name_or_path;
  const std::string base = fs::proximate(name_or_path, fs::absolute(path).parent_path()).string();
  for (std::string_view rest = base; !rest.empty(); rest.remove_prefix(base::utf8_length(rest)))
    if (base::utf8_length(rest) == 0)
      return Error{fmt::format("no scheme file can extend '{}': its name is not UTF-8", base),
                   "rename it"};
  return base;
}

Error not_written(const Error& fault, const std::string& path) {
  const std::string first = fault.message.substr(0, fault.message.find('\n'));
  return {fmt::format("'{}' is not written: {}", path, first), fault.hint};
}

std::string derived_title(const Scheme& scheme, std::string_view how) {
  return fmt::format("{}, {}", scheme.title.empty() ? scheme.name : scheme.title, how);
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

std::string definition_by_valence(const std::vector<std::pair<int, Rational>>& numbers,
                                  const Expression& elsewhere) {
  std::string sum, guards;
  for (const auto& [n, number] : numbers) {
    sum += fmt::format("(n == {}) * ({}) + ", n, to_string(number));
    guards += fmt::format("(n != {}) * ", n);
  }
  return fmt::format("{}{}({})", sum, guards, elsewhere.text());
}

std::string weights_toml(const Scheme& scheme) {
  return scheme.has_decimals ? "weights = \"decimal\"\n" : "";
}

std::string definitions_toml(const Scheme& scheme,
                             const std::vector<std::pair<std::string, std::string>>& definitions) {
  std::string parameters, lets;
  std::set<std::string_view> written;
  for (const Parameter& parameter : scheme.parameters) {
    const auto found =
        std::find_if(definitions.begin(), definitions.end(),
                     [&](const auto& definition) { return definition.first == parameter.name; });
    if (found != definitions.end()) {
      written.insert(found->first);
      parameters += parameter_toml(parameter, found->second);
    } else if (parameter.value.place.line == 0) {  // it was set by an option
      parameters += parameter_toml(parameter, parameter.value.expression.text());
    }
  }
  for (const auto& [name, definition] : definitions)
    if (written.count(name) == 0) lets += fmt::format("{} = {}\n", name, toml_string(definition));
  return lets.empty() ? parameters : parameters + "\n[let]\n" + lets;
}

}  // namespace limn::scheme
