#include <chrono>
#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "control_mesh.h"
#include "limn/base/progress.h"
#include "limn/extraordinary/limit_points.h"
#include "limn/mesh/io/mesh_file.h"
#include "limn/refine/refine.h"
#include "limn/report/data_table.h"

namespace limn::app {
namespace {

struct RefineOptions {
  std::string mesh;
  SchemeOptions scheme;
  int levels = 3;
  std::string output;
  bool limit = false;
  bool normals = false;
  std::string curvatures;
  bool triangulate = false;
  bool json = false;
};

void print_result(const RefineOptions& options, const Scheme& scheme, const Mesh& mesh,
                  double seconds) {
  if (options.json) {
    const nlohmann::ordered_json json{
        {"vertices", mesh.vertex_count()}, {"faces", mesh.face_count()},
        {"levels", options.levels},        {"seconds", seconds},
        {"scheme", scheme.name},           {"output", options.output}};
    fmt::print("{}\n", json.dump());
    return;
  }
  fmt::print("{}: {} vertices, {} faces, after {} level{} of {} in {:.3g} s\n", options.output,
             mesh.vertex_count(), mesh.face_count(), options.levels, options.levels == 1 ? "" : "s",
             scheme.name, seconds);
}

/// A row for each vertex of the refined mesh; empty numbers where there is no curvature.
Status write_curvatures(const std::string& path, const LimitPoints& limit) {
  DataTable table{{"vertex", "x", "y", "z", "largest", "smallest"}, {}};
  for (std::size_t v = 0; v < limit.positions.size(); ++v) {
    const Point3& p = limit.positions[v];
    const LimitPoints::Curvatures& k = limit.curvatures[v];
    table.rows.push_back({static_cast<double>(v), p.x, p.y, p.z, k.largest, k.smallest});
  }
  return write_table(path, table);
}

/// Moves the points to the limit surface and finds normals there, as the options ask.
Status take_to_limit(const RefineOptions& options, const Scheme& scheme, Refined<Point3>& refined,
                     WriteOptions& extras, ProgressLine& line) {
  if (!options.limit && !options.normals && options.curvatures.empty()) return Done{};
  LimitOptions limit_options;
  limit_options.steps_made = options.levels;
  limit_options.curvatures = !options.curvatures.empty();
  limit_options.progress = [&](int left) {
    line.show(fmt::format("limit points: {} vertices left, near irregular ones", left));
  };
  Result<LimitPoints> limit =
      approx_limit_points(scheme, refined.mesh, refined.values, limit_options);
  if (!limit) {
    if (limit.error().file.empty()) limit.error().file = options.mesh;
    return limit.error();
  }
  if (!options.curvatures.empty())
    if (Status status = write_curvatures(options.curvatures, *limit); !status) return status;
  if (options.limit) refined.values = std::move(limit->positions);
  if (options.normals) extras.normals = std::move(limit->normals);
  return Done{};
}

int refine_mesh(const RefineOptions& options) {
  // what can be refused at once is refused before any work
  if (Status status = check_readable(options.mesh); !status) return report(status.error());
  if (Status status = check_writable(options.output); !status) return report(status.error());
  if (!options.curvatures.empty() && !is_table_path(options.curvatures))
    return report({fmt::format("--curvatures: '{}' is no table", options.curvatures),
                   "it ends in .csv or .json",
                   {},
                   0,
                   0});
  const Result<Scheme> scheme = options.scheme.load();
  if (!scheme) return report(scheme.error());
  Result<ControlMesh> control = load_control_mesh(options.mesh, options.triangulate);
  if (!control) return report(control.error());

  ProgressLine line;
  const auto start = std::chrono::steady_clock::now();
  Result<Refined<Point3>> refined =
      refine(*scheme, std::move(control->mesh), std::move(control->points), options.levels,
             [&](int done, int levels, const Mesh& fine) {
               line.show(fmt::format("refining: {} of {} levels, {} vertices", done, levels,
                                     fine.vertex_count()));
             });
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  if (!refined) {
    Error error = refined.error();
    if (error.file.empty()) error.file = options.mesh;
    return report(error);
  }
  WriteOptions extras;
  if (Status status = take_to_limit(options, *scheme, *refined, extras, line); !status)
    return report(status.error());
  line.show("writing " + options.output);
  const Polygons result = refined->mesh.polygons(std::move(refined->values));
  if (Status status = write_mesh(options.output, result, extras); !status)
    return report(status.error());
  print_result(options, *scheme, refined->mesh, time.count());
  return kDone;
}

}  // namespace

void declare_refine(CLI::App& parser, Action& action) {
  CLI::App* command = parser.add_subcommand("refine", "refine a mesh with a scheme");
  const auto options = std::make_shared<RefineOptions>();
  command->add_option("MESH", options->mesh, "control mesh: .obj, .off, .ply or .stl")->required();
  command->add_option("-s,--scheme", options->scheme.name, "a shipped scheme, or a scheme file")
      ->required();
  command->add_option("-n,--levels", options->levels, "refinement steps")
      ->capture_default_str()
      ->check(CLI::Range(0, 64));
  command
      ->add_option("-o,--output", options->output,
                   "where the refined mesh goes: .obj, .off, .ply, .stl or .glb")
      ->required();
  options->scheme.declare_parameters(*command);
  command->add_flag("--limit", options->limit, "move the refined vertices to the limit surface");
  command->add_flag("--normals", options->normals,
                    "write the limit surface's normals (.obj, .off, .ply, .glb)");
  command->add_option("--curvatures", options->curvatures,
                      "write the limit surface's principal curvatures to this .csv or .json, "
                      "where they are bounded");
  command->add_flag("--triangulate", options->triangulate,
                    "cut polygons into triangles first, each from its first corner");
  command->add_flag("--json", options->json, "print one JSON object");
  command->footer(
      "Example: limn refine mesh.obj -s catmull-clark -n 4 -o fine.ply\n"
      "         limn refine mesh.obj -s butterfly -p w=1/20 -n 5 -o fine.glb\n"
      "         limn refine mesh.obj -s loop -n 3 --limit --normals -o surface.ply");
  command->callback([&action, options] { action = [options] { return refine_mesh(*options); }; });
}

}  // namespace limn::app
