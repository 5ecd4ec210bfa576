#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "control_mesh.h"
#include "limn/base/printable.h"
#include "limn/base/progress.h"
#include "limn/fast/limit/fast_limit.h"
#include "limn/limit/limit_estimate.h"
#include "limn/limit/limit_points.h"
#include "limn/refine/fast/fast_refiner.h"
#include "limn/refine/refine.h"
#include "limn/regular/smoothness/second_differences.h"
#include "limn/report/data_table.h"
#include "limn/report/limit_report.h"
#include "mesh_output.h"

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
  bool triangulate = false;
  bool json = false;
  std::string engine = "quick";

  [[nodiscard]] bool wants_quick(const Scheme& chosen) const {
    return engine == "quick" && has_fast_layout(*chosen.split);
  }
  /// Whether anything is asked of the limit surface.
  [[nodiscard]] bool wants_limit() const { return limit || normals || !curvatures.empty(); }
};

void print_result(const RefineOptions& options, const Scheme& scheme, const Polygons& result,
                  double seconds, const LimitGaps& gaps, const MeshRemarks& remarks) {
  for (const std::string& sentence : gaps_text(gaps, options.output.missing_normal()))
    report_warnings({{sentence, {}, options.output.path, 0, 0}});
  if (options.json) {
    nlohmann::ordered_json json{{"vertices", result.vertex_count()},
                                {"faces", result.face_count()},
                                {"levels", options.levels},
                                {"seconds", seconds},
                                {"scheme", scheme.name},
                                {"output", options.output.path}};
    if (gaps.any()) json["missing"] = gaps_json(gaps);
    add_remarks(json, remarks);
    print_json(json);
    return;
  }
  const std::string text =
      fmt::format("{}: {} vertices, {} faces, after {} level{} of {} in {:.3g} s\n",
                  printable(options.output.path), result.vertex_count(), result.face_count(),
                  options.levels, options.levels == 1 ? "" : "s", printable(scheme.name), seconds);
  if (!options.output.is_printed())
    print_text(text);
  else if (!is_quiet())
    fmt::print(stderr, "{}", text);
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

/// The quick engine's result as one of the plain engine's kind; nothing where polygons do not tell
/// what the mesh is, two edges of it having the same ends.
std::optional<Refined<Point3>> with_connectivity(Polygons& polygons) {
  Result<Mesh> mesh = Mesh::build(polygons);
  if (!mesh) return std::nullopt;
  return Refined<Point3>{*std::move(mesh), std::move(polygons.positions)};
}

/// Moves the points to the limit surface and finds normals there, as the options ask.
Status take_to_limit(const RefineOptions& options, const Scheme& scheme, Refined<Point3>& refined,
                     WriteOptions& extras, LimitGaps& gaps, ProgressLine& line) {
  set_step("finding limit points of " + options.mesh + ", refined");
  LimitOptions limit_options;
  limit_options.steps_made = options.levels;
  limit_options.partial = true;
  limit_options.curvatures = !options.curvatures.empty();
  if (limit_options.curvatures) {
    limit_options.regular = find_regular_part(scheme);
    if (limit_options.regular.bounded == Truth::no)
      report_warnings(
          {{fmt::format("{} has unbounded curvature wherever the mesh is regular, so "
                        "'{}' holds none: {}",
                        scheme.name, options.curvatures, limit_options.regular.reason)}});
  }
  limit_options.progress = [&](int left) {
    line.show(fmt::format("limit points: {} vertices left, near irregular ones", left));
  };
  Result<LimitPoints> limit =
      approx_limit_points(scheme, refined.mesh, refined.values, limit_options);
  if (!limit) return limit.error();
  if (!options.curvatures.empty()) {
    if (Status status = write_curvatures(options.curvatures, *limit); !status) return status;
    gaps.curvatures = without_curvature(limit->curvatures);
  }
  gaps.limits = std::move(limit->refused);
  if (options.limit) refined.values = std::move(limit->positions);
  if (options.normals) extras.normals = std::move(limit->normals);
  return Done{};
}

/// What is needed, in a word before the work begins, where it is much; refused, where it is more
/// than there is.
Status announce(const RefineOptions& options, const Scheme& scheme, const Mesh& mesh,
                ProgressLine& line) {
  const LimitWork work{.quick = options.wants_quick(scheme),
                       .limit = options.limit || options.normals,
                       .curvatures = !options.curvatures.empty()};
  const RefineEstimate needed = estimate_with_limit(*scheme.split, mesh, options.levels, work);
  if (needed.peak_bytes > kMuchMemory) line.show_now(text_of(needed, options.levels));
  return check_memory(needed, options.levels, available_memory());
}

/// Refinement and limit in one; nothing where the limit has no quick way.
std::optional<Polygons> quick_limit(const RefineOptions& options, const Scheme& scheme,
                                    const ControlMesh& control, WriteOptions& extras) {
  Result<std::optional<FastLimitMesh>> limit =
      approx_fast_limit_mesh(scheme, control.mesh, control.points, options.levels);
  // where there is no limit somewhere, the plain way knows where, and gives the rest
  if (!limit || !*limit) return std::optional<Polygons>();
  if (options.normals) extras.normals = std::move((*limit)->normals);
  if (options.limit) (*limit)->refined.positions = std::move((*limit)->limit);
  return std::optional<Polygons>(std::move((*limit)->refined));
}

/// The refined mesh, by the engine that was asked for where there is a choice, and what the options
/// ask of the limit. `seconds` is the time of refinement, without a limit that is found after it.
Result<Polygons> refined_polygons(const RefineOptions& options, const Scheme& scheme,
                                  ControlMesh& control, WriteOptions& extras, LimitGaps& gaps,
                                  ProgressLine& line, double& seconds) {
  const auto start = std::chrono::steady_clock::now();
  const auto stop = [&] {
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const bool quick = options.wants_quick(scheme);
  if (quick && options.wants_limit() && options.curvatures.empty()) {
    std::optional<Polygons> fine = quick_limit(options, scheme, control, extras);
    stop();
    if (fine) return *std::move(fine);
  }
  std::optional<Refined<Point3>> refined;
  if (quick) {
    Result<Polygons> fine = fast_refine(scheme, control.mesh, control.points, options.levels);
    stop();
    if (!fine || !options.wants_limit()) return fine;
    refined = with_connectivity(*fine);
  }
  if (!refined) {
    Result<Refined<Point3>> plain =
        refine(scheme, std::move(control.mesh), std::move(control.points), options.levels,
               [&](int done, int levels, const Mesh& fine) {
                 line.show(fmt::format("refining: {} of {} levels, {} vertices", done, levels,
                                       fine.vertex_count()));
               });
    stop();
    if (!plain) return plain.error();
    refined = *std::move(plain);
  }
  if (options.wants_limit())
    if (Status status = take_to_limit(options, scheme, *refined, extras, gaps, line); !status)
      return status.error();
  return refined->mesh.polygons(std::move(refined->values));
}

int refine_mesh(const RefineOptions& options) {
  // what can be refused at once is refused before any work
  if (Status status = check_mesh_path(options.mesh); !status) return report(status.error());
  if (Status status = options.output.check(options.json); !status) return report(status.error());
  if (!options.curvatures.empty() && !is_table_path(options.curvatures))
    return report({fmt::format("--curvatures: '{}' is no table", options.curvatures),
                   "it ends in .csv or .json"});
  if (Status status = check_outputs({options.output.path, options.curvatures}); !status)
    return report(status.error());
  const Result<Scheme> scheme = options.scheme.load();
  if (!scheme) return report(scheme.error());
  Result<ControlMesh> control = load_control_mesh(options.mesh, options.triangulate);
  if (!control) return report(control.error());

  ProgressLine line;
  WriteOptions extras;
  LimitGaps gaps;
  double seconds = 0;
  set_step(fmt::format("refining {} by {} levels", options.mesh, options.levels));
  if (Status status = announce(options, *scheme, control->mesh, line); !status) {
    status.error().file = options.mesh;
    return report(status.error());
  }
  const Result<Polygons> result =
      refined_polygons(options, *scheme, *control, extras, gaps, line, seconds);
  if (!result) {
    Error error = result.error();
    if (error.file.empty()) error.file = options.mesh;
    return report(error);
  }
  if (options.normals) gaps.normals = without_normal(extras.normals);
  line.show("writing " + options.output.path);
  set_step("writing " + options.output.path);
  if (Status status = options.output.write(*result, extras); !status) {
    if (status.error().file.empty()) status.error().file = options.mesh;
    return report(status.error());
  }
  print_result(options, *scheme, *result, seconds, gaps, control->remarks);
  return kDone;
}

}  // namespace

void declare_refine(CLI::App& parser, Action& action) {
  CLI::App* command = parser.add_subcommand("refine", "refine a mesh with a scheme");
  const auto options = std::make_shared<RefineOptions>();
  command->add_option("MESH", options->mesh, kMeshArgumentHelp)->required();
  command->add_option("-s,--scheme", options->scheme.name, kSchemeArgumentHelp)->required();
  command->add_option("-n,--levels", options->levels, "refinement steps")
      ->capture_default_str()
      ->check(CLI::Range(0, 64));
  options->output.declare(*command);
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
  command->add_flag("--triangulate", options->triangulate,
                    "cut polygons into triangles first, concave ones too");
  command
      ->add_option("--engine", options->engine,
                   "quick: grids on the control faces; plain: step by step. The same surface to "
                   "rounding, its vertices and faces in another order")
      ->capture_default_str()
      ->check(CLI::IsMember({"quick", "plain"}));
  command->add_flag("--json", options->json, "print one JSON object");
  command->footer(
      "Example: limn refine mesh.obj -s catmull-clark -n 4 -o fine.ply\n"
      "         limn refine mesh.obj -s butterfly -p w=1/20 -n 5 -o fine.glb\n"
      "         limn refine - -s loop -n 2 -o - --format ply < mesh.obj > fine.ply\n"
      "         limn refine mesh.obj -s loop -n 3 --limit --normals -o surface.ply");
  command->callback([&action, options] { action = [options] { return refine_mesh(*options); }; });
}

}  // namespace limn::app
