#include "control_mesh.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "command.h"
#include "limn/base/files/file.h"
#include "limn/mesh/io/mesh_file.h"
#include "limn/mesh/mesh_faults.h"
#include "limn/mesh/polygon/triangulate.h"

namespace limn::app {
namespace {

Result<MeshFile> read_named(const std::string& path) {
  set_step("reading " + path);
  if (path != kStandardStream) return read_mesh_file(path);
  const Result<std::string> content = take_standard_input();
  if (!content) return content.error();
  return parse_mesh_file(*content, "", "standard input");
}

void report_notes(const Warnings& notes) {
  if (is_quiet()) return;
  for (const Error& note : notes) std::fprintf(stderr, "limn: note: %s\n", note.text().c_str());
}

}  // namespace

Status check_mesh_path(const std::string& path) {
  if (path == kStandardStream) return Done{};
  return check_readable(path);
}

Result<ControlMesh> load_control_mesh(const std::string& path, bool triangulate, TagUse use) {
  Result<MeshFile> file = read_named(path);
  if (!file) return file.error();
  if (use == TagUse::leave_out) file->leave_out_tags();
  Warnings& warnings = file->warnings;
  const MeshSource source = file->source;
  Polygons uncut;
  if (triangulate) {
    Result<Triangulation> cut = limn::triangulate(file->polygons);
    if (!cut) {
      cut.error().file = path;
      return cut.error();
    }
    for (Error& warning : warnings_of(*cut, source)) warnings.push_back(std::move(warning));
    file->source = source_of(*cut, source);
    uncut = std::exchange(file->polygons, std::move(cut->polygons));
  }
  Result<Mesh> mesh = build_mesh(file->polygons, file->source, &warnings);
  // A fault of the polygons is named once, not for each triangle of them.
  if (!mesh && triangulate) {
    if (Result<Mesh> polygons = build_mesh(uncut, source); !polygons) mesh = std::move(polygons);
  }
  report_warnings(warnings);
  report_notes(file->notes());
  if (!mesh) return mesh.error();
  return ControlMesh{std::move(*mesh),
                     std::move(file->polygons.positions),
                     {std::move(warnings), std::move(file->left_out)},
                     std::move(file->source),
                     std::move(file->tags)};
}

void add_warnings(MeshRemarks& remarks, const Warnings& warnings) {
  report_warnings(warnings);
  remarks.warnings.insert(remarks.warnings.end(), warnings.begin(), warnings.end());
}

void add_remarks(nlohmann::ordered_json& json, const MeshRemarks& remarks) {
  json["warnings"] = nlohmann::ordered_json::array();
  for (const Error& warning : remarks.warnings) {
    nlohmann::ordered_json one{{"message", warning.message}, {"line", warning.line}};
    if (warning.line == 0 && !warning.file.empty()) one["file"] = warning.file;
    json["warnings"].push_back(std::move(one));
  }
  json["left_out"] = nlohmann::ordered_json::array();
  for (const LeftOut& kind : remarks.left_out) {
    json["left_out"].push_back(
        {{"what", kind.what}, {"count", kind.count}, {"unit", kind.unit}, {"line", kind.line}});
  }
}

}  // namespace limn::app
