#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/base/files/file.h"
#include "limn/base/memory.h"
#include "limn/base/printable.h"
#include "limn/base/progress.h"
#include "limn/report/data_table.h"
#include "limn/report/limit_report.h"
#include "limn/surface/refine_surface.h"
#include "limn/surface/refined_file.h"
#include "limn/surface/surface_estimate.h"
#include "options/attribute_options.h"
#include "options/control_mesh.h"
#include "options/sharpness_options.h"
#include "output/mesh_output.h"

namespace limn::app {
namespace {

constexpr double kMuchMemory = 256e6;  // bytes; worth a word before the work begins

struct RefineOptions {
  std::string mesh;
  SchemeOptions scheme;
  int levels = 3;
  MeshOutput output;
  bool limit = false;
  bool normals = false;
  std::string curvatures;
  bool overwrite = false;
  MeshPreparation preparation;
  bool json = false;
  std::string engine = "quick";
  SharpnessOptions sharpness;
  AttributeOptions attributes;
};

void print_result(const RefineOptions& options, const Scheme& scheme,
                  const surface::RefinedFile& file, const MeshAttributes& attributes,
                  const MeshRemarks& remarks) {
  if (options.json) {
    nlohmann::ordered_json json{{"vertices", file.vertices}, {"faces", file.faces},
                                {"levels", options.levels},  {"seconds", file.refinement_seconds},
                                {"scheme", scheme.name},     {"output", options.output.path}};
    if (!file.sharp.empty())
      json["sharp"] = {{"edges", file.sharp.creases.size()},
                       {"vertices", file.sharp.corners.size()}};
    if (!attributes.empty()) json["attributes"] = attributes_json(attributes);
    if (file.gaps.any()) json["missing"] = report::gaps_json(file.gaps);
    add_remarks(json, remarks);
    print_json(json);
    return;
  }
  const std::string text = fmt::format(
      "{}: {} vertices, {} faces, after {} level{} of {} in {:.3g} s\n",
      base::printable(options.output.path), file.vertices, file.faces, options.levels,
      options.levels == 1 ? "" : "s", base::printable(scheme.name), file.refinement_seconds);
  if (!options.output.is_printed())
    print_text(text);
  else if (!is_quiet())
    fmt::print(stderr, "{}", text);
}

/// A row for each vertex of the refined mesh; empty numbers where there is no curvature.
Status write_curvatures(const std::string& path, const RefinedSurface& surface) {
  report::DataTable table{{"vertex", "x", "y", "z", "largest", "smallest"}, {}};
  for (std::size_t v = 0; v < surface.limit.size(); ++v) {
    const Point3& p = surface.limit[v];
    const LimitPoints::Curvatures& k = surface.curvatures[v];
    table.rows.push_back({static_cast<double>(v), p.x, p.y, p.z, k.largest, k.smallest});
  }
  return report::write_table(path, table);
}

/// What is needed, in a word before the work begins, where it is much; refused, where it is more
/// than there is. `written`: while it is made.
Status announce(const RefineOptions& options, const Scheme& scheme, const Mesh& mesh, bool quick,
                bool written, int columns, base::ProgressLine& line) {
  const surface::LimitWork work{.quick = quick,
                                .limit = options.limit || options.normals,
                                .curvatures = !options.curvatures.empty(),
                                .written = written,
                                .columns = columns};
  const refine::RefineEstimate needed =
      surface::estimate_with_limit(scheme, mesh, options.levels, work);
  if (needed.peak_bytes > kMuchMemory) line.show_now(refine::text_of(needed, options.levels));
  return refine::check_memory(needed, options.levels, base::available_memory());
}

/// Further points for each vertex: numbers by threes, texture points.
int column_count(const MeshAttributes& attributes) {
  return static_cast<int>((attributes.vertices.size() + 2) / 3) +
         (attributes.texture.empty() ? 0 : 2);
}

/// What the options ask of the surface.
SurfaceOptions wanted_of(const RefineOptions& options, base::ProgressLine& line) {
  SurfaceOptions wanted{.levels = options.levels,
                        .limit = options.limit || !options.curvatures.empty(),
                        .normals = options.normals,
                        .curvatures = !options.curvatures.empty(),
                        .partial = true,
                        .progress = [&](const std::string& what) {
                          line.show(what);
                          set_step(options.mesh + ": " + what);
                        }};
  if (options.engine == "plain") wanted.engine = SurfaceOptions::Engine::plain;
  return wanted;
}

/// Warnings of what is missing of the surface.
void warn_of_gaps(const RefineOptions& options, const LimitGaps& gaps, MeshRemarks& remarks) {
  const report::GapPlaces places{
      .mesh = options.output.path,
      .normal = fmt::format("written as {}", options.output.missing_normal()),
      .curvatures = options.curvatures};
  add_warnings(remarks, report::gaps_text(gaps, places));
}

/// A warning of what the format cannot hold.
void warn_of_lost_tags(const RefineOptions& options, const SharpnessTags& tags,
                       ControlMesh& control) {
  const SharpnessTags lost = lost_tags(options.output.extension(), tags);
  const std::size_t edges = lost.creases.size(), vertices = lost.corners.size();
  if (edges == 0 && vertices == 0) return;
  Error warning(fmt::format("left out: what is still sharp, {} edge{} and {} {}, which {} files "
                            "cannot hold",
                            edges, edges == 1 ? "" : "s", vertices,
                            vertices == 1 ? "vertex" : "vertices", options.output.extension()),
                "write obj, which can");
  warning.file = options.output.path;
  add_warnings(control.remarks, {warning});
}

/// Those of the vertices, and of their sides where they have several and the format holds them.
void add_normals(const RefineOptions& options, RefinedSurface& surface, ControlMesh& control,
                 WriteOptions& extras) {
  extras.normals = std::move(surface.normals);
  if (surface.sides.empty()) return;
  const std::vector<Index>& corners = surface.polygons.corners;
  const std::string extension = options.output.extension();
  if (!holds_corner_normals(extension)) {
    std::vector<bool> sided(extras.normals.size(), false);
    for (std::size_t c = 0; c < corners.size(); ++c)
      if (surface.sides.of_corner[c] != kNone) sided[static_cast<std::size_t>(corners[c])] = true;
    Error warning(fmt::format("{} vertices have a normal on each side, for which {} files have no "
                              "place: written as {}",
                              std::count(sided.begin(), sided.end(), true), extension,
                              options.output.missing_normal()),
                  "obj and glb have normals of corners");
    warning.file = options.output.path;
    return add_warnings(control.remarks, {warning});
  }
  const auto vertices = static_cast<Index>(extras.normals.size());
  extras.normals.insert(extras.normals.end(), surface.sides.normals.begin(),
                        surface.sides.normals.end());
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const Index side = surface.sides.of_corner[c];
    extras.normal_of_corner.push_back(side == kNone ? corners[c] : vertices + side);
  }
}

/// The whole mesh in memory first, and then written.
Result<surface::RefinedFile> refine_then_write(const RefineOptions& options, const Scheme& scheme,
                                               ControlMesh& control, const SurfaceOptions& wanted,
                                               base::ProgressLine& line) {
  const bool quick = is_quick(scheme, control.mesh, wanted);
  const int columns = column_count(control.attributes);
  if (Status status = announce(options, scheme, control.mesh, quick, false, columns, line); !status)
    return status.error();
  Result<RefinedSurface> surface =
      refine_surface(scheme, std::move(control.mesh), std::move(control.points), wanted);
  if (!surface) return surface.error();
  line.show("writing " + options.output.path);
  set_step("writing " + options.output.path);
  if (!options.curvatures.empty())
    if (Status status = write_curvatures(options.curvatures, *surface); !status)
      return status.error();
  if (options.limit) surface->polygons.positions = std::move(surface->limit);
  WriteOptions extras;
  add_normals(options, *surface, control, extras);
  extras.tags = surface->sharp;
  extras.attributes = std::move(surface->attributes);
  warn_of_lost_tags(options, extras.tags, control);
  add_warnings(control.remarks, options.output.rounding_warnings(surface->polygons));
  if (Status status = options.output.write(surface->polygons, extras); !status)
    return status.error();
  if (surface->regular_part.bounded == Truth::no)
    add_warnings(control.remarks,
                 {{fmt::format("{} has unbounded curvature wherever the mesh is regular, "
                               "so that none is given: {}",
                               scheme.name, surface->regular_part.reason),
                   {},
                   options.curvatures,
                   0,
                   0}});
  control.attributes = std::move(extras.attributes);
  surface::RefinedFile file;
  file.sharp = std::move(surface->sharp);
  file.vertices = surface->polygons.positions.size();
  file.faces = static_cast<std::size_t>(surface->polygons.face_count());
  file.gaps = std::move(surface->gaps);
  file.refinement_seconds = surface->refinement_seconds;
  return file;
}

/// Refines into the output, while it is written where that can be.
Result<surface::RefinedFile> refine_into_output(const RefineOptions& options, Scheme& scheme,
                                                ControlMesh& control, base::ProgressLine& line) {
  SurfaceOptions wanted = wanted_of(options, line);
  Result<Sharpness> sharpness = options.sharpness.of(control, scheme);
  if (!sharpness) return sharpness.error();
  wanted.sharpness = *std::move(sharpness);
  const std::string extension = options.output.extension();
  if (Status status = options.attributes.fit(control, scheme, extension, options.output.path);
      !status)
    return status.error();
  wanted.attributes = control.attributes.empty() ? nullptr : &control.attributes;
  wanted.attribute_rules = options.attributes.rules();
  const std::string& path = options.output.path;
  if (surface::may_write_refined(scheme, wanted, path, extension)) {
    if (Status status = announce(options, scheme, control.mesh, true, true, 0, line); !status)
      return status.error();
    Result<std::optional<surface::RefinedFile>> file =
        surface::write_refined(scheme, control.mesh, control.points, wanted, path);
    if (!file) return file.error();
    if (*file) return **std::move(file);
  }
  return refine_then_write(options, scheme, control, wanted, line);
}

int refine_mesh(const RefineOptions& options) {
  // what can be refused at once is refused before any work
  if (Status status = check_mesh_path(options.mesh); !status) return report(status.error());
  if (Status status = options.output.check(options.json); !status) return report(status.error());
  if (Status status = options.output.check_keeps(options.mesh, options.overwrite); !status)
    return report(status.error());
  if (!options.curvatures.empty() && !report::is_table_path(options.curvatures))
    return report({fmt::format("--curvatures: '{}' is no table", options.curvatures),
                   "it ends in .csv or .json"});
  if (Status status = check_outputs({options.output.path, options.curvatures}); !status)
    return report(status.error());
  Result<Scheme> scheme = options.scheme.load();
  if (!scheme) return report(scheme.error());
  Result<ControlMesh> control =
      load_control_mesh(options.mesh, options.preparation, options.sharpness.use(),
                        options.attributes.wanted() ? AttributeUse::keep : AttributeUse::leave_out);
  if (!control) return report(control.error());

  base::ProgressLine line;
  set_step(fmt::format("refining {} by {} levels", options.mesh, options.levels));
  const Result<surface::RefinedFile> file = refine_into_output(options, *scheme, *control, line);
  if (!file) {
    Error error = file.error();
    if (error.file.empty()) error.file = options.mesh;
    return report(error);
  }
  warn_of_gaps(options, file->gaps, control->remarks);
  print_result(options, *scheme, *file, control->attributes, control->remarks);
  return kDone;
}

}  // namespace

void declare_refine(CLI::App& parser, Action& action) {
  CLI::App* command = add_command(parser, "refine", "refine a mesh with a scheme");
  const auto options = std::make_shared<RefineOptions>();
  command->add_option("MESH", options->mesh, kMeshArgumentHelp)->required();
  command->add_option("-s,--scheme", options->scheme.name, kSchemeArgumentHelp)->required();
  command->add_option("-n,--levels", options->levels, "refinement steps")
      ->capture_default_str()
      ->check(CLI::Range(0, 64));
  options->output.declare(*command, "write the refined mesh")->required();
  options->scheme.declare_parameters(*command);
  command->add_flag("--limit", options->limit, "move the refined vertices to the limit surface");
  command->add_flag(
      "--normals", options->normals,
      "write the limit surface's normals (.obj, .off, .ply, .glb); 0 0 0 (.glb: 0 0 1) "
      "where there is none, which a warning and --json's \"missing\" tell");
  command
      ->add_option("--curvatures", options->curvatures,
                   fmt::format("also write the limit surface's principal curvatures, where "
                               "they are bounded, to FILE ({}); nothing where there is none",
                               kTableFiles))
      ->type_name("FILE");
  command->add_flag("--overwrite", options->overwrite,
                    "the output may be MESH itself, which is replaced");
  options->preparation.declare(*command);
  command
      ->add_option("--engine", options->engine,
                   "quick: grids on the control faces; plain: step by step. The same surface to "
                   "rounding, its vertices and faces in another order")
      ->capture_default_str()
      ->check(CLI::IsMember({"quick", "plain"}));
  options->sharpness.declare(*command);
  options->attributes.declare(*command);
  command->add_flag("--json", options->json, "print one JSON object");
  command->footer(
      "Example: limn refine mesh.obj -s catmull-clark -n 4 -o fine.ply\n"
      "         limn refine mesh.obj -s butterfly -p w=1/20 -n 5 -o fine.glb\n"
      "         limn refine - -s loop -n 2 -o - --format ply < mesh.obj > fine.ply\n"
      "         limn refine mesh.obj -s loop -n 3 --limit --normals -o surface.ply\n"
      "         limn refine textured.obj -s catmull-clark -n 3 --uv boundaries -o fine.glb");
  command->callback([&action, options] { action = [options] { return refine_mesh(*options); }; });
}

}  // namespace limn::app
