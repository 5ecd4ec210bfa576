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
      ->expected(1);
}

Result<Scheme> SchemeOptions::load() const {
  Result<Scheme> scheme = find_scheme(name);
  if (!scheme) return scheme;
  for (const std::string& parameter : parameters)
    if (Status status = set_parameter(*scheme, parameter); !status) return status.error();
  return scheme;
}

}  // namespace limn::app
