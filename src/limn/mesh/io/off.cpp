/// Geomview OFF, ascii, three-dimensional: OFF and the variants with vertex colours (C), normals
/// (N) and texture coordinates (ST), which are left out. One vertex or face a line; a plain OFF
/// whose lines are broken otherwise is read number by number. As data sets have it, the keyword may
/// be in lower case, glued to the first count ("OFF4 4 0", ModelNet), or missing.

#include <algorithm>
#include <cctype>
#include <cstdint>

#include "limn/mesh/io/blocks.h"
#include "limn/mesh/io/formats.h"
#include "limn/mesh/io/text_writer.h"

namespace limn::io {
namespace {

std::string upper_case(std::string_view word) {
  std::string upper(word);
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return upper;
}

class OffReader {
 public:
  OffReader(std::string_view content, const ReadOptions& options, MeshFile& file, bool by_number)
      : in_(content, file.source.file,
            {.comments = true, .non_finite = options.keep_faults, .continuation = false}),
        options_(options),
        remarks_(file),
        mesh_(file.polygons),
        source_(file.source),
        by_number_(by_number) {}

  Status read() {
    if (header() && counts() && vertices() && faces() && check_end()) return Done{};
    return in_.error();
  }
  /// Whether the fault lies in or behind the counts, and nothing but numbers is expected there.
  [[nodiscard]] bool may_read_by_number() const { return in_body_ && !has_extras_; }

 private:
  bool header() {
    if (!in_.next_content()) return in_.fail(in_.place(), "the file has no content");
    const std::string_view word = in_.take_word();
    const std::size_t length = off_keyword_length(word);
    in_.keep_of_last(length);
    if (length > 0) return variant(word.substr(0, length));
    std::int64_t count = 0;
    if (parse_integer(word.data(), word.data() + word.size(), count) != nullptr) return true;
    return in_.fail(in_.last_place(), "expected the word OFF, found " + in_quotes(word));
  }

  /// Of the keyword `whole`.
  bool variant(std::string_view whole) {
    const std::string_view prefix = whole.substr(0, whole.size() - 3);
    // "nOFF" is of n dimensions; "noff" is taken for NOFF in lower case.
    const bool n_dimensions = whole.ends_with("OFF") && prefix.find('n') != std::string_view::npos;
    if (n_dimensions || prefix.find('4') != std::string_view::npos) {
      return in_.fail(in_.last_place(), in_quotes(whole) +
                                            " holds points of other than three "
                                            "dimensions, expected OFF, COFF, NOFF or STOFF");
    }
    const std::string kind = upper_case(prefix);
    std::string_view rest = kind;
    const auto take = [&rest](std::string_view part) {
      const bool found = rest.starts_with(part);
      if (found) rest.remove_prefix(part.size());
      return found;
    };
    // The manual has C before N, some programs write NC.
    const bool texture = take("ST");
    const bool normals_first = take("N");
    const bool colours = take("C");
    const bool normals = take("N") || normals_first;
    if (!rest.empty()) {
      return in_.fail(in_.last_place(), "unknown kind of OFF file " + in_quotes(whole));
    }
    const auto left_out = [&](bool there, const char* what) {
      if (there) extras_.emplace_back(what);
    };
    left_out(texture, "texture coordinates");
    left_out(normals, "normals");
    left_out(colours, "vertex colours");
    has_extras_ = !extras_.empty();
    keyword_place_ = in_.last_place();
    return true;
  }

  /// On the line of the header or on the next; the count of edges may be missing.
  bool counts() {
    if (!in_.next_content())
      return in_.fail(in_.place(), "expected the count of vertices, found the end of the file");
    in_body_ = true;
    Count vertices{0, {}, "the count of vertices"}, faces{0, {}, "the count of faces"};
    if (!read(vertices) || !read(faces)) return false;
    // Counts on several lines are three; on one line the third may be missing.
    const bool spread = vertices.place.line != faces.place.line;
    Count edges{0, {}, "the count of edges"};
    if ((spread || in_.line_has_more()) && !read(edges)) return false;
    if (!by_number_ && in_.line_has_more()) {
      in_.take_word();
      return in_.fail(in_.last_place(), "expected the end of the line of counts, found " +
                                            in_quotes(in_.last_word()));
    }
    vertex_count_ = vertices.value;
    face_count_ = faces.value;
    if (!check(vertices) || !check(faces)) return false;
    for (const char* what : extras_) {
      remarks_.left_out(keyword_place_, what, "vertices", static_cast<std::size_t>(vertex_count_));
    }
    return true;
  }

  struct Count {
    std::int64_t value;
    Place place;
    const char* what;
  };

  bool read(Count& count) {
    const bool read = integer(count.value, count.what);
    count.place = in_.last_place();
    if (!read && upper_case(in_.last_word()) == "BINARY") {
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
    return count.value <= static_cast<std::int64_t>(mesh::kMostElements) ||
           in_.fail(count.place, what + " is 2^31 - 1 or more");
  }

  bool next_line_of(const char* kind, std::int64_t number, std::int64_t count) {
    if (!by_number_) in_.skip_line();
    if (in_.next_content()) return true;
    return in_.fail(in_.place(), "expected " + std::string(kind) + " " + std::to_string(number) +
                                     " of " + std::to_string(count) +
                                     ", found the end of the file");
  }

  bool number(double& value, const char* what) {
    if (by_number_) in_.next_content();
    return in_.read_number(value, what);
  }
  bool integer(std::int64_t& value, const char* what) {
    if (by_number_) in_.next_content();
    return in_.read_integer(value, what);
  }

  bool vertices() {
    mesh_.positions.reserve(static_cast<std::size_t>(vertex_count_));
    for (std::int64_t v = 0; v < vertex_count_; ++v) {
      if (!next_line_of("vertex", v + 1, vertex_count_)) return false;
      source_.vertex_lines.push_back(in_.place().line);
      Point3 p;
      if (!number(p.x, "the x coordinate") || !number(p.y, "the y coordinate") ||
          !number(p.z, "the z coordinate")) {
        return false;
      }
      // Many write colours under a plain OFF.
      if (!has_extras_ && !by_number_ && in_.line_has_more()) {
        remarks_.left_out(in_.place(), "numbers behind the coordinates", "vertices");
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
    source_.face_lines.push_back(in_.place().line);
    std::int64_t degree = 0;
    if (!integer(degree, "the number of corners")) return false;
    if (degree < least_corners(options_))
      return in_.fail(in_.last_place(), small_face(degree), kSmallFaceHint);
    for (std::int64_t k = 0; k < degree; ++k) {
      std::int64_t vertex = 0;
      if (!integer(vertex, "a vertex index")) return false;
      if ((vertex < 0 || vertex >= vertex_count_) && !options_.keep_faults) {
        return in_.fail(in_.last_place(), "vertex index " + std::to_string(vertex) +
                                              " is out of range: expected 0 to " +
                                              std::to_string(vertex_count_ - 1));
      }
      if (mesh_.corners.size() == mesh::kMostElements) {
        return in_.fail(in_.last_place(), "2^31 - 1 corners or more");
      }
      mesh_.corners.push_back(to_index(vertex));
    }
    mesh_.face_begin.push_back(static_cast<Index>(mesh_.corners.size()));
    if (!by_number_ && in_.line_has_more()) {
      remarks_.left_out(in_.place(), "face colours", "faces");
    }
    return true;
  }

  bool check_end() {
    if (std::string fault = emptiness(mesh_); !fault.empty()) return in_.fail(in_.place(), fault);
    if (!by_number_) in_.skip_line();
    if (!in_.next_content() || is_padding(in_.rest())) return true;
    return in_.fail(in_.place(),
                    "expected the end of the file after " +
                        count_of(mesh_.face_begin.size() - 1, "face", "faces") +
                        ", found more lines",
                    "are the counts at the head right?");
  }

  TextScanner in_;
  const ReadOptions options_;
  Remarks remarks_;
  Polygons& mesh_;
  MeshSource& source_;
  bool by_number_;  ///< lines mean nothing
  bool in_body_ = false;
  std::vector<const char*> extras_;  ///< of vertices, that the keyword announces
  Place keyword_place_;
  std::int64_t vertex_count_ = 0;
  std::int64_t face_count_ = 0;
  bool has_extras_ = false;
};

}  // namespace

std::size_t off_keyword_length(std::string_view word) {
  const std::string upper = upper_case(word);
  const std::size_t at = upper.find("OFF");
  if (at == std::string::npos) return 0;
  const std::size_t length = at + 3;
  return length == word.size() || std::isdigit(static_cast<unsigned char>(word[length])) != 0
             ? length
             : 0;
}

Status parse_off(std::string_view content, const ReadOptions& options, MeshFile& mesh) {
  OffReader by_line(content, options, mesh, false);
  Status status = by_line.read();
  if (status || !by_line.may_read_by_number()) return status;
  MeshFile other;
  other.source.file = mesh.source.file;
  // Only where every number finds its place to the end of the file; else the lines tell the fault.
  if (!OffReader(content, options, other, true).read()) return status;
  Remarks(other).warn({status.error().line, 1},
                      "not one vertex or face a line, so read number by number");
  mesh = std::move(other);
  return Done{};
}

void format_off(const Polygons& mesh, const WriteOptions& options, const base::Sink& sink) {
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
