/// STL: ascii and binary are read, binary is written. Corners whose coordinates are equal are one
/// vertex, numbered as first met; -0 is +0, but coordinates that an exporter rounded differently
/// stay apart. A facet that does not have three corners then, or whose corners lie on a line, is
/// dropped, with a warning.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "limn/mesh/finite_point.h"
#include "limn/mesh/io/blocks.h"
#include "limn/mesh/io/bytes.h"
#include "limn/mesh/io/formats.h"
#include "limn/mesh/io/stl_slivers.h"

namespace limn::io {
namespace {

constexpr std::size_t kHeadSize = 84;      // 80 bytes of comment, the count of triangles
constexpr std::size_t kTriangleSize = 50;  // normal, three corners, two bytes of attributes

std::uint64_t size_for(std::uint32_t triangles) {
  return kHeadSize + std::uint64_t{kTriangleSize} * triangles;
}

/// As every coordinate is kept: one zero, so that equal coordinates have equal bits.
double without_sign_of_zero(double x) { return x + 0.0; }

/// Gives every distinct point an index: open addressing, with linear probing. No coordinate is -0.
class Merger {
 public:
  explicit Merger(Polygons& mesh) : mesh_(mesh), slots_(64, kNone) {}

  Index index_of(Point3 point) {
    if (2 * mesh_.positions.size() >= slots_.size()) grow();
    Index& slot = find(point);
    if (slot == kNone) {
      slot = mesh_.vertex_count();
      mesh_.positions.push_back(point);
    }
    return slot;
  }

 private:
  static_assert(sizeof(Point3) == 3 * sizeof(double), "points are compared as bytes");

  static std::uint64_t hash(Point3 point) {
    std::uint64_t words[3];
    std::memcpy(words, &point, sizeof(words));
    std::uint64_t h = 0;
    for (const std::uint64_t word : words) {
      h = (h ^ word) * 0x9E3779B97F4A7C15u;
      h ^= h >> 32;
    }
    return h;
  }

  Index& find(Point3 point) {
    std::size_t k = hash(point) & (slots_.size() - 1);
    while (slots_[k] != kNone && mesh_.positions[slots_[k]] != point) {
      k = (k + 1) & (slots_.size() - 1);
    }
    return slots_[k];
  }

  void grow() {
    slots_.assign(2 * slots_.size(), kNone);
    for (Index v = 0; v < mesh_.vertex_count(); ++v) find(mesh_.positions[v]) = v;
  }

  Polygons& mesh_;
  std::vector<Index> slots_;
};

/// Takes the facets of a file, in order.
class Facets {
 public:
  explicit Facets(MeshFile& file) : file_(file), mesh_(file.polygons), merger_(mesh_) {}

  void reserve(std::size_t count) {
    mesh_.face_begin.reserve(count + 1);
    numbers_.reserve(count);
    mesh_.corners.reserve(3 * count);
  }
  /// Whether there is room for one more.
  [[nodiscard]] bool full() const { return mesh_.corners.size() > mesh::kMostElements - 3; }

  /// `line`: 0 in a binary file.
  void add(Point3 a, Point3 b, Point3 c, int line) {
    if (line > 0) file_.source.face_lines.push_back(line);
    const Index number = met_++;
    for (Point3* p : {&a, &b, &c}) {
      *p = {without_sign_of_zero(p->x), without_sign_of_zero(p->y), without_sign_of_zero(p->z)};
    }
    if (a == b || b == c || c == a) {
      file_.dropped.push_back(number);
      return coincident_.add(number, line);
    }
    if (mesh::is_finite(a) && mesh::is_finite(b) && mesh::is_finite(c) && lie_on_a_line(a, b, c)) {
      collinear_.add(number, line);
      slivers_.push_back(mesh_.face_count());
    }
    for (const Point3& p : {a, b, c}) mesh_.corners.push_back(merger_.index_of(p));
    mesh_.face_begin.push_back(static_cast<Index>(mesh_.corners.size()));
    numbers_.push_back(number);
  }

  /// Precondition: no `add` follows.
  void finish() {
    const std::size_t cut = slivers_.empty() ? 0 : without_slivers();
    if (mesh_.face_count() < met_) file_.source.file_faces = std::move(numbers_);
    warn(coincident_, "two of its corners are one place", "two of their corners are one place", "");
    warn(collinear_, "its corners lie on a line", "their corners lie on a line",
         cut == 0 ? ""
                  : "; " + count_of(cut, "facet that met", "facets that met") + " the whole line " +
                        (cut == 1 ? "is" : "are") +
                        " cut at the corner between, so that no crack opens");
  }

  /// Why there is no mesh, after `finish`; or nothing.
  [[nodiscard]] std::string emptiness() const {
    if (met_ == 0 || mesh_.face_count() > 0) return io::emptiness(mesh_);
    return "the mesh has no faces: the corners of no facet are three places off a line";
  }

 private:
  struct Dropped {
    void add(Index number, int line) {
      if (count++ > 0) return;
      first = number;
      first_line = line;
    }
    std::size_t count = 0;
    Index first = 0;
    int first_line = 0;
  };

  void warn(const Dropped& dropped, const char* why_one, const char* why_many,
            const std::string& besides) {
    if (dropped.count == 0) return;
    const bool one = dropped.count == 1;
    std::string message = count_of(dropped.count, "facet", "facets") + " dropped: ";
    message += one ? why_one : why_many;
    message += std::string(" (") + (one ? "" : "the first is ") + "facet " +
               std::to_string(dropped.first) + ", counted from 0)" + besides;
    Remarks(file_).warn({dropped.first_line, 0}, std::move(message));
  }

  /// Leaves them out, and vertices that no other facet has. Returns how many facets were cut.
  std::size_t without_slivers() {
    const SliverRemoval removal = take_out_slivers(mesh_, slivers_);
    Polygons kept;
    std::vector<Index> numbers, new_index(mesh_.positions.size(), kNone);
    for (Index face = 0; face < mesh_.face_count(); ++face) {
      if (removal.removed[face] != 0) {
        file_.dropped.push_back(numbers_[face]);
        continue;
      }
      for (Index c = mesh_.face_begin[face]; c < mesh_.face_begin[face + 1]; ++c) {
        Index& index = new_index[mesh_.corners[c]];
        if (index == kNone) {
          index = kept.vertex_count();
          kept.positions.push_back(mesh_.positions[mesh_.corners[c]]);
        }
        kept.corners.push_back(index);
      }
      kept.face_begin.push_back(static_cast<Index>(kept.corners.size()));
      numbers.push_back(numbers_[face]);
    }
    std::sort(file_.dropped.begin(), file_.dropped.end());
    mesh_ = std::move(kept);
    numbers_ = std::move(numbers);
    return removal.cut;
  }

  MeshFile& file_;
  Polygons& mesh_;
  Merger merger_;
  Index met_ = 0;
  std::vector<Index> numbers_;  ///< of the faces of the mesh, in the file
  Dropped coincident_, collinear_;
  std::vector<Index> slivers_;  ///< faces of the mesh whose corners lie on a line
};

class StlTextReader {
 public:
  StlTextReader(std::string_view content, const ReadOptions& options, MeshFile& file)
      : in_(content, file.source.file, {.non_finite = options.keep_faults}),
        file_(file),
        facets_(file) {}

  Status read() {
    // Several solids may follow each other; they are one mesh.
    int solids = 0;
    Place second;
    for (; in_.next_content() && !is_padding(in_.rest()); ++solids) {
      if (solids == 1) second = in_.place();
      if (!solid()) return in_.error();
    }
    facets_.finish();
    if (const std::string fault = facets_.emptiness(); !fault.empty()) {
      in_.fail(in_.place(), fault);
      return in_.error();
    }
    if (solids > 1) {
      Remarks(file_).left_out(second, "which facets form a solid", "solids",
                              static_cast<std::size_t>(solids));
    }
    return Done{};
  }

 private:
  static bool is_word(std::string_view word, std::string_view lower) {
    if (word.size() != lower.size()) return false;
    for (std::size_t k = 0; k < word.size(); ++k) {
      const char c = word[k] >= 'A' && word[k] <= 'Z' ? static_cast<char>(word[k] + 32) : word[k];
      if (c != lower[k]) return false;
    }
    return true;
  }

  /// Words may be spread over lines in any way.
  bool take(const char* expected) {
    if (!in_.next_content()) {
      return in_.fail(in_.place(),
                      std::string("expected ") + expected + ", found the end of the file");
    }
    in_.take_word();
    return true;
  }

  bool expect(const char* word) {
    if (!take(word)) return false;
    if (is_word(in_.last_word(), word) || is_end_and(word)) return true;
    return in_.fail(in_.last_place(),
                    std::string("expected ") + word + ", found " + in_quotes(in_.last_word()));
  }

  /// Whether the word that was taken is "end" and the rest of `word`, as "end solid", which some
  /// programs write, follows; it is taken then.
  bool is_end_and(std::string_view word) {
    if (!word.starts_with("end") || !is_word(in_.last_word(), "end")) return false;
    return in_.next_content() && is_word(in_.take_word(), word.substr(3));
  }

  bool solid() {
    if (!expect("solid")) return false;
    in_.skip_line();  // the name
    for (;;) {
      if (!take("facet or endsolid")) return false;
      if (is_word(in_.last_word(), "endsolid") || is_end_and("endsolid")) break;
      if (!is_word(in_.last_word(), "facet")) {
        return in_.fail(in_.last_place(),
                        "expected facet or endsolid, found " + in_quotes(in_.last_word()));
      }
      if (!facet()) return false;
    }
    in_.skip_line();
    return true;
  }

  bool facet() {
    const int line = in_.last_place().line;
    if (!expect("normal")) return false;
    // Not used, and often wrong or nan: the corners tell the orientation.
    for (int k = 0; k < 3; ++k) {
      if (!take("a component of the normal")) return false;
    }
    if (!expect("outer") || !expect("loop")) return false;
    Point3 corners[3];
    for (Point3& p : corners) {
      if (!expect("vertex") || !number(p.x, "the x coordinate") ||
          !number(p.y, "the y coordinate") || !number(p.z, "the z coordinate")) {
        return false;
      }
    }
    if (facets_.full()) return in_.fail(in_.last_place(), "2^31 - 1 corners or more");
    facets_.add(corners[0], corners[1], corners[2], line);
    return expect("endloop") && expect("endfacet");
  }

  bool number(double& value, const char* what) {
    in_.next_content();
    return in_.read_number(value, what);
  }

  TextScanner in_;
  MeshFile& file_;
  Facets facets_;
};

Status parse_binary(std::string_view content, const ReadOptions& options, MeshFile& file) {
  const auto fail = [&file](std::string message, std::size_t byte) {
    return Error{std::move(message) + " at byte " + std::to_string(byte), "", file.source.file, 0,
                 0};
  };
  if (content.size() < kHeadSize) {
    return fail("expected the 84 bytes of a binary STL head, found the end of the file",
                content.size());
  }
  const auto count = load_little<std::uint32_t>(content.data() + kHeadSize - 4);
  const std::uint64_t expected = size_for(count);
  const bool longer = content.size() > expected;
  if (content.size() < expected ||
      (longer && !is_padding(content.substr(static_cast<std::size_t>(expected))))) {
    return fail("a binary STL file of " + count_of(count, "triangle", "triangles") + " has " +
                    std::to_string(expected) + " bytes, this one " +
                    std::to_string(content.size()) + "; the count is",
                kHeadSize - 4);
  }
  if (count == 0) return fail("the mesh has no faces: the count is 0", kHeadSize - 4);
  if (count > mesh::kMostElements / 3) return fail("2^31 - 1 corners or more", kHeadSize - 4);

  Facets facets(file);
  facets.reserve(count);
  std::size_t attributes = 0;
  for (std::size_t triangle = 0; triangle < count; ++triangle) {
    const std::size_t begin = kHeadSize + kTriangleSize * triangle + 12;
    Point3 corners[3];
    std::size_t at = begin;
    for (Point3& p : corners) {
      for (double* x : {&p.x, &p.y, &p.z}) {
        *x = double{load_little<float>(content.data() + at)};
        if (!std::isfinite(*x) && !options.keep_faults)
          return fail("a coordinate is not finite", at);
        at += 4;
      }
    }
    if (load_little<std::uint16_t>(content.data() + at) != 0) ++attributes;
    facets.add(corners[0], corners[1], corners[2], 0);
  }
  facets.finish();
  if (const std::string fault = facets.emptiness(); !fault.empty())
    return Error{fault, "", file.source.file, 0, 0};
  if (longer) {
    Remarks(file).warn({}, padding_remark(content.size() - static_cast<std::size_t>(expected)) +
                               " at byte " + std::to_string(expected));
  }
  if (attributes > 0) Remarks(file).left_out({}, "attributes (colours)", "facets", attributes);
  return Done{};
}

/// Of length 1, or zero where the triangle has no area.
Point3 face_normal(Point3 a, Point3 b, Point3 c) {
  const Point3 u = b - a, v = c - a;
  const Point3 n = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double length = std::hypot(n.x, n.y, n.z);
  return length > 0 && std::isfinite(length) ? (1 / length) * n : Point3{};
}

/// The point as the file keeps it; the normal belongs to the triangle in the file.
Point3 rounded(Point3 p) {
  return {double{static_cast<float>(p.x)}, double{static_cast<float>(p.y)},
          double{static_cast<float>(p.z)}};
}

char* store(char* to, Point3 p) {
  for (const double x : {p.x, p.y, p.z}) {
    to = store_little(to, static_cast<float>(without_sign_of_zero(x)));
  }
  return to;
}

}  // namespace

bool has_size_of_binary_stl(std::string_view content) {
  return content.size() >= kHeadSize &&
         content.size() == size_for(load_little<std::uint32_t>(content.data() + kHeadSize - 4));
}

/// Binary files may begin with "solid" too, so the size decides first; a binary file of the wrong
/// size still has a NUL near its head, as the attributes of its triangles are 0 as a rule. (A whole
/// text may be padded with them.)
bool is_binary_stl(std::string_view content) {
  if (has_size_of_binary_stl(content)) return true;
  const std::string_view padless = content.substr(0, content.find_last_not_of('\0') + 1);
  const bool is_text =
      content.starts_with("solid") && padless.find("endsolid") != std::string_view::npos;
  return (is_text ? padless : content).substr(0, 1024).find('\0') != std::string_view::npos;
}

Status parse_stl(std::string_view content, const ReadOptions& options, MeshFile& mesh) {
  return is_binary_stl(content) ? parse_binary(content, options, mesh)
                                : StlTextReader(content, options, mesh).read();
}

void format_stl(const Polygons& mesh, const WriteOptions&, const base::Sink& sink) {
  // Must not begin with "solid".
  std::string head = "binary STL by limn";
  head.resize(kHeadSize);
  store_little(head.data() + kHeadSize - 4, static_cast<std::uint32_t>(triangle_count(mesh)));
  sink(head);
  write_blocks(mesh.face_count(), sink, [&](Index first, Index last, std::string& out) {
    for_each_triangle(mesh, first, last, [&](Index a, Index b, Index c) {
      const Point3 p = rounded(mesh.positions[a]), q = rounded(mesh.positions[b]),
                   r = rounded(mesh.positions[c]);
      char triangle[kTriangleSize];
      char* const normal_end = store(triangle, face_normal(p, q, r));
      store_little(store(store(store(normal_end, p), q), r), std::uint16_t{0});
      out.append(triangle, kTriangleSize);
    });
  });
}

}  // namespace limn::io
