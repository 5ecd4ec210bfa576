#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/base/progress.h"
#include "limn/figure/space/visibility.h"
#include "limn/report/compare/compare_report.h"
#include "limn/report/compare/field.h"
#include "limn/scheme/lattice_schemes.h"
#include "options/control_mesh.h"
#include "options/number_option.h"
#include "options/scheme_argument.h"
#include "options/time_option.h"
#include "options/valences.h"
#include "options/view_options.h"
#include "output/figure_output.h"

namespace limn::app {
namespace {

struct CompareOptions {
  std::vector<std::string> schemes;
  SchemeOptions common;
  std::string valence = "3..12";
  double tolerance = 1;
  int budget = RegularityOptions{}.budget;
  double seconds = kDefaultSeconds;
  std::string mesh;
  int steps = 4;
  FigureOutput output;
  ViewOptions view;
  MeshPreparation preparation;
  bool differences = false;
  bool all = false;       ///< the shipped schemes, before those that are named
  bool markdown = false;  ///< the table of `all`
  bool json = false;
};

/// What can be refused at once is refused before any work.
Status check(const CompareOptions& options) {
  if (options.schemes.size() < 2)
    return Error{"one scheme alone cannot be compared",
                 "name two or more, or give --all for all shipped ones"};
  if (!options.output.path.empty() && options.mesh.empty() && !options.all)
    return Error{
        "-o: there is nothing to draw",
        "give --mesh MESH for limit surfaces over it, or --all for the chart of all schemes"};
  if (!options.mesh.empty())
    if (Status status = check_mesh_path(options.mesh); !status) return status;
  if (options.output.path.empty()) return Done{};
  if (!figure::figures_available() || !(figure::rays_available() || options.all))
    return Error{options.all ? "this limn draws no figures" : "this limn draws no surfaces",
                 options.all ? "build it with cairo" : "build it with cairo and Embree"};
  if (Status status = options.output.check(options.json); !status) return status;
  if (!options.all && options.schemes.size() - 1 > report::kMostPairs)
    return Error{fmt::format("-o: {} schemes are too many for one picture", options.schemes.size()),
                 fmt::format("it shows the first beside at most {} others", report::kMostPairs)};
  return check_outputs({options.output.path});
}

Result<report::MeshComparison> compare_surfaces(const CompareOptions& options,
                                                const std::vector<report::LabelledScheme>& schemes,
                                                base::ProgressLine& line, MeshRemarks& remarks) {
  Result<ControlMesh> control = load_control_mesh(options.mesh, options.preparation);
  if (!control) return control.error();
  report::MeshOptions mesh_options;
  mesh_options.steps = options.steps;
  mesh_options.progress = [&](const std::string& what) { line.show(what); };
  if (Status status = report::check_steps(schemes, control->mesh, mesh_options); !status) {
    status.error().file = options.mesh;
    return status.error();
  }
  report::MeshComparison found =
      report::compare_on_mesh(schemes, options.mesh, control->mesh, control->points, mesh_options);
  remarks = std::move(control->remarks);
  add_warnings(remarks, report::gap_warnings(found, schemes));
  return found;
}

Status draw(const CompareOptions& options, const report::MeshComparison& on_mesh) {
  if (on_mesh.distances.empty())
    return Error{"there are no two limit surfaces to draw",
                 on_mesh.missing.empty() ? "" : on_mesh.missing.front(), options.mesh, 0, 0};
  const report::CompareView view = {options.view.azimuth, options.view.elevation};
  return options.output.write(report::compare_figure(on_mesh.surfaces, on_mesh.distances, view));
}

/// Of what was found, in the form that the options ask for.
void print(const CompareOptions& options, const report::Comparison& comparison,
           const MeshRemarks& remarks) {
  if (options.json) {
    nlohmann::ordered_json json = report::compare_json(comparison);
    if (comparison.on_mesh) add_remarks(json, remarks);
    return print_json(json);
  }
  options.output.print_report(options.markdown ? report::field_markdown(comparison)
                              : options.all
                                  ? report::field_text(comparison)
                                  : report::compare_text(comparison, options.differences));
}

/// Each lattice beside the others. Surfaces over a mesh are those of the scheme itself.
std::vector<report::LabelledScheme> by_lattices(
    const std::vector<report::LabelledScheme>& schemes) {
  std::vector<report::LabelledScheme> list;
  for (const auto& [label, scheme] : schemes)
    for (Scheme& one : scheme::lattice_schemes(scheme)) {
      std::string name = scheme::label_on_lattice(label, one);
      list.push_back({std::move(name), std::move(one)});
    }
  return list;
}

int compare(const CompareOptions& options) {
  if (Status status = check(options); !status) return report(status.error());
  const Result<Valences> valences = read_valences(options.valence);
  if (!valences) return report(valences.error());
  Result<std::vector<NamedScheme>> named =
      scheme_arguments(options.schemes, options.common.parameters);
  if (!named) return report(named.error());
  std::vector<report::LabelledScheme> schemes;
  for (NamedScheme& one : *named) schemes.push_back({one.label, std::move(one.scheme)});
  if (options.mesh.empty()) schemes = by_lattices(schemes);

  base::ProgressLine line;
  report::Comparison comparison{.tolerance = options.tolerance};
  MeshRemarks remarks;
  if (!options.mesh.empty()) {  // first: a bad mesh is soon found
    Result<report::MeshComparison> on_mesh = compare_surfaces(options, schemes, line, remarks);
    if (!on_mesh) return report(on_mesh.error());
    comparison.on_mesh = std::move(*on_mesh);
  }
  if (comparison.on_mesh && !options.output.path.empty()) {
    line.show("drawing " + options.output.path);
    if (Status status = draw(options, *comparison.on_mesh); !status) return report(status.error());
  }
  study::RecordOptions record{.first_valence = valences->first,
                              .last_valence = valences->last,
                              .tolerance = options.tolerance,
                              .progress = [&](const std::string& what) { line.show(what); }};
  record.regularity.budget = options.budget;
  record.regularity.seconds = time_limit(options.seconds);
  for (const auto& [label, scheme] : schemes)
    comparison.schemes.push_back(study::approx_record(label, scheme, record));
  if (options.all && !options.output.path.empty())
    if (Status status = options.output.write(report::field_figure(comparison)); !status)
      return report(status.error());
  print(options, comparison, remarks);
  return kDone;
}

void declare_mesh(CLI::App& command, CompareOptions& options) {
  CLI::Option* const mesh = command.add_option(
      "--mesh", options.mesh,
      "also fairness and distances of the limit surfaces over this control mesh (.obj, .off, "
      ".ply, .stl, .glb or .gltf)");
  command
      .add_option("-n,--levels", options.steps,
                  "refinement steps before the limit is taken, of splits that make four faces of "
                  "one; others take as many as make about as many faces")
      ->capture_default_str()
      ->check(CLI::Range(0, 64))
      ->needs(mesh);
  options.output.declare(
      command,
      "also draw the surfaces over --mesh, overlaid and coloured by their distance, or with "
      "--all every scheme by smoothness and sampling density,");
  options.view.declare(command);
  for (CLI::Option* const option : options.preparation.declare(command)) option->needs(mesh);
}

}  // namespace

void declare_compare(CLI::App& parser, Action& action) {
  CLI::App* command = add_command(parser, "compare",
                                  "schemes side by side: smoothness, eigencomponents, "
                                  "artifacts, and their limit surfaces");
  const auto options = std::make_shared<CompareOptions>();
  command->add_option("SCHEME", options->schemes, kSchemeArgumentHelp);
  CLI::Option* const all = command->add_flag(
      "--all", options->all, "all shipped schemes, a line each, and those that are named besides");
  command->add_flag("--markdown", options->markdown, "the table of --all in Markdown")->needs(all);
  command
      ->add_option("--valence", options->valence,
                   "valences of the eigencomponents: edges at a vertex, or corners of a dual "
                   "split's face")
      ->type_name("N or A..B")
      ->capture_default_str();
  command
      ->add_option("--tolerance", options->tolerance,
                   "artifacts in percent of the signal, for which sampling densities are given")
      ->type_name("PERCENT")
      ->capture_default_str()
      ->check(number_between(kLeastTolerance, 100));
  declare_time(*command, options->seconds, "how long to look for each scheme's regularity");
  command
      ->add_option("--budget", options->budget,
                   "of the bracket for the Hölder exponent: more is slower and tighter")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000));
  declare_mesh(*command, *options);
  command->get_option("--mesh")->excludes(all);
  options->common.declare_parameters(*command);
  command
      ->add_flag("--differences", options->differences,
                 "only the lines in which the schemes differ")
      ->excludes(all);
  command->add_flag("--json", options->json, "print one JSON object");
  command->footer(
      "Example: limn compare loop butterfly sqrt3\n"
      "         limn compare laplacian-butterfly:b=1/8 laplacian-butterfly:b=3/16 --differences\n"
      "         limn compare loop laplacian-loop-low --mesh mesh.obj -o overlaid.png\n"
      "         limn compare --all -o field.pdf");
  command->callback([&action, options] {
    if (options->all) {
      std::vector<std::string> schemes = shipped_schemes();
      schemes.insert(schemes.end(), options->schemes.begin(), options->schemes.end());
      options->schemes = std::move(schemes);
    }
    action = [options] { return compare(*options); };
  });
}

}  // namespace limn::app
