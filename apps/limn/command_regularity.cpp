#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/base/printable.h"
#include "limn/base/progress.h"
#include "limn/regular/regular_mask.h"
#include "limn/report/lattice/regularity_report.h"
#include "options/number_option.h"
#include "options/time_option.h"
#include "output/lattice_objects.h"

namespace limn::app {
namespace {

constexpr int kMostBudget = 1'000'000;

struct RegularityCommand {
  SchemeOptions scheme;
  RegularityOptions options;
  double seconds = kDefaultSeconds;
  bool json = false;
};

int analyse(const RegularityCommand& command) {
  const Result<Scheme> scheme = command.scheme.load();
  if (!scheme) return report(scheme.error());
  base::ProgressLine line;
  RegularityOptions options = command.options;
  options.seconds = time_limit(command.seconds);
  options.progress = [&line](const std::string& what) { line.show(what); };
  const std::vector<Scheme> lattices = scheme::lattice_schemes(*scheme);
  LatticeObjects json(scheme->name, lattices.size() > 1);
  std::string text;
  for (const Scheme& one : lattices) {
    const Result<Mask> mask = regular_mask(one);
    if (!mask) return report(mask.error());
    Result<Regularity> regularity = enclose_regularity(*mask, options);
    if (!regularity) {
      regularity.error().file = scheme->file;
      return report(regularity.error());
    }
    json.add(one, report::regularity_json(scheme->name, *regularity));
    text += (text.empty() ? "" : "\n") +
            report::regularity_text(base::printable(scheme::label_on_lattice(scheme->name, one)),
                                    *regularity);
  }
  if (command.json)
    print_json(json.object());
  else
    print_text(text);
  return kDone;
}

}  // namespace

void declare_regularity(CLI::App& parser, Action& action) {
  CLI::App* command = add_command(parser, "regularity",
                                  "how smooth the surfaces are on the regular lattice, with proof");
  const auto chosen = std::make_shared<RegularityCommand>();
  command->add_option("SCHEME", chosen->scheme.name, kSchemeArgumentHelp)->required();
  chosen->scheme.declare_parameters(*command);
  command
      ->add_option("--budget", chosen->options.budget,
                   "work for the bracket: so many vertices, at most, of a polytope")
      ->check(CLI::Range(1, kMostBudget))
      ->capture_default_str();
  command
      ->add_option("--tolerance", chosen->options.tolerance,
                   "width of the Hölder bracket below which little more is sought")
      ->check(number_between(1e-6, 1))
      ->capture_default_str();
  declare_time(*command, chosen->seconds, "how long to look for more; what was reached is given");
  command->add_flag("--json", chosen->json, "print one JSON object");
  command->footer(
      "Example: limn regularity butterfly\n"
      "         limn regularity laplacian-loop -p a=1/16 --json\n"
      "         limn regularity optimal-low --tolerance 0.002 --budget 30000 --time 60");
  command->callback([&action, chosen] { action = [chosen] { return analyse(*chosen); }; });
}

}  // namespace limn::app
