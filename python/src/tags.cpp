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

template <class Value>
Value named(const std::string& name, const std::vector<std::pair<std::string, Value>>& known,
            Value otherwise) {
  if (name.empty()) return otherwise;
  std::string all;
  for (const auto& [word, value] : known) {
    if (word == name) return value;
    all += (all.empty() ? "" : ", ") + word;
  }
  raise({"'" + name + "' is none of " + all}, Fault::mesh);
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
  return dict;
}

Sharpness sharpness_of(const Mesh& mesh, const std::vector<Point3>& points,
                       const SharpnessTags& tags, const SharpnessRules& rules) {
  Sharpness sharpness;
  check(apply_tags(mesh, {}, tags, sharpness), Fault::mesh);
  if (rules.crease_angle >= 0)
    static_cast<void>(sharpen_by_angle(mesh, points, rules.crease_angle, sharpness));
  sharpness.method = named(rules.method, crease_methods(), CreaseMethod::uniform);
  apply_boundary_mode(mesh, named(rules.boundary, boundary_modes(), BoundaryMode::edge_only),
                      sharpness);
  return sharpness;
}

}  // namespace limn::python
