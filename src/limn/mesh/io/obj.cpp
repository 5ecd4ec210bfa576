/// Wavefront OBJ: `v`, `f` and the tags `t` are read, and what vertices, corners and faces carry
/// where that is asked for; all else is left out.

#include <algorithm>
#include <cstdint>
#include <iterator>

#include "limn/mesh/io/blocks.h"
#include "limn/mesh/io/formats.h"
#include "limn/mesh/io/obj_attributes.h"
#include "limn/mesh/io/obj_tags.h"
#include "limn/mesh/io/text_writer.h"

namespace limn::io {
namespace {

/// Those of the manual [Wavefront, appendix B1], and OpenSubdiv's tags.
constexpr std::string_view kKeywords[] = {
    "v",     "vt",    "vn",   "vp",     "f",        "fo",       "l",      "p",          "g",
    "o",     "s",     "mg",   "usemtl", "mtllib",   "usemap",   "maplib", "curv",       "curv2",
    "surf",  "parm",  "trim", "hole",   "scrv",     "sp",       "end",    "con",        "cstype",
    "deg",   "bmat",  "step", "bevel",  "c_interp", "d_interp", "lod",    "shadow_obj", "trace_obj",
    "ctech", "stech", "t",    "call",   "csh"};

struct Kind {
  std::string_view keyword, what;
};
constexpr Kind kLeftOut[] = {
    {"vt", "texture coordinates ('vt')"},
    {"vn", "normals ('vn')"},
    {"vp", "points of parameter space ('vp')"},
    {"l", "lines ('l')"},
    {"p", "points ('p')"},
    {"g", "groups ('g')"},
    {"o", "object names ('o')"},
    {"s", "smoothing groups ('s')"},
    {"usemtl", "materials of faces ('usemtl')"},
    {"mtllib", "names of material files ('mtllib')"},
};

class ObjReader {
 public:
  ObjReader(std::string_view content, const ReadOptions& options, MeshFile& file)
      : in_(content, file.source.file,
            {.comments = true, .non_finite = options.keep_faults, .continuation = true}),
        options_(options),
        remarks_(file),
        attributes_(in_, remarks_, file),
        mesh_(file.polygons),
        source_(file.source),
        tags_(file.tags) {}

  Status read() {
    source_.first = 1;
    tags_.file = source_.file;
    while (in_.next_content() && !is_padding(in_.rest())) {
      if (!statement()) return in_.error();
      in_.skip_line(is_obj_keyword);
    }
    if (!check_end()) return in_.error();
    if (options_.attributes && !attributes_.finish()) return in_.error();
    return Done{};
  }

 private:
  bool statement() {
    const std::string_view keyword = in_.take_word();
    if (keyword == "v") return vertex();
    if (keyword == "f") return face();
    if (keyword == "t") return tag();
    if (options_.attributes) {
      bool taken = false;
      if (!attributes_.statement(keyword, taken)) return false;
      if (taken) return true;
    }
    return other(keyword);
  }

  bool vertex() {
    const Place place = in_.last_place();
    double numbers[7];
    int count = 0;
    while (in_.line_has_more() && count < 7) {
      if (!in_.read_number(numbers[count], "a coordinate")) return false;
      ++count;
    }
    if (in_.line_has_more() || count < 3 || count == 5) return bad_vertex(place, count);
    if (count >= 6 && !options_.attributes) remarks_.left_out(place, "vertex colours", "vertices");
    if (count == 4 && numbers[3] != 1.0) {
      remarks_.left_out(place, "weights w other than 1", "vertices");
    }
    if (mesh_.positions.size() == mesh::kMostElements) {
      return in_.fail(place, "2^31 - 1 vertices or more");
    }
    mesh_.positions.push_back({numbers[0], numbers[1], numbers[2]});
    source_.vertex_lines.push_back(place.line);
    if (options_.attributes) attributes_.add_colour(numbers + 3, count >= 6 ? count - 3 : 0);
    return true;
  }

  bool bad_vertex(Place place, int count) {
    if (count < 3) {
      return in_.fail(in_.place(),
                      "expected three coordinates of the vertex, found the end of "
                      "the line after " +
                          std::to_string(count));
    }
    const std::string found = in_.line_has_more() ? "more than seven" : std::to_string(count);
    return in_.fail(place,
                    "a vertex of " + found + " numbers, expected x y z, x y z w or x y z r g b");
  }

  bool face() {
    const Place place = in_.last_place();
    const std::size_t begin = mesh_.corners.size();
    while (in_.line_has_more()) {
      if (!corner()) return false;
    }
    const auto degree = static_cast<std::int64_t>(mesh_.corners.size() - begin);
    if (degree < least_corners(options_))
      return in_.fail(place, small_face(degree), kSmallFaceHint);
    mesh_.face_begin.push_back(static_cast<Index>(mesh_.corners.size()));
    source_.face_lines.push_back(place.line);
    return !options_.attributes || attributes_.end_face(place, static_cast<std::size_t>(degree));
  }

  /// One of v, v/t, v//n, v/t/n; indices from 1, or from -1 backwards.
  bool corner() {
    const std::string_view word = in_.take_word();
    const char* const end = word.data() + word.size();
    std::int64_t index = 0;
    const char* rest = parse_integer(word.data(), end, index);
    if (rest == nullptr || !is_attribute_list(rest, end)) {
      return in_.fail(in_.last_place(),
                      "expected a corner like 1, 1/2, 1//3 or 1/2/3, found " + in_quotes(word));
    }
    const auto vertices = static_cast<std::int64_t>(mesh_.positions.size());
    if ((index == 0 || index < -vertices) && !options_.keep_faults)
      return bad_index(word, in_.last_place());
    // 0 counts as the one before the first
    const std::int64_t vertex = index >= 0 ? index - 1 : vertices + index;
    if (vertex > last_vertex_) {
      last_vertex_ = vertex;
      last_vertex_place_ = in_.last_place();
    }
    if (mesh_.corners.size() == mesh::kMostElements) {
      return in_.fail(in_.last_place(), "2^31 - 1 corners or more");
    }
    mesh_.corners.push_back(to_index(vertex));
    return !options_.attributes ||
           attributes_.corner(word, {rest, static_cast<std::size_t>(end - rest)});
  }

  /// Up to two of "/", "/number".
  static bool is_attribute_list(const char* p, const char* end) {
    std::int64_t ignored = 0;
    for (int k = 0; k < 2 && p != end && *p == '/'; ++k) {
      ++p;
      if (p != end && *p != '/') p = parse_integer(p, end, ignored);
      if (p == nullptr) return false;
    }
    return p == end;
  }

  bool bad_index(std::string_view word, Place place) {
    const std::string_view index = word.substr(0, word.find('/'));
    if (index.find_first_not_of("+-0") == std::string_view::npos) {
      return in_.fail(place, "vertex index 0, expected 1 or more", "OBJ counts from 1");
    }
    return in_.fail(
        place, "vertex index " + std::string(index.substr(0, 40)) + " is out of range: " +
                   count_of(mesh_.positions.size(), "vertex", "vertices") + " before this line");
  }

  bool tag() {
    const Place place = in_.last_place();
    std::string unknown;
    if (!read_obj_tag(in_, tags_, unknown)) return false;
    if (!unknown.empty())
      remarks_.left_out(place, "tags " + in_quotes(unknown) + " ('t')", "lines");
    return true;
  }

  bool other(std::string_view keyword) {
    for (const char c : keyword) {
      if (static_cast<unsigned char>(c) > 0x20 && static_cast<unsigned char>(c) != 0x7f) continue;
      return in_.fail(in_.last_place(), "expected an OBJ keyword, found " + in_quotes(keyword),
                      "is this a binary file?");
    }
    const auto known = std::find_if(std::begin(kLeftOut), std::end(kLeftOut),
                                    [&](const Kind& kind) { return kind.keyword == keyword; });
    remarks_.left_out(
        in_.last_place(),
        known != std::end(kLeftOut) ? std::string(known->what) : "statements " + in_quotes(keyword),
        "lines");
    return true;
  }

  /// A face may come before its vertices; only now is it known which are missing.
  bool check_end() {
    if (std::string fault = emptiness(mesh_); !fault.empty()) return in_.fail(in_.place(), fault);
    const auto vertices = static_cast<std::int64_t>(mesh_.positions.size());
    if (last_vertex_ < vertices || options_.keep_faults) return true;
    return in_.fail(last_vertex_place_, "vertex index " + std::to_string(last_vertex_ + 1) +
                                            " is out of range: the "
                                            "file has " +
                                            count_of(mesh_.positions.size(), "vertex", "vertices"));
  }

  TextScanner in_;
  const ReadOptions options_;
  Remarks remarks_;
  ObjAttributes attributes_;
  Polygons& mesh_;
  MeshSource& source_;
  SharpnessTags& tags_;
  std::int64_t last_vertex_ = -1;  ///< the largest index seen
  Place last_vertex_place_;
};

}  // namespace

bool is_obj_keyword(std::string_view word) {
  return std::find(std::begin(kKeywords), std::end(kKeywords), word) != std::end(kKeywords);
}

Status parse_obj(std::string_view content, const ReadOptions& options, MeshFile& mesh) {
  return ObjReader(content, options, mesh).read();
}

namespace {

void write_vertices(const Polygons& mesh, const MeshAttributes& attributes,
                    const base::Sink& sink) {
  const ColourColumns colour = colour_of(attributes);
  write_blocks(mesh.vertex_count(), sink, [&](Index first, Index last, std::string& out) {
    for (Index v = first; v < last; ++v) {
      out += "v ";
      append(out, mesh.positions[static_cast<std::size_t>(v)]);
      for (const VertexNumbers* column : colour.column) {
        if (column == nullptr) continue;
        out += ' ';
        append(out, column->values[static_cast<std::size_t>(v)] / full_intensity(column->type));
      }
      out += '\n';
    }
  });
}

void write_texture_points(const TextureCoordinates& texture, const base::Sink& sink) {
  write_blocks(static_cast<Index>(texture.points.size()), sink,
               [&](Index first, Index last, std::string& out) {
                 for (Index i = first; i < last; ++i) {
                   const TexturePoint& point = texture.points[static_cast<std::size_t>(i)];
                   out += "vt ";
                   append(out, point.u);
                   out += ' ';
                   append(out, point.v);
                   out += '\n';
                 }
               });
}

/// v, v/vt, v//vn or v/vt/vn.
void append_corner(std::string& out, Index vertex, Index point, Index normal) {
  out += ' ';
  append(out, vertex + 1);
  if (point != kNone) {
    out += '/';
    append(out, point + 1);
  }
  if (normal == kNone) return;
  out += point != kNone ? "/" : "//";
  append(out, normal + 1);
}

}  // namespace

void format_obj(const Polygons& mesh, const WriteOptions& options, const base::Sink& sink) {
  const MeshAttributes& attributes = options.attributes;
  const TextureCoordinates& texture = attributes.texture;
  if (const std::string head = obj_head_lines(attributes); !head.empty()) sink(head);
  write_vertices(mesh, attributes, sink);
  write_texture_points(texture, sink);
  write_blocks(static_cast<Index>(options.normals.size()), sink,
               [&](Index first, Index last, std::string& out) {
                 for (Index i = first; i < last; ++i) {
                   out += "vn ";
                   append(out, options.normals[static_cast<std::size_t>(i)]);
                   out += '\n';
                 }
               });
  const auto normal_of = [&](Index c) {
    if (options.normals.empty()) return kNone;
    return options.normal_of_corner.empty() ? mesh.corners[c] : options.normal_of_corner[c];
  };
  write_blocks(mesh.face_count(), sink, [&](Index first, Index last, std::string& out) {
    for (Index face = first; face < last; ++face) {
      append_obj_names(out, attributes, face > 0 ? face - 1 : kNone, face);
      out += 'f';
      for (Index c = mesh.face_begin[face]; c < mesh.face_begin[face + 1]; ++c)
        append_corner(out, mesh.corners[c], texture.empty() ? kNone : texture.of_corner[c],
                      normal_of(c));
      out += '\n';
    }
  });
  if (const std::string tags = obj_tag_lines(options.tags); !tags.empty()) sink(tags);
}

}  // namespace limn::io
