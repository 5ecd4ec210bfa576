#include <algorithm>
#include <cstdio>
#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/report/scheme_report.h"

namespace limn::app {
namespace {

int list_schemes(bool json) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  std::size_t widest = 0;
  for (const std::string& name : shipped_schemes()) widest = std::max(widest, name.size());
  for (const std::string& name : shipped_schemes()) {
    const Result<Scheme> scheme = find_scheme(name);
    if (!scheme) return report(scheme.error());
    if (json) {
      list.push_back(report::summary_json(*scheme));
      continue;
    }
    std::string parameters;
    for (const Parameter& parameter : scheme->parameters)
      parameters += fmt::format("  {}={}", parameter.name, parameter.value.expression.text());
    fmt::print("{:<{}}  {:<15}  {}{}\n", name, widest, scheme->split->name, scheme->title,
               parameters);
  }
  if (json) print_json({{"schemes", list}});
  return kDone;
}

}  // namespace

void declare_schemes(CLI::App& parser, Action& action) {
  CLI::App* command = add_command(parser, "schemes", "list the shipped schemes, a line each");
  const auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "print one JSON object");
  command->footer("Example: limn schemes");
  command->callback([&action, json] { action = [json] { return list_schemes(*json); }; });
}

}  // namespace limn::app
