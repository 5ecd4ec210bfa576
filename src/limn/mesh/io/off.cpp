/// Geomview OFF, ascii, three-dimensional: OFF and the variants with vertex colours (C), normals
/// (N) and texture coordinates (ST), which are left out. One vertex or face a line.

#include <cstdint>

#include "limn/mesh/io/blocks.h"
#include "limn/mesh/io/formats.h"
#include "limn/mesh/io/text_writer.h"

namespace limn::io {
namespace {

class OffReader {
 public:
  OffReader(std::string_view content, const std::string& path, Warnings* warnings)
      : in_(content, path, {.comments = true, .continuation = false}), remarks_(warnings, path) {}

  Result<Polygons> read() {
    if (header() && counts() && vertices() && faces() && check_end()) return std::move(mesh_);
    return in_.error();
  }

 private:
  bool header() {
    if (!in_.next_content()) return in_.fail(in_.place(), "the file has no content");
    std::string_view word = in_.take_word();
    const std::string_view whole = word;
    if (!word.ends_with("OFF")) {
      return in_.fail(in_.last_place(), "expected the word OFF, found " + in_quotes(word));
    }
    word.remove_suffix(3);
    const auto take = [&word](std::string_view prefix) {
      const bool found = word.starts_with(prefix);
      if (found) word.remove_prefix(prefix.size());
      return found;
    };
    // The manual has C before N, some programs write NC.
    const bool texture = take("ST");
    const bool normals_first = take("N");
    const bool colours = take("C");
    const bool normals = take("N") || normals_first;
    if (word == "4" || word == "n" || word == "4n") {
      return in_.fail(in_.last_place(), in_quotes(whole) +
                                            " holds points of other than three "
                                            "dimensions, expected OFF, COFF, NOFF or STOFF");
    }
    if (!word.empty()) {
      return in_.fail(in_.last_place(), "unknown kind of OFF file " + in_quotes(whole));
    }
    if (texture || normals) remarks_.texture_or_normals(in_.last_place());
    if (colours) remarks_.left_out(in_.last_place(), "vertex colours are");
    has_extras_ = texture || colours || normals;
    return true;
  }

  /// On the line of the header or on the next; the count of edges may be missing.
  bool counts() {
    if (!in_.next_content())
      return in_.fail(in_.place(), "expected the count of vertices, found the end of the file");
    Count vertices{0, {}, "the count of vertices"}, faces{0, {}, "the count of faces"};
    if (!read(vertices) || !read(faces)) return false;
    std::int64_t edges = 0;
    if (in_.line_has_more() && !in_.read_integer(edges, "the count of edges")) return false;
    if (in_.line_has_more()) {
      in_.take_word();
      return in_.fail(in_.last_place(), "expected the end of the line of counts, found " +
                                            in_quotes(in_.last_word()));
    }
    vertex_count_ = vertices.value;
    face_count_ = faces.value;
    return check(vertices) && check(faces);
  }

  struct Count {
    std::int64_t value;
    Place place;
    const char* what;
  };

  bool read(Count& count) {
    const bool read = in_.read_integer(count.value, count.what);
    count.place = in_.last_place();
    if (!read && in_.last_word() == "BINARY") {
      return in_.fail(count.place, "binary OFF is not read", "convert it to ascii OFF or PLY");
    }
    return read;
  }

  /// Refuses a count that the rest of the file cannot hold, before anything is allocated.
  bool check(const Count& count) {
    // "0 0 0" and "3 0 1 2" with their line end: no vertex and no face is shorter.
    constexpr std::int64_t shortest = 6;
    const std::string what = count.what;
    if (count.value < 0) return in_.fail(count.place, what + " is negative");
    if (count.value > static_cast<std::int64_t>(in_.remaining()) / shortest + 1) {
      return in_.fail(count.place, what + " is " + std::to_string(count.value) +
                                       ", more than the " + std::to_string(in_.remaining()) +
                                       " bytes that follow can hold");
    }
    return count.value <= static_cast<std::int64_t>(kMaxCorners) ||
           in_.fail(count.place, what + " is 2^31 or more");
  }

  bool next_line_of(const char* kind, std::int64_t number, std::int64_t count) {
    in_.skip_line();
    if (in_.next_content()) return true;
    return in_.fail(in_.place(), "expected " + std::string(kind) + " " + std::to_string(number) +
                                     " of " + std::to_string(count) +
                                     ", found the end of the file");
  }

  bool vertices() {
    mesh_.positions.reserve(static_cast<std::size_t>(vertex_count_));
    for (std::int64_t v = 0; v < vertex_count_; ++v) {
      if (!next_line_of("vertex", v + 1, vertex_count_)) return false;
      Point3 p;
      if (!in_.read_number(p.x, "the x coordinate") || !in_.read_number(p.y, "the y coordinate") ||
          !in_.read_number(p.z, "the z coordinate")) {
        return false;
      }
      // Many write colours under a plain OFF.
      if (!has_extras_ && in_.line_has_more()) {
        remarks_.left_out(in_.place(), "numbers behind the coordinates of vertices are");
      }
      mesh_.positions.push_back(p);
    }
    return true;
  }

  bool faces() {
    mesh_.face_begin.reserve(static_cast<std::size_t>(face_count_) + 1);
    for (std::int64_t f = 0; f < face_count_; ++f) {
      if (!next_line_of("face", f + 1, face_count_) || !face()) return false;
    }
    return true;
  }

  /// The degree and the indices; what follows on the line is a colour.
  bool face() {
    std::int64_t degree = 0;
    if (!in_.read_integer(degree, "the number of corners")) return false;
    if (degree < 3) {
      return in_.fail(in_.last_place(),
                      "a face of " + std::to_string(degree) + " corners, expected three or more");
    }
    for (std::int64_t k = 0; k < degree; ++k) {
      std::int64_t vertex = 0;
      if (!in_.read_integer(vertex, "a vertex index")) return false;
      if (vertex < 0 || vertex >= vertex_count_) {
        return in_.fail(in_.last_place(), "vertex index " + std::to_string(vertex) +
                                              " is out of range: expected 0 to " +
                                              std::to_string(vertex_count_ - 1));
      }
      if (mesh_.corners.size() == kMaxCorners) {
        return in_.fail(in_.last_place(), "more than 2^31 - 1 corners");
      }
      mesh_.corners.push_back(static_cast<Index>(vertex));
    }
    mesh_.face_begin.push_back(static_cast<Index>(mesh_.corners.size()));
    return true;
  }

  bool check_end() {
    if (std::string fault = emptiness(mesh_); !fault.empty()) return in_.fail(in_.place(), fault);
    in_.skip_line();
    if (!in_.next_content()) return true;
    return in_.fail(in_.place(),
                    "expected the end of the file after " +
                        count_of(mesh_.face_begin.size() - 1, "face", "faces") +
                        ", found more lines",
                    "are the counts at the head right?");
  }

  TextScanner in_;
  Remarks remarks_;
  Polygons mesh_;
  std::int64_t vertex_count_ = 0;
  std::int64_t face_count_ = 0;
  bool has_extras_ = false;
};

}  // namespace

Result<Polygons> parse_off(std::string_view content, const std::string& path, Warnings* warnings) {
  return OffReader(content, path, warnings).read();
}

void format_off(const Polygons& mesh, const WriteOptions& options, const Sink& sink) {
  std::string head = options.normals.empty() ? "OFF\n" : "NOFF\n";
  append(head, mesh.vertex_count());
  head += ' ';
  append(head, mesh.face_count());
  sink(head + " 0\n");
  write_blocks(mesh.vertex_count(), sink, [&](Index first, Index last, std::string& out) {
    for (Index v = first; v < last; ++v) {
      append(out, mesh.positions[v]);
      if (!options.normals.empty()) {
        out += ' ';
        append(out, options.normals[v]);
      }
      out += '\n';
    }
  });
  write_blocks(mesh.face_count(), sink, [&](Index first, Index last, std::string& out) {
    for (Index face = first; face < last; ++face) {
      append(out, mesh.degree(face));
      for (Index c = mesh.face_begin[face]; c < mesh.face_begin[face + 1]; ++c) {
        out += ' ';
        append(out, mesh.corners[c]);
      }
      out += '\n';
    }
  });
}

}  // namespace limn::io
