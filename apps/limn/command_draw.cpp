#include <memory>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/base/printable.h"
#include "limn/base/progress.h"
#include "limn/figure/figure.h"
#include "limn/figure/space/visibility.h"
#include "limn/report/limit_report.h"
#include "limn/study/surface_scenes.h"
#include "options/control_mesh.h"
#include "options/view_options.h"
#include "output/figure_output.h"

namespace limn::app {
namespace {

constexpr double kWidth = 482;  // points, of the page

struct DrawOptions {
  std::string mesh;
  SchemeOptions scheme;
  int levels = 4;
  FigureOutput output;
  bool stripes = false;
  bool lines = false;
  int lights = 32;
  bool net = false;
  ViewOptions view;
  MeshPreparation preparation;
  bool json = false;
};

/// What is drawn, and what there is to say of it.
struct Drawing {
  SurfaceScene scene;
  LimitGaps gaps;
  MeshRemarks remarks;
};

Result<Drawing> drawing_of(const DrawOptions& options, const Scheme& scheme) {
  Result<ControlMesh> control = load_control_mesh(options.mesh, options.preparation);
  if (!control) return control.error();
  LimitGaps gaps;
  if (Status status = check_drawable(scheme, control->mesh, options.levels); !status)
    return status.error();
  set_step("finding limit points of " + options.mesh);
  Result<SmoothSurface> surface =
      limit_surface(scheme, control->mesh, control->points, options.levels, &gaps);
  if (!surface) {
    if (surface.error().file.empty()) surface.error().file = options.mesh;
    return surface.error();
  }
  SurfaceScene scene;
  scene.surfaces.push_back(std::move(*surface));
  scene.azimuth = options.view.azimuth;
  scene.elevation = options.view.elevation;
  if (options.net) scene.net = control_net(control->mesh, control->points);
  scale_to_draw(scene);
  return Drawing{std::move(scene), std::move(gaps), std::move(control->remarks)};
}

int draw(const DrawOptions& options) {
  const bool curves = options.lines || options.stripes || options.net;
  if (!figures_available() || (curves && !rays_available()))
    return report({"this limn draws no surfaces", "build it with cairo and Embree"});
  if (Status status = check_mesh_path(options.mesh); !status) return report(status.error());
  if (Status status = options.output.check(options.json); !status) return report(status.error());
  if (Status status = check_outputs({options.output.path}); !status) return report(status.error());
  const Result<Scheme> scheme = options.scheme.load();
  if (!scheme) return report(scheme.error());
  ProgressLine line;
  line.show("finding limit points");
  Result<Drawing> drawing = drawing_of(options, *scheme);
  if (!drawing) return report(drawing.error());
  const SurfaceScene* const scene = &drawing->scene;
  add_warnings(drawing->remarks,
               gaps_text(drawing->gaps, {.mesh = fmt::format("{}, refined", options.mesh),
                                         .normal = kLeftOutOfPictures,
                                         .curvatures = ""}));
  line.show("drawing " + options.output.path);
  set_step("drawing " + options.output.path);
  const LightLines lights{.count = options.lights};
  if (options.lines || options.stripes)
    if (Status status = check_lights(*scene, lights, kWidth); !status)
      return report(status.error());
  Figure figure(1, kWidth);
  if (options.lines)
    figure.add(ReflectionLinePanel{.scene = *scene, .lights = lights});
  else if (options.stripes)
    figure.add(ShadedPanel{.scene = *scene, .stripes = lights});
  else
    figure.add(ShadedPanel{.scene = *scene});
  if (Status status = options.output.write(figure); !status) return report(status.error());
  const std::size_t vertices = scene->surfaces.front().vertices.size();
  if (options.json) {
    nlohmann::ordered_json json{{"output", options.output.path},
                                {"scheme", scheme->name},
                                {"levels", options.levels},
                                {"vertices", vertices}};
    if (drawing->gaps.any()) json["missing"] = gaps_json(drawing->gaps);
    add_remarks(json, drawing->remarks);
    print_json(json);
    return kDone;
  }
  options.output.print_report(fmt::format("{}: the limit surface of {} at {} points\n",
                                          printable(options.output.path), printable(scheme->name),
                                          vertices));
  return kDone;
}

void declare_look(CLI::App& command, DrawOptions& options) {
  CLI::Option* const stripes =
      command.add_flag("--stripes", options.stripes, "as a mirror of parallel lights, in pixels");
  command.add_flag("--reflection-lines", options.lines, "reflection lines and outlines as curves")
      ->excludes(stripes);
  command
      .add_option("--lights", options.lights,
                  "light lines all round, as many as the picture can show apart")
      ->capture_default_str()
      ->check(CLI::Range(1, 10000));
  command.add_flag("--net", options.net, "the control net too, dashed where hidden");
  options.view.declare(command);
}

}  // namespace

void declare_draw(CLI::App& parser, Action& action) {
  CLI::App* command = add_command(
      parser, "draw", "a picture of a mesh's limit surface: shaded, or with reflection lines");
  const auto options = std::make_shared<DrawOptions>();
  command->add_option("MESH", options->mesh, kMeshArgumentHelp)->required();
  command->add_option("-s,--scheme", options->scheme.name, kSchemeArgumentHelp)->required();
  command->add_option("-n,--levels", options->levels, "refinement steps before the limit is taken")
      ->capture_default_str()
      ->check(CLI::Range(0, 64));
  options->output.declare(*command, "draw")->required();
  options->scheme.declare_parameters(*command);
  declare_look(*command, *options);
  options->preparation.declare(*command);
  command->add_flag("--json", options->json, "print one JSON object");
  command->footer(
      "Example: limn draw mesh.obj -s loop -o surface.png\n"
      "         limn draw mesh.obj -s catmull-clark --reflection-lines --net -o lines.pdf");
  command->callback([&action, options] { action = [options] { return draw(*options); }; });
}

}  // namespace limn::app
