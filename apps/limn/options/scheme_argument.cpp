#include "options/scheme_argument.h"

#include <algorithm>
#include <filesystem>

#include <fmt/core.h>

#include "command.h"

namespace limn::app {
namespace {

struct Parts {
  std::string scheme;
  bool colon = false;
  std::vector<std::string> parameters;
};

Parts parts_of(const std::string& text) {
  std::error_code ignored;
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos || std::filesystem::is_regular_file(text, ignored))
    return {text, false, {}};
  const std::string rest = text.substr(colon + 1);
  if (rest.find('=') == std::string::npos &&
      (rest.find('/') != std::string::npos || rest.ends_with(".toml")))
    return {text, false, {}};
  Parts parts{text.substr(0, colon), true, {}};
  for (std::size_t begin = colon + 1; begin < text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    parts.parameters.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

Result<Scheme> load(const std::string& text, std::vector<std::string> parameters) {
  const Parts parts = parts_of(text);
  if (parts.colon && parts.parameters.empty())
    return Error{fmt::format("'{}': no parameter after the colon", text),
                 "as laplacian-butterfly:b=3/16"};
  parameters.insert(parameters.end(), parts.parameters.begin(), parts.parameters.end());
  Result<Scheme> scheme = load_scheme(parts.scheme);
  if (!scheme) return scheme;
  if (Status status = set_parameters(*scheme, parameters); !status) return status.error();
  return scheme;
}

/// Whether a label comes twice; then texts, which never do, take their place.
bool any_twice(const std::vector<NamedScheme>& schemes) {
  std::vector<std::string> labels;
  labels.reserve(schemes.size());
  for (const NamedScheme& scheme : schemes) labels.push_back(scheme.label);
  std::sort(labels.begin(), labels.end());
  return std::adjacent_find(labels.begin(), labels.end()) != labels.end();
}

}  // namespace

Result<Scheme> scheme_argument(const std::string& text, const std::vector<std::string>& common) {
  return load(text, common);
}

std::string scheme_name_of(const std::string& text) { return parts_of(text).scheme; }

std::set<std::string> given_parameters(const std::string& text,
                                       const std::vector<std::string>& common) {
  std::vector<std::string> assignments = parts_of(text).parameters;
  assignments.insert(assignments.end(), common.begin(), common.end());
  std::set<std::string> names;
  for (const std::string& assignment : assignments) {
    std::string name = assignment.substr(0, assignment.find('='));
    std::erase_if(name, [](char c) { return c == ' ' || c == '\t'; });
    names.insert(std::move(name));
  }
  return names;
}

std::string scheme_label(const std::string& text, const Scheme& scheme) {
  std::string label = scheme.name;
  for (const std::string& parameter : parts_of(text).parameters) label += " " + parameter;
  return label;
}

Result<std::vector<NamedScheme>> scheme_arguments(const std::vector<std::string>& texts,
                                                  const std::vector<std::string>& common) {
  std::vector<NamedScheme> schemes;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (std::find(texts.begin(), texts.begin() + static_cast<std::ptrdiff_t>(i), texts[i]) !=
        texts.begin() + static_cast<std::ptrdiff_t>(i))
      return Error{fmt::format("scheme '{}' is given twice", texts[i])};
    Result<Scheme> scheme = load(texts[i], common);
    if (!scheme) return scheme.error();
    std::string label = scheme_label(texts[i], *scheme);
    for (const std::string& parameter : common) label += " " + parameter;
    schemes.push_back({std::move(label), std::move(*scheme)});
  }
  if (any_twice(schemes))
    for (std::size_t i = 0; i < texts.size(); ++i) schemes[i].label = texts[i];
  return schemes;
}

}  // namespace limn::app
