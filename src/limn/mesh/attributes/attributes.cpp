#include "limn/mesh/attributes/attributes.h"

#include <algorithm>
#include <utility>

#include "limn/mesh/index.h"

namespace limn {
namespace {

using mesh::at;

template <class Value>
std::vector<Value> taken(const std::vector<Value>& values, const std::vector<Index>& from,
                         const Value& none) {
  if (values.empty()) return {};
  std::vector<Value> result;
  result.reserve(from.size());
  for (const Index i : from) result.push_back(i == kNone ? none : values[at(i)]);
  return result;
}

bool are_below(const std::vector<Index>& list, std::size_t count) {
  return std::all_of(list.begin(), list.end(),
                     [&](Index i) { return i == kNone || (i >= 0 && at(i) < count); });
}

}  // namespace

const char* words_of(LabelKind kind) {
  switch (kind) {
    case LabelKind::object: return "object names";
    case LabelKind::group: return "groups";
    case LabelKind::material: return "materials";
    case LabelKind::smoothing: break;
  }
  return "smoothing groups";
}

const VertexNumbers* MeshAttributes::find(std::string_view name) const {
  const auto found = std::find_if(vertices.begin(), vertices.end(),
                                  [&](const VertexNumbers& one) { return one.name == name; });
  return found == vertices.end() ? nullptr : &*found;
}

bool MeshAttributes::has_labels() const {
  return std::any_of(labels.begin(), labels.end(),
                     [](const FaceLabels& one) { return !one.empty(); });
}

bool MeshAttributes::empty() const {
  return vertices.empty() && texture.empty() && !has_labels() && material_files.empty();
}

bool attributes_fit(const MeshAttributes& attributes, const Polygons& mesh) {
  for (const VertexNumbers& column : attributes.vertices)
    if (column.values.size() != mesh.positions.size()) return false;
  const TextureCoordinates& texture = attributes.texture;
  if (!texture.empty() && (texture.of_corner.size() != mesh.corners.size() ||
                           !are_below(texture.of_corner, texture.points.size())))
    return false;
  return std::all_of(attributes.labels.begin(), attributes.labels.end(),
                     [&](const FaceLabels& one) {
                       return one.empty() || (one.of_face.size() + 1 == mesh.face_begin.size() &&
                                              are_below(one.of_face, one.names.size()));
                     });
}

ColourColumns colour_of(const MeshAttributes& attributes) {
  ColourColumns colour;
  static constexpr std::array names{"red", "green", "blue", "alpha"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    colour.column.at(i) = attributes.find(names.at(i));
    if (colour.column.at(i) == nullptr && i < 3) return {};
  }
  return colour;
}

double full_intensity(NumberType type) {
  switch (type) {
    case NumberType::int8: return 127;
    case NumberType::uint8: return 255;
    case NumberType::int16: return 32767;
    case NumberType::uint16: return 65535;
    case NumberType::int32: return 2147483647;
    case NumberType::uint32: return 4294967295;
    case NumberType::float32:
    case NumberType::float64: break;
  }
  return 1;
}

MeshAttributes mapped(const MeshAttributes& attributes, const AttributeMap& map) {
  MeshAttributes result;
  result.material_files = attributes.material_files;
  for (const VertexNumbers& column : attributes.vertices)
    result.vertices.push_back(
        {column.name, column.type, taken(column.values, *map.vertex_of, 0.0)});
  result.texture = {attributes.texture.points,
                    taken(attributes.texture.of_corner, *map.corner_of, kNone),
                    attributes.texture.type};
  for (std::size_t k = 0; k < attributes.labels.size(); ++k)
    result.labels.at(k) = {attributes.labels.at(k).names,
                           taken(attributes.labels.at(k).of_face, *map.face_of, kNone)};
  return result;
}

void join_equal_points(const Polygons& mesh, TextureCoordinates& texture) {
  if (texture.empty()) return;
  std::vector<TexturePoint> points;
  // of each vertex, a list of the new points that its corners have
  std::vector<Index> first(mesh.positions.size(), kNone), next;
  for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
    Index& of_corner = texture.of_corner[c];
    const Index v = mesh.corners[c];
    if (of_corner == kNone || v < 0 || v >= mesh.vertex_count()) continue;
    const TexturePoint point = texture.points[at(of_corner)];
    Index found = first[at(v)];
    while (found != kNone && !(points[at(found)] == point)) found = next[at(found)];
    if (found == kNone) {
      found = static_cast<Index>(points.size());
      points.push_back(point);
      next.push_back(std::exchange(first[at(v)], found));
    }
    of_corner = found;
  }
  texture.points = std::move(points);
}

}  // namespace limn
