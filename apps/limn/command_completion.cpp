#include <memory>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "command.h"
#include "command_tree.h"

namespace limn::app {
namespace {

/// In single quotes of a shell.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string words(const CommandText& command) {
  std::string text;
  for (const OptionText& option : command.options)
    if (!option.positional)
      for (const std::string& name : option.names) text += (text.empty() ? "" : " ") + name;
  return text;
}

std::string command_names(const std::vector<CommandText>& texts) {
  std::string names;
  for (auto command = texts.begin() + 1; command != texts.end(); ++command)
    names += (names.empty() ? "" : " ") + command->name;
  return names;
}

/// Both shells: options of the command that is typed, else schemes and files.
constexpr const char* kBash = R"(# bash completion of limn; made by `limn completion bash`
_limn() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} command= one
  for one in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    case $one in -*) ;; *) command=$one; break ;; esac
  done
  COMPREPLY=()
  if [[ -z $command && $word != -* ]]; then
    COMPREPLY=($(compgen -W {0} -- "$word"))
    return
  fi
  if [[ $word == -* ]]; then
    local options={1}
    case $command in
{2}    esac
    COMPREPLY=($(compgen -W "$options" -- "$word"))
    return
  fi
  COMPREPLY=($(compgen -W {3} -- "$word") $(compgen -f -- "$word"))
}}
complete -o filenames -F _limn limn
)";

std::string bash(const std::vector<CommandText>& texts) {
  std::string cases;
  for (auto command = texts.begin() + 1; command != texts.end(); ++command)
    cases +=
        fmt::format("      {}) options+={} ;;\n", command->name, quoted(" " + words(*command)));
  return fmt::format(kBash, quoted(command_names(texts)), quoted(words(texts.front())), cases,
                     quoted(fmt::format("{}", fmt::join(shipped_schemes(), " "))));
}

/// For _describe and _arguments of zsh, where a colon and brackets mean something.
std::string zsh_escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == ':' || c == '[' || c == ']' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string zsh_options(const CommandText& command) {
  std::string text;
  for (const OptionText& option : command.options) {
    if (option.positional) continue;
    for (const std::string& name : option.names)
      text +=
          fmt::format(" {}", quoted(fmt::format("*{}[{}]{}", name, zsh_escaped(option.description),
                                                option.value.empty() ? "" : ":value:_files")));
  }
  return text;
}

std::string zsh(const std::vector<CommandText>& texts) {
  std::string text = "#compdef limn\n# made by `limn completion zsh`\nlocal -a commands schemes\n";
  text += fmt::format("schemes=({})\ncommands=(\n", fmt::join(shipped_schemes(), " "));
  for (auto command = texts.begin() + 1; command != texts.end(); ++command)
    text += "  " + quoted(command->name + ":" + zsh_escaped(command->description)) + "\n";
  text += ")\nif (( CURRENT == 2 )); then\n  _describe command commands\n  return\nfi\n";
  text += "local command=$words[2]\nshift words\n(( CURRENT-- ))\ncase $command in\n";
  for (auto command = texts.begin() + 1; command != texts.end(); ++command)
    text += fmt::format("  {}) _arguments{}{} '*:argument:{{compadd -a schemes; _files}}' ;;\n",
                        command->name, zsh_options(texts.front()), zsh_options(*command));
  return text + "esac\n";
}

std::string fish_options(const CommandText& command, const std::string& condition) {
  std::string text;
  for (const OptionText& option : command.options) {
    if (option.positional) continue;
    text += "complete -c limn" + condition;
    for (const std::string& name : option.names)
      text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    text += (option.value.empty() ? "" : " -r") + std::string(" -d ") + quoted(option.description) +
            "\n";
  }
  return text;
}

std::string fish(const std::vector<CommandText>& texts) {
  std::string text = "# fish completion of limn; made by `limn completion fish`\n";
  text += fish_options(texts.front(), "");
  for (auto command = texts.begin() + 1; command != texts.end(); ++command) {
    text += fmt::format("complete -c limn -n __fish_use_subcommand -f -a {} -d {}\n", command->name,
                        quoted(command->description));
    const std::string seen = fmt::format(" -n '__fish_seen_subcommand_from {}'", command->name);
    text += fish_options(*command, seen);
    for (const OptionText& option : command->options)
      if (option.names.front() == "SCHEME" || option.names.back() == "--scheme")
        text += fmt::format("complete -c limn{} -a {}\n", seen,
                            quoted(fmt::format("{}", fmt::join(shipped_schemes(), " "))));
  }
  return text;
}

int print_completion(const CLI::App& parser, const std::string& shell) {
  const std::vector<CommandText> texts = command_texts(parser);
  fmt::print("{}", shell == "bash" ? bash(texts) : shell == "zsh" ? zsh(texts) : fish(texts));
  return kDone;
}

}  // namespace

void declare_completion(CLI::App& parser, Action& action) {
  CLI::App* command =
      parser.add_subcommand("completion", "print what completes limn's words in a shell");
  const auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command->footer("Example: eval \"$(limn completion bash)\"");
  command->callback([&action, &parser, shell] {
    action = [&parser, shell] { return print_completion(parser, *shell); };
  });
}

}  // namespace limn::app
