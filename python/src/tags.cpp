#include "tags.h"

#include <algorithm>

#include "arrays.h"
#include "errors.h"

namespace limn::python {
namespace {

py::object entry(const py::dict& dict, const char* key) {
  return dict.contains(key) ? py::object(dict[key]) : py::none();
}

/// The numbers of `key`, or infinitely sharp where nothing is said.
std::vector<double> sharpness_for(const py::dict& dict, const char* key, std::size_t count) {
  const py::object given = entry(dict, key);
  if (given.is_none()) return std::vector<double>(count, kInfinitelySharp);
  std::vector<double> numbers = numbers_for(given, count, key);
  for (double& number : numbers) {
    if (number < 0) raise({std::string(key) + " is below 0"}, Fault::mesh);
    number = std::min(number, kInfinitelySharp);
  }
  return numbers;
}

using Triangles = std::vector<std::pair<std::string, bool>>;

const Triangles& triangle_words() {
  static const Triangles words{{"catmullClark", false}, {"smooth", true}};
  return words;
}

/// What the word of `key` means; nothing where none is given.
template <class Value>
std::optional<Value> named(const py::dict& dict, const char* key,
                           const std::vector<std::pair<std::string, Value>>& known) {
  const py::object given = entry(dict, key);
  if (given.is_none()) return std::nullopt;
  const std::string name = py::str(given);
  std::string all;
  for (const auto& [word, value] : known) {
    if (word == name) return value;
    all += (all.empty() ? "" : ", ") + word;
  }
  raise({std::string(key) + " '" + name + "' is none of " + all}, Fault::mesh);
}

template <class Value>
void add_word(py::dict& dict, const char* key, const std::optional<Value>& stated,
              const std::vector<std::pair<std::string, Value>>& known) {
  for (const auto& [word, value] : known)
    if (stated == value) dict[key] = word;
}

}  // namespace

SharpnessTags tags_of(const py::dict& dict) {
  SharpnessTags tags;
  if (const py::object given = entry(dict, "creases"); !given.is_none()) {
    const std::vector<Index> ends = indices_of(given, 2, "creases");
    const std::vector<double> sharpness = sharpness_for(dict, "crease_sharpness", ends.size() / 2);
    for (std::size_t i = 0; i < sharpness.size(); ++i)
      tags.creases.push_back({{ends[2 * i], ends[2 * i + 1]}, {sharpness[i]}});
  }
  if (const py::object given = entry(dict, "corners"); !given.is_none()) {
    const std::vector<Index> vertices = indices_of(given, 0, "corners");
    const std::vector<double> sharpness = sharpness_for(dict, "corner_sharpness", vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
      tags.corners.push_back({vertices[i], sharpness[i]});
  }
  if (const py::object given = entry(dict, "holes"); !given.is_none())
    for (const Index face : indices_of(given, 0, "holes")) tags.holes.push_back({face});
  tags.boundary = named(dict, "boundary", boundary_modes());
  tags.method = named(dict, "crease_method", crease_methods());
  tags.smooth_triangles = named(dict, "triangles", triangle_words());
  return tags;
}

py::dict tags_dict(const SharpnessTags& tags) {
  py::dict dict;
  std::vector<Index> ends, corners, holes;
  std::vector<double> creases, points;
  for (const SharpnessTags::Crease& crease : tags.creases)
    for (std::size_t i = 0; i + 1 < crease.vertices.size(); ++i) {
      ends.insert(ends.end(), {crease.vertices[i], crease.vertices[i + 1]});
      creases.push_back(crease.sharpness[std::min(i, crease.sharpness.size() - 1)]);
    }
  for (const SharpnessTags::Corner& corner : tags.corners) {
    corners.push_back(corner.vertex);
    points.push_back(corner.sharpness);
  }
  for (const SharpnessTags::Hole& hole : tags.holes) holes.push_back(hole.face);
  if (!creases.empty()) {
    dict["creases"] = array_of(std::move(ends), {static_cast<py::ssize_t>(creases.size()), 2});
    dict["crease_sharpness"] = array_of(std::move(creases));
  }
  if (!corners.empty()) {
    dict["corners"] = array_of(std::move(corners));
    dict["corner_sharpness"] = array_of(std::move(points));
  }
  if (!holes.empty()) dict["holes"] = array_of(std::move(holes));
  add_word(dict, "boundary", tags.boundary, boundary_modes());
  add_word(dict, "crease_method", tags.method, crease_methods());
  add_word(dict, "triangles", tags.smooth_triangles, triangle_words());
  return dict;
}

Sharpness sharpness_of(const Mesh& mesh, const SharpnessTags& tags,
                       const std::optional<CreaseAngle>& angle) {
  Sharpness sharpness;
  check(apply_tags(mesh, {}, tags, sharpness), Fault::mesh);
  if (angle) static_cast<void>(sharpen_by_angle(mesh, angle->points, angle->degrees, sharpness));
  apply_boundary_mode(mesh, tags.boundary.value_or(BoundaryMode::edge_only), sharpness);
  return sharpness;
}

std::optional<Scheme> smoothed(const Scheme& scheme, const SharpnessTags& tags) {
  if (!tags.smooth_triangles.value_or(false)) return std::nullopt;
  Scheme smooth = scheme;
  if (!use_smooth_triangles(smooth))
    raise({scheme.name + " has no rule for smooth triangles",
           "leave out triangles=, or state [smooth-triangles] in a scheme file", scheme.file},
          Fault::scheme);
  return smooth;
}

}  // namespace limn::python
