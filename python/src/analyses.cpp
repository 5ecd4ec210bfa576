/// Eigencomponents, formulas, characteristic maps and regularity of a scheme.

#include <pybind11/stl.h>

#include <nlohmann/json.hpp>
#include <set>

#include "arrays.h"
#include "call.h"
#include "errors.h"
#include "json_objects.h"
#include "limn/limit/characteristic_map.h"
#include "limn/regular/regular_mask.h"
#include "limn/regular/smoothness/regularity.h"
#include "limn/report/eigen/eigen_formula_report.h"
#include "limn/report/eigen/eigen_report.h"
#include "limn/report/eigen/eigenvector_report.h"
#include "limn/report/lattice/regularity_report.h"
#include "limn/spectrum/eigencomponents.h"
#include "module.h"

namespace limn::python {
namespace {

using Json = nlohmann::ordered_json;

/// As `limn eigen --json`: one object for each valence.
py::object eigen(const Scheme& scheme, const std::vector<int>& valences, int rings, bool vectors) {
  const Result<Json> found = without_gil([&]() -> Result<Json> {
    FrequencyAnalysis analysis(scheme, rings);
    const RegularPart regular = find_regular_part(scheme);
    Json list = Json::array();
    for (const int n : valences) {
      base::check_interrupt();
      const Result<FrequencyBlocks> blocks = analysis.blocks(n);
      if (!blocks) return blocks.error();
      const Eigencomponents components = approx_eigencomponents(*blocks, regular);
      list.push_back(report::eigen_json(*blocks, components));
      if (vectors) report::add_vectors_json(*blocks, components, list.back());
    }
    return list;
  });
  if (!found) raise(in_file(found.error(), scheme.file), Fault::scheme);
  return to_python(*found);
}

py::object formulas(const Scheme& scheme, const std::set<std::string>& evaluated, int rings) {
  const auto found = without_gil([&] { return eigen_formulas(scheme, evaluated, rings); });
  if (!found) raise(in_file(found.error(), scheme.file), Fault::scheme);
  return to_python(report::eigen_formulas_json(scheme.name, *found));
}

py::object regularity(const Scheme& scheme, int budget, double tolerance, double seconds) {
  const Result<Json> found = without_gil([&]() -> Result<Json> {
    const Result<Mask> mask = regular_mask(scheme);
    if (!mask) return mask.error();
    RegularityOptions options;
    options.budget = budget;
    options.tolerance = tolerance;
    options.seconds = seconds;
    options.progress = on_progress;
    const Result<Regularity> regularity = enclose_regularity(*mask, options);
    if (!regularity) return regularity.error();
    return report::regularity_json(scheme.name, *regularity);
  });
  if (!found) raise(in_file(found.error(), scheme.file), Fault::scheme);
  return to_python(*found);
}

/// (V, F).
py::tuple mesh_tuple(const Mesh& mesh, std::vector<Point3> points) {
  Polygons polygons = mesh.polygons(std::move(points));
  return py::make_tuple(points_array(std::move(polygons.positions)),
                        faces_object(std::move(polygons.face_begin), std::move(polygons.corners)));
}

py::dict characteristic_map(const Scheme& scheme, int valence, int steps) {
  auto found = without_gil([&] { return approx_characteristic_map(scheme, valence, steps); });
  if (!found) raise(in_file(found.error(), scheme.file), Fault::scheme);
  CharacteristicMap& map = *found;
  py::dict dict;
  dict["valence"] = map.valence;
  dict["eigenvalue"] = map.eigenvalue;
  dict["regular"] = std::string(to_string(map.regular));
  dict["reason"] = to_str(map.reason);
  dict["turned_over"] = map.turned_over;
  dict["smallest_area"] = map.smallest_area;
  dict["net"] = mesh_tuple(map.net, std::move(map.net_points));
  dict["image"] = mesh_tuple(map.image.mesh, std::move(map.image.positions));
  return dict;
}

}  // namespace

void bind_analyses(py::module_& module) {
  module.def("eigen", &eigen, py::arg("scheme"), py::arg("valences"), py::arg("rings"),
             py::arg("vectors"));
  module.def("eigen_formulas", &formulas, py::arg("scheme"), py::arg("evaluated"),
             py::arg("rings"));
  module.def("regularity", &regularity, py::arg("scheme"), py::arg("budget"), py::arg("tolerance"),
             py::arg("seconds"));
  module.def("regular_part", [](const Scheme& scheme) {
    return to_python(
        report::regular_part_json(without_gil([&] { return find_regular_part(scheme); })));
  });
  module.def("characteristic_map", &characteristic_map, py::arg("scheme"), py::arg("valence"),
             py::arg("steps"));
}

}  // namespace limn::python
