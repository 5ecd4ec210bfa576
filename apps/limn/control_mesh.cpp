#include "control_mesh.h"

#include "command.h"
#include "limn/base/file.h"
#include "limn/mesh/io/mesh_file.h"

namespace limn::app {

namespace {

Result<Polygons> read_named(const std::string& path, Warnings* warnings) {
  set_step("reading " + path);
  if (path != kStandardStream) return read_mesh(path, warnings);
  const Result<std::string> content = take_standard_input();
  if (!content) return content.error();
  const Result<MeshFile> file = parse_mesh_file(*content, "", "standard input");
  if (!file) return file.error();
  *warnings = file->warnings;
  for (const Error& note : file->notes()) warnings->push_back(note);
  return file->polygons;
}

}  // namespace

Status check_mesh_path(const std::string& path) {
  if (path == kStandardStream) return Done{};
  return check_readable(path);
}

Result<ControlMesh> load_control_mesh(const std::string& path, bool triangulate) {
  Warnings warnings;
  Result<Polygons> polygons = read_named(path, &warnings);
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
