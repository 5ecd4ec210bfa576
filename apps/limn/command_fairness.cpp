#include <filesystem>
#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "control_mesh.h"
#include "limn/base/progress.h"
#include "limn/mesh/io/mesh_file.h"
#include "limn/report/fairness_report.h"
#include "scheme_argument.h"

namespace limn::app {
namespace {

struct FairnessCommand {
  std::string mesh;
  std::vector<std::string> schemes;
  SchemeOptions common;
  int levels = 0;
  std::string chart;
  bool triangulate = false;
  bool json = false;
};

Result<std::vector<FairnessRecord>> measure(const FairnessCommand& options,
                                            const std::vector<NamedScheme>& schemes,
                                            const ControlMesh& control) {
  ProgressLine line;
  std::vector<FairnessRecord> records;
  for (const auto& [label, scheme] : schemes) {
    FairnessOptions how;
    how.levels = options.levels;
    how.progress = [&line, &name = label](int level, int levels) {
      line.show(fmt::format("{}: level {} of {}", name, level, levels));
    };
    Result<FairnessRecord> record =
        approx_fairness(label, scheme, control.mesh, control.points, how);
    if (!record) {
      if (record.error().file.empty()) record.error().file = options.mesh;
      return record.error();
    }
    records.push_back(*std::move(record));
  }
  return records;
}

int print_fairness(const FairnessCommand& options) {
  // what can be refused at once is refused before any work
  if (Status status = check_readable(options.mesh); !status) return report(status.error());
  if (!options.chart.empty())
    if (const Result<FigureFormat> format = figure_format(options.chart); !format)
      return report(format.error());
  const Result<std::vector<NamedScheme>> schemes =
      scheme_arguments(options.schemes, options.common.parameters);
  if (!schemes) return report(schemes.error());
  const Result<ControlMesh> control = load_control_mesh(options.mesh, options.triangulate);
  if (!control) return report(control.error());
  const Result<std::vector<FairnessRecord>> records = measure(options, *schemes, *control);
  if (!records) return report(records.error());
  if (!options.chart.empty()) {
    const std::string name = std::filesystem::path(options.mesh).filename().string();
    if (Status status = fairness_figure(name, *records).write(options.chart); !status)
      return report(status.error());
  }
  if (options.json)
    fmt::print("{}\n", fairness_json(options.mesh, *records).dump());
  else
    fmt::print("{}", fairness_text(options.mesh, *records));
  return kDone;
}

}  // namespace

void declare_fairness(CLI::App& parser, Action& action) {
  CLI::App* command = parser.add_subcommand(
      "fairness", "energies of a mesh's limit surfaces under several schemes");
  const auto options = std::make_shared<FairnessCommand>();
  command->add_option("MESH", options->mesh, "control mesh: .obj, .off, .ply or .stl")->required();
  command->add_option("-s,--scheme", options->schemes, kSchemeArgumentHelp)
      ->required()
      ->type_name("SCHEME")
      ->allow_extra_args(false);
  command
      ->add_option("-n,--levels", options->levels,
                   "measure after 1 … so many steps (default: as many as make up to 200000 "
                   "vertices)")
      ->check(CLI::Range(1, 64));
  options->common.declare_parameters(*command);
  command
      ->add_option("--chart", options->chart,
                   "draw the energies against the level (.pdf, .svg, .png)")
      ->type_name("FILE");
  command->add_flag("--triangulate", options->triangulate,
                    "cut polygons into triangles first, each from its first corner");
  command->add_flag("--json", options->json, "print one JSON object");
  command->footer(
      "Example: limn fairness mesh.obj -s loop -s optimal -s laplacian-butterfly:b=1/8\n"
      "         limn fairness mesh.obj -s loop -s butterfly -n 6 --chart fairness.pdf");
  command->callback(
      [&action, options] { action = [options] { return print_fairness(*options); }; });
}

}  // namespace limn::app
