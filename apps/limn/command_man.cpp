#include <fmt/core.h>

#include <fmt/ranges.h>
#include <algorithm>

#include "command.h"
#include "command_tree.h"

namespace limn::app {
namespace {

/// The code point at `at`, which is moved behind it; what is not UTF-8 is a question mark.
char32_t next_character(const std::string& text, std::size_t& at) {
  const auto lead = static_cast<unsigned char>(text[at++]);
  const int more = lead >= 0xf0 ? 3 : lead >= 0xe0 ? 2 : lead >= 0xc0 ? 1 : 0;
  char32_t character = more == 0 ? lead : lead & (0x3fU >> more);
  for (int k = 0; k < more && at < text.size(); ++k)
    character = (character << 6) | (static_cast<unsigned char>(text[at++]) & 0x3fU);
  return character;
}

/// As text of a manual page.
std::string roff(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const char32_t c = next_character(text, at);
    if (c == U'\\')
      result += "\\e";
    else if (c == U'-')
      result += "\\-";
    else if (c > 126)
      result += fmt::format("\\[u{:04X}]", static_cast<unsigned>(c));
    else
      result += static_cast<char>(c);
  }
  if (result.starts_with('.') || result.starts_with('\'')) result.insert(0, "\\&");
  return result;
}

std::string option_entry(const OptionText& option) {
  std::string names;
  for (const std::string& name : option.names)
    names += (names.empty() ? "" : ", ") + fmt::format("\\fB{}\\fR", roff(name));
  if (!option.value.empty() && !option.positional)
    names += fmt::format(" \\fI{}\\fR", roff(option.value));
  std::string text = fmt::format(".TP\n{}\n{}", names, roff(option.description));
  if (option.required && !option.positional) text += " (required)";
  if (!option.standard.empty()) text += fmt::format(" [{}]", roff(option.standard));
  return text + "\n";
}

/// "Example: …" lines as they are.
std::string footer_entry(const std::string& footer) {
  if (footer.empty()) return {};
  std::string text = ".PP\n.nf\n";
  for (std::size_t begin = 0; begin <= footer.size();) {
    const std::size_t end = std::min(footer.find('\n', begin), footer.size());
    text += roff(footer.substr(begin, end - begin)) + "\n";
    begin = end + 1;
  }
  return text + ".fi\n";
}

std::string command_entry(const CommandText& command) {
  std::string usage = fmt::format("\\fBlimn {}\\fR", roff(command.name));
  for (const OptionText& option : command.options)
    if (option.positional) {
      const std::string name = fmt::format("\\fI{}\\fR", roff(option.names.front()));
      usage += option.required ? " " + name : " [" + name + "]";
    }
  std::string text = fmt::format(".SS {}\n{} [\\fIOPTIONS\\fR]\n.PP\n{}.\n", roff(command.name),
                                 usage, roff(command.description));
  for (const OptionText& option : command.options) text += option_entry(option);
  return text + footer_entry(command.footer);
}

int print_manual(const CLI::App& parser) {
  const std::vector<CommandText> texts = command_texts(parser);
  const CommandText& whole = texts.front();
  std::string text = fmt::format(
      ".TH LIMN 1 \"\" \"limn {0}\" \"User Commands\"\n.SH NAME\nlimn \\- {1}\n.SH SYNOPSIS\n"
      "\\fBlimn\\fR \\fICOMMAND\\fR [\\fIARGUMENTS\\fR]\n.SH OPTIONS\nOf every command:\n",
      LIMN_VERSION, roff(whole.description.substr(whole.description.find(": ") + 2)));
  for (const OptionText& option : whole.options) text += option_entry(option);
  text += ".SH COMMANDS\n";
  for (auto command = texts.begin() + 1; command != texts.end(); ++command)
    text += command_entry(*command);
  text +=
      ".SH EXIT STATUS\n.TP\n0\nDone.\n.TP\n2\nBad usage or bad input; nothing was written.\n"
      ".TP\n3\nSome answer is undecided.\n";
  fmt::print("{}", text);
  return kDone;
}

}  // namespace

void declare_man(CLI::App& parser, Action& action) {
  CLI::App* command = add_command(parser, "man", "print the manual page, for man(1)");
  command->footer("Example: limn man > limn.1 && man ./limn.1");
  command->callback([&action, &parser] { action = [&parser] { return print_manual(parser); }; });
}

}  // namespace limn::app
