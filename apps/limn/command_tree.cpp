#include "command_tree.h"

#include <algorithm>
#include <sstream>

namespace limn::app {
namespace {

/// Of "TEXT:{quick,plain}" the words in braces.
std::vector<std::string> choices_of(const std::string& type) {
  std::vector<std::string> choices;
  const std::size_t open = type.find(":{");
  const std::size_t close = type.find('}', open);
  if (open == std::string::npos || close == std::string::npos) return choices;
  std::istringstream list(type.substr(open + 2, close - open - 2));
  for (std::string word; std::getline(list, word, ',');) choices.push_back(word);
  return choices;
}

OptionText text_of(const CLI::Option& option) {
  OptionText text;
  text.description = option.get_description();
  text.required = option.get_required();
  text.positional = option.get_positional();
  if (text.positional) text.names.push_back(option.get_name(true));
  for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  if (option.get_items_expected_max() > 0) {
    const std::string type = option.get_type_name();  // "INT:INT in [0 - 64]"
    text.value = type.empty() ? "VALUE" : type.substr(0, type.find(':'));
    text.standard = option.get_default_str();
    text.choices = choices_of(type);
  }
  return text;
}

CommandText text_of(const CLI::App& command) {
  CommandText text{command.get_name(), command.get_description(), command.get_footer(), {}};
  for (const CLI::Option* option : command.get_options()) text.options.push_back(text_of(*option));
  std::stable_partition(text.options.begin(), text.options.end(),
                        [](const OptionText& option) { return option.positional; });
  return text;
}

}  // namespace

bool OptionText::takes_scheme() const {
  return std::any_of(names.begin(), names.end(), [](const std::string& name) {
    return name == "--scheme" || name.starts_with("SCHEME");
  });
}

std::vector<CommandText> command_texts(const CLI::App& parser) {
  std::vector<CommandText> texts{text_of(parser)};
  for (const CLI::App* command : parser.get_subcommands([](const CLI::App*) { return true; }))
    texts.push_back(text_of(*command));
  return texts;
}

}  // namespace limn::app
