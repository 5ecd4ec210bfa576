/// Artifacts and sampling densities on the regular lattice.

#include <pybind11/stl.h>

#include <array>
#include <nlohmann/json.hpp>

#include "arrays.h"
#include "call.h"
#include "errors.h"
#include "json_objects.h"
#include "limn/regular/artifact_map.h"
#include "limn/regular/artifacts.h"
#include "limn/regular/regular_mask.h"
#include "limn/report/lattice/artifact_report.h"
#include "module.h"

namespace limn::python {
namespace {

using Json = nlohmann::ordered_json;

/// "limit", "steps" or "stages", and how many.
study::Stage stage_of(const std::string& kind, int count) {
  if (kind == "steps") return {study::Stage::Kind::steps, count};
  if (kind == "stages") return {study::Stage::Kind::smoothing, count};
  return {};
}

Result<study::NamedAnalysis> analysis_of(const Scheme& scheme) {
  const Result<Mask> mask = regular_mask(scheme);
  if (!mask) return mask.error();
  Result<ArtifactAnalysis> analysis = ArtifactAnalysis::of(*mask);
  if (!analysis) return analysis.error();
  return study::NamedAnalysis{scheme.name, *std::move(analysis)};
}

py::object artifacts(const Scheme& scheme, Frequency f, const std::string& stage, int count) {
  const Result<Json> found = without_gil([&]() -> Result<Json> {
    const Result<study::NamedAnalysis> analysis = analysis_of(scheme);
    if (!analysis) return analysis.error();
    return report::artifacts_json(*analysis, f, stage_of(stage, count));
  });
  if (!found) raise(in_file(found.error(), scheme.file), Fault::scheme);
  return to_python(*found);
}

py::object sampling(const Scheme& scheme, double tolerance) {
  const Result<Json> found = without_gil([&]() -> Result<Json> {
    const Result<study::NamedAnalysis> analysis = analysis_of(scheme);
    if (!analysis) return analysis.error();
    study::SamplingDensities densities;
    return report::sampling_json(*analysis, tolerance, densities);
  });
  if (!found) raise(in_file(found.error(), scheme.file), Fault::scheme);
  return to_python(*found);
}

struct MapArrays {
  regular::FrequencyGrid grid;
  std::vector<std::vector<double>> components;
  std::vector<double> percent;  // of the signal: mean energy
  std::vector<Frequency> region;
};

Result<MapArrays> map_of(const Scheme& scheme, int width, int height) {
  const Result<study::NamedAnalysis> named = analysis_of(scheme);
  if (!named) return named.error();
  const ArtifactAnalysis& analysis = named->analysis;
  if (!analysis.limit_status()) return analysis.limit_status().error();
  MapArrays map;
  const Lattice lattice = analysis.mask().lattice;
  map.grid = regular::nyquist_grid(lattice, width, height);
  map.components = regular::limit_map(analysis, map.grid);
  map.region = nyquist_region(lattice);
  Components at;
  at.artifacts.resize(map.components.size() - 1);
  map.percent.resize(map.components.front().size());
  for (std::size_t i = 0; i < map.percent.size(); ++i) {
    at.signal = map.components[0][i];
    for (std::size_t c = 1; c < map.components.size(); ++c)
      at.artifacts[c - 1] = map.components[c][i];
    map.percent[i] = at.percent_of_signal();
  }
  return map;
}

/// The middles of a row of cells.
py::array_t<double> axis(double first, double step, int count) {
  std::vector<double> values(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) values[static_cast<std::size_t>(i)] = first + i * step;
  return array_of(std::move(values));
}

py::dict artifact_map(const Scheme& scheme, int width, int height) {
  if (width < 1 || height < 1 || width > 32768 || height > 32768)
    raise({"a map has from 1 to 32768 frequencies along each side"}, Fault::other);
  Result<MapArrays> found = without_gil([&] { return map_of(scheme, width, height); });
  if (!found) raise(in_file(found.error(), scheme.file), Fault::scheme);
  py::dict map;
  const regular::FrequencyGrid& grid = found->grid;
  map["fx"] = axis(grid.x0, grid.dx, grid.nx);
  map["fy"] = axis(grid.y0, grid.dy, grid.ny);
  const std::vector<py::ssize_t> shape{grid.ny, grid.nx};
  map["signal"] = array_of(std::move(found->components.front()), shape);
  py::list artifacts;
  for (std::size_t c = 1; c < found->components.size(); ++c)
    artifacts.append(array_of(std::move(found->components[c]), shape));
  map["artifacts"] = artifacts;
  map["percent_of_signal"] = array_of(std::move(found->percent), shape);
  py::list region;
  for (const Frequency& corner : found->region) region.append(py::make_tuple(corner[0], corner[1]));
  map["nyquist_region"] = region;
  return map;
}

}  // namespace

void bind_lattice(py::module_& module) {
  module.def("artifacts", &artifacts, py::arg("scheme"), py::arg("frequency"), py::arg("stage"),
             py::arg("count"));
  module.def("sampling_density", &sampling, py::arg("scheme"), py::arg("tolerance"));
  module.def("artifact_map", &artifact_map, py::arg("scheme"), py::arg("width"), py::arg("height"));
}

}  // namespace limn::python
