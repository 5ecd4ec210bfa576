/// Binary glTF 2.0 as it is written: one mesh of triangles (triangulate.h), float positions,
/// optional unit normals, texture coordinates (vertices are there once for each side of a seam or
/// crease) and colours, 32-bit indices. [glTF 2.0 §4.4 GLB file format, §3.7 meshes]

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "limn/mesh/io/blocks.h"
#include "limn/mesh/io/bytes.h"
#include "limn/mesh/io/formats.h"
#include "limn/mesh/io/gltf_attributes.h"
#include "limn/mesh/io/gltf_document.h"

namespace limn::io {
namespace {

using OrderedJson = nlohmann::ordered_json;

// Constants of the format.
constexpr std::uint32_t kMagic = 0x46546C67;  // "glTF"
constexpr int kFloat = 5126, kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;

void append(std::string& out, Point3 p) {
  append_little(out, static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z));
}

/// glTF demands unit normals; where there is none any direction does.
Point3 unit(Point3 normal) {
  const double length = std::hypot(normal.x, normal.y, normal.z);
  return length > 0 && std::isfinite(length) ? (1 / length) * normal : Point3{0, 0, 1};
}

/// The bounds of the positions as they are written, in floats; a zero without its sign, which would
/// be that of whichever vertex came first.
void add_bounds(OrderedJson& accessor, const Polygons& mesh) {
  const Point3 first = mesh.positions.front();
  Point3 low = first, high = first;
  for (const Point3& p : mesh.positions) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const auto rounded = [](double x) { return double{static_cast<float>(x)} + 0.0; };
  accessor["min"] = {rounded(low.x), rounded(low.y), rounded(low.z)};
  accessor["max"] = {rounded(high.x), rounded(high.y), rounded(high.z)};
}

/// Adds a buffer view of `bytes` and its accessor; returns the index of both.
std::size_t add_block(OrderedJson& gltf, std::size_t& offset, std::size_t bytes, int target,
                      OrderedJson accessor) {
  const std::size_t index = gltf["bufferViews"].size();
  gltf["bufferViews"].push_back(
      {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes}, {"target", target}});
  accessor["bufferView"] = index;
  gltf["accessors"].push_back(std::move(accessor));
  offset += bytes;
  return index;
}

/// How often numbers of each kind stand for a vertex.
struct Parts {
  bool normals = false, texture = false;
  int colours = 0;  ///< 3 or 4; 0: there are none
};

OrderedJson description(const Polygons& mesh, const Parts& parts, std::size_t indices) {
  const std::size_t vertices = mesh.positions.size();
  OrderedJson gltf;
  gltf["asset"] = {{"version", "2.0"}, {"generator", "limn"}};
  gltf["scene"] = 0;
  gltf["scenes"] = OrderedJson::array({{{"nodes", {0}}}});
  gltf["nodes"] = OrderedJson::array({{{"mesh", 0}}});
  gltf["bufferViews"] = OrderedJson::array();
  gltf["accessors"] = OrderedJson::array();

  std::size_t size = 0;
  OrderedJson attributes;
  OrderedJson positions = {{"componentType", kFloat}, {"count", vertices}, {"type", "VEC3"}};
  add_bounds(positions, mesh);
  attributes["POSITION"] = add_block(gltf, size, 12 * vertices, kArrayBuffer, positions);
  const auto add = [&](const char* name, int numbers) {
    attributes[name] =
        add_block(gltf, size, 4 * static_cast<std::size_t>(numbers) * vertices, kArrayBuffer,
                  {{"componentType", kFloat},
                   {"count", vertices},
                   {"type", "VEC" + std::to_string(numbers)}});
  };
  if (parts.normals) add("NORMAL", 3);
  if (parts.texture) add("TEXCOORD_0", 2);
  if (parts.colours > 0) add("COLOR_0", parts.colours);
  const std::size_t triangles =
      add_block(gltf, size, 4 * indices, kElementArrayBuffer,
                {{"componentType", kUnsignedInt}, {"count", indices}, {"type", "SCALAR"}});
  OrderedJson primitive = {{"attributes", attributes}, {"indices", triangles}, {"mode", 4}};
  gltf["meshes"] = OrderedJson::array({{{"primitives", OrderedJson::array({primitive})}}});
  gltf["buffers"] = OrderedJson::array({{{"byteLength", size}}});
  return gltf;
}

/// A mesh whose vertices have each one texture point and one normal: cut at seams and creases.
struct CutAtSeams {
  Polygons mesh;
  std::vector<Index> vertex_of, point_of, normal_of;  ///< of each of its vertices
};
CutAtSeams cut_at_seams(const Polygons& mesh, const std::vector<Index>& point_of_corner,
                        const std::vector<Index>& normal_of_corner) {
  CutAtSeams cut;
  cut.mesh.face_begin = mesh.face_begin;
  std::vector<Index> first(mesh.positions.size(), kNone), next;  // copies of each vertex
  for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
    const auto v = static_cast<std::size_t>(mesh.corners[c]);
    const Index point = point_of_corner.empty() ? kNone : point_of_corner[c];
    const Index normal = normal_of_corner.empty() ? mesh.corners[c] : normal_of_corner[c];
    Index copy = first[v];
    while (copy != kNone && (cut.point_of[static_cast<std::size_t>(copy)] != point ||
                             cut.normal_of[static_cast<std::size_t>(copy)] != normal))
      copy = next[static_cast<std::size_t>(copy)];
    if (copy == kNone) {
      copy = static_cast<Index>(cut.vertex_of.size());
      cut.vertex_of.push_back(mesh.corners[c]);
      cut.point_of.push_back(point);
      cut.normal_of.push_back(normal);
      cut.mesh.positions.push_back(mesh.positions[v]);
      next.push_back(std::exchange(first[v], copy));
    }
    cut.mesh.corners.push_back(copy);
  }
  return cut;
}

/// Writes numbers of vertices, in floats.
template <class Append>
void write_numbers(const Polygons& mesh, const base::Sink& sink, const Append& append_numbers) {
  write_blocks(mesh.vertex_count(), sink, [&](Index first, Index last, std::string& out) {
    for (Index v = first; v < last; ++v) append_numbers(out, static_cast<std::size_t>(v));
  });
}

void write_head(const OrderedJson& gltf, const base::Sink& sink) {
  std::string json = gltf.dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::size_t data = gltf["buffers"][0]["byteLength"];  // a multiple of 4 already
  std::string head;
  const auto put = [&head](std::size_t value) {
    append_little(head, static_cast<std::uint32_t>(value));
  };
  put(kMagic);
  put(2);
  put(12 + 8 + json.size() + 8 + data);
  put(json.size());
  put(kJsonChunk);
  head += json;
  put(data);
  put(kBinaryChunk);
  sink(head);
}

}  // namespace

void format_glb(const Polygons& whole, const WriteOptions& options, const base::Sink& sink) {
  const TextureCoordinates& texture = options.attributes.texture;
  const ColourColumns colour = colour_of(options.attributes);
  Parts parts{!options.normals.empty(), !texture.empty(), 0};
  if (colour) parts.colours = colour.column[3] != nullptr ? 4 : 3;
  const bool is_cut = parts.texture || !options.normal_of_corner.empty();
  CutAtSeams cut;
  if (is_cut) cut = cut_at_seams(whole, texture.of_corner, options.normal_of_corner);
  const Polygons& mesh = is_cut ? cut.mesh : whole;
  const auto original = [&](std::size_t v) {
    return is_cut ? static_cast<std::size_t>(cut.vertex_of[v]) : v;
  };
  write_head(description(mesh, parts, 3 * triangle_count(mesh)), sink);
  write_numbers(mesh, sink,
                [&](std::string& out, std::size_t v) { append(out, mesh.positions[v]); });
  if (parts.normals)
    write_numbers(mesh, sink, [&](std::string& out, std::size_t v) {
      append(out, unit(options.normals[is_cut ? static_cast<std::size_t>(cut.normal_of[v]) : v]));
    });
  if (parts.texture)
    write_numbers(mesh, sink, [&](std::string& out, std::size_t v) {
      const Index i = cut.point_of[v];
      const TexturePoint p =
          i == kNone ? TexturePoint{} : texture.points[static_cast<std::size_t>(i)];
      append_little(out, static_cast<float>(p.u), static_cast<float>(turned_v(p.v)));
    });
  if (parts.colours > 0)
    write_numbers(mesh, sink, [&](std::string& out, std::size_t v) {
      for (const VertexNumbers* column : colour.column)
        if (column != nullptr)
          append_little(
              out, static_cast<float>(column->values[original(v)] / full_intensity(column->type)));
    });
  write_blocks(mesh.face_count(), sink, [&](Index first, Index last, std::string& out) {
    for_each_triangle(mesh, first, last,
                      [&](Index a, Index b, Index c) { append_little(out, a, b, c); });
  });
}

}  // namespace limn::io
