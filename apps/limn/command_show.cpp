#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/base/printable.h"
#include "limn/report/scheme_report.h"
#include "limn/report/stencil_report.h"
#include "output/figure_output.h"

namespace limn::app {
namespace {

struct ShowOptions {
  SchemeOptions scheme;
  bool latex = false;
  bool json = false;
  bool stencils = false;
  FigureOutput figure;
};

/// Draws the stencils into the file that was asked for.
Status draw_stencils(const ShowOptions& options, const Scheme& scheme,
                     const std::vector<study::RulePicture>& pictures) {
  if (pictures.empty())
    return Error{"scheme '" + scheme.name + "' has no rules to draw",
                 scheme.stages ? "its step is a sequence of averagings"
                               : "its mask lacks the lattice's symmetry"};
  const figure::Figure figure = report::stencils_figure(base::printable(scheme.name), pictures);
  if (Status status = figure.check(); !status) return status;
  return options.figure.write(figure);
}

int show(const ShowOptions& options) {
  const bool drawn = !options.figure.path.empty();
  if (drawn) {
    if (!figure::figures_available())
      return report({"this limn draws no figures", "build it with cairo"});
    if (Status status = options.figure.check(options.json); !status) return report(status.error());
    if (Status status = check_outputs({options.figure.path}); !status)
      return report(status.error());
  }
  const Result<Scheme> scheme = options.scheme.load();
  if (!scheme) return report(scheme.error());
  std::vector<study::RulePicture> pictures;
  if (drawn || options.stencils) {
    Result<std::vector<study::RulePicture>> found = study::rule_pictures(*scheme);
    if (!found) return report(found.error());
    pictures = std::move(*found);
  }
  if (drawn)
    if (Status status = draw_stencils(options, *scheme, pictures); !status)
      return report(status.error());
  if (options.latex) {
    const Result<std::string> latex = report::describe_latex(*scheme);
    if (!latex) return report(latex.error());
    options.figure.print_report(*latex);
    return kDone;
  }
  if (options.json) {
    nlohmann::ordered_json json = report::describe_json(*scheme);
    if (options.stencils) json["stencils"] = report::stencils_json(pictures);
    print_json(json);
    return kDone;
  }
  options.figure.print_report(report::describe(*scheme) +
                              (options.stencils ? report::stencils_text(pictures) : std::string()));
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
  command->add_flag("--stencils", options->stencils,
                    "draw each rule's stencil in letters, too; with --json as numbers");
  options->figure.declare(*command, "draw each rule's stencil");
  command->footer("Example: limn show laplacian-butterfly -p b=3/16 --stencils -o stencils.svg");
  command->callback([&action, options] { action = [options] { return show(*options); }; });
}

}  // namespace limn::app
