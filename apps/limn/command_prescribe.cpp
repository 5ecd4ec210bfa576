#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/base/files/file.h"
#include "limn/base/printable.h"
#include "limn/regular/smoothness/regularity.h"
#include "limn/report/eigen/eigen_report.h"
#include "limn/spectrum/eigencomponents.h"
#include "limn/tune/prescribe.h"

namespace limn::app {
namespace {

struct PrescribeOptions {
  SchemeOptions scheme;
  int valence = 0;
  std::vector<std::string> eigenvalues;
  std::string output;
  bool json = false;
};

int prescribe(const PrescribeOptions& options) {
  const Result<Scheme> base = options.scheme.load();
  if (!base) return report(base.error());
  if (Status status = check_scheme_path(options.output); !status) return report(status.error());
  if (Status status = check_outputs({options.output}); !status) return report(status.error());
  const tune::Prescription prescription{
      options.valence,
      options.eigenvalues.front(),
      {options.eigenvalues.begin() + 1, options.eigenvalues.end()}};
  const Result<std::string> extends = extends_name(options.scheme.name, options.output);
  if (!extends) return report(extends.error());
  const Result<tune::Prescribed> text =
      tune::prescribed_scheme(*base, *extends, options.output, prescription);
  if (!text) return report(text.error());
  const Result<Scheme> made = parse_scheme(text->text, options.output);
  if (!made) return report(unwritten(made.error(), options.output));
  const Result<FrequencyBlocks> blocks = FrequencyAnalysis(*made).blocks(options.valence);
  if (!blocks) return report(unwritten(blocks.error(), options.output));
  const RegularPart regular = find_regular_part(*made);
  const Eigencomponents components = approx_eigencomponents(*blocks, regular);
  if (Status status = base::write_file(options.output, text->text); !status)
    return report(status.error());
  report_warnings(text->unmet);
  if (options.json)
    print_json({{"scheme", made->name},
                {"file", options.output},
                {"regular_part", report::regular_part_json(regular)},
                {"valences", {report::eigen_json(*blocks, components)}}});
  else
    print_text(base::printable(options.output) + "\n" + report::regular_part_text(regular) +
               report::eigen_heading() + report::eigen_text(components) + report::eigen_legend());
  return kDone;
}

}  // namespace

void declare_prescribe(CLI::App& parser, Action& action) {
  CLI::App* command =
      add_command(parser, "prescribe",
                  "a scheme file with chosen eigenvalues at one valence, by the inverse DFT");
  const auto options = std::make_shared<PrescribeOptions>();
  command->add_option("SCHEME", options->scheme.name, kSchemeArgumentHelp)->required();
  options->scheme.declare_parameters(*command);
  command->add_option("--valence", options->valence, "where")->required()->type_name("N");
  command
      ->add_option("--eigenvalues", options->eigenvalues,
                   "expressions: the cup's, then those of frequency 1 (tangent), 2 (saddle), …")
      ->required()
      ->delimiter(',');
  command->add_option("-o,--output", options->output, "write the scheme file to FILE (.toml)")
      ->type_name("FILE")
      ->required();
  command->add_flag("--json", options->json, "print one JSON object");
  command->footer(
      "Example: limn prescribe loop --valence 7 --eigenvalues 1/4,1/2,1/4,1/8 -o mine.toml");
  command->callback([&action, options] { action = [options] { return prescribe(*options); }; });
}

}  // namespace limn::app
