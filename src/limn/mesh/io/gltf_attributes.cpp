#include "limn/mesh/io/gltf_attributes.h"

#include <array>
#include <cmath>

#include "limn/mesh/index.h"

namespace limn::io {
namespace {

using mesh::at;

}  // namespace

bool GltfAttributes::numbers(const GltfDocument::Json& attributes, const std::string& where,
                             const char* name, std::size_t count, std::uint64_t& accessor,
                             GltfAccessor& numbers) {
  if (!document_.whole(attributes, where, name, accessor) ||
      !document_.accessor(accessor, where, numbers))
    return false;
  if (numbers.count == count) return true;
  return document_.fail(where,
                        std::string(name) + " has " + std::to_string(numbers.count) +
                            " entries for " + std::to_string(count) + " vertices",
                        "leave attributes out by --attributes none");
}

bool GltfAttributes::add(const GltfDocument::Json& attributes, const std::string& where,
                         Index first, std::size_t count, std::size_t first_corner) {
  std::uint64_t accessor = 0;
  GltfAccessor found;
  if (attributes.contains("COLOR_0") &&
      (!numbers(attributes, where, "COLOR_0", count, accessor, found) ||
       !colours(found, accessor, first)))
    return false;
  if (!attributes.contains("TEXCOORD_0")) {
    if (!out_.texture.empty()) out_.texture.of_corner.resize(mesh_.corners.size(), kNone);
    return true;
  }
  return numbers(attributes, where, "TEXCOORD_0", count, accessor, found) &&
         points(found, accessor, first, first_corner);
}

bool GltfAttributes::colours(const GltfAccessor& numbers, std::uint64_t accessor, Index first) {
  const std::string where = "accessors[" + std::to_string(accessor) + "]";
  if (numbers.parts != 3 && numbers.parts != 4)
    return document_.fail(where, "colours are to be VEC3 or VEC4",
                          "leave attributes out by --attributes none");
  static constexpr std::array names{"red", "green", "blue", "alpha"};
  for (std::size_t k = out_.vertices.size(); k < static_cast<std::size_t>(numbers.parts); ++k)
    out_.vertices.push_back({names.at(k), NumberType::float32, {}});
  for (VertexNumbers& column : out_.vertices) column.values.resize(mesh_.positions.size(), 1);
  for (std::size_t i = 0; i < numbers.count; ++i)
    for (int k = 0; k < numbers.parts; ++k) {
      const double value = numbers.number(i, k);
      if (!std::isfinite(value))
        return document_.fail(where, "colour " + std::to_string(i) + " is not finite",
                              "leave attributes out by --attributes none");
      out_.vertices[static_cast<std::size_t>(k)].values[at(first) + i] = value;
    }
  return true;
}

bool GltfAttributes::points(const GltfAccessor& numbers, std::uint64_t accessor, Index first,
                            std::size_t first_corner) {
  const std::string where = "accessors[" + std::to_string(accessor) + "]";
  if (numbers.parts != 2)
    return document_.fail(where, "texture coordinates are to be VEC2",
                          "leave attributes out by --attributes none");
  TextureCoordinates& texture = out_.texture;
  texture.type = NumberType::float32;
  const auto [found, fresh] =
      first_point_.try_emplace({accessor, first}, static_cast<Index>(texture.points.size()));
  for (std::size_t i = 0; fresh && i < numbers.count; ++i) {
    const TexturePoint point{numbers.number(i, 0), turned_v(numbers.number(i, 1))};
    if (!std::isfinite(point.u) || !std::isfinite(point.v))
      return document_.fail(where, "texture point " + std::to_string(i) + " is not finite",
                            "leave attributes out by --attributes none");
    texture.points.push_back(point);
  }
  texture.of_corner.resize(first_corner, kNone);
  for (std::size_t c = first_corner; c < mesh_.corners.size(); ++c) {
    const Index v = mesh_.corners[c];
    texture.of_corner.push_back(v == kNone ? kNone : found->second + (v - first));
  }
  return true;
}

void GltfAttributes::finish() {
  for (VertexNumbers& column : out_.vertices) column.values.resize(mesh_.positions.size(), 1);
  if (out_.texture.points.empty())
    out_.texture = {};
  else
    out_.texture.of_corner.resize(mesh_.corners.size(), kNone);
}

}  // namespace limn::io
