/// STL: ascii and binary are read, binary is written. Corners whose coordinates are equal bit by
/// bit are one vertex, numbered as first met; so +0 and -0 stay apart, as do coordinates that an
/// exporter rounded differently.

#include <cmath>
#include <cstdint>
#include <vector>

#include "limn/mesh/io/blocks.h"
#include "limn/mesh/io/bytes.h"
#include "limn/mesh/io/formats.h"

namespace limn::io {
namespace {

constexpr std::size_t kHeadSize = 84;      // 80 bytes of comment, the count of triangles
constexpr std::size_t kTriangleSize = 50;  // normal, three corners, two bytes of attributes

std::uint64_t size_for(std::uint32_t triangles) {
  return kHeadSize + std::uint64_t{kTriangleSize} * triangles;
}

/// Gives every distinct point an index: open addressing, with linear probing.
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

  // the bits are what is meant: +0 and -0 are different corners
  static bool same_bits(Point3 a, Point3 b) {
    return std::memcmp(&a, &b, sizeof(a)) == 0;  // NOLINT(bugprone-suspicious-memory-comparison)
  }

  Index& find(Point3 point) {
    std::size_t k = hash(point) & (slots_.size() - 1);
    while (slots_[k] != kNone && !same_bits(mesh_.positions[slots_[k]], point)) {
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

class StlTextReader {
 public:
  StlTextReader(std::string_view content, const std::string& path) : in_(content, path, {}) {}

  Result<Polygons> read() {
    // Several solids may follow each other; they are one mesh.
    while (in_.next_content()) {
      if (!solid()) return in_.error();
    }
    if (const std::string fault = emptiness(mesh_); !fault.empty()) in_.fail(in_.place(), fault);
    return mesh_.face_count() > 0 ? Result<Polygons>(std::move(mesh_)) : in_.error();
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
    if (is_word(in_.last_word(), word)) return true;
    return in_.fail(in_.last_place(),
                    std::string("expected ") + word + ", found " + in_quotes(in_.last_word()));
  }

  bool solid() {
    if (!expect("solid")) return false;
    in_.skip_line();  // the name
    for (;;) {
      if (!take("facet or endsolid")) return false;
      if (is_word(in_.last_word(), "endsolid")) break;
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
    if (!expect("normal")) return false;
    // Not used, and often wrong or nan: the corners tell the orientation.
    for (int k = 0; k < 3; ++k) {
      if (!take("a component of the normal")) return false;
    }
    if (!expect("outer") || !expect("loop")) return false;
    for (int k = 0; k < 3; ++k) {
      Point3 p;
      if (!expect("vertex") || !number(p.x, "the x coordinate") ||
          !number(p.y, "the y coordinate") || !number(p.z, "the z coordinate")) {
        return false;
      }
      if (mesh_.corners.size() == kMaxCorners) {
        return in_.fail(in_.last_place(), "more than 2^31 - 1 corners");
      }
      mesh_.corners.push_back(merger_.index_of(p));
    }
    mesh_.face_begin.push_back(static_cast<Index>(mesh_.corners.size()));
    return expect("endloop") && expect("endfacet");
  }

  bool number(double& value, const char* what) {
    in_.next_content();
    return in_.read_number(value, what);
  }

  TextScanner in_;
  Polygons mesh_;
  Merger merger_{mesh_};
};

Result<Polygons> parse_binary(std::string_view content, const std::string& path) {
  const auto fail = [&path](std::string message, std::size_t byte) {
    return Error{std::move(message) + " at byte " + std::to_string(byte), "", path, 0, 0};
  };
  if (content.size() < kHeadSize) {
    return fail("expected the 84 bytes of a binary STL head, found the end of the file",
                content.size());
  }
  const auto count = load_little<std::uint32_t>(content.data() + kHeadSize - 4);
  const std::uint64_t expected = size_for(count);
  if (content.size() != expected) {
    return fail("a binary STL file of " + count_of(count, "triangle", "triangles") + " has " +
                    std::to_string(expected) + " bytes, this one " +
                    std::to_string(content.size()) + "; the count is",
                kHeadSize - 4);
  }
  if (count == 0) return fail("the mesh has no faces: the count is 0", kHeadSize - 4);
  if (count > kMaxCorners / 3) return fail("more than 2^31 - 1 corners", kHeadSize - 4);

  Polygons mesh;
  Merger merger(mesh);
  mesh.face_begin.reserve(std::size_t{count} + 1);
  mesh.corners.reserve(3 * std::size_t{count});
  for (std::size_t triangle = 0; triangle < count; ++triangle) {
    const std::size_t corners = kHeadSize + kTriangleSize * triangle + 12;
    for (std::size_t k = 0; k < 3; ++k) {
      double xyz[3];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t at = corners + 12 * k + 4 * axis;
        xyz[axis] = double{load_little<float>(content.data() + at)};
        if (!std::isfinite(xyz[axis])) return fail("a coordinate is not finite", at);
      }
      mesh.corners.push_back(merger.index_of({xyz[0], xyz[1], xyz[2]}));
    }
    mesh.face_begin.push_back(static_cast<Index>(mesh.corners.size()));
  }
  return mesh;
}

/// Binary files may begin with "solid" too, so the size decides first; a binary file of the wrong
/// size still has a NUL near its head, as the attributes of its triangles are 0 as a rule.
bool is_binary(std::string_view content) {
  if (content.size() >= kHeadSize) {
    const auto count = load_little<std::uint32_t>(content.data() + kHeadSize - 4);
    if (content.size() == size_for(count)) return true;
  }
  return content.substr(0, 1024).find('\0') != std::string_view::npos;
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
  to = store_little(to, static_cast<float>(p.x));
  to = store_little(to, static_cast<float>(p.y));
  return store_little(to, static_cast<float>(p.z));
}

}  // namespace

Result<Polygons> parse_stl(std::string_view content, const std::string& path, Warnings*) {
  return is_binary(content) ? parse_binary(content, path) : StlTextReader(content, path).read();
}

void format_stl(const Polygons& mesh, const WriteOptions&, const Sink& sink) {
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
