#include "control_mesh.h"

#include "command.h"
#include "limn/mesh/io/mesh_file.h"

namespace limn::app {

Result<ControlMesh> load_control_mesh(const std::string& path, bool triangulate) {
  set_step("reading " + path);
  Warnings warnings;
  Result<Polygons> polygons = read_mesh(path, &warnings);
  report_warnings(warnings);
  if (!polygons) return polygons.error();
  if (triangulate) polygons = triangulated(*polygons);
  warnings.clear();
  Result<Mesh> mesh = Mesh::build(*polygons, &warnings);
  for (Error& warning : warnings) warning.file = path;
  report_warnings(warnings);
  if (!mesh) {
    mesh.error().file = path;
    return mesh.error();
  }
  return ControlMesh{std::move(*mesh), std::move(polygons->positions)};
}

}  // namespace limn::app
