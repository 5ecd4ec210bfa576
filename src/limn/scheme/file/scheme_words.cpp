#include "limn/scheme/file/scheme_words.h"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/core.h>

#include "limn/scheme/role.h"

namespace limn::scheme {

std::vector<std::string> known_keys() {
  std::vector<std::string> keys{"name",    "title",   "split", "weights",   "source", "notes",
                                "extends", "lattice", "let",   "parameter", "roles"};
  for (int i = 0; i < kRuleKinds; ++i)
    if (const std::string name(rule_name(static_cast<RuleKind>(i))); !name.starts_with(kBoundary))
      keys.push_back(name);
  keys.insert(keys.end(), {"boundary", "mask", "factors", "stages", "facts", "smooth-triangles"});
  return keys;
}

std::vector<std::string> boundary_keys() {
  std::vector<std::string> keys;
  for (int i = 0; i < kRuleKinds; ++i)
    if (const std::string name(rule_name(static_cast<RuleKind>(i))); name.starts_with(kBoundary))
      keys.push_back(name.substr(kBoundary.size()));
  return keys;
}

std::vector<std::string> rule_names() {
  std::vector<std::string> names;
  for (int i = 0; i < kRuleKinds; ++i) names.emplace_back(rule_name(static_cast<RuleKind>(i)));
  return names;
}

bool is_identifier(std::string_view name) {
  if (name.empty() || (std::isalpha(static_cast<unsigned char>(name[0])) == 0 && name[0] != '_'))
    return false;
  return std::all_of(name.begin(), name.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  });
}

bool is_reserved(std::string_view name) {
  constexpr std::array<std::string_view, 9> reserved{"n",    "k",   "pi", "cos", "sin",
                                                     "sqrt", "and", "or", "not"};
  return std::find(reserved.begin(), reserved.end(), name) != reserved.end();
}

std::string fault_of_base(const std::string& name, const Error& fault) {
  constexpr std::string_view extends = "extends '", by_way = "', which extends '",
                             far = "' and, by way of others, '";
  if (!fault.message.starts_with(extends))
    return fmt::format("{}{}': {}", extends, name, fault.text());
  std::string rest = fault.message.substr(extends.size());
  for (const std::string_view link : {by_way, far})
    if (const std::size_t at = rest.find(link); at != std::string::npos)
      return fmt::format("{}{}{}{}", extends, name, far, rest.substr(at + link.size()));
  return fmt::format("{}{}{}{}", extends, name, by_way, rest);
}

}  // namespace limn::scheme
