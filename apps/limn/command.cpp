#include "command.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "limn/base/files/file.h"
#include "limn/base/printable.h"
#include "limn/base/progress.h"
#include "limn/scheme/file/scheme_text.h"
#include "limn/scheme/scheme_size.h"
#include "options/scheme_argument.h"

namespace limn::app {
namespace {

bool quiet = false;
std::string current_step = "limn";

}  // namespace

CLI::App* add_command(CLI::App& parser, const std::string& name, const std::string& help) {
  return parser.add_subcommand(name, help);
}

int report(const Error& error) {
  const std::string text = error.text();
  for (std::size_t begin = 0; begin <= text.size();) {  // a line for each fault
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::fprintf(stderr, "limn: %s\n", text.substr(begin, end - begin).c_str());
    begin = end + 1;
  }
  return kBadInput;
}

void print_text(const std::string& text) { fmt::print("{}", base::printable_lines(text)); }

void report_warnings(const Warnings& warnings) {
  if (quiet) return;
  for (const Error& warning : warnings)
    std::fprintf(stderr, "limn: warning: %s\n", warning.text().c_str());
}

void be_quiet() {
  quiet = true;
  base::ProgressLine::show_none();
}

bool is_quiet() { return quiet; }

void set_step(const std::string& step) { current_step = step; }
const std::string& step() { return current_step; }

void print_json(const nlohmann::ordered_json& json) {
  using Handler = nlohmann::ordered_json::error_handler_t;
  fmt::print("{}\n", json.dump(-1, ' ', false, Handler::replace));
}

Status check_outputs(std::initializer_list<std::string> paths) {
  for (auto path = paths.begin(); path != paths.end(); ++path) {
    if (path->empty()) continue;
    if (Status status = base::check_can_write(*path); !status) return status;
    for (auto other = paths.begin(); other != path; ++other)
      if (!other->empty() && base::is_same_output(*other, *path))
        return Error{fmt::format("{} and {} are the same file", *other, *path),
                     "give each output a name of its own"};
  }
  return Done{};
}

Result<std::string> take_standard_input(std::uint64_t most_bytes) {
  static bool taken = false;
  if (taken) return Error{"standard input is asked for twice", "one input alone can be -"};
  taken = true;
  return base::read_standard_input(most_bytes);
}

Result<Scheme> load_scheme(const std::string& name_or_path) {
  set_step("reading scheme '" + name_or_path + "'");
  if (name_or_path != base::kStandardStream) return find_scheme(name_or_path);
  const Result<std::string> text = take_standard_input(scheme::kMostSchemeBytes);
  if (!text) return text.error();
  return parse_scheme(*text, "standard input");
}

void SchemeOptions::declare_parameters(CLI::App& command) {
  command
      .add_option("-p,--parameter", parameters,
                  "set a parameter to an expression in n and the scheme's names, as a=1/8")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);  // one after each -p, and -p as often as one likes
}

Result<Scheme> SchemeOptions::load() const { return scheme_argument(name, parameters); }

Status check_scheme_path(const std::string& path) {
  if (std::filesystem::path(path).extension() == ".toml") return Done{};
  return Error{fmt::format("'{}' is no scheme file's name", path), "it ends in .toml"};
}

Result<std::string> extends_name(const std::string& scheme, const std::string& path) {
  const std::string name = scheme_name_of(scheme);
  if (name == base::kStandardStream)
    return Error{"a scheme on standard input has no name that a file could extend",
                 "write it to a file first"};
  return scheme::extended_name(name, path);
}

Error unwritten(const Error& fault, const std::string& path) {
  return scheme::not_written(fault, path);
}

}  // namespace limn::app
