#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/report/scheme_report.h"

namespace limn::app {
namespace {

struct ShowOptions {
  SchemeOptions scheme;
  bool latex = false;
  bool json = false;
};

int show(const ShowOptions& options) {
  const Result<Scheme> scheme = options.scheme.load();
  if (!scheme) return report(scheme.error());
  if (options.latex) {
    const Result<std::string> latex = describe_latex(*scheme);
    if (!latex) return report(latex.error());
    print_text(*latex);
    return kDone;
  }
  if (options.json)
    print_json(describe_json(*scheme));
  else
    print_text(describe(*scheme));
  return kDone;
}

}  // namespace

void declare_show(CLI::App& parser, Action& action) {
  CLI::App* command =
      add_command(parser, "show", "a scheme's rules, mask, factors, closed formulas, source");
  const auto options = std::make_shared<ShowOptions>();
  command->add_option("SCHEME", options->scheme.name, kSchemeArgumentHelp)->required();
  options->scheme.declare_parameters(*command);
  CLI::Option* json = command->add_flag("--json", options->json, "print one JSON object");
  command
      ->add_flag("--latex", options->latex,
                 "print mask, factors, limit stencil and artifact formulas as LaTeX")
      ->excludes(json);
  command->footer("Example: limn show laplacian-butterfly -p b=3/16");
  command->callback([&action, options] { action = [options] { return show(*options); }; });
}

}  // namespace limn::app
