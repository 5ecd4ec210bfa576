#include <algorithm>
#include <cmath>
#include <span>

#include "example_meshes.h"
#include "limn/base/printable.h"
#include "limn/mesh/attributes/carried.h"
#include "limn/mesh/io/mesh_file.h"
#include "limn/mesh/mesh_faults.h"
#include "limn/mesh/mesh_limits.h"
#include "limn/mesh/polygon/triangulate.h"
#include "limn/mesh/repair/repair.h"
#include "limn/report/mesh_check_report.h"
#include "page_state.h"

namespace limn::page {
namespace {

constexpr std::size_t kMostBytesOfFile = std::size_t{1} << 26;
constexpr double kLargestCoordinate = 1e30;

/// What is asked for in words.
struct Wanted {
  mesh::RepairOptions repair;
  bool triangulate = false;
};

Result<Wanted> wanted_of(const std::string& words) {
  Wanted wanted;
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t end = std::min(words.find(',', begin), words.size());
    const std::string word = words.substr(begin, end - begin);
    begin = end + 1;
    if (word == "weld")
      wanted.repair.weld = 1e-6;
    else if (word == "cut")
      wanted.repair.cut = true;
    else if (word == "orient")
      wanted.repair.orient = true;
    else if (word == "triangulate")
      wanted.triangulate = true;
    else if (word == "repair")
      wanted.repair = mesh::RepairOptions::everything();
    else
      return Error{fmt::format("'{}' is no way to repair a mesh", base::printable(word)),
                   "repair, weld, cut, orient or triangulate"};
  }
  return wanted;
}

/// A mesh file with what was done to it.
struct Prepared {
  MeshFile file;
  std::vector<mesh::RepairStep> done;
  mesh::Cuts cuts;
};

Result<Prepared> prepare(MeshFile file, const Wanted& wanted) {
  Prepared prepared{std::move(file), {}, {}};
  MeshFile& now = prepared.file;
  if (wanted.repair.any()) {
    Result<mesh::Repaired> repaired = mesh::repair(now.polygons, wanted.repair);
    if (!repaired) return repaired.error();
    now.source = mesh::source_of(*repaired, now.source);
    now.attributes = mesh::carried(now.attributes, *repaired);
    prepared.cuts = mesh::cuts_of(*repaired);
    now.polygons = std::move(repaired->polygons);
    prepared.done = std::move(repaired->done);
  }
  if (wanted.triangulate) {
    Result<mesh::Triangulation> cut = limn::mesh::triangulate(now.polygons);
    if (!cut) return cut.error();
    for (Error& warning : mesh::warnings_of(*cut, now.source))
      now.warnings.push_back(std::move(warning));
    now.source = mesh::source_of(*cut, now.source);
    now.attributes = mesh::carried(now.attributes, *cut);
    now.polygons = std::move(cut->polygons);
  }
  return prepared;
}

const char* faces_word(const Polygons& polygons) {
  bool triangles = true, quads = true;
  for (Index f = 0; f < polygons.face_count(); ++f) {
    triangles = triangles && polygons.degree(f) == 3;
    quads = quads && polygons.degree(f) == 4;
  }
  if (triangles) return "triangles";
  return quads ? "quads" : "mixed";
}

/// Of the text of an OBJ file, by the words of its faces' lines: reading them all is slow.
const char* faces_stated(const std::string& text) {
  bool triangles = true, quads = true;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = std::string_view(text).substr(begin, end - begin);
    begin = end + 1;
    if (!line.starts_with("f ")) continue;
    Index corners = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
      corners += line[i - 1] == ' ' && line[i] != ' ' ? 1 : 0;
    triangles = triangles && corners == 3;
    quads = quads && corners == 4;
  }
  return triangles ? "triangles" : quads ? "quads" : "mixed";
}

Json repaired_json(const std::vector<mesh::RepairStep>& done) {
  Json list = Json::array();
  for (const mesh::RepairStep& step : done)
    list.push_back({{"what", step.what}, {"count", step.count}, {"text", step.text}});
  return list;
}

Result<MeshFile> parse(const std::string& name, std::string_view content) {
  if (content.size() > kMostBytesOfFile)
    return Error{fmt::format("the file has more than {} MB", kMostBytesOfFile >> 20),
                 "the command `limn` takes larger ones"};
  Result<MeshFile> file =
      parse_mesh_file(content, extension_of(name), name, {.keep_faults = true, .attributes = true});
  if (!file) return file;
  if (const auto fault =
          mesh::too_many(file->polygons.positions.size(), file->polygons.face_begin.size(),
                         file->polygons.corners.size()))
    return *fault;
  return file;
}

/// The answer, and the mesh where it can be refined.
Result<Json> load_file(const std::string& name, std::string_view content, const std::string& repair,
                       std::shared_ptr<LoadedMesh>& loaded) {
  const Result<Wanted> wanted = wanted_of(repair);
  if (!wanted) return wanted.error();
  Result<MeshFile> file = parse(name, content);
  if (!file) return file.error();
  Result<Prepared> prepared = prepare(std::move(*file), *wanted);
  if (!prepared) return prepared.error();
  MeshFile& now = prepared->file;
  const report::MeshCheck check{name, now.polygons, now.source, mesh::survey_mesh(now.polygons),
                                now.dropped};
  Result<Mesh> mesh = mesh::build_mesh(now.polygons, now.source, &now.warnings);
  if (mesh && !check.survey.not_finite.empty())
    mesh = Error{"a coordinate is not a finite number", "correct the file", name,
                 now.source.vertex_line(check.survey.not_finite.front())};
  Json json = mesh ? Json::object() : refused(mesh.error());
  json["faces"] = faces_word(now.polygons);
  json["closed"] = mesh && !mesh->has_boundary();
  json["check"] = report::mesh_check_json(check);
  json["repaired"] = repaired_json(prepared->done);
  if (mesh) {
    loaded = std::make_shared<LoadedMesh>();
    loaded->cuts = std::move(prepared->cuts);
    if (Status status = apply_tags(*mesh, now.source, now.tags, loaded->sharpness); !status)
      return status.error();
    if (now.tags.boundary)
      mesh::apply_boundary_mode(*mesh, *now.tags.boundary, loaded->cuts, loaded->sharpness);
    loaded->mesh = std::move(*mesh);
    if (attributes_fit(now.attributes, now.polygons))
      loaded->texture = std::move(now.attributes.texture);
    loaded->points = std::move(now.polygons.positions);
  }
  Warnings warnings = now.notes();
  warnings.insert(warnings.begin(), now.warnings.begin(), now.warnings.end());
  json["warnings"] = errors_json(warnings);
  return json;
}

Json sharp_json(const std::vector<double>& sharpness) {
  Json json = Json::object();
  for (std::size_t i = 0; i < sharpness.size(); ++i)
    if (sharpness[i] > 0) json[std::to_string(i)] = sharpness[i];
  return json;
}

Json bounds_json(const std::vector<Point3>& points) {
  Point3 low = points.front(), high = points.front();
  for (const Point3& point : points) {
    low = {std::min(low.x, point.x), std::min(low.y, point.y), std::min(low.z, point.z)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y), std::max(high.z, point.z)};
  }
  return {{low.x, low.y, low.z}, {high.x, high.y, high.z}};
}

}  // namespace

std::vector<float> floats_of(const std::vector<Point3>& points) {
  const std::span<const double> numbers = numbers_of(points);
  std::vector<float> floats(numbers.size());
  std::transform(numbers.begin(), numbers.end(), floats.begin(),
                 [](double number) { return static_cast<float>(number); });
  return floats;
}

std::string PageCore::meshes() const {
  return answer([]() -> Result<Json> {
    Json list = Json::array();
    for (const ExampleMesh& example : example_meshes()) {
      const Result<std::string> text = example_mesh(example.name);
      if (!text) return text.error();
      list.push_back(
          {{"name", example.name}, {"summary", example.summary}, {"faces", faces_stated(*text)}});
    }
    return Json{{"meshes", std::move(list)}};
  });
}

std::string PageCore::mesh(const std::string& name) {
  return answer([&]() -> Result<Json> {
    const Result<std::string> text = example_mesh(name);
    if (!text) return text.error();
    return Json::parse(load_mesh(name + ".obj", *text, ""));
  });
}

std::string PageCore::load_mesh(const std::string& file_name, std::string_view content,
                                const std::string& repair) {
  return answer([&]() -> Result<Json> {
    std::shared_ptr<LoadedMesh> loaded;
    Result<Json> json = load_file(file_name, content, repair, loaded);
    if (json && loaded) json->emplace("id", state_->meshes.add(std::move(loaded)));
    return json;
  });
}

void PageCore::unload_mesh(int mesh) { state_->meshes.remove(mesh); }

ControlAnswer PageCore::control(int mesh) {
  ControlAnswer made;
  made.json = answer([&]() -> Result<Json> {
    const auto found = state_->meshes.find(mesh);
    if (!found) return found.error();
    const LoadedMesh& loaded = **found;
    for (Index e = 0; e < loaded.mesh.edge_count(); ++e) {
      const Index h = loaded.mesh.halfedge_of_edge(e);
      made.edges.push_back(static_cast<std::uint32_t>(loaded.mesh.origin(h)));
      made.edges.push_back(static_cast<std::uint32_t>(loaded.mesh.target(h)));
    }
    made.positions = floats_of(loaded.points);
    return Json{{"vertices", loaded.mesh.vertex_count()},
                {"edges", loaded.mesh.edge_count()},
                {"faces", loaded.mesh.face_count()},
                {"bounds", bounds_json(loaded.points)},
                {"sharp",
                 {{"edges", sharp_json(loaded.sharpness.edges)},
                  {"vertices", sharp_json(loaded.sharpness.vertices)}}}};
  });
  return made;
}

std::string PageCore::move_vertex(int mesh, int vertex, double x, double y, double z) {
  return answer([&]() -> Result<Json> {
    const auto found = state_->meshes.find(mesh);
    if (!found) return found.error();
    LoadedMesh& loaded = **found;
    if (vertex < 0 || vertex >= loaded.mesh.vertex_count())
      return Error{fmt::format("there is no vertex {}", vertex)};
    for (const double number : {x, y, z})
      if (!(std::abs(number) <= kLargestCoordinate))
        return Error{"a coordinate is not a number of a size that can be drawn"};
    loaded.points[static_cast<std::size_t>(vertex)] = {x, y, z};
    ++loaded.moves;
    return Json::object();
  });
}

std::string PageCore::set_sharpness(int mesh, const std::string& kind, int index,
                                    double sharpness) {
  return answer([&]() -> Result<Json> {
    const auto found = state_->meshes.find(mesh);
    if (!found) return found.error();
    LoadedMesh& loaded = **found;
    if (kind != "edge" && kind != "vertex") return Error{"only an edge or a vertex can be sharp"};
    const bool edge = kind == "edge";
    const Index count = edge ? loaded.mesh.edge_count() : loaded.mesh.vertex_count();
    if (index < 0 || index >= count) return Error{fmt::format("there is no {} {}", kind, index)};
    if (!(sharpness >= 0 && sharpness <= kInfinitelySharp))
      return Error{fmt::format("the sharpness is not between 0 and {}", kInfinitelySharp)};
    std::vector<double>& all = edge ? loaded.sharpness.edges : loaded.sharpness.vertices;
    all.resize(static_cast<std::size_t>(count), 0);
    all[static_cast<std::size_t>(index)] = sharpness;
    return Json::object();
  });
}

}  // namespace limn::page
