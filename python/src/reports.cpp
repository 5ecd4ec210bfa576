/// Schemes side by side: records, fairness, limit surfaces over one mesh.

#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "arrays.h"
#include "call.h"
#include "errors.h"
#include "json_objects.h"
#include "limn/report/compare/compare_report.h"
#include "limn/report/fairness_report.h"
#include "limn/report/spectrum_report.h"
#include "module.h"

namespace limn::python {
namespace {

using Json = nlohmann::ordered_json;
using LabelledSchemes = std::vector<std::pair<std::string, std::shared_ptr<Scheme>>>;

/// A mesh of Python.
struct ControlNet {
  Mesh mesh;
  std::vector<Point3> points;
};
ControlNet net_of(const py::object& vertices, const py::object& faces) {
  const Positions positions(vertices);
  positions.check_finite();
  Polygons polygons = faces_of(faces);
  polygons.positions = positions.points();
  Mesh mesh = value_of(without_gil([&] { return Mesh::build(polygons); }), Fault::mesh);
  return {std::move(mesh), std::move(polygons.positions)};
}

py::object fairness(const LabelledSchemes& schemes, const py::object& vertices,
                    const py::object& faces, int levels) {
  const ControlNet net = net_of(vertices, faces);
  const Result<Json> found = without_gil([&]() -> Result<Json> {
    study::FairnessOptions options;
    options.levels = levels;
    options.partial = true;
    options.progress = [](int, int) { base::check_interrupt(); };
    std::vector<study::FairnessRecord> records;
    for (const auto& [label, scheme] : schemes) {
      Result<study::FairnessRecord> record =
          study::approx_fairness(label, *scheme, net.mesh, net.points, options);
      if (!record) return record.error();
      records.push_back(*std::move(record));
    }
    return report::fairness_json("", records);
  });
  if (!found) raise(found.error(), Fault::other);
  return to_python(*found);
}

struct CompareWanted {
  int first_valence = 3, last_valence = 12;
  double tolerance = 1, seconds = 10;
  int budget = RegularityOptions{}.budget;
  int levels = 4;
};

/// (as JSON, as a table).
py::tuple compare(const LabelledSchemes& schemes, const std::optional<ControlNet>& net,
                  const CompareWanted& wanted) {
  std::vector<report::LabelledScheme> labelled;
  for (const auto& [label, scheme] : schemes) labelled.push_back({label, *scheme});
  report::Comparison comparison{.tolerance = wanted.tolerance};
  const Status done = without_gil([&]() -> Status {
    if (net) {
      report::MeshOptions options;
      options.steps = wanted.levels;
      options.progress = on_progress;
      if (Status status = report::check_steps(labelled, net->mesh, options); !status) return status;
      comparison.on_mesh =
          report::compare_on_mesh(labelled, "mesh", net->mesh, net->points, options);
    }
    study::RecordOptions options{.first_valence = wanted.first_valence,
                                 .last_valence = wanted.last_valence,
                                 .tolerance = wanted.tolerance,
                                 .progress = on_progress};
    options.regularity.budget = wanted.budget;
    options.regularity.seconds = wanted.seconds;
    options.regularity.progress = on_progress;
    for (const auto& [label, scheme] : labelled)
      comparison.schemes.push_back(study::approx_record(label, scheme, options));
    return Done{};
  });
  check(done, Fault::other);
  return py::make_tuple(to_python(report::compare_json(comparison)),
                        to_str(report::compare_text(comparison)));
}

py::object spectrum(const py::object& vertices, const py::object& faces, int count) {
  const ControlNet net = net_of(vertices, faces);
  const report::SpectrumEnds ends = value_of(
      without_gil([&] { return report::approx_spectrum_ends(net.mesh, count); }), Fault::other);
  return to_python(report::spectrum_json(ends));
}

}  // namespace

void bind_reports(py::module_& module) {
  module.def("fairness", &fairness, py::arg("schemes"), py::arg("vertices"), py::arg("faces"),
             py::arg("levels"));
  module.def(
      "compare",
      [](const LabelledSchemes& schemes, const py::object& vertices, const py::object& faces,
         int first, int last, double tolerance, double seconds, int budget, int levels) {
        std::optional<ControlNet> net;
        if (!vertices.is_none()) net = net_of(vertices, faces);
        return compare(schemes, net, {first, last, tolerance, seconds, budget, levels});
      },
      py::arg("schemes"), py::arg("vertices"), py::arg("faces"), py::arg("first_valence"),
      py::arg("last_valence"), py::arg("tolerance"), py::arg("seconds"), py::arg("budget"),
      py::arg("levels"));
  module.def("spectrum", &spectrum, py::arg("vertices"), py::arg("faces"), py::arg("count"));
}

}  // namespace limn::python
