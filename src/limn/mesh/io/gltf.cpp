/// glTF 2.0, binary (GLB) and JSON: triangles, strips and fans of all meshes of the scene, where
/// its nodes put them, as one mesh. Positions and connectivity are kept. [glTF 2.0 §3.5, §3.7]

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "limn/base/memory.h"
#include "limn/mesh/finite_point.h"
#include "limn/mesh/io/formats.h"
#include "limn/mesh/io/gltf_attributes.h"
#include "limn/mesh/io/gltf_document.h"

namespace limn::io {
namespace {

using Json = GltfDocument::Json;

/// x' = column[0] x + column[1] y + column[2] z + column[3].
struct Transform {
  std::array<Point3, 4> column{Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}, Point3{}};

  [[nodiscard]] Point3 of_vector(Point3 p) const {
    return p.x * column[0] + p.y * column[1] + p.z * column[2];
  }
  [[nodiscard]] Point3 of(Point3 p) const { return of_vector(p) + column[3]; }
  /// First `inner`, then this.
  [[nodiscard]] Transform after(const Transform& inner) const {
    return {{of_vector(inner.column[0]), of_vector(inner.column[1]), of_vector(inner.column[2]),
             of(inner.column[3])}};
  }
  /// Whether it turns left hands into right ones.
  [[nodiscard]] bool mirrors() const { return dot(cross(column[0], column[1]), column[2]) < 0; }
  [[nodiscard]] bool is_identity() const { return column == Transform{}.column; }
};

class GltfReader {
 public:
  GltfReader(std::string_view content, const ReadOptions& options, MeshFile& file)
      : document_(content, file.source.file, opener(options)),
        options_(options),
        file_(file),
        mesh_(file.polygons),
        remarks_(file),
        attributes_(document_, mesh_, file.attributes) {}

  Status read() {
    if (!document_.read() || !scene() || !place_all()) return document_.error();
    attributes_.finish();
    if (const std::string fault = emptiness(mesh_); !fault.empty()) {
      document_.fail("", fault);
      return document_.error();
    }
    return Done{};
  }

 private:
  static GltfDocument::Open opener(const ReadOptions& options) {
    if (options.folder.empty()) return {};
    return [folder = options.folder](const std::string& name) {
      return base::read_file(folder + "/" + name);
    };
  }

  struct Visit {
    std::uint64_t node;
    Transform above;
  };

  /// All nodes of the scene, each once: they are trees.
  bool scene() {
    std::vector<Visit> open;
    if (!roots(open)) return false;
    std::vector<char> met(document_.count("nodes"), 0);
    while (!open.empty()) {
      const Visit visit = open.back();
      open.pop_back();
      const std::string where = "nodes[" + std::to_string(visit.node) + "]";
      const Json* node = document_.entry("nodes", visit.node, "the scene");
      if (node == nullptr) return false;
      char& is_met = met[static_cast<std::size_t>(visit.node)];
      if (is_met != 0) return document_.fail(where, "has two parents: nodes are to be trees");
      is_met = 1;
      Transform own;
      if (!transform(*node, where, own)) return false;
      const Transform placed = visit.above.after(own);
      if (node->contains("mesh") && !mesh(*node, where, placed)) return false;
      const Json* children = GltfDocument::list(*node, "children");
      if (children == nullptr) continue;
      for (std::size_t k = children->size(); k-- > 0;)  // the first is looked at first
        if (!push(open, (*children)[k], placed, where)) return false;
    }
    return true;
  }

  bool push(std::vector<Visit>& open, const Json& number, const Transform& above,
            const std::string& where) {
    if (!number.is_number_unsigned())
      return document_.fail(where, "a node is a whole number from 0 on");
    open.push_back({number.get<std::uint64_t>(), above});
    return true;
  }

  /// Of the scene that is shown; without a scene all nodes that are nobody's children; without
  /// nodes all meshes.
  bool roots(std::vector<Visit>& open) {
    if (document_.count("scenes") > 0) {
      std::uint64_t shown = 0;
      const std::uint64_t first = 0;
      if (!document_.whole(document_.json(), "", "scene", shown, &first)) return false;
      const Json* scene = document_.entry("scenes", shown, "'scene'");
      if (scene == nullptr) return false;
      if (document_.count("scenes") > 1)
        remarks_.left_out({}, "scenes that are not shown", "scenes", document_.count("scenes") - 1);
      const Json* nodes = GltfDocument::list(*scene, "nodes");
      for (std::size_t k = nodes == nullptr ? 0 : nodes->size(); k-- > 0;)
        if (!push(open, (*nodes)[k], {}, "scenes[" + std::to_string(shown) + "]")) return false;
      return true;
    }
    const std::size_t nodes = document_.count("nodes");
    if (nodes == 0) {
      for (std::size_t m = 0; m < document_.count("meshes"); ++m)
        if (!mesh_at(m, "the file", {})) return false;
      return true;
    }
    std::vector<char> is_child(nodes, 0);
    for (std::size_t n = 0; n < nodes; ++n) {
      const Json* node = document_.entry("nodes", n, "");
      if (node == nullptr) return false;
      if (const Json* children = GltfDocument::list(*node, "children"))
        for (const Json& child : *children)
          if (child.is_number_unsigned() && child.get<std::uint64_t>() < nodes)
            is_child[static_cast<std::size_t>(child.get<std::uint64_t>())] = 1;
    }
    for (std::size_t n = nodes; n-- > 0;)
      if (is_child[n] == 0) open.push_back({n, {}});
    return true;
  }

  /// `size` finite numbers under `key`, where it is there.
  template <std::size_t size>
  bool numbers(const Json& node, const std::string& where, const char* key,
               std::array<double, size>& values) {
    if (!node.contains(key)) return true;
    const Json* list = GltfDocument::list(node, key);
    bool right = list != nullptr && list->size() == size;
    for (std::size_t k = 0; right && k < size; ++k) {
      right = (*list)[k].is_number();
      if (right) values[k] = (*list)[k].template get<double>();
      right = right && std::isfinite(values[k]);
    }
    return right || document_.fail(where, std::string("'") + key + "' is to be " +
                                              std::to_string(size) + " numbers");
  }

  /// A matrix, or a translation after a rotation after a scaling.
  bool transform(const Json& node, const std::string& where, Transform& result) {
    if (node.contains("matrix")) {
      std::array<double, 16> m{};
      if (!numbers(node, where, "matrix", m)) return false;
      for (std::size_t c = 0; c < 4; ++c) result.column[c] = {m[4 * c], m[4 * c + 1], m[4 * c + 2]};
      return true;
    }
    std::array<double, 3> move{}, scale{1, 1, 1};
    std::array<double, 4> q{0, 0, 0, 1};
    if (!numbers(node, where, "translation", move) || !numbers(node, where, "scale", scale) ||
        !numbers(node, where, "rotation", q))
      return false;
    const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
    if (!(length > 0)) return document_.fail(where, "'rotation' is 0 0 0 0");
    const double x = q[0] / length, y = q[1] / length, z = q[2] / length, w = q[3] / length;
    result.column = {
        scale[0] * Point3{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
        scale[1] * Point3{2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
        scale[2] * Point3{2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)},
        Point3{move[0], move[1], move[2]}};
    return true;
  }

  bool mesh(const Json& node, const std::string& where, const Transform& placed) {
    std::uint64_t number = 0;
    if (!document_.whole(node, where, "mesh", number)) return false;
    if (node.contains("skin")) remarks_.left_out({}, "skins (bones)", "nodes");
    return mesh_at(number, where, placed);
  }

  /// Notes a mesh that is to be placed, and what it needs.
  bool mesh_at(std::uint64_t number, const std::string& from, const Transform& placed) {
    const auto [at, is_new] = needed_by_.try_emplace(number, 0.0);
    if (is_new && !estimate(number, from, at->second)) return false;
    needed_ += at->second;
    placements_.push_back({number, placed});
    return true;
  }

  /// Bytes of a mesh, placed once, as far as accessors tell that are looked at again when it is.
  bool estimate(std::uint64_t number, const std::string& from, double& bytes) {
    return for_each_primitive(number, from, [&](const Json& entry, const std::string& where) {
      const Json* attributes = GltfDocument::object(entry, "attributes");
      if (attributes == nullptr) return true;
      std::size_t corners = 0;
      for (const auto& [object, key] : {std::pair{attributes, "POSITION"}, {&entry, "indices"}}) {
        if (!object->contains(key)) continue;
        std::uint64_t accessor = 0;
        GltfAccessor numbers;
        if (!document_.whole(*object, where, key, accessor) ||
            !document_.accessor(accessor, where, numbers))
          return false;
        corners = numbers.count;
        bytes += 32.0 * static_cast<double>(numbers.count);
      }
      bytes += 24.0 * static_cast<double>(corners);  // strips and fans have a triangle for each
      return true;
    });
  }

  /// Meshes may be placed again and again: what that needs is known before any is.
  bool place_all() {
    if (needed_ > kSmall && needed_ > base::available_memory() / 2)
      return document_.fail(
          "", "the scene repeats its meshes until they need more memory than there is",
          "export the meshes that are meant alone");
    for (const Placement& placement : placements_) {
      first_vertex_.clear();
      const bool done = for_each_primitive(placement.mesh, "the scene",
                                           [&](const Json& entry, const std::string& where) {
                                             return primitive(entry, where, placement.placed);
                                           });
      if (!done) return false;
    }
    return true;
  }

  template <class Use>
  bool for_each_primitive(std::uint64_t number, const std::string& from, const Use& use) {
    const Json* mesh = document_.entry("meshes", number, from);
    if (mesh == nullptr) return false;
    const std::string where = "meshes[" + std::to_string(number) + "]";
    const Json* primitives = GltfDocument::list(*mesh, "primitives");
    if (primitives == nullptr) return document_.fail(where, "has no list 'primitives'");
    for (std::size_t p = 0; p < primitives->size(); ++p) {
      const std::string at = where + ".primitives[" + std::to_string(p) + "]";
      if (!(*primitives)[p].is_object()) return document_.fail(at, "expected an object");
      if (!use((*primitives)[p], at)) return false;
    }
    return true;
  }

  bool primitive(const Json& entry, const std::string& where, const Transform& placed) {
    std::uint64_t mode = 0, position = 0;
    const std::uint64_t triangles = 4;
    if (!document_.whole(entry, where, "mode", mode, &triangles)) return false;
    if (mode > 6) return document_.fail(where, "unknown 'mode' " + std::to_string(mode));
    if (mode < 4) {
      remarks_.left_out({}, "points and lines", "primitives");
      return true;
    }
    const Json* attributes = GltfDocument::object(entry, "attributes");
    if (attributes == nullptr || !attributes->contains("POSITION")) {
      if (entry.contains("extensions"))
        return document_.fail(where, "its positions are in an extension, which is not read");
      remarks_.left_out({}, "primitives without positions", "primitives");
      return true;
    }
    remark(*attributes, entry);
    Index first = 0;
    GltfAccessor positions;
    if (!document_.whole(*attributes, where, "POSITION", position) ||
        !document_.accessor(position, where, positions) ||
        !vertices(position, positions, placed, first))
      return false;
    GltfAccessor indices;
    if (entry.contains("indices")) {
      std::uint64_t number = 0;
      if (!document_.whole(entry, where, "indices", number) ||
          !document_.accessor(number, where, indices))
        return false;
      const bool whole =
          indices.component == 5121 || indices.component == 5123 || indices.component == 5125;
      if (indices.parts != 1 || !whole)
        return document_.fail(where, "'indices' are to be whole numbers without a sign");
    }
    const std::size_t corners = mesh_.corners.size();
    return faces(positions.count, indices, mode, first, placed.mirrors(), where) &&
           (!options_.attributes ||
            attributes_.add(*attributes, where, first, positions.count, corners));
  }

  void remark(const Json& attributes, const Json& entry) {
    for (const auto& [name, value] : attributes.items()) {
      if (options_.attributes && GltfAttributes::takes(name)) continue;
      const std::string kind = name.starts_with("TEXCOORD_") ? "texture coordinates"
                               : name.starts_with("COLOR_")  ? "vertex colours"
                               : name == "NORMAL"            ? "normals"
                               : name == "POSITION"          ? ""
                                                    : "vertex attributes " + in_quotes(name);
      if (!kind.empty()) remarks_.left_out({}, kind, "primitives");
    }
    if (entry.contains("material")) remarks_.left_out({}, "materials", "primitives");
    if (entry.contains("targets")) remarks_.left_out({}, "morph targets", "primitives");
  }

  /// Whether so many more can be counted.
  bool fits(std::size_t vertices, std::size_t corners) {
    return (mesh_.positions.size() + vertices <= mesh::kMostElements &&
            mesh_.corners.size() + corners <= mesh::kMostElements) ||
           document_.fail("", "2^31 - 1 vertices or corners or more", "cut the mesh into parts");
  }

  /// The vertices of an accessor, once for all primitives of a mesh that share it.
  bool vertices(std::uint64_t number, const GltfAccessor& positions, const Transform& placed,
                Index& first) {
    const std::string where = "accessors[" + std::to_string(number) + "]";
    const bool known = positions.component != 5125 && positions.parts == 3;
    if (!known) return document_.fail(where, "positions are to be VEC3 of floats");
    if (const auto at = first_vertex_.find(number); at != first_vertex_.end()) {
      first = at->second;
      return true;
    }
    if (!fits(positions.count, 0)) return false;
    first = mesh_.vertex_count();
    first_vertex_[number] = first;
    const bool moves = !placed.is_identity();
    for (std::size_t i = 0; i < positions.count; ++i) {
      Point3 p{positions.number(i, 0), positions.number(i, 1), positions.number(i, 2)};
      if (moves) p = placed.of(p);
      if (!options_.keep_faults && !mesh::is_finite(p))
        return document_.fail(where, "position " + std::to_string(i) + " is not finite");
      mesh_.positions.push_back(p);
    }
    return true;
  }

  bool faces(std::size_t vertices, const GltfAccessor& indices, std::uint64_t mode, Index first,
             bool mirrored, const std::string& where) {
    const std::size_t count = indices.data != nullptr ? indices.count : vertices;
    if (mode == 4 && count % 3 != 0)
      return document_.fail(where, std::to_string(count) + " corners are no triangles");
    const std::size_t triangles = mode == 4 ? count / 3 : count < 3 ? 0 : count - 2;
    if (!fits(0, 3 * triangles)) return false;
    for (std::size_t t = 0; t < triangles; ++t) {
      std::array<std::size_t, 3> at{3 * t, 3 * t + 1, 3 * t + 2};
      if (mode == 5) at = {t, t + 1 + t % 2, t + 2 - t % 2};  // every other is turned over
      if (mode == 6) at = {0, t + 1, t + 2};
      std::array<Index, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t v = indices.data != nullptr ? indices.whole(at[k]) : at[k];
        if (v >= vertices && !options_.keep_faults)
          return document_.fail(where, "index " + std::to_string(v) + " at place " +
                                           std::to_string(at[k]) + " is out of range: there are " +
                                           count_of(vertices, "vertex", "vertices"));
        corners[k] =
            v < vertices ? first + static_cast<Index>(v) : std::numeric_limits<Index>::min();
      }
      const bool meets_twice =
          corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
      if (mode == 5 && meets_twice) continue;  // these only lead from one strip to the next
      if (mirrored) std::swap(corners[1], corners[2]);
      mesh_.corners.insert(mesh_.corners.end(), corners.begin(), corners.end());
      mesh_.face_begin.push_back(static_cast<Index>(mesh_.corners.size()));
    }
    return true;
  }

  static constexpr double kSmall = 1e7;  // bytes that are not worth asking for

  struct Placement {
    std::uint64_t mesh;
    Transform placed;
  };

  GltfDocument document_;
  const ReadOptions options_;
  MeshFile& file_;
  Polygons& mesh_;
  Remarks remarks_;
  GltfAttributes attributes_;
  std::map<std::uint64_t, Index> first_vertex_;  ///< by accessor, of the mesh that is placed
  std::map<std::uint64_t, double> needed_by_;    ///< bytes of each mesh, placed once
  std::vector<Placement> placements_;            ///< in the order in which nodes are met
  double needed_ = 0;                            ///< bytes of all
};

}  // namespace

Status parse_gltf(std::string_view content, const ReadOptions& options, MeshFile& mesh) {
  return GltfReader(content, options, mesh).read();
}

}  // namespace limn::io
