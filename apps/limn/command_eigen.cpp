#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/extraordinary/eigencomponents.h"
#include "limn/report/eigen_report.h"
#include "valences.h"

namespace limn::app {
namespace {

constexpr int kMostRings = 6;

struct EigenOptions {
  SchemeOptions scheme;
  std::string valence = "3..12";
  int rings = 0;
  bool json = false;
};

int analyse(const EigenOptions& options) {
  const Result<ValenceSpan> range = read_valences(options.valence);
  if (!range) return report(range.error());
  const Result<Scheme> scheme = options.scheme.load();
  if (!scheme) return report(scheme.error());
  FrequencyAnalysis analysis(*scheme, options.rings);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  std::string text = scheme->name + "\n" + eigen_heading();
  for (int n = range->first; n <= range->last; ++n) {
    const Result<FrequencyBlocks> blocks = analysis.blocks(n);
    if (!blocks) return report(blocks.error());
    const Eigencomponents components = approx_eigencomponents(*blocks);
    if (options.json)
      list.push_back(eigen_json(*blocks, components));
    else
      text += eigen_text(components);
  }
  if (options.json)
    fmt::print("{}\n", nlohmann::ordered_json{{"scheme", scheme->name}, {"valences", list}}.dump());
  else
    fmt::print("{}", text);
  return kDone;
}

}  // namespace

void declare_eigen(CLI::App& parser, Action& action) {
  CLI::App* command = parser.add_subcommand(
      "eigen", "frequency blocks, labelled eigencomponents and verdicts at extraordinary vertices");
  const auto options = std::make_shared<EigenOptions>();
  command->add_option("SCHEME", options->scheme.name, "a shipped scheme, or a scheme file")
      ->required();
  command->add_option("--valence", options->valence, "a valence, or a range of them")
      ->type_name("N or A..B")
      ->capture_default_str();
  command
      ->add_option("--rings", options->rings,
                   "analyse so many rings; 0: as many as control the surface")
      ->check(CLI::Range(0, kMostRings));
  options->scheme.declare_parameters(*command);
  command->add_flag("--json", options->json, "print one JSON object");
  command->footer("Example: limn eigen loop --valence 3..12");
  command->callback([&action, options] { action = [options] { return analyse(*options); }; });
}

}  // namespace limn::app
