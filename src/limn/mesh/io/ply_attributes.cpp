#include "limn/mesh/io/ply_attributes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <set>

#include "limn/mesh/index.h"
#include "limn/mesh/io/bytes.h"

namespace limn::io {
namespace {

using mesh::at;

bool is_one_of(const std::string& name, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(), [&](const char* known) { return name == known; });
}

constexpr std::array kEdgeProperties{"vertex1", "vertex2", "sharpness"};

bool is_normal(const PlyProperty& property) { return is_one_of(property.name, {"nx", "ny", "nz"}); }

/// Names that u and v have in the files of several programs.
constexpr std::array<std::array<const char*, 2>, 4> kTexturePairs{
    {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}};

bool is_texture_name(const std::string& name) {
  return std::any_of(kTexturePairs.begin(), kTexturePairs.end(),
                     [&](const auto& pair) { return name == pair[0] || name == pair[1]; });
}

bool faces_have_texture(const PlyHeader& header) {
  const PlyElement* const face = header.find("face");
  return face != nullptr && corner_texture(*face) != nullptr;
}

/// The places of u and v among the properties; nothing where there are none, or faces have them.
std::optional<std::array<std::size_t, 2>> texture_pair(const PlyElement& element,
                                                       const PlyHeader& header) {
  if (faces_have_texture(header)) return std::nullopt;
  const auto find = [&](const char* name) {
    std::size_t k = 0;
    while (k < element.properties.size() &&
           (element.properties[k].name != name || element.properties[k].is_list))
      ++k;
    return k;
  };
  for (const auto& [u, v] : kTexturePairs) {
    const std::array<std::size_t, 2> found{find(u), find(v)};
    if (std::max(found[0], found[1]) < element.properties.size()) return found;
  }
  return std::nullopt;
}

/// What a property of a vertex or face is to a user.
std::string kind_of(const PlyElement& element, const PlyProperty& property) {
  const std::string& name = property.name;
  if (is_normal(property)) return "normals";
  if (is_texture_name(name) || name == "texcoord") return "texture coordinates";
  if (is_one_of(name, {"red", "green", "blue", "alpha"})) return element.name + " colours";
  return "the " + element.name + " property " + in_quotes(name);
}

NumberType texture_type_of(NumberType type) {
  return type == NumberType::float32 ? type : NumberType::float64;
}

/// Whether it is kept as an attribute, where these are. Texture coordinates of faces stand in for
/// those of vertices.
bool is_attribute(const PlyHeader& header, const PlyElement& element, const PlyProperty& property) {
  if (element.name == "vertex")
    return !property.is_list && !is_normal(property) &&
           !(is_texture_name(property.name) && faces_have_texture(header));
  return element.name == "face" && corner_texture(element) == &property;
}

template <class Whole>
void append_whole(std::string& out, double value) {
  constexpr double low = std::numeric_limits<Whole>::min();
  constexpr double high = std::numeric_limits<Whole>::max();
  append_little(out, static_cast<Whole>(std::clamp(std::round(value), low, high)));
}

/// A finite number; whole ones are rounded to the nearest that the type has.
void append_number(std::string& out, NumberType type, double value) {
  switch (type) {
    case NumberType::int8: return append_whole<std::int8_t>(out, value);
    case NumberType::uint8: return append_whole<std::uint8_t>(out, value);
    case NumberType::int16: return append_whole<std::int16_t>(out, value);
    case NumberType::uint16: return append_whole<std::uint16_t>(out, value);
    case NumberType::int32: return append_whole<std::int32_t>(out, value);
    case NumberType::uint32: return append_whole<std::uint32_t>(out, value);
    case NumberType::float32: return append_little(out, static_cast<float>(value));
    case NumberType::float64: break;
  }
  append_little(out, value);
}

}  // namespace

bool is_index_list(const PlyProperty& property) {
  return property.is_list && is_one_of(property.name, {"vertex_indices", "vertex_index"});
}

int axis_of(const PlyProperty& property) {
  if (property.is_list) return -1;
  return property.name == "x" ? 0 : property.name == "y" ? 1 : property.name == "z" ? 2 : -1;
}

bool holds_faces(const PlyElement& element) {
  return is_one_of(element.name, {"face", "tristrips"});
}

int edge_role_of(const PlyProperty& property) {
  for (int role = 0; role < 3; ++role)
    if (!property.is_list && property.name == kEdgeProperties.at(static_cast<std::size_t>(role)))
      return role;
  return -1;
}

bool holds_sharpness(const PlyElement& element) {
  int found = 0;
  for (const PlyProperty& property : element.properties)
    if (const int role = edge_role_of(property); role >= 0) found |= 1 << role;
  return element.name == "edge" && found == 7;
}

const PlyProperty* corner_texture(const PlyElement& element) {
  const auto found =
      std::find_if(element.properties.begin(), element.properties.end(),
                   [](const PlyProperty& one) { return one.is_list && one.name == "texcoord"; });
  return found == element.properties.end() ? nullptr : &*found;
}

void remark_what_is_left_out(const PlyHeader& header, bool attributes, Remarks& remarks) {
  for (const PlyElement& element : header.elements) {
    const auto count = static_cast<std::size_t>(element.count);
    const bool is_vertex = element.name == "vertex";
    if (holds_sharpness(element)) continue;
    if (!is_vertex && !holds_faces(element)) {
      if (count > 0)
        remarks.left_out(element.place, "elements " + in_quotes(element.name), "of them", count);
      continue;
    }
    std::set<std::string> kinds;
    for (const PlyProperty& property : element.properties) {
      if (is_vertex ? axis_of(property) >= 0 : is_index_list(property)) continue;
      if (attributes && is_attribute(header, element, property)) continue;
      std::string kind = kind_of(element, property);
      if (!kinds.insert(kind).second) continue;
      remarks.left_out(property.place, kind, is_vertex ? "vertices" : "faces", count);
    }
  }
}

PlyVertexLayout::PlyVertexLayout(const PlyElement& element, const PlyHeader& header,
                                 bool attributes) {
  std::optional<std::array<std::size_t, 2>> pair;
  if (attributes) pair = texture_pair(element, header);
  for (std::size_t k = 0; k < element.properties.size(); ++k) {
    const PlyProperty& property = element.properties[k];
    const bool of_texture = pair && (k == (*pair)[0] || k == (*pair)[1]);
    places_.push_back(axis_of(property));
    if (places_.back() >= 0 || !attributes || of_texture ||
        !is_attribute(header, element, property))
      continue;
    places_.back() = static_cast<int>(size_++);
    columns_.push_back({property.name, property.type, {}});
  }
  if (!pair) return;
  texture_ = texture_type_of(element.properties[(*pair)[0]].type);
  for (const std::size_t k : *pair) places_[k] = static_cast<int>(size_++);
}

void PlyVertexLayout::begin(MeshAttributes& attributes) const {
  attributes.vertices = columns_;
  if (texture_) attributes.texture.type = *texture_;
}

void PlyVertexLayout::add(const std::vector<double>& numbers, MeshAttributes& attributes) const {
  for (std::size_t k = 0; k < columns_.size(); ++k)
    attributes.vertices[k].values.push_back(numbers[3 + k]);
  if (texture_) attributes.texture.points.push_back({numbers[size_ - 2], numbers[size_ - 1]});
}

void finish_ply_texture(const PlyHeader& header, const Polygons& mesh, MeshAttributes& attributes) {
  TextureCoordinates& texture = attributes.texture;
  if (faces_have_texture(header)) {
    texture.of_corner.resize(mesh.corners.size(), kNone);  // those of strips
    if (texture.points.empty()) texture.of_corner.clear();
    return join_equal_points(mesh, texture);
  }
  if (texture.points.empty()) return;
  for (const Index v : mesh.corners)
    texture.of_corner.push_back(v >= 0 && v < mesh.vertex_count() ? v : kNone);
}

PlyExtras::PlyExtras(const Polygons& mesh, const MeshAttributes& attributes)
    : mesh_(mesh), attributes_(attributes) {
  for (Index f = 0; f < mesh.face_count(); ++f) wide_ = wide_ || mesh.degree(f) > 127;
  if (texture().empty() || attributes.find("s") != nullptr || attributes.find("t") != nullptr)
    return;
  of_vertex_.assign(mesh.positions.size(), kNone);
  for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
    Index& point = of_vertex_[at(mesh.corners[c])];
    if (point == kNone) point = texture().of_corner[c];
    if (point == kNone || point != texture().of_corner[c]) {
      of_vertex_.clear();
      break;
    }
  }
}

bool PlyExtras::has_vertex_properties() const {
  return !attributes_.vertices.empty() || !of_vertex_.empty();
}

bool PlyExtras::has_face_properties() const { return !texture().empty() && of_vertex_.empty(); }

std::string PlyExtras::vertex_properties() const {
  std::string lines;
  const auto add = [&](NumberType type, const std::string& name) {
    lines += std::string("property ") + name_of(type) + ' ' + name + '\n';
  };
  for (const VertexNumbers& column : attributes_.vertices) add(column.type, column.name);
  if (of_vertex_.empty()) return lines;
  add(texture().type, "s");
  add(texture().type, "t");
  return lines;
}

std::string PlyExtras::face_properties() const {
  if (!has_face_properties()) return {};
  return std::string("property list ") + (wide_ ? "int " : "uchar ") + name_of(texture().type) +
         " texcoord\n";
}

void PlyExtras::append_vertex(std::string& out, Index vertex) const {
  for (const VertexNumbers& column : attributes_.vertices)
    append_number(out, column.type, column.values[at(vertex)]);
  if (of_vertex_.empty()) return;
  const Index number = of_vertex_[at(vertex)];  // none: an isolated vertex
  const TexturePoint point = number == kNone ? TexturePoint{} : texture().points[at(number)];
  append_number(out, texture().type, point.u);
  append_number(out, texture().type, point.v);
}

void PlyExtras::append_face(std::string& out, Index face) const {
  const Index first = mesh_.face_begin[at(face)], last = mesh_.face_begin[at(face) + 1];
  const std::vector<Index>& of_corner = texture().of_corner;
  const bool has = last > first && of_corner[at(first)] != kNone;
  const Index count = has ? 2 * (last - first) : 0;
  if (wide_)
    append_little(out, count);
  else
    append_little(out, static_cast<std::uint8_t>(count));
  for (Index c = first; has && c < last; ++c) {
    const TexturePoint& point = texture().points[at(of_corner[at(c)])];
    append_number(out, texture().type, point.u);
    append_number(out, texture().type, point.v);
  }
}

}  // namespace limn::io
