#include "limn/report/mesh_check_report.h"

#include <algorithm>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "limn/base/printable.h"
#include "limn/report/mesh_check_faults.h"

namespace limn::report {
namespace {

using Json = nlohmann::ordered_json;
using Kind = mesh::MeshFault::Kind;

constexpr std::size_t kListed = 5;  // faults of a kind, before "and N more"

std::string counted(std::int64_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// "8 of 3, 12 of 4": the first few.
std::string histogram(const std::map<Index, Index>& counts) {
  constexpr int most = 12;
  std::string text;
  int listed = 0;
  for (const auto& [value, count] : counts) {
    if (++listed > most) return text + ", …";
    text += fmt::format("{}{} of {}", text.empty() ? "" : ", ", count, value);
  }
  return text;
}

std::string description(const MeshCheck& check) {
  const mesh::MeshSurvey& survey = check.survey;
  std::string text = fmt::format(
      "{}: {}, {}, {}, in {}\n", base::printable(check.name),
      counted(survey.vertices, "vertex", "vertices"), counted(survey.edges, "edge", "edges"),
      counted(survey.faces, "face", "faces"), counted(survey.components, "part", "parts"));
  text += fmt::format("  corners of faces: {}\n", histogram(survey.degrees));
  text += fmt::format("  edges of vertices: {}\n", histogram(survey.valences));
  text += survey.boundary_edges == 0
              ? std::string("  closed")
              : fmt::format("  open: {} in {}",
                            counted(survey.boundary_edges, "boundary edge", "boundary edges"),
                            counted(survey.boundary_loops, "loop", "loops"));
  text += fmt::format("; Euler characteristic {}", survey.euler);
  if (survey.genus) text += fmt::format(", genus {}", *survey.genus);
  return text + (survey.orientable ? "\n" : ", one-sided\n");
}

void append_kind(std::string& text, const CheckedKind& kind) {
  text += "  " + kind.title;
  if (!kind.remedy.empty()) text += ": " + kind.remedy;
  text += '\n';
  for (std::size_t k = 0; k < std::min(kind.count, kListed); ++k)
    text += "    " + kind.fault(k).message + '\n';
  if (kind.count > kListed) text += fmt::format("    and {} more\n", kind.count - kListed);
}

Json numbers(const std::vector<Index>& list, Index first,
             const std::function<Index(Index)>& number) {
  Json json = Json::array();
  for (const Index i : list) json.push_back(std::int64_t{number(i)} + first);
  return json;
}

Json fault_json(const MeshCheck& check, const CheckedKind& kind, const CheckedFault& fault) {
  const MeshSource& source = check.source;
  Json json{{"kind", kind.kind}, {"blocks", kind.blocks}};
  json["vertices"] =
      numbers(fault.vertices, source.first, [&](Index v) { return source.file_vertex(v); });
  json["faces"] = numbers(fault.faces, source.first, [&](Index f) { return source.file_face(f); });
  Json lines = Json::array();
  const auto add_line = [&lines](int line) {
    if (line > 0) lines.push_back(line);
  };
  for (const Index f : fault.faces) add_line(source.face_line(f));
  for (const Index f : fault.file_faces) {
    json["faces"].push_back(f + source.first);
    if (static_cast<std::size_t>(f) < source.face_lines.size())
      add_line(source.face_lines[static_cast<std::size_t>(f)]);
  }
  if (json["faces"].empty())
    for (const Index v : fault.vertices) add_line(source.vertex_line(v));
  json["lines"] = std::move(lines);
  json["message"] = fault.message;
  return json;
}

Json histogram_json(const std::map<Index, Index>& counts) {
  Json json = Json::object();
  for (const auto& [value, count] : counts) json[std::to_string(value)] = count;
  return json;
}

std::size_t count_of(const mesh::MeshSurvey& survey, Kind kind) {
  return static_cast<std::size_t>(
      std::count_if(survey.faults.list.begin(), survey.faults.list.end(),
                    [kind](const mesh::MeshFault& fault) { return fault.kind == kind; }));
}

Json counts_json(const MeshCheck& check) {
  const mesh::MeshSurvey& survey = check.survey;
  Json json{{"mesh", check.name},
            {"vertices", survey.vertices},
            {"edges", survey.edges},
            {"faces", survey.faces},
            {"components", survey.components},
            {"boundary_edges", survey.boundary_edges},
            {"boundary_loops", survey.boundary_loops},
            {"euler", survey.euler},
            {"genus", survey.genus ? Json(*survey.genus) : Json()},
            {"orientable", survey.orientable}};
  json["isolated_vertices"] = survey.isolated.size();
  json["coincident_vertices"] = survey.coincident.size();
  json["near_vertices"] = survey.near.size();
  json["open_seams"] = survey.seams.edges;
  json["degenerate_faces"] = survey.degenerate.size() + check.dropped.size();
  json["duplicate_faces"] = count_of(survey, Kind::repeated_face);
  json["flipped_edges"] = count_of(survey, Kind::flipped_edge);
  json["non_manifold_edges"] = count_of(survey, Kind::crowded_edge);
  json["non_manifold_vertices"] = count_of(survey, Kind::several_fans);
  json["not_finite"] = survey.not_finite.size();
  json["valences"] = histogram_json(survey.valences);
  json["degrees"] = histogram_json(survey.degrees);
  json["refinable"] = survey.refinable;
  json["counts_from"] = check.source.first;
  return json;
}

}  // namespace

std::string mesh_check_text(const MeshCheck& check) {
  const std::vector<CheckedKind> kinds = kinds_of(check);
  std::string text;
  text += description(check);
  text += check.survey.refinable ? "limn refines it" : "limn does not refine it as it is";
  std::string faults, remarks;
  for (const CheckedKind& kind : kinds) append_kind(kind.is_fault ? faults : remarks, kind);
  text += faults.empty() ? "; no faults\n" : "; faults:\n" + faults;
  if (!remarks.empty()) text += "remarks:\n" + remarks;
  if (!kinds.empty())
    text += fmt::format("vertices and faces count from {}, as in the file\n", check.source.first);
  return text;
}

Json mesh_check_json(const MeshCheck& check) {
  Json json = counts_json(check);
  json["faults"] = Json::array();
  json["remarks"] = Json::array();
  json["remedies"] = Json::object();
  for (const CheckedKind& kind : kinds_of(check)) {
    Json& list = json[kind.is_fault ? "faults" : "remarks"];
    for (std::size_t k = 0; k < kind.count; ++k)
      list.push_back(fault_json(check, kind, kind.fault(k)));
    json["remedies"][kind.kind] = kind.remedy;
  }
  json["to_reverse"] = numbers(check.survey.faults.to_reverse, check.source.first,
                               [&](Index f) { return check.source.file_face(f); });
  return json;
}

}  // namespace limn::report
