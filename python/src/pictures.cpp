/// Figures, as the bytes of SVG, PNG and PDF files.

#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "arrays.h"
#include "call.h"
#include "errors.h"
#include "limn/base/printable.h"
#include "limn/figure/space/shaded_panel.h"
#include "limn/regular/regular_mask.h"
#include "limn/report/eigen/eigen_figures.h"
#include "limn/report/lattice/artifact_figures.h"
#include "limn/report/stencil_report.h"
#include "limn/study/marked_surface.h"
#include "limn/study/surface_scenes.h"
#include "module.h"
#include "tags.h"

namespace limn::python {
namespace {

constexpr double kWidth = 482;  // points, of a page that shows a surface

/// Makes the figure and its file without the interpreter's lock.
template <class Make>
py::bytes drawn(const std::string& format, const std::string& file, Make make) {
  const Result<figure::FigureFormat> kind = figure::figure_format("figure." + format);
  if (!kind) raise(kind.error(), Fault::other);
  const Result<std::string> bytes = without_gil([&]() -> Result<std::string> {
    const Result<figure::Figure> figure = make();
    if (!figure) return figure.error();
    if (Status status = figure->check(); !status) return status.error();
    return figure->canvas(*kind == figure::FigureFormat::png ? figure::kPngDensity : 0)
        .render(*kind);
  });
  if (!bytes) raise(in_file(bytes.error(), file), Fault::other);
  return py::bytes(*bytes);
}

py::bytes draw_stencils(const Scheme& scheme, const std::string& format) {
  return drawn(format, scheme.file, [&]() -> Result<figure::Figure> {
    const auto pictures = study::rule_pictures(scheme);
    if (!pictures) return pictures.error();
    if (pictures->empty()) return Error{"scheme '" + scheme.name + "' has no rules to draw"};
    return report::stencils_figure(base::printable(scheme.name), *pictures);
  });
}

py::bytes draw_artifacts(const Scheme& scheme, const std::string& format) {
  return drawn(format, scheme.file, [&]() -> Result<figure::Figure> {
    const Result<Mask> mask = regular_mask(scheme);
    if (!mask) return mask.error();
    Result<ArtifactAnalysis> analysis = ArtifactAnalysis::of(*mask);
    if (!analysis) return analysis.error();
    return report::artifact_figure({scheme.name, *std::move(analysis)}, {});
  });
}

py::bytes draw_maps(const Scheme& scheme, const std::vector<int>& valences, int steps,
                    const std::string& format) {
  return drawn(format, scheme.file, [&]() -> Result<figure::Figure> {
    std::vector<CharacteristicMap> maps;
    for (const int n : valences) {
      Result<CharacteristicMap> map = approx_characteristic_map(scheme, n, steps);
      if (!map) return map.error();
      maps.push_back(*std::move(map));
    }
    return report::characteristic_maps_figure(scheme.name, maps);
  });
}

struct Look {
  std::string kind;  ///< "shaded", "stripes" or "lines"
  int lights = 32;
  double azimuth = -50, elevation = 30;
  bool net = false, marks = false;
};

Result<figure::Figure> surface_figure(const Scheme& scheme, const Mesh& mesh,
                                      const std::vector<Point3>& points,
                                      const study::MarkedOptions& options, const Look& look) {
  if (Status status = study::check_drawable(scheme, mesh, options.steps); !status)
    return status.error();
  Result<study::MarkedSurface> surface = study::marked_surface(scheme, mesh, points, options);
  if (!surface) return surface.error();
  figure::SurfaceScene scene;
  scene.surfaces.push_back(std::move(surface->surface));
  scene.marks = std::move(surface->marks);
  scene.azimuth = look.azimuth;
  scene.elevation = look.elevation;
  if (look.net) scene.net = study::control_net(mesh, points);
  figure::scale_to_draw(scene);
  const figure::LightLines lights{.count = look.lights};
  if (look.kind != "shaded")
    if (Status status = figure::check_lights(scene, lights, kWidth); !status) return status.error();
  figure::Figure figure(1, kWidth);
  if (look.kind == "lines")
    figure.add(figure::ReflectionLinePanel{.scene = scene, .lights = lights});
  else if (look.kind == "stripes")
    figure.add(figure::ShadedPanel{.scene = scene, .stripes = lights});
  else
    figure.add(figure::ShadedPanel{.scene = scene});
  return figure;
}

/// `crease_angle` in degrees; below 0: none.
py::bytes draw_surface(const Scheme& given, const py::object& vertices, const py::object& faces,
                       int levels, const Look& look, const py::dict& tags_given,
                       double crease_angle, const std::string& format) {
  const Positions positions(vertices);
  positions.check_finite();
  Polygons polygons = faces_of(faces);
  polygons.positions = positions.points();
  const Mesh mesh = value_of(without_gil([&] { return Mesh::build(polygons); }), Fault::mesh);
  const SharpnessTags tags = tags_of(tags_given);
  std::optional<CreaseAngle> angle;
  if (crease_angle >= 0) angle.emplace(CreaseAngle{crease_angle, polygons.positions});
  const study::MarkedOptions options{
      .steps = levels, .sharpness = sharpness_of(mesh, tags, angle), .marks = look.marks};
  const std::optional<Scheme> smooth = smoothed(given, tags);
  return drawn(format, "", [&] {
    return surface_figure(smooth ? *smooth : given, mesh, polygons.positions, options, look);
  });
}

}  // namespace

void bind_pictures(py::module_& module) {
  module.def("figures_available", &figure::figures_available);
  module.def("draw_stencils", &draw_stencils, py::arg("scheme"), py::arg("format"));
  module.def("draw_artifacts", &draw_artifacts, py::arg("scheme"), py::arg("format"));
  module.def("draw_maps", &draw_maps, py::arg("scheme"), py::arg("valences"), py::arg("steps"),
             py::arg("format"));
  module.def(
      "draw_surface",
      [](const Scheme& scheme, const py::object& vertices, const py::object& faces, int levels,
         const std::string& kind, int lights, double azimuth, double elevation, bool net,
         bool marks, const py::dict& tags, double crease_angle, const std::string& format) {
        return draw_surface(scheme, vertices, faces, levels,
                            {kind, lights, azimuth, elevation, net, marks}, tags, crease_angle,
                            format);
      },
      py::arg("scheme"), py::arg("vertices"), py::arg("faces"), py::arg("levels"), py::arg("kind"),
      py::arg("lights"), py::arg("azimuth"), py::arg("elevation"), py::arg("net"), py::arg("marks"),
      py::arg("tags"), py::arg("crease_angle"), py::arg("format"));
}

}  // namespace limn::python
