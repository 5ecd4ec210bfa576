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

std::string schemes() { return fmt::format("{}", fmt::join(shipped_schemes(), " ")); }

/// The names of the options before a command that take a value, joined.
std::string names_with_value(const CommandText& command, const char* between) {
  std::vector<std::string> names;
  for (const OptionText& option : command.options)
    if (!option.positional && !option.value.empty())
      names.insert(names.end(), option.names.begin(), option.names.end());
  return fmt::format("{}", fmt::join(names, between));
}

/// Options, values of options, else schemes and files; after {0} comes a value, not the command.
constexpr const char* kBash = R"(# bash completion of limn; made by `limn completion bash`
_limn() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} command= value= one
  local schemes={1}
  if [[ $word == = ]]; then word=; fi
  if [[ $before == = ]]; then before=${{COMP_WORDS[COMP_CWORD-2]}}; fi
  for one in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    if [[ $one == = ]]; then value=1; continue; fi
    if [[ -n $value ]]; then value=; continue; fi
    case $one in {0}) value=1 ;; -*) ;; *) command=$one; break ;; esac
  done
  COMPREPLY=()
  if [[ -z $command && -z $value && $word != -* ]]; then
    COMPREPLY=($(compgen -W {2} -- "$word"))
    return
  fi
  case "$command $before" in
{3}  esac
  if [[ $word == -* ]]; then
    local options={4}
    case $command in
{5}    esac
    COMPREPLY=($(compgen -W "$options" -- "$word"))
    return
  fi
  case $command in
{6}  esac
  COMPREPLY+=($(compgen -f -- "$word"))
}}
complete -o filenames -F _limn limn
)";

std::string bash(const std::vector<CommandText>& texts) {
  std::string values, options, arguments;
  for (auto command = texts.begin() + 1; command != texts.end(); ++command) {
    options +=
        fmt::format("      {}) options+={} ;;\n", command->name, quoted(" " + words(*command)));
    for (const OptionText& option : command->options) {
      const bool closed = !option.choices.empty();
      if (!closed && !option.takes_scheme()) continue;
      const std::string list =
          closed ? quoted(fmt::format("{}", fmt::join(option.choices, " "))) : "\"$schemes\"";
      const std::string reply = fmt::format("COMPREPLY=($(compgen -W {} -- \"$word\"){})", list,
                                            closed ? "" : " $(compgen -f -- \"$word\")");
      if (option.positional) {
        arguments += fmt::format("    {}) {}; return ;;\n", command->name, reply);
        continue;
      }
      std::vector<std::string> patterns;
      for (const std::string& name : option.names)
        patterns.push_back(quoted(command->name + " " + name));
      values += fmt::format("    {}) {}; return ;;\n", fmt::join(patterns, "|"), reply);
    }
  }
  return fmt::format(kBash, names_with_value(texts.front(), "|"), quoted(schemes()),
                     quoted(command_names(texts)), values, quoted(words(texts.front())), options,
                     arguments);
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

std::string zsh_action(const OptionText& option) {
  if (!option.choices.empty()) return fmt::format("({})", fmt::join(option.choices, " "));
  return option.takes_scheme() ? "{compadd -a schemes; _files}" : "_files";
}

std::string zsh_options(const CommandText& command) {
  std::string text;
  for (const OptionText& option : command.options) {
    if (option.positional) continue;
    for (const std::string& name : option.names)
      text += fmt::format(
          " {}", quoted(fmt::format("*{}[{}]{}", name, zsh_escaped(option.description),
                                    option.value.empty() ? "" : ":value:" + zsh_action(option))));
  }
  return text;
}

std::string zsh_arguments(const CommandText& command) {
  std::string action = "_files";
  for (const OptionText& option : command.options)
    if (option.positional) action = zsh_action(option);
  return quoted("*:argument:" + action);
}

std::string zsh(const std::vector<CommandText>& texts) {
  std::string text =
      "#compdef limn\n# made by `limn completion zsh`: a file _limn in a folder of $fpath, or\n"
      "# eval \"$(limn completion zsh)\" behind compinit\n_limn() {\n"
      "  local curcontext=$curcontext state state_descr line\n  typeset -A opt_args\n"
      "  local -a commands schemes\n";
  text += fmt::format("  schemes=({})\n  commands=(\n", schemes());
  for (auto command = texts.begin() + 1; command != texts.end(); ++command)
    text += "    " + quoted(command->name + ":" + zsh_escaped(command->description)) + "\n";
  text += fmt::format(
      "  )\n  _arguments -C{} '(-): :->command' '(-)*:: :->rest' && return\n  case $state in\n"
      "  command) _describe command commands ;;\n  rest)\n    case $words[1] in\n",
      zsh_options(texts.front()));
  for (auto command = texts.begin() + 1; command != texts.end(); ++command)
    text += fmt::format("    {}) _arguments{}{} {} ;;\n", command->name, zsh_options(texts.front()),
                        zsh_options(*command), zsh_arguments(*command));
  return text +
         "    esac ;;\n  esac\n}\n"
         "if [[ $funcstack[1] == _limn ]]; then _limn \"$@\"; else compdef _limn limn; fi\n";
}

/// The command that is typed: after {0} comes a value.
constexpr const char* kFish = R"fish(# fish completion of limn; made by `limn completion fish`
function __limn_command
  set -l value 0
  for word in (commandline -opc)[2..]
    if test $value = 1
      set value 0
      continue
    end
    switch $word
      case {0}
        set value 1
      case '-*'
      case '*'
        echo $word
        return
    end
  end
end
function __limn_needs_command
  set -l command (__limn_command)
  test -z "$command"
end
function __limn_uses
  set -l command (__limn_command)
  test "$command" = $argv[1]
end
)fish";

std::string fish_list(const OptionText& option) {
  if (!option.choices.empty())
    return fmt::format(" -f -a {}", quoted(fmt::format("{}", fmt::join(option.choices, " "))));
  return option.takes_scheme() ? " -a " + quoted(schemes()) : "";
}

std::string fish_options(const CommandText& command, const std::string& condition) {
  std::string text;
  for (const OptionText& option : command.options) {
    if (option.positional && fish_list(option).empty()) continue;
    text += "complete -c limn" + condition;
    if (!option.positional) {
      for (const std::string& name : option.names)
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      text +=
          (option.value.empty() ? "" : " -r") + std::string(" -d ") + quoted(option.description);
    }
    text += fish_list(option) + "\n";
  }
  return text;
}

std::string fish(const std::vector<CommandText>& texts) {
  std::string text = fmt::format(kFish, names_with_value(texts.front(), " "));
  text += fish_options(texts.front(), "");
  for (auto command = texts.begin() + 1; command != texts.end(); ++command) {
    text += fmt::format("complete -c limn -n __limn_needs_command -f -a {} -d {}\n", command->name,
                        quoted(command->description));
    text += fish_options(*command, fmt::format(" -n '__limn_uses {}'", command->name));
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
      add_command(parser, "completion", "print what completes limn's words in a shell");
  const auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command->footer(
      "Example: eval \"$(limn completion bash)\"\n"
      "         eval \"$(limn completion zsh)\"        behind compinit\n"
      "         limn completion fish | source");
  command->callback([&action, &parser, shell] {
    action = [&parser, shell] { return print_completion(parser, *shell); };
  });
}

}  // namespace limn::app
