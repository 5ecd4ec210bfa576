#pragma once
/// The commands and options as they are declared, for what is made of them: manual, completion.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace limn::app {

struct OptionText {
  std::vector<std::string> names;  ///< "-s", "--scheme"; a positional's one name
  std::string value;               ///< what it takes, "FILE"; empty: it is a flag
  std::string description;
  std::string standard;              ///< the default, or empty
  std::vector<std::string> choices;  ///< the words that it takes; none: others than a few
  bool positional = false;
  bool required = false;

  /// Whether it takes schemes: SCHEME, --scheme.
  [[nodiscard]] bool takes_scheme() const;
};

struct CommandText {
  std::string name, description, footer;
  std::vector<OptionText> options;  ///< positionals first
};

/// `parser` itself, with the options that every command takes, and then its commands.
[[nodiscard]] std::vector<CommandText> command_texts(const CLI::App& parser);

}  // namespace limn::app
