#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/base/printable.h"
#include "limn/base/progress.h"
#include "limn/report/fairness_report.h"
#include "limn/report/limit_report.h"
#include "limn/report/spectrum_report.h"
#include "options/control_mesh.h"
#include "options/scheme_argument.h"

namespace limn::app {
namespace {

struct FairnessCommand {
  std::string mesh;
  std::vector<std::string> schemes;
  SchemeOptions common;
  int levels = 0;
  std::string chart;
  std::string spectrum;  // a file, or how many frequencies to print
  MeshPreparation preparation;
  bool json = false;
};

std::string display_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

Result<std::vector<study::FairnessRecord>> measure(const FairnessCommand& options,
                                                   const std::vector<NamedScheme>& schemes,
                                                   const ControlMesh& control) {
  base::ProgressLine line;
  std::vector<study::FairnessRecord> records;
  for (const auto& [label, scheme] : schemes) {
    study::FairnessOptions how;
    how.levels = options.levels;
    how.partial = true;
    how.progress = [&line, &name = label](int level, int levels) {
      line.show(fmt::format("{}: level {} of {}", name, level, levels));
    };
    Result<study::FairnessRecord> record =
        study::approx_fairness(label, scheme, control.mesh, control.points, how);
    if (!record) {
      if (record.error().file.empty()) record.error().file = options.mesh;
      return record.error();
    }
    records.push_back(*std::move(record));
  }
  return records;
}

constexpr int kMostFrequencies = 1000;

/// How many frequencies --spectrum asks for; 0 where it names a file or nothing.
int frequency_count(const std::string& text) {
  const bool digits =
      std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  return digits && !text.empty() && text.size() < 5 ? std::stoi(text) : 0;
}

/// What can be refused before any work.
Status check_figures(const FairnessCommand& options) {
  const bool draws_spectrum = frequency_count(options.spectrum) == 0;

  if (!options.chart.empty())
    if (const Result<figure::FigureFormat> format = figure::figure_format(options.chart); !format)
      return format.error();
  const std::string drawn = draws_spectrum ? options.spectrum : "";
  if (drawn.empty() ? frequency_count(options.spectrum) <= kMostFrequencies
                    : figure::figure_format(drawn).ok())
    return check_outputs({options.chart, drawn});
  return Error{
      fmt::format("--spectrum: '{}' is neither a figure nor a count", options.spectrum),
      fmt::format("it ends in .pdf, .svg or .png, or is a number from 1 to {}", kMostFrequencies)};
}

/// Where there are no limit points, of the mesh at some level of a scheme.
Warnings gap_warnings(const FairnessCommand& options, const std::string& label, int level,
                      const std::vector<LimitPoints::Refused>& refused) {
  Warnings warnings = report::gaps_text({.limits = refused, .normals = {}, .curvatures = {}},
                                        {.mesh = options.mesh, .normal = "", .curvatures = ""});
  for (Error& warning : warnings)
    warning.message = fmt::format("{}, level {}: {}", label, level, warning.message);
  return warnings;
}

Status draw_spectrum(const FairnessCommand& options, const std::vector<NamedScheme>& schemes,
                     ControlMesh& control) {
  std::vector<report::NamedPoints> points{{"control vertices", control.points}};
  for (const auto& [label, scheme] : schemes) {
    std::vector<LimitPoints::Refused> refused;
    Result<report::NamedPoints> limits =
        report::limits_of_vertices(label, scheme, control.mesh, control.points, refused);
    if (!limits) return limits.error();
    add_warnings(control.remarks, gap_warnings(options, label, 0, refused));
    points.push_back(*std::move(limits));
  }
  const Result<figure::Figure> figure =
      report::spectrum_figure(display_name(options.mesh), control.mesh, points);
  if (!figure) return figure.error();
  return figure->write(options.spectrum);
}

/// Draws what is asked for.
Status draw_figures(const FairnessCommand& options, const std::vector<NamedScheme>& schemes,
                    ControlMesh& control, const std::vector<study::FairnessRecord>& records) {
  if (!options.chart.empty())
    if (Status status =
            report::fairness_figure(display_name(options.mesh), records).write(options.chart);
        !status)
      return status;
  if (options.spectrum.empty() || frequency_count(options.spectrum) > 0) return Done{};
  return draw_spectrum(options, schemes, control);
}

int print_fairness(const FairnessCommand& options) {
  // what can be refused at once is refused before any work
  if (Status status = check_mesh_path(options.mesh); !status) return report(status.error());
  if (Status status = check_figures(options); !status) return report(status.error());
  const Result<std::vector<NamedScheme>> schemes =
      scheme_arguments(options.schemes, options.common.parameters);
  if (!schemes) return report(schemes.error());
  Result<ControlMesh> control = load_control_mesh(options.mesh, options.preparation);
  if (!control) return report(control.error());
  const Result<std::vector<study::FairnessRecord>> records = measure(options, *schemes, *control);
  if (!records) return report(records.error());
  for (const study::FairnessRecord& record : *records)
    add_warnings(control->remarks,
                 gap_warnings(options, record.scheme, record.last().level, record.refused));
  if (Status status = draw_figures(options, *schemes, *control, *records); !status)
    return report(status.error());
  const int frequencies = frequency_count(options.spectrum);
  const Result<report::SpectrumEnds> ends =
      frequencies > 0 ? report::approx_spectrum_ends(control->mesh, frequencies)
                      : report::SpectrumEnds{};
  if (!ends) return report(ends.error());
  if (options.json) {
    nlohmann::ordered_json json = report::fairness_json(options.mesh, *records);
    if (frequencies > 0) json["spectrum"] = report::spectrum_json(*ends);
    add_remarks(json, control->remarks);
    print_json(json);
    return kDone;
  }
  print_text(report::fairness_text(base::printable(options.mesh), *records));
  if (frequencies > 0)
    print_text("\n" + report::spectrum_text(base::printable(options.mesh), *ends));
  return kDone;
}

}  // namespace

void declare_fairness(CLI::App& parser, Action& action) {
  CLI::App* command =
      add_command(parser, "fairness", "energies of a mesh's limit surfaces under several schemes");
  const auto options = std::make_shared<FairnessCommand>();
  command->add_option("MESH", options->mesh, kMeshArgumentHelp)->required();
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
      ->add_option(
          "--chart", options->chart,
          fmt::format("also draw the energies over the levels into FILE ({})", kFigureFiles))
      ->type_name("FILE");
  command
      ->add_option(
          "--spectrum", options->spectrum,
          fmt::format("also print so many of the lowest and highest natural frequencies of "
                      "the control mesh, or draw which of them each scheme passes on into "
                      "FILE ({})",
                      kFigureFiles))
      ->type_name("K|FILE");
  options->preparation.declare(*command);
  command->add_flag("--json", options->json, "print one JSON object");
  command->footer(
      "Example: limn fairness mesh.obj -s loop -s optimal -s laplacian-butterfly:b=1/8\n"
      "         limn fairness mesh.obj -s loop -s butterfly -n 6 --chart fairness.pdf");
  command->callback(
      [&action, options] { action = [options] { return print_fairness(*options); }; });
}

}  // namespace limn::app
