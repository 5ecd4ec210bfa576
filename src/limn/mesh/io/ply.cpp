/// Stanford PLY: the positions of `vertex`, the index lists of `face` and the strips of
/// `tristrips`, and the sharpness of `edge`, are read from ascii and both binary encodings, and
/// what vertices and corners carry where that is asked for.

#include <cmath>
#include <cstdint>

#include "limn/mesh/io/formats.h"
#include "limn/mesh/io/ply_attributes.h"
#include "limn/mesh/io/ply_body.h"
#include "limn/mesh/io/ply_header.h"

namespace limn::io {
namespace {

/// That the element has one list of vertices.
bool check_index_list(TextScanner& in, const PlyElement& element) {
  int lists = 0;
  for (const PlyProperty& property : element.properties) lists += is_index_list(property) ? 1 : 0;
  if (lists == 1) return true;
  return in.fail(element.place, "element " + in_quotes(element.name) +
                                    (lists == 0 ? " has no list property 'vertex_indices' "
                                                  "or 'vertex_index'"
                                                : " has two lists of vertex indices"));
}

/// Checks that the header declares a mesh.
bool check_header(TextScanner& in, const PlyHeader& header) {
  const PlyElement* vertex = header.find("vertex");
  const PlyElement* face = header.find("face");
  const PlyElement* strips = header.find("tristrips");
  if (vertex == nullptr) return in.fail(in.last_place(), "the header has no element 'vertex'");
  if (face == nullptr && strips == nullptr) {
    return in.fail(in.last_place(), "the header has no element 'face' or 'tristrips'");
  }
  if (vertex->count == 0) return in.fail(vertex->count_place, "the mesh has no vertices");
  if ((face == nullptr || face->count == 0) && (strips == nullptr || strips->count == 0)) {
    return in.fail((face != nullptr ? face : strips)->count_place,
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
  for (const PlyElement* element : {face, strips}) {
    if (element != nullptr && !check_index_list(in, *element)) return false;
  }
  return true;
}

template <class Body>
class ElementReader {
 public:
  ElementReader(Body& body, const PlyHeader& header, const ReadOptions& options, MeshFile& file)
      : body_(body), header_(header), options_(options), file_(file), mesh_(file.polygons) {}

  bool read() {
    vertex_count_ = header_.find("vertex")->count;
    for (const PlyElement& element : header_.elements) {
      if (!check_count(element)) return false;
      if (element.name == "vertex") {
        if (!vertices(element)) return false;
      } else if (holds_faces(element)) {
        if (!faces(element)) return false;
      } else if (holds_sharpness(element)) {
        if (!edges(element)) return false;
      } else if (!skip_all(element)) {
        return false;
      }
    }
    if (options_.attributes) finish_ply_texture(header_, mesh_, file_.attributes);
    // Strips may hold no triangle.
    if (const std::string fault = emptiness(mesh_); !fault.empty()) return body_.fail(fault);
    Remarks remarks(file_);
    return body_.finish(remarks);
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
    const bool kept = element.name == "vertex" || holds_faces(element);
    return !kept || count <= mesh::kMostElements ||
           body_.fail_at(element.count_place, "2^31 - 1 or more of '" + element.name + "'");
  }

  /// Reads a value of its declared type.
  bool typed(const PlyProperty& property, double& value, const char* what) {
    return body_.read(property.type, value, what) && body_.check_type(property.type, value, what);
  }

  bool vertices(const PlyElement& element) {
    const PlyVertexLayout layout(element, header_, options_.attributes);
    mesh_.positions.reserve(static_cast<std::size_t>(element.count));
    static constexpr const char* names[3] = {"the x coordinate", "the y coordinate",
                                             "the z coordinate"};
    layout.begin(file_.attributes);
    std::vector<double> numbers(layout.size());
    for (std::int64_t number = 0; number < element.count; ++number) {
      if (!body_.begin(element, number)) return false;
      note_line(file_.source.vertex_lines);
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        const int place = layout.place(k);
        const char* const what = place < 3 ? names[std::max(place, 0)] : property.name.c_str();
        if (place < 0 ? !skip(property)
                      : !typed(property, numbers[static_cast<std::size_t>(place)], what))
          return false;
      }
      if (!body_.end()) return false;
      mesh_.positions.push_back({numbers[0], numbers[1], numbers[2]});
      layout.add(numbers, file_.attributes);
    }
    return true;
  }

  bool faces(const PlyElement& element) {
    std::vector<char> is_index;
    is_index.reserve(element.properties.size());
    for (const PlyProperty& property : element.properties) {
      is_index.push_back(is_index_list(property) ? 1 : 0);
    }
    const bool strips = element.name == "tristrips";
    const PlyProperty* const texture =
        options_.attributes && !strips ? corner_texture(element) : nullptr;
    if (texture != nullptr)
      file_.attributes.texture.type =
          texture->type == NumberType::float32 ? NumberType::float32 : NumberType::float64;
    mesh_.face_begin.reserve(static_cast<std::size_t>(element.count) + 1);
    for (std::int64_t number = 0; number < element.count; ++number) {
      if (!body_.begin(element, number)) return false;
      wedges_.clear();
      for (std::size_t k = 0; k < is_index.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        const bool read = &property == texture ? wedges(property)
                          : is_index[k] == 0   ? skip(property)
                          : strips             ? strip(property)
                                               : face(property);
        if (!read) return false;
      }
      if (texture != nullptr && !take_wedges()) return false;
      if (!body_.end()) return false;
    }
    return true;
  }

  /// The texture coordinates of a face: u and v of each corner, or nothing.
  bool wedges(const PlyProperty& property) {
    std::int64_t count = 0;
    if (!integer(property.count_type, count, "the number of texture coordinates")) return false;
    for (std::int64_t k = 0; k < count; ++k) {
      double value = 0;
      if (!typed(property, value, "a texture coordinate")) return false;
      wedges_.push_back(value);
    }
    return true;
  }
  bool take_wedges() {
    const std::size_t corners =
        mesh_.corners.size() - static_cast<std::size_t>(*(mesh_.face_begin.end() - 2));
    TextureCoordinates& texture = file_.attributes.texture;
    if (!wedges_.empty() && wedges_.size() != 2 * corners)
      return body_.fail("a face of " + std::to_string(corners) + " corners has " +
                            std::to_string(wedges_.size()) + " texture coordinates, expected " +
                            std::to_string(2 * corners) + " or none",
                        "u and v of each corner; or leave attributes out by --attributes none");
    if (wedges_.empty()) {
      texture.of_corner.resize(mesh_.corners.size(), kNone);
      return true;
    }
    for (std::size_t c = 0; c < corners; ++c) {
      texture.of_corner.push_back(static_cast<Index>(texture.points.size()));
      texture.points.push_back({wedges_[2 * c], wedges_[2 * c + 1]});
    }
    return true;
  }

  /// Those of a sharpness other than 0.
  bool edges(const PlyElement& element) {
    SharpnessTags& tags = file_.tags;
    tags.file = file_.source.file;
    tags.line = element.place.line;
    tags.column = element.place.column;
    for (std::int64_t number = 0; number < element.count; ++number) {
      std::int64_t ends[2] = {};
      double sharpness = 0;
      if (!body_.begin(element, number)) return false;
      const int line = body_.line();
      for (const PlyProperty& property : element.properties) {
        const int role = edge_role_of(property);
        const bool read = role < 0    ? skip(property)
                          : role == 2 ? typed(property, sharpness, "a sharpness")
                                      : integer(property.type, ends[role], "a vertex index") &&
                                            check_vertex(ends[role]);
        if (!read) return false;
      }
      if (sharpness < 0) return body_.fail("a sharpness below 0");
      if (!body_.end()) return false;
      if (sharpness == 0) continue;
      ++tags.statements;
      tags.creases.push_back(
          {{static_cast<Index>(ends[0]), static_cast<Index>(ends[1])}, {sharpness}, line});
    }
    return true;
  }

  void note_line(std::vector<int>& lines) {
    if (const int line = body_.line(); line > 0) lines.push_back(line);
  }

  bool face(const PlyProperty& property) {
    note_line(file_.source.face_lines);
    std::int64_t degree = 0;
    if (!integer(property.count_type, degree, "the number of corners")) return false;
    if (degree < least_corners(options_)) return body_.fail(small_face(degree), kSmallFaceHint);
    for (std::int64_t k = 0; k < degree; ++k) {
      std::int64_t vertex = 0;
      if (!integer(property.type, vertex, "a vertex index")) return false;
      if (!options_.keep_faults && !check_vertex(vertex)) return false;
      if (mesh_.corners.size() == mesh::kMostElements)
        return body_.fail("2^31 - 1 corners or more");
      mesh_.corners.push_back(to_index(vertex));
    }
    mesh_.face_begin.push_back(static_cast<Index>(mesh_.corners.size()));
    return true;
  }

  bool check_vertex(std::int64_t vertex) {
    if (vertex >= 0 && vertex < vertex_count_) return true;
    return body_.fail("vertex index " + std::to_string(vertex) +
                      " is out of range: expected 0 to " + std::to_string(vertex_count_ - 1));
  }

  /// Each vertex from the third on makes a triangle with the two before it; every other triangle
  /// is turned over. A vertex -1 ends the strip, and the next begins. Triangles that meet a vertex
  /// twice only lead from one strip to the next.
  bool strip(const PlyProperty& property) {
    std::int64_t count = 0;
    if (!integer(property.count_type, count, "the length of the strips")) return false;
    if (count < 0) return body_.fail("a list of negative length");
    std::int64_t before[2] = {};
    std::int64_t length = 0;  // of the strip that has begun
    for (std::int64_t k = 0; k < count; ++k) {
      std::int64_t vertex = 0;
      if (!integer(property.type, vertex, "a vertex index, or -1")) return false;
      if (vertex == -1 || is_unsigned_minus_one(property.type, vertex)) {
        length = 0;
        continue;
      }
      if (!check_vertex(vertex)) return false;
      const bool turned = length % 2 != 0;
      if (length >= 2 && !triangle(before[turned ? 1 : 0], before[turned ? 0 : 1], vertex)) {
        return false;
      }
      before[0] = before[1];
      before[1] = vertex;
      ++length;
    }
    return true;
  }

  /// -1 as some write it into a list of unsigned numbers; a vertex has no such number.
  static bool is_unsigned_minus_one(PlyType type, std::int64_t value) {
    return type == PlyType::uint32 && value == 0xffffffff;
  }

  bool triangle(std::int64_t a, std::int64_t b, std::int64_t c) {
    if (a == b || b == c || c == a) return true;
    if (mesh_.corners.size() > mesh::kMostElements - 3)
      return body_.fail("2^31 - 1 corners or more");
    note_line(file_.source.face_lines);
    for (const std::int64_t vertex : {a, b, c}) {
      mesh_.corners.push_back(static_cast<Index>(vertex));
    }
    mesh_.face_begin.push_back(static_cast<Index>(mesh_.corners.size()));
    return true;
  }

  /// Some files declare counts or indices as float; 2^53 bounds what a double counts exactly.
  bool integer(PlyType type, std::int64_t& value, const char* what) {
    double number = 0;
    if (!body_.read(type, number, what)) return false;
    if (!std::isfinite(number)) return body_.fail(std::string(what) + " is not finite");
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
  const ReadOptions options_;
  MeshFile& file_;
  Polygons& mesh_;
  std::int64_t vertex_count_ = 0;
  std::vector<double> wedges_;  // of the face that is read
};

template <class Body>
Status read_elements(Body body, const PlyHeader& header, const ReadOptions& options,
                     MeshFile& mesh) {
  if (ElementReader<Body>(body, header, options, mesh).read()) return Done{};
  return body.error();
}

/// Where the binary data begin, of a header that was read up to `offset`. Where lines end with CR,
/// an LF behind the last is the first byte of data.
std::size_t data_begin(std::string_view content, std::size_t offset) {
  const std::size_t end = content.find('\r');
  const bool by_cr = end < offset && content[end + 1] != '\n';
  return by_cr && content.substr(0, offset).ends_with("\r\n") ? offset - 1 : offset;
}

/// `by_word`: where one instance a line does not make sense of ascii data.
Status read_ply(std::string_view content, bool by_word, const ReadOptions& options,
                MeshFile& mesh) {
  TextScanner in(content, mesh.source.file, {.non_finite = options.keep_faults});
  PlyHeader header;
  if (!read_ply_header(in, header) || !check_header(in, header)) return in.error();
  Remarks remarks(mesh);
  remark_what_is_left_out(header, options.attributes, remarks);
  if (header.format != PlyFormat::ascii) {
    return read_elements(BinaryBody(content, data_begin(content, in.offset()), header.format,
                                    mesh.source.file, options.keep_faults),
                         header, options, mesh);
  }
  Status status = read_elements(AsciiBody(in, by_word), header, options, mesh);
  if (status || by_word) return status;
  MeshFile other;
  other.source.file = mesh.source.file;
  // Only where every word finds its place to the end of the file; else the lines tell the fault.
  if (!read_ply(content, true, options, other)) return status;
  Remarks(other).warn({status.error().line, 1},
                      "not one vertex or face a line, so read word by word");
  mesh = std::move(other);
  return Done{};
}

}  // namespace

Status parse_ply(std::string_view content, const ReadOptions& options, MeshFile& mesh) {
  return read_ply(content, false, options, mesh);
}

}  // namespace limn::io
