#include "command.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include <fmt/core.h>

namespace limn::app {

int report(const Error& error) {
  std::fprintf(stderr, "limn: %s\n", error.text().c_str());
  return kBadInput;
}

void report_warnings(const Warnings& warnings) {
  for (const Error& warning : warnings)
    std::fprintf(stderr, "limn: warning: %s\n", warning.text().c_str());
}

void SchemeOptions::declare_parameters(CLI::App& command) {
  command
      .add_option("-p,--parameter", parameters,
                  "set a parameter to an expression in n and the scheme's names, as a=1/8")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);  // one after each -p, and -p as often as one likes
}

Result<Scheme> SchemeOptions::load() const {
  Result<Scheme> scheme = find_scheme(name);
  if (!scheme) return scheme;
  if (Status status = set_parameters(*scheme, parameters); !status) return status.error();
  return scheme;
}

Status check_scheme_path(const std::string& path) {
  if (std::filesystem::path(path).extension() == ".toml") return Done{};
  return Error{fmt::format("'{}' is no scheme file's name", path), "it ends in .toml", {}, 0, 0};
}

std::string extends_name(const std::string& scheme, const std::string& path) {
  namespace fs = std::filesystem;
  const std::vector<std::string> shipped = shipped_schemes();
  if (std::find(shipped.begin(), shipped.end(), scheme) != shipped.end()) return scheme;
  return fs::proximate(scheme, fs::absolute(path).parent_path()).string();
}

}  // namespace limn::app
