#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/base/files/file.h"
#include "limn/base/printable.h"
#include "limn/mesh/mesh_limits.h"
#include "limn/mesh/sharpness/sharpness.h"
#include "limn/report/mesh_check_report.h"
#include "options/attribute_options.h"
#include "options/control_mesh.h"
#include "output/mesh_output.h"

namespace limn::app {
namespace {

struct CheckOptions {
  std::string mesh;
  MeshPreparation preparation;
  MeshOutput output;                // no path: nothing is written
  std::string attributes = "keep";  // none: they are not looked at
  bool overwrite = false;
  bool json = false;
};

/// What can be refused at once.
Status check_arguments(const CheckOptions& options) {
  if (Status status = check_mesh_path(options.mesh); !status) return status;
  if (options.output.path.empty()) return Done{};
  if (Status status = options.output.check(options.json); !status) return status;
  if (Status status = options.output.check_keeps(options.mesh, options.overwrite); !status)
    return status;
  return check_outputs({options.output.path});
}

void print(const CheckOptions& options, const report::MeshCheck& check,
           const MeshAttributes& attributes, const MeshRemarks& remarks) {
  if (options.json) {
    nlohmann::ordered_json json = report::mesh_check_json(check);
    json["attributes"] = attributes_json(attributes);
    if (!options.output.path.empty()) json["output"] = options.output.path;
    add_remarks(json, remarks);
    print_json(json);
    return;
  }
  const std::string text = report::mesh_check_text(check);
  if (options.output.path.empty() || !options.output.is_printed())
    print_text(text);
  else if (!is_quiet())
    fmt::print(stderr, "{}", base::printable_lines(text));
}

/// Copies that a cut has made lie where they must.
void leave_out_copies(const MeshSource& source, mesh::MeshSurvey& survey) {
  std::vector<Index> vertices, first;
  for (std::size_t k = 0; k < survey.coincident.size(); ++k) {
    const Index v = survey.coincident[k], w = survey.coincident_with[k];
    if (source.file_vertex(v) == source.file_vertex(w)) continue;
    vertices.push_back(v);
    first.push_back(w);
  }
  survey.coincident = std::move(vertices);
  survey.coincident_with = std::move(first);
}

/// What keeps a mesh that is a surface from being refined as its file states it: numbers of
/// attributes and tags, and tags of what the mesh does not have.
Status check_rest(MeshInput& input, bool attributes) {
  const Result<MeshFile> file = input.read({.attributes = attributes});
  if (!file) return file.error();
  const Result<Mesh> mesh = mesh::build_mesh(file->polygons, file->source);
  if (!mesh) return mesh.error();
  Sharpness sharpness;
  return apply_tags(*mesh, file->source, file->tags, sharpness);
}

int check_mesh(const CheckOptions& options) {
  if (Status status = check_arguments(options); !status) return report(status.error());
  const bool attributes = options.attributes != "none";
  MeshInput input(options.mesh);
  Result<MeshFile> file = input.read({.keep_faults = true, .attributes = attributes});
  if (!file) return report(file.error());
  const bool carries = !file->attributes.empty() || !file->tags.empty();
  if (auto fault = mesh::too_many(file->polygons.positions.size(), file->polygons.face_begin.size(),
                                  file->polygons.corners.size())) {
    fault->file = options.mesh;
    return report(*fault);
  }
  set_step("checking " + options.mesh);
  if (!options.output.path.empty()) file->leave_out_tags();
  const Result<Prepared> prepared = prepare(*file, options.preparation);
  if (!prepared) return report(prepared.error());
  report_remarks(*file);
  mesh::MeshSurvey survey = mesh::survey_mesh(file->polygons);
  leave_out_copies(file->source, survey);
  if (carries && survey.refinable && !options.preparation.repair().any())
    if (Status status = check_rest(input, attributes); !status) return report(status.error());
  const report::MeshCheck check{options.mesh, std::move(file->polygons), std::move(file->source),
                                std::move(survey), std::move(file->dropped)};
  const bool is_written = !options.output.path.empty() && check.survey.refinable;
  MeshRemarks remarks{std::move(file->warnings), std::move(file->left_out), prepared->done};
  if (is_written) {
    WriteOptions extras;
    extras.attributes = std::move(file->attributes);
    leave_out_lost(extras.attributes, options.output.extension(), options.output.path, remarks);
    add_warnings(remarks, options.output.rounding_warnings(check.polygons));
    if (Status status = options.output.write(check.polygons, extras); !status)
      return report(status.error());
    file->attributes = std::move(extras.attributes);
  }
  print(options, check, file->attributes, remarks);
  if (check.survey.refinable) return kDone;
  if (!options.output.path.empty())
    return report({fmt::format("{} is not written: the mesh has faults that keep it from being "
                               "refined",
                               base::printable(options.output.path)),
                   "--repair mends what can be mended"});
  return kBadInput;
}

}  // namespace

void declare_check(CLI::App& parser, Action& action) {
  CLI::App* command =
      add_command(parser, "check", "what a mesh is, and every fault of it with its lines");
  const auto options = std::make_shared<CheckOptions>();
  command->add_option("MESH", options->mesh, kMeshArgumentHelp)->required();
  options->preparation.declare(*command);
  options->output.declare(*command, "write the mesh, repaired as asked,");
  command->add_flag("--overwrite", options->overwrite,
                    "the output may be MESH itself, which is replaced");
  command
      ->add_option("--attributes", options->attributes,
                   "keep, or none: colours, other numbers of vertices, texture coordinates and "
                   "names of faces are left out, and faults of theirs are no faults")
      ->capture_default_str()
      ->check(CLI::IsMember({"keep", "none"}));
  command->add_flag("--json", options->json, "print one JSON object, with all faults");
  command->footer(
      "Example: limn check mesh.obj\n"
      "         limn check scan.stl --repair -o repaired.ply\n"
      "         limn check mesh.obj --weld=1e-4 --orient --json\n"
      "Exit code 0: limn refines the mesh; 2: it has faults that keep it from that.");
  command->callback([&action, options] { action = [options] { return check_mesh(*options); }; });
}

}  // namespace limn::app
