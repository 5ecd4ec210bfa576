/// Stanford PLY: the positions of `vertex` and the index lists of `face` are read from ascii and
/// both binary encodings; binary little-endian with double coordinates is written.

#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "limn/mesh/io/blocks.h"
#include "limn/mesh/io/bytes.h"
#include "limn/mesh/io/formats.h"
#include "limn/mesh/io/ply_body.h"
#include "limn/mesh/io/ply_header.h"

namespace limn::io {
namespace {

bool is_one_of(const std::string& name, std::initializer_list<const char*> names) {
  for (const char* known : names) {
    if (name == known) return true;
  }
  return false;
}

bool is_index_list(const PlyProperty& property) {
  return property.is_list && is_one_of(property.name, {"vertex_indices", "vertex_index"});
}

/// 0, 1, 2 for x, y, z; else -1.
int axis_of(const PlyProperty& property) {
  if (property.is_list) return -1;
  return property.name == "x" ? 0 : property.name == "y" ? 1 : property.name == "z" ? 2 : -1;
}

/// Checks that the header declares a mesh.
bool check_header(TextScanner& in, const PlyHeader& header) {
  const PlyElement* vertex = header.find("vertex");
  const PlyElement* face = header.find("face");
  if (vertex == nullptr) return in.fail(in.last_place(), "the header has no element 'vertex'");
  if (face == nullptr) return in.fail(in.last_place(), "the header has no element 'face'");
  if (vertex->count == 0) return in.fail(vertex->count_place, "the mesh has no vertices");
  if (face->count == 0) {
    return in.fail(face->count_place,
                   "the mesh has no faces, only " +
                       count_of(static_cast<std::size_t>(vertex->count), "vertex", "vertices"));
  }
  for (int axis = 0; axis < 3; ++axis) {
    bool found = false;
    for (const PlyProperty& property : vertex->properties) {
      found = found || axis_of(property) == axis;
    }
    if (!found) {
      return in.fail(vertex->place,
                     std::string("element 'vertex' has no scalar property '") + "xyz"[axis] + "'");
    }
  }
  int lists = 0;
  for (const PlyProperty& property : face->properties) lists += is_index_list(property) ? 1 : 0;
  if (lists == 1) return true;
  return in.fail(face->place, lists == 0 ? "element 'face' has no list property 'vertex_indices' "
                                           "or 'vertex_index'"
                                         : "element 'face' has two lists of vertex indices");
}

void remark_what_is_left_out(const PlyHeader& header, Remarks& remarks) {
  for (const PlyElement& element : header.elements) {
    const bool is_vertex = element.name == "vertex";
    const bool is_face = element.name == "face";
    if (!is_vertex && !is_face) {
      remarks.left_out(element.place, "elements " + in_quotes(element.name) + " are");
      continue;
    }
    for (const PlyProperty& property : element.properties) {
      if (is_vertex ? axis_of(property) >= 0 : is_index_list(property)) continue;
      const std::string& name = property.name;
      if (is_one_of(name,
                    {"nx", "ny", "nz", "s", "t", "u", "v", "texture_u", "texture_v", "texcoord"})) {
        remarks.texture_or_normals(property.place);
      } else if (is_one_of(name, {"red", "green", "blue", "alpha"})) {
        remarks.left_out(property.place, element.name + " colours are");
      } else {
        remarks.left_out(property.place, element.name + " property " + in_quotes(name) + " is");
      }
    }
  }
}

template <class Body>
class ElementReader {
 public:
  ElementReader(Body& body, const PlyHeader& header, Polygons& mesh)
      : body_(body), header_(header), mesh_(mesh) {}

  bool read() {
    vertex_count_ = header_.find("vertex")->count;
    for (const PlyElement& element : header_.elements) {
      if (!check_count(element)) return false;
      if (element.name == "vertex") {
        if (!vertices(element)) return false;
      } else if (element.name == "face") {
        if (!faces(element)) return false;
      } else if (!skip_all(element)) {
        return false;
      }
    }
    return body_.finish();
  }

 private:
  /// Refuses a count that the rest of the file cannot hold, before anything is allocated.
  bool check_count(const PlyElement& element) {
    std::size_t least = 0;
    for (const PlyProperty& property : element.properties) {
      least += Body::least_size(property.is_list ? property.count_type : property.type);
    }
    const auto count = static_cast<std::uint64_t>(element.count);  // size_t may have 32 bits
    if (least > 0 && count > body_.remaining() / least + 1) {
      return body_.fail_at(element.count_place, "the header declares " + std::to_string(count) +
                                                    " of '" + element.name + "', more than the " +
                                                    std::to_string(body_.remaining()) +
                                                    " bytes of data can hold");
    }
    const bool kept = element.name == "vertex" || element.name == "face";
    return !kept || count <= kMaxCorners ||
           body_.fail_at(element.count_place, "more than 2^31 - 1 of '" + element.name + "'");
  }

  bool vertices(const PlyElement& element) {
    std::vector<int> axes;
    axes.reserve(element.properties.size());
    for (const PlyProperty& property : element.properties) axes.push_back(axis_of(property));
    mesh_.positions.reserve(static_cast<std::size_t>(element.count));
    static constexpr const char* names[3] = {"the x coordinate", "the y coordinate",
                                             "the z coordinate"};
    for (std::int64_t number = 0; number < element.count; ++number) {
      double xyz[3] = {};
      if (!body_.begin(element, number)) return false;
      for (std::size_t k = 0; k < axes.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        const int axis = axes[k];
        if (axis >= 0 ? !body_.read(property.type, xyz[axis], names[axis]) : !skip(property)) {
          return false;
        }
      }
      if (!body_.end()) return false;
      mesh_.positions.push_back({xyz[0], xyz[1], xyz[2]});
    }
    return true;
  }

  bool faces(const PlyElement& element) {
    std::vector<char> is_index;
    is_index.reserve(element.properties.size());
    for (const PlyProperty& property : element.properties) {
      is_index.push_back(is_index_list(property) ? 1 : 0);
    }
    mesh_.face_begin.reserve(static_cast<std::size_t>(element.count) + 1);
    for (std::int64_t number = 0; number < element.count; ++number) {
      if (!body_.begin(element, number)) return false;
      for (std::size_t k = 0; k < is_index.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        if (is_index[k] != 0 ? !face(property) : !skip(property)) return false;
      }
      if (!body_.end()) return false;
    }
    return true;
  }

  bool face(const PlyProperty& property) {
    std::int64_t degree = 0;
    if (!integer(property.count_type, degree, "the number of corners")) return false;
    if (degree < 3) {
      return body_.fail("a face of " + std::to_string(degree) + " corners, expected three or more");
    }
    for (std::int64_t k = 0; k < degree; ++k) {
      std::int64_t vertex = 0;
      if (!integer(property.type, vertex, "a vertex index")) return false;
      if (vertex < 0 || vertex >= vertex_count_) {
        return body_.fail("vertex index " + std::to_string(vertex) +
                          " is out of range: expected 0 to " + std::to_string(vertex_count_ - 1));
      }
      if (mesh_.corners.size() == kMaxCorners) return body_.fail("more than 2^31 - 1 corners");
      mesh_.corners.push_back(static_cast<Index>(vertex));
    }
    mesh_.face_begin.push_back(static_cast<Index>(mesh_.corners.size()));
    return true;
  }

  /// Some files declare counts or indices as float; 2^53 bounds what a double counts exactly.
  bool integer(PlyType type, std::int64_t& value, const char* what) {
    double number = 0;
    if (!body_.read(type, number, what)) return false;
    if (std::abs(number) > 9007199254740992.0 || number != std::floor(number)) {
      return body_.fail(std::string(what) + " is not an integer");
    }
    value = static_cast<std::int64_t>(number);
    return true;
  }

  bool skip(const PlyProperty& property) {
    std::int64_t count = 1;
    if (property.is_list) {
      if (!integer(property.count_type, count, "the length of a list")) return false;
      if (count < 0) return body_.fail("a list of negative length");
    }
    return body_.skip(property.type, count);
  }

  bool skip_all(const PlyElement& element) {
    if (element.properties.empty()) return true;  // nothing is stored, whatever the count
    for (std::int64_t number = 0; number < element.count; ++number) {
      if (!body_.begin(element, number)) return false;
      for (const PlyProperty& property : element.properties) {
        if (!skip(property)) return false;
      }
      if (!body_.end()) return false;
    }
    return true;
  }

  Body& body_;
  const PlyHeader& header_;
  Polygons& mesh_;
  std::int64_t vertex_count_ = 0;
};

template <class Body>
Result<Polygons> read_elements(Body body, const PlyHeader& header) {
  Polygons mesh;
  if (ElementReader<Body>(body, header, mesh).read()) return mesh;
  return body.error();
}

std::string header_text(const Polygons& mesh, bool normals, bool wide) {
  std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                     std::to_string(mesh.positions.size()) +
                     "\nproperty double x\nproperty double y\nproperty double z\n";
  if (normals) text += "property double nx\nproperty double ny\nproperty double nz\n";
  text += "element face " + std::to_string(mesh.face_count());
  text += wide ? "\nproperty list int int vertex_indices\n"
               : "\nproperty list uchar int vertex_indices\n";
  return text + "end_header\n";
}

char* store(char* to, Point3 p) {
  return store_little(store_little(store_little(to, p.x), p.y), p.z);
}

}  // namespace

Result<Polygons> parse_ply(std::string_view content, const std::string& path, Warnings* warnings) {
  TextScanner in(content, path, {});
  PlyHeader header;
  if (!read_ply_header(in, header) || !check_header(in, header)) return in.error();
  Remarks remarks(warnings, path);
  remark_what_is_left_out(header, remarks);
  if (header.format == PlyFormat::ascii) return read_elements(AsciiBody(in), header);
  return read_elements(BinaryBody(content, in.offset(), header.format, path), header);
}

void format_ply(const Polygons& mesh, const WriteOptions& options, const Sink& sink) {
  const bool normals = !options.normals.empty();
  bool wide = false;  // the length of a list needs more than a byte
  for (Index face = 0; face < mesh.face_count(); ++face) wide = wide || mesh.degree(face) > 255;
  sink(header_text(mesh, normals, wide));
  write_blocks(mesh.vertex_count(), sink, [&](Index first, Index last, std::string& out) {
    out.resize(static_cast<std::size_t>(last - first) * (normals ? 48 : 24));
    char* to = out.data();
    for (Index v = first; v < last; ++v) {
      to = store(to, mesh.positions[v]);
      if (normals) to = store(to, options.normals[v]);
    }
  });
  write_blocks(mesh.face_count(), sink, [&](Index first, Index last, std::string& out) {
    const Index corners = mesh.face_begin[last] - mesh.face_begin[first];
    out.resize(static_cast<std::size_t>(last - first) * (wide ? 4 : 1) +
               static_cast<std::size_t>(corners) * 4);
    char* to = out.data();
    for (Index face = first; face < last; ++face) {
      const Index degree = mesh.degree(face);
      to = wide ? store_little(to, degree) : store_little(to, static_cast<std::uint8_t>(degree));
      for (Index c = mesh.face_begin[face]; c < mesh.face_begin[face + 1]; ++c) {
        to = store_little(to, mesh.corners[c]);
      }
    }
  });
}

}  // namespace limn::io
