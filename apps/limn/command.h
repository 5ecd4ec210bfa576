#pragma once
/// What the commands share. A command is one file: a function that declares its options on the
/// parser and hands over what to run. It parses, calls the library and prints; no mathematics.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "limn/base/error.h"
#include "limn/scheme/scheme.h"

namespace limn::app {

// exit codes of every command
inline constexpr int kDone = 0;
inline constexpr int kBadInput = 2;
inline constexpr int kUndecided = 3;  // some answer is "undecided"

/// A command of the parser. Here, as whoever creates a CLI::App itself compiles all of it once
/// more: its help, its configuration files.
[[nodiscard]] CLI::App* add_command(CLI::App& parser, const std::string& name,
                                    const std::string& help);

/// What the chosen command runs once the whole command line is parsed; returns the exit code.
using Action = std::function<int()>;

/// Declares one command on `parser` and sets `action` if it is the one chosen.
using Declare = void (*)(CLI::App& parser, Action& action);

void declare_schemes(CLI::App& parser, Action& action);
void declare_show(CLI::App& parser, Action& action);
void declare_refine(CLI::App& parser, Action& action);
void declare_check(CLI::App& parser, Action& action);
void declare_draw(CLI::App& parser, Action& action);
void declare_artifacts(CLI::App& parser, Action& action);
void declare_eigen(CLI::App& parser, Action& action);
void declare_compare(CLI::App& parser, Action& action);
void declare_regularity(CLI::App& parser, Action& action);
void declare_certify(CLI::App& parser, Action& action);
void declare_prescribe(CLI::App& parser, Action& action);
void declare_tune(CLI::App& parser, Action& action);
void declare_study(CLI::App& parser, Action& action);
void declare_fairness(CLI::App& parser, Action& action);
void declare_papers(CLI::App& parser, Action& action);
void declare_report(CLI::App& parser, Action& action);
void declare_man(CLI::App& parser, Action& action);
void declare_completion(CLI::App& parser, Action& action);

/// Prints "limn: …" on standard error; returns kBadInput.
int report(const Error& error);
/// Prints "limn: warning: …" on standard error, unless quiet.
void report_warnings(const Warnings& warnings);

/// From now on no progress and no warnings, only errors.
void be_quiet();
[[nodiscard]] bool is_quiet();

/// What is being done, for the message of a failure that has no better place, as that of memory.
void set_step(const std::string& step);
[[nodiscard]] const std::string& step();

/// Prints one object, on a line. What is not UTF-8 in it, as a file's name may be, becomes U+FFFD:
/// JSON has no other way.
void print_json(const nlohmann::ordered_json& json);

/// Whether the files of a command line can be written, and are different files, so that it is
/// refused before the work. Empty paths are outputs that nobody wants.
[[nodiscard]] Status check_outputs(std::initializer_list<std::string> paths);

/// What comes on standard input. It can be taken once in a run: who asks again is told so.
[[nodiscard]] Result<std::string> take_standard_input(std::uint64_t most_bytes = 0);

/// A shipped scheme, a scheme file, or with "-" the scheme on standard input. For what fails while
/// it is read, `step` names it.
[[nodiscard]] Result<Scheme> load_scheme(const std::string& name_or_path);

/// Prints text on standard output; control characters that a name brought along are escaped.
void print_text(const std::string& text);

/// What the help of an option says of SCHEME.
inline constexpr const char* kSchemeArgumentHelp =
    "a shipped scheme or a scheme file, with its parameters after a colon, as "
    "laplacian-butterfly:b=3/16";

/// What the help says of files, the same in every command: -o takes what the command makes; --map
/// and --chart draw beside what it prints.
inline constexpr const char* kFigureFiles = ".pdf, .svg or .png";
inline constexpr const char* kTableFiles = ".csv or .json";

/// SCHEME and its parameters, as several commands take them.
struct SchemeOptions {
  std::string name;                     // "NAME_OR_PATH[:name=value,…]"
  std::vector<std::string> parameters;  // "name=value"

  void declare_parameters(CLI::App& command);
  /// Fails as scheme_argument (scheme_argument.h) does.
  [[nodiscard]] Result<Scheme> load() const;
};

/// Whether a scheme file can have this name: NAME.toml.
[[nodiscard]] Status check_scheme_path(const std::string& path);

/// What a scheme file at `path` says after "extends" to mean the SCHEME of a command line: a
/// shipped name, or a path from its folder. Fails where a scheme file cannot say it: TOML is UTF-8,
/// and standard input has no name.
[[nodiscard]] Result<std::string> extends_name(const std::string& scheme, const std::string& path);

/// What is wrong with a scheme file that therefore is not written: no places in it.
[[nodiscard]] Error unwritten(const Error& fault, const std::string& path);

}  // namespace limn::app
