#include <memory>
#include <optional>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command.h"
#include "limn/base/printable.h"
#include "limn/base/progress.h"
#include "limn/figure/figure.h"
#include "limn/figure/space/visibility.h"
#include "limn/mesh/mesh_limits.h"
#include "limn/report/limit_report.h"
#include "limn/study/marked_surface.h"
#include "limn/study/surface_scenes.h"
#include "options/attribute_options.h"
#include "options/control_mesh.h"
#include "options/number_option.h"
#include "options/sharpness_options.h"
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
  SharpnessOptions sharpness;
  AttributeOptions attributes;
  bool marks = false;
  bool control = false;
  std::string texture;        // squares along a unit; empty: no squares
  std::string texture_image;  // path; empty: no image
  bool json = false;

  [[nodiscard]] bool is_textured() const { return !texture.empty() || !texture_image.empty(); }
  [[nodiscard]] double squares() const {
    double number = 0;
    return read_number(texture, number) ? number : 0;
  }
};

/// What is drawn, and what there is to say of it.
struct Drawing {
  figure::SurfaceScene scene;
  std::optional<figure::SurfaceScene> control;  ///< what is drawn beside it
  LimitGaps gaps;
  MeshRemarks remarks;
  std::optional<figure::TextureLook> texture = {};
};

/// What the options ask of the surface.
Result<study::MarkedOptions> wanted_of(const DrawOptions& options, Scheme& scheme,
                                       ControlMesh& control) {
  study::MarkedOptions wanted{.steps = options.levels};
  Result<Sharpness> sharpness = options.sharpness.of(control, scheme);
  if (!sharpness) return sharpness.error();
  wanted.sharpness = *std::move(sharpness);
  wanted.marks = options.marks;
  wanted.textured = options.is_textured();
  const TextureCoordinates& texture = control.attributes.texture;
  if (!wanted.marks && !wanted.textured) return wanted;
  if (texture.empty()) {
    if (!wanted.textured) return wanted;
    Error error("the mesh has no texture coordinates to draw",
                "leave out --texture, --texture-image");
    error.file = options.mesh;
    return error;
  }
  wanted.texture = &texture;
  wanted.rule = options.attributes.rules().texture;
  if (wanted.textured)
    if (Status takes = check_takes_texture(scheme, control.mesh, texture, wanted.rule); !takes) {
      takes.error().hint = "leave out --texture, or take a scheme with a dyadic split";
      return takes.error();
    }
  return wanted;
}

/// The edges of a mesh.
figure::SceneMarks edge_marks(const figure::ControlNet& net) {
  figure::SceneMarks marks{.colour = {0.10, 0.12, 0.16}, .stroke = {0.5, {}}};
  for (const auto& [from, to] : net.edges)
    marks.curves.push_back(
        {net.vertices[static_cast<std::size_t>(from)], net.vertices[static_cast<std::size_t>(to)]});
  return marks;
}

/// A scene of the control mesh, at the scale of the surface's.
figure::SurfaceScene control_scene(study::MarkedSurface flat, const figure::ControlNet& net,
                                   figure::SurfaceScene& scene) {
  figure::SurfaceScene both = scene;  // scaled as one, where that is needed
  both.surfaces.push_back(std::move(flat.surface));
  const auto marks = static_cast<std::ptrdiff_t>(both.marks.size());
  both.marks.push_back(edge_marks(net));
  for (figure::SceneMarks& kind : flat.marks) both.marks.push_back(std::move(kind));
  figure::scale_to_draw(both);
  figure::SurfaceScene control = both;
  control.surfaces.erase(control.surfaces.begin());
  control.marks.erase(control.marks.begin(), control.marks.begin() + marks);
  control.net = {};
  both.surfaces.pop_back();
  both.marks.resize(static_cast<std::size_t>(marks));
  scene = std::move(both);
  scene.seen_frame = control.seen_frame = figure::frame_of(control);
  return control;
}

Result<Drawing> drawing_of(const DrawOptions& options, Scheme& scheme) {
  const bool attributes =
      options.marks || options.is_textured() || options.sharpness.may_name_faces();
  Result<ControlMesh> control =
      load_control_mesh(options.mesh, options.preparation, options.sharpness.use(),
                        attributes ? AttributeUse::keep : AttributeUse::leave_out);
  if (!control) return control.error();
  if (Status status = mesh::check_differences(control->points); !status) {
    status.error().file = options.mesh;
    return status.error();
  }
  if (Status status = study::check_drawable(scheme, control->mesh, options.levels); !status)
    return status.error();
  set_step("finding limit points of " + options.mesh);
  const Result<study::MarkedOptions> wanted = wanted_of(options, scheme, *control);
  if (!wanted) return wanted.error();
  Result<study::MarkedSurface> surface =
      study::marked_surface(scheme, control->mesh, control->points, *wanted);
  if (!surface) {
    if (surface.error().file.empty()) surface.error().file = options.mesh;
    return surface.error();
  }
  figure::SurfaceScene scene;
  scene.surfaces.push_back(std::move(surface->surface));
  scene.marks = std::move(surface->marks);
  scene.azimuth = options.view.azimuth;
  scene.elevation = options.view.elevation;
  if (options.net) scene.net = study::control_net(control->mesh, control->points);
  std::optional<figure::SurfaceScene> before;
  if (options.control)
    before = control_scene(study::marked_control(scheme, control->mesh, control->points, *wanted),
                           study::control_net(control->mesh, control->points), scene);
  else
    figure::scale_to_draw(scene);
  return Drawing{std::move(scene), std::move(before), std::move(surface->gaps),
                 std::move(control->remarks)};
}

/// What the texture shows, if it is drawn.
Result<std::optional<figure::TextureLook>> texture_of(const DrawOptions& options) {
  if (!options.is_textured()) return std::optional<figure::TextureLook>();
  figure::TextureLook look{.squares = options.squares()};
  if (options.texture_image.empty()) return std::optional(std::move(look));
  Result<figure::Image> image = figure::read_png(options.texture_image);
  if (!image) return image.error();
  look.image = *std::move(image);
  return std::optional(std::move(look));
}

void add_panel(const DrawOptions& options, const Drawing& drawing, figure::Figure& figure) {
  const figure::SurfaceScene& scene = drawing.scene;
  const figure::LightLines lights{.count = options.lights};
  if (options.lines) {
    figure.add(figure::ReflectionLinePanel{.scene = scene, .lights = lights});
    return;
  }
  figure::ShadedPanel panel{.scene = scene};
  if (options.stripes) panel.stripes = lights;
  panel.texture = drawing.texture;
  figure.add(std::move(panel));
}

figure::Figure figure_of(const DrawOptions& options, const Drawing& drawing) {
  figure::Figure figure(drawing.control ? 2 : 1, kWidth);
  if (drawing.control) {
    figure::ShadedPanel panel{.scene = *drawing.control};
    panel.texture = drawing.texture;
    figure.add(std::move(panel));
  }
  add_panel(options, drawing, figure);
  return figure;
}

nlohmann::ordered_json marks_json(const std::vector<figure::SceneMarks>& marks) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const figure::SceneMarks& kind : marks)
    json.push_back(
        {{"name", kind.name}, {"curves", kind.curves.size()}, {"points", kind.points.size()}});
  return json;
}

int draw(const DrawOptions& options) {
  const bool curves =
      options.lines || options.stripes || options.net || options.marks || options.control;
  if (!figure::figures_available() || (curves && !figure::rays_available()))
    return report({"this limn draws no surfaces", "build it with cairo and Embree"});
  if (Status status = check_mesh_path(options.mesh); !status) return report(status.error());
  if (Status status = options.output.check(options.json); !status) return report(status.error());
  if (Status status = check_outputs({options.output.path}); !status) return report(status.error());
  Result<Scheme> scheme = options.scheme.load();
  if (!scheme) return report(scheme.error());
  Result<std::optional<figure::TextureLook>> texture = texture_of(options);
  if (!texture) return report(texture.error());
  base::ProgressLine line;
  line.show("finding limit points");
  Result<Drawing> drawing = drawing_of(options, *scheme);
  if (!drawing) return report(drawing.error());
  drawing->texture = *std::move(texture);
  const figure::SurfaceScene* const scene = &drawing->scene;
  add_warnings(drawing->remarks,
               report::gaps_text(drawing->gaps, {.mesh = fmt::format("{}, refined", options.mesh),
                                                 .normal = report::kLeftOutOfPictures,
                                                 .curvatures = ""}));
  line.show("drawing " + options.output.path);
  set_step("drawing " + options.output.path);
  const figure::LightLines lights{.count = options.lights};
  if (options.lines || options.stripes)
    if (Status status = figure::check_lights(*scene, lights, kWidth); !status)
      return report(status.error());
  const figure::Figure figure = figure_of(options, *drawing);
  if (Status status = options.output.write(figure); !status) return report(status.error());
  const std::size_t vertices = scene->surfaces.front().vertices.size();
  if (options.json) {
    nlohmann::ordered_json json{{"output", options.output.path},
                                {"scheme", scheme->name},
                                {"levels", options.levels},
                                {"vertices", vertices}};
    if (!scene->marks.empty()) json["marks"] = marks_json(scene->marks);
    if (drawing->gaps.any()) json["missing"] = report::gaps_json(drawing->gaps);
    add_remarks(json, drawing->remarks);
    print_json(json);
    return kDone;
  }
  options.output.print_report(fmt::format("{}: the limit surface of {} at {} points\n",
                                          base::printable(options.output.path),
                                          base::printable(scheme->name), vertices));
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
  command.add_flag("--control", options.control,
                   "the control mesh beside it, its faces flat, at the same scale");
  command.add_flag("--marks", options.marks,
                   "sharp edges and vertices in lines and dots, the sharper the darker and the "
                   "wider, and the seams of the texture, dashed; with a legend");
  CLI::Option* const squares =
      command
          .add_flag("--texture{8}", options.texture,
                    "the texture as a checker of 8 squares along a unit of its coordinates "
                    "(--texture=N: of N)")
          ->check(number_between(1e-6, 1e6).description(""));
  command
      .add_option(
          "--texture-image", options.texture_image,
          "the texture as this image, a .png, between (0, 0) and (1, 1) and repeated beyond")
      ->type_name("FILE")
      ->excludes(squares);
  options.view.declare(command);
}

}  // namespace

void declare_draw(CLI::App& parser, Action& action) {
  CLI::App* command = add_command(
      parser, "draw",
      "a picture of a mesh's limit surface: shaded, textured, or with reflection lines");
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
  options->sharpness.declare(*command);
  options->attributes.declare_texture(*command);
  command->add_flag("--json", options->json, "print one JSON object");
  command->footer(
      "Example: limn draw mesh.obj -s loop -o surface.png\n"
      "         limn draw mesh.obj -s catmull-clark --reflection-lines --net -o lines.pdf\n"
      "         limn draw part.obj -s catmull-clark --texture --marks -o part.png");
  command->callback([&action, options] { action = [options] { return draw(*options); }; });
}

}  // namespace limn::app
