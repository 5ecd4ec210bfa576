#pragma once
/// Texture coordinates and colours of glTF primitives: TEXCOORD_0 and COLOR_0. [glTF 2.0 §3.7.2.1]

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "limn/mesh/attributes/attributes.h"
#include "limn/mesh/io/gltf_document.h"
#include "limn/mesh/polygons.h"

namespace limn::io {

/// v of a texture point, up, from that of glTF, down; and the other way round.
[[nodiscard]] inline double turned_v(double v) { return 1 - v; }

/// Takes them up, primitive by primitive.
class GltfAttributes {
 public:
  GltfAttributes(GltfDocument& document, const Polygons& mesh, MeshAttributes& out)
      : document_(document), mesh_(mesh), out_(out) {}

  /// Whether an attribute of a primitive is one of them.
  [[nodiscard]] static bool takes(const std::string& name) {
    return name == "TEXCOORD_0" || name == "COLOR_0";
  }
  /// Of a primitive with `count` vertices, the first of them being `first`, whose corners are those
  /// from `first_corner` on. False where it is at fault (the document knows why).
  [[nodiscard]] bool add(const GltfDocument::Json& attributes, const std::string& where,
                         Index first, std::size_t count, std::size_t first_corner);
  /// At the end: all vertices and corners have something.
  void finish();

 private:
  [[nodiscard]] bool numbers(const GltfDocument::Json& attributes, const std::string& where,
                             const char* name, std::size_t count, std::uint64_t& accessor,
                             GltfAccessor& numbers);
  [[nodiscard]] bool colours(const GltfAccessor& numbers, std::uint64_t accessor, Index first);
  [[nodiscard]] bool points(const GltfAccessor& numbers, std::uint64_t accessor, Index first,
                            std::size_t first_corner);

  GltfDocument& document_;
  const Polygons& mesh_;
  MeshAttributes& out_;
  std::map<std::pair<std::uint64_t, Index>, Index> first_point_;  ///< by accessor and vertex
};

}  // namespace limn::io
