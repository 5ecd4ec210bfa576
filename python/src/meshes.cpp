/// Meshes and their files: read, written, checked, repaired.

#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "arrays.h"
#include "call.h"
#include "errors.h"
#include "json_objects.h"
#include "limn/mesh/finite_point.h"
#include "limn/mesh/io/mesh_file.h"
#include "limn/mesh/mesh_limits.h"
#include "limn/mesh/polygon/triangulate.h"
#include "limn/mesh/repair/repair.h"
#include "limn/mesh/sharpness/cuts.h"
#include "limn/report/mesh_check_report.h"
#include "limn/surface/tags_file.h"
#include "module.h"
#include "tags.h"

namespace limn::python {
namespace {

/// What names of faces say, as tags.
SharpnessTags tags_of_labels(const std::string& path, const Mesh& mesh,
                             const surface::LabelTags& labels) {
  if (labels.statements.empty()) return {};
  const MeshFile file = value_of(
      without_gil([&] { return read_mesh_file(path, {.attributes = true}); }), Fault::mesh);
  Sharpness sharpness;
  check(surface::apply_label_tags(mesh, file.attributes, labels, sharpness), Fault::mesh);
  SharpnessTags tags = limn::tags_of(mesh, sharpness);
  // those along the boundary count where that makes holes
  for (Index e = 0; e < static_cast<Index>(sharpness.edges.size()); ++e) {
    const double sharp = sharpness.edges[static_cast<std::size_t>(e)];
    const Index h = mesh.halfedge_of_edge(e);
    if (sharp > 0 && mesh.is_boundary_edge(e))
      tags.creases.push_back({{mesh.origin(h), mesh.target(h)}, {sharp}, 0});
  }
  return tags;
}

/// Those of a mesh file, then those of a file of tags, which count more.
SharpnessTags with_tags_file(const MeshFile& file, const std::string& mesh_path,
                             const std::string& path) {
  surface::LabelTags labels;
  const SharpnessTags stated =
      value_of(surface::read_tags_file(path, file.source.first, &labels), Fault::mesh);
  const Mesh mesh = value_of(without_gil([&] { return Mesh::build(file.polygons); }), Fault::mesh);
  SharpnessTags all = file.tags;
  for (const SharpnessTags& more : {tags_of_labels(mesh_path, mesh, labels), stated}) {
    all.creases.insert(all.creases.end(), more.creases.begin(), more.creases.end());
    all.corners.insert(all.corners.end(), more.corners.begin(), more.corners.end());
    all.holes.insert(all.holes.end(), more.holes.begin(), more.holes.end());
  }
  if (stated.boundary) all.boundary = stated.boundary;
  if (stated.method) all.method = stated.method;
  if (stated.smooth_triangles) all.smooth_triangles = stated.smooth_triangles;
  Sharpness tried;  // so that a fault is told with its line
  check(apply_tags(mesh, file.source, file.tags, tried), Fault::mesh);
  check(apply_tags(mesh, file.source, stated, tried), Fault::mesh);
  return all;
}

/// (V, F, tags). `tags`: the path of a file of them, or empty.
py::tuple read(const std::string& path, const std::string& tags_path) {
  MeshFile file = value_of(without_gil([&] { return read_mesh_file(path); }), Fault::mesh);
  warn(file.warnings);
  warn(file.notes());
  const py::dict tags =
      tags_dict(tags_path.empty() ? file.tags : with_tags_file(file, path, tags_path));
  Polygons& mesh = file.polygons;
  return py::make_tuple(points_array(std::move(mesh.positions)),
                        faces_object(std::move(mesh.face_begin), std::move(mesh.corners)), tags);
}

Polygons polygons_of(const py::object& vertices, const py::object& faces) {
  const Positions positions(vertices);
  Polygons polygons = faces_of(faces);
  polygons.positions = positions.points();
  return polygons;
}

void write(const std::string& path, const py::object& vertices, const py::object& faces,
           const py::object& normals, const py::dict& tags) {
  const Polygons polygons = polygons_of(vertices, faces);
  for (std::size_t i = 0; i < polygons.corners.size(); ++i)
    if (polygons.corners[i] < 0 || polygons.corners[i] >= polygons.vertex_count())
      raise({"corner " + std::to_string(i) + " is vertex " + std::to_string(polygons.corners[i]) +
                 ", which is not there",
             "vertices are counted from 0"},
            Fault::mesh);
  WriteOptions options;
  options.tags = tags_of(tags);
  if (!normals.is_none()) options.normals = Positions(normals).points();
  if (!normals.is_none() && options.normals.size() != polygons.positions.size())
    raise({"there are not as many normals as vertices"}, Fault::mesh);
  const SharpnessTags lost = lost_tags(extension_of(path), options.tags);
  if (!lost.creases.empty() || !lost.corners.empty() || !lost.holes.empty())
    warn({Error{"left out: sharpness that such files cannot hold", "write obj, which can", path}});
  check(without_gil([&] { return write_mesh(path, polygons, options); }), Fault::mesh);
}

py::object check_polygons(report::MeshCheck look) {
  if (const auto fault =
          mesh::too_many(look.polygons.positions.size(), look.polygons.face_begin.size(),
                         look.polygons.corners.size()))
    raise(*fault, Fault::mesh);
  return to_python(without_gil([&] {
    look.survey = mesh::survey_mesh(look.polygons);
    return report::mesh_check_json(look);
  }));
}

py::object check_file(const std::string& path) {
  MeshFile file = value_of(without_gil([&] { return read_mesh_file(path, {.keep_faults = true}); }),
                           Fault::mesh);
  return check_polygons(
      {path, std::move(file.polygons), std::move(file.source), {}, std::move(file.dropped)});
}

/// What holds the copies of cut vertices together; nothing where the mesh has more faults.
SharpnessTags tags_of_cuts(const mesh::Repaired& repaired) {
  const mesh::Cuts cuts = mesh::cuts_of(repaired);
  if (cuts.empty()) return {};
  const Result<Mesh> mesh = Mesh::build(repaired.polygons);
  if (!mesh) return {};
  Sharpness sharpness;
  mesh::hold_cuts(*mesh, cuts, sharpness);
  return limn::tags_of(*mesh, sharpness);
}

/// What no repair mends.
void check_vertices(const Polygons& polygons) {
  mesh::MeshFaults faults = mesh::find_mesh_faults(polygons);
  std::erase_if(faults.list, [](const mesh::MeshFault& fault) {
    return fault.kind != mesh::MeshFault::Kind::out_of_range;
  });
  if (!faults.list.empty()) raise(mesh::error_of(faults, polygons, {}), Fault::mesh);
  for (std::size_t v = 0; v < polygons.positions.size(); ++v)
    if (!mesh::is_finite(polygons.positions[v]))
      raise({"vertex " + std::to_string(v) + " is not finite, which no repair mends"}, Fault::mesh);
}

/// (V, F, tags, [what was done]).
py::tuple mend(const py::object& vertices, const py::object& faces,
               const mesh::RepairOptions& options, bool triangulate) {
  Polygons polygons = polygons_of(vertices, faces);
  SharpnessTags tags;
  py::list done;
  if (options.any()) {
    mesh::Repaired repaired =
        value_of(without_gil([&] { return mesh::repair(polygons, options); }), Fault::mesh);
    for (const mesh::RepairStep& step : repaired.done) {
      py::dict one;
      one["what"] = to_str(step.what);
      one["count"] = step.count;
      one["text"] = to_str(step.text);
      done.append(one);
    }
    tags = without_gil([&] { return tags_of_cuts(repaired); });
    polygons = std::move(repaired.polygons);
    check_vertices(polygons);
  }
  if (triangulate) {
    mesh::Triangulation cut =
        value_of(without_gil([&] { return limn::mesh::triangulate(polygons); }), Fault::mesh);
    polygons = std::move(cut.polygons);
  }
  return py::make_tuple(points_array(std::move(polygons.positions)),
                        faces_object(std::move(polygons.face_begin), std::move(polygons.corners)),
                        tags_dict(tags), done);
}

}  // namespace

void bind_meshes(py::module_& module) {
  module.def("read_mesh", &read, py::arg("path"), py::arg("tags"));
  module.def("write_mesh", &write, py::arg("path"), py::arg("vertices"), py::arg("faces"),
             py::arg("normals"), py::arg("tags"));
  module.def("check_mesh_file", &check_file, py::arg("path"));
  module.def(
      "check_mesh",
      [](const py::object& vertices, const py::object& faces) {
        return check_polygons({"", polygons_of(vertices, faces), {}, {}, {}});
      },
      py::arg("vertices"), py::arg("faces"));
  module.def(
      "repair_mesh",
      [](const py::object& vertices, const py::object& faces, std::optional<double> weld, bool drop,
         bool cut, bool orient, bool triangulate) {
        return mend(vertices, faces, {weld, drop, cut, orient}, triangulate);
      },
      py::arg("vertices"), py::arg("faces"), py::arg("weld"), py::arg("drop"), py::arg("cut"),
      py::arg("orient"), py::arg("triangulate"));
}

}  // namespace limn::python
