#include "options/control_mesh.h"

#include <cstdio>

#include <fmt/core.h>
#include <nlohmann/json.hpp>
#include <utility>

#include "command.h"
#include "limn/base/files/file.h"
#include "limn/mesh/attributes/carried.h"
#include "limn/mesh/io/mesh_file.h"
#include "limn/mesh/mesh_faults.h"
#include "limn/mesh/polygon/triangulate.h"
#include "limn/mesh/repair/survey.h"

namespace limn::app {
namespace {

/// That the mesh looks unwelded.
void warn_of_open_seams(const Mesh& mesh, MeshFile& file) {
  const mesh::OpenSeams seams = mesh::open_seams(mesh, file.polygons.positions);
  if (seams.edges == 0) return;
  file.warnings.push_back(
      {fmt::format("the mesh looks unwelded: {} lie where others do, and joining them would close "
                   "{} of its boundary edges in pairs",
                   seams.vertices == 1 ? "1 vertex of its boundary"
                                       : fmt::format("{} vertices of its boundary", seams.vertices),
                   2 * seams.edges),
       "--weld joins them", file.source.file, 0, 0});
}

void report_notes(const Warnings& notes) {
  if (is_quiet()) return;
  for (const Error& note : notes) std::fprintf(stderr, "limn: note: %s\n", note.text().c_str());
}

}  // namespace

Status check_mesh_path(const std::string& path) {
  if (path == base::kStandardStream) return Done{};
  return check_readable(path);
}

Result<MeshFile> MeshInput::read(const ReadOptions& options) {
  set_step("reading " + path_);
  if (path_ != base::kStandardStream) return read_mesh_file(path_, options);
  if (!content_) {
    Result<std::string> content = take_standard_input();
    if (!content) return content.error();
    content_ = *std::move(content);
  }
  return parse_mesh_file(*content_, "", "standard input", options);
}

Result<Prepared> prepare(MeshFile& file, const MeshPreparation& preparation) {
  Prepared prepared;
  if (const mesh::RepairOptions asked = preparation.repair(); asked.any()) {
    Result<mesh::Repaired> repaired = mesh::repair(file.polygons, asked);
    if (!repaired) {
      repaired.error().file = file.source.file;
      return repaired.error();
    }
    file.source = mesh::source_of(*repaired, file.source);
    file.attributes = mesh::carried(file.attributes, *repaired);
    prepared.cuts = mesh::cuts_of(*repaired);
    file.polygons = std::move(repaired->polygons);
    prepared.done = std::move(repaired->done);
  }
  if (preparation.triangulate) {
    Result<mesh::Triangulation> cut = limn::mesh::triangulate(file.polygons);
    if (!cut) {
      cut.error().file = file.source.file;
      return cut.error();
    }
    for (Error& warning : mesh::warnings_of(*cut, file.source))
      file.warnings.push_back(std::move(warning));
    file.source = mesh::source_of(*cut, file.source);
    file.attributes = mesh::carried(file.attributes, *cut);
    file.polygons = std::move(cut->polygons);
  }
  Warnings notes;
  for (const mesh::RepairStep& step : prepared.done)
    notes.push_back({"repaired: " + step.text, "", file.source.file, 0, 0});
  report_notes(notes);
  return prepared;
}

void report_remarks(const MeshFile& file) {
  report_warnings(file.warnings);
  report_notes(file.notes());
}

Result<ControlMesh> load_control_mesh(const std::string& path, const MeshPreparation& preparation,
                                      TagUse use, AttributeUse attributes) {
  Result<MeshFile> file = MeshInput(path).read({.keep_small_faces = preparation.repair().drop,
                                                .attributes = attributes == AttributeUse::keep});
  if (!file) return file.error();
  if (use == TagUse::leave_out) file->leave_out_tags();
  MeshFile uncut;
  if (preparation.triangulate) uncut = *file;
  Result<Prepared> prepared = prepare(*file, preparation);
  if (!prepared) return prepared.error();
  Result<Mesh> mesh = mesh::build_mesh(file->polygons, file->source, &file->warnings);
  // A fault of the polygons is named once, not for each triangle of them.
  if (!mesh && preparation.triangulate && !preparation.repair().any()) {
    if (Result<Mesh> polygons = mesh::build_mesh(uncut.polygons, uncut.source); !polygons)
      mesh = std::move(polygons);
  }
  // a cut makes such seams
  const mesh::RepairOptions asked = preparation.repair();
  if (mesh && !asked.weld && !asked.cut) warn_of_open_seams(*mesh, *file);
  report_remarks(*file);
  if (!mesh) return mesh.error();
  return ControlMesh{
      std::move(*mesh),
      std::move(file->polygons.positions),
      {std::move(file->warnings), std::move(file->left_out), std::move(prepared->done)},
      std::move(file->source),
      std::move(file->tags),
      std::move(prepared->cuts),
      std::move(file->attributes)};
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
  json["repaired"] = nlohmann::ordered_json::array();
  for (const mesh::RepairStep& step : remarks.repaired)
    json["repaired"].push_back({{"what", step.what}, {"count", step.count}, {"text", step.text}});
}

}  // namespace limn::app
