#include "command.h"

#include <cstdio>

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

}  // namespace limn::app
