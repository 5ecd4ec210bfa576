/// Refined meshes and their limit surfaces, by one call.

#include <pybind11/stl.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "arrays.h"
#include "call.h"
#include "errors.h"
#include "json_objects.h"
#include "limn/base/memory.h"
#include "limn/fast/fast_refiner.h"
#include "limn/limit/limit_points.h"
#include "limn/report/limit_report.h"
#include "limn/surface/refine_surface.h"
#include "limn/surface/surface_estimate.h"
#include "module.h"
#include "refined_faces.h"
#include "tags.h"

namespace limn::python {
namespace {

/// What is asked of the surface, as `refine` of Python has it.
struct Wanted {
  int levels = 0;
  bool limit = false, normals = false, curvatures = false;
  bool plain = false;
  py::dict tags;
  double crease_angle = -1;  ///< degrees; below 0: none
};

/// Connectivity of faces and so many vertices.
Mesh mesh_of(Polygons polygons, std::size_t vertices) {
  polygons.positions.resize(vertices);
  Warnings warnings;
  Mesh mesh = value_of(without_gil([&] { return Mesh::build(polygons, &warnings); }), Fault::mesh);
  warn(warnings);
  return mesh;
}

void check_memory_for(const Scheme& scheme, const Mesh& mesh, const Wanted& wanted, bool quick) {
  const surface::LimitWork work{.quick = quick,
                                .limit = wanted.limit || wanted.normals,
                                .curvatures = wanted.curvatures,
                                .written = false};
  const refine::RefineEstimate needed =
      surface::estimate_with_limit(scheme, mesh, wanted.levels, work);
  check(refine::check_memory(needed, wanted.levels, base::available_memory()), Fault::mesh);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Refined points alone, by the fast engine, read and written in the arrays themselves.
template <class Real>
py::dict refine_in_place(const Scheme& scheme, Mesh mesh, const Positions& positions, int levels) {
  const auto start = std::chrono::steady_clock::now();
  const FastRefiner refiner =
      value_of(without_gil([&] { return FastRefiner::make(scheme, std::move(mesh), levels); }),
               Fault::other);
  base::HugeArray<Real> fine(3 * static_cast<std::size_t>(refiner.vertex_count()));
  without_gil([&] { refiner.evaluate<Real>(positions.numbers<Real>(), fine); });
  py::dict result;
  result["faces"] = faces_of_refiner(refiner);
  result["vertices"] = array_of(std::move(fine), {refiner.vertex_count(), 3});
  result["seconds"] = seconds_since(start);
  return result;
}

py::object as_wanted(py::array_t<double> array, bool is_float) {
  return is_float ? array.attr("astype")("float32") : py::object(std::move(array));
}

/// The normal of each corner, where vertices have several.
std::vector<Point3> corner_normals(const RefinedSurface& surface) {
  std::vector<Point3> normals;
  for (std::size_t c = 0; c < surface.sides.of_corner.size(); ++c) {
    const Index side = surface.sides.of_corner[c];
    normals.push_back(side == kNone
                          ? surface.normals[static_cast<std::size_t>(surface.polygons.corners[c])]
                          : surface.sides.normals[static_cast<std::size_t>(side)]);
  }
  return normals;
}

/// What refine_surface has made, as arrays over its memory.
py::dict surface_dict(RefinedSurface surface, const Wanted& wanted, bool is_float) {
  py::dict result;
  Polygons& mesh = surface.polygons;
  if (wanted.normals && !surface.sides.empty())
    result["corner_normals"] = as_wanted(points_array(corner_normals(surface)), is_float);
  result["vertices"] =
      as_wanted(points_array(std::move(wanted.limit ? surface.limit : mesh.positions)), is_float);
  result["faces"] = faces_object(std::move(mesh.face_begin), std::move(mesh.corners));
  if (wanted.normals)
    result["normals"] = as_wanted(points_array(std::move(surface.normals)), is_float);
  if (wanted.curvatures) {
    using Pair = LimitPoints::Curvatures;
    static_assert(sizeof(Pair) == 2 * sizeof(double));
    const auto size = static_cast<py::ssize_t>(surface.curvatures.size());
    auto owner = std::make_unique<std::vector<Pair>>(std::move(surface.curvatures));
    const double* const data = owner->empty() ? nullptr : &owner->front().largest;
    result["curvatures"] = array_over<double>(std::move(owner), data, {size, 2});
    result["regular_part"] = std::string(to_string(surface.regular_part.bounded));
  }
  result["sharp"] = tags_dict(surface.sharp);
  if (surface.gaps.any()) {
    result["missing"] = to_python(report::gaps_json(surface.gaps));
    warn(report::gaps_text(surface.gaps,
                           {.mesh = "", .normal = "given as 0 0 0", .curvatures = ""}));
  }
  result["seconds"] = surface.refinement_seconds;
  return result;
}

/// Those of the limit surface, of sharpness, and points made by the plain engine: all but what
/// refine_in_place makes.
py::dict refine_copy(const Scheme& scheme, Mesh mesh, std::vector<Point3> points, bool is_float,
                     const SurfaceOptions& options, const Wanted& wanted) {
  RefinedSurface surface =
      value_of(without_gil([&] {
                 return refine_surface(scheme, std::move(mesh), std::move(points), options);
               }),
               Fault::other);
  return surface_dict(std::move(surface), wanted, is_float);
}

py::dict refine(const Scheme& given, const py::object& vertices, const py::object& faces,
                const Wanted& wanted) {
  if (wanted.levels < 0 || wanted.levels > 64) raise({"levels is not from 0 to 64"}, Fault::other);
  const Positions positions(vertices);
  positions.check_finite();
  Mesh mesh = mesh_of(faces_of(faces), static_cast<std::size_t>(positions.count()));
  const bool of_limit = wanted.limit || wanted.normals || wanted.curvatures;
  SurfaceOptions options{.levels = wanted.levels,
                         .limit = wanted.limit,
                         .normals = wanted.normals,
                         .curvatures = wanted.curvatures,
                         .partial = true,
                         .progress = on_progress};
  if (wanted.plain) options.engine = SurfaceOptions::Engine::plain;
  std::vector<Point3> points;
  const SharpnessTags tags = tags_of(wanted.tags);
  if (wanted.crease_angle >= 0) {
    points = positions.points();
    options.sharpness = sharpness_of(mesh, tags, CreaseAngle{wanted.crease_angle, points});
  } else if (!tags.empty()) {
    options.sharpness = sharpness_of(mesh, tags);
  }
  const std::optional<Scheme> smooth = smoothed(given, tags);
  const Scheme& scheme = smooth ? *smooth : given;
  const bool quick = is_quick(scheme, mesh, options);
  check_memory_for(scheme, mesh, wanted, quick);
  if (!quick || of_limit || options.has_sharpness()) {
    if (points.empty()) points = positions.points();
    return refine_copy(scheme, std::move(mesh), std::move(points), positions.is_float, options,
                       wanted);
  }
  return positions.is_float
             ? refine_in_place<float>(scheme, std::move(mesh), positions, wanted.levels)
             : refine_in_place<double>(scheme, std::move(mesh), positions, wanted.levels);
}

/// (P, N) at the vertices of the mesh itself.
py::tuple limit_points(const Scheme& scheme, const py::object& vertices, const py::object& faces) {
  const Positions positions(vertices);
  positions.check_finite();
  const Mesh mesh = mesh_of(faces_of(faces), static_cast<std::size_t>(positions.count()));
  const std::vector<Point3> points = positions.points();
  LimitOptions options;
  options.partial = true;
  options.progress = [](int) { base::check_interrupt(); };
  LimitPoints found =
      value_of(without_gil([&] { return approx_limit_points(scheme, mesh, points, options); }),
               Fault::other);
  LimitGaps gaps;
  gaps.limits = std::move(found.refused);
  gaps.normals = without_normal(found.normals);
  if (gaps.any())
    warn(report::gaps_text(gaps, {.mesh = "", .normal = "given as 0 0 0", .curvatures = ""}));
  return py::make_tuple(as_wanted(points_array(std::move(found.positions)), positions.is_float),
                        as_wanted(points_array(std::move(found.normals)), positions.is_float));
}

}  // namespace

void bind_surfaces(py::module_& module) {
  module.def(
      "refine",
      [](const Scheme& scheme, const py::object& vertices, const py::object& faces, int levels,
         bool limit, bool normals, bool curvatures, bool plain, const py::dict& tags,
         double crease_angle) {
        return refine(scheme, vertices, faces,
                      {levels, limit, normals, curvatures, plain, tags, crease_angle});
      },
      py::arg("scheme"), py::arg("vertices"), py::arg("faces"), py::arg("levels"), py::arg("limit"),
      py::arg("normals"), py::arg("curvatures"), py::arg("plain"), py::arg("tags"),
      py::arg("crease_angle"));
  module.def("limit_points", &limit_points, py::arg("scheme"), py::arg("vertices"),
             py::arg("faces"));
}

}  // namespace limn::python
