#pragma once
/// The single formats behind mesh_file.h, and what their readers and writers share.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "limn/base/error.h"
#include "limn/base/files/file.h"
#include "limn/mesh/io/mesh_file.h"
#include "limn/mesh/io/text_scanner.h"
#include "limn/mesh/mesh_limits.h"
#include "limn/mesh/polygon/triangulate.h"
#include "limn/mesh/polygons.h"

namespace limn::io {

/// What a reader has to say beside the mesh: each kind once, with the place of the first and how
/// many there were.
class Remarks {
 public:
  explicit Remarks(MeshFile& out) : out_(out) {}

  /// `what` in the plural: "vertex colours"; `unit`: "lines".
  void left_out(Place place, std::string_view what, const char* unit, std::size_t count = 1) {
    LeftOut& kind = find(place, what, unit);
    kind.count += count;
  }
  void warn(Place place, std::string message) {
    out_.warnings.push_back({std::move(message), "", out_.source.file, place.line, place.column});
  }

 private:
  LeftOut& find(Place place, std::string_view what, const char* unit) {
    for (LeftOut& kind : out_.left_out) {
      if (kind.what == what) return kind;
    }
    // A file of noise has as many kinds as it has words.
    constexpr std::size_t most = 24;
    if (out_.left_out.size() > most) return out_.left_out.back();
    const bool last = out_.left_out.size() == most;
    out_.left_out.push_back(
        {last ? "statements of more kinds" : std::string(what), 0, unit, place.line, place.column});
    return out_.left_out.back();
  }

  MeshFile& out_;
};

/// Whether an extension, in any case, is this one.
bool is_extension(std::string_view extension, std::string_view known);

/// Why a mesh cannot be written; no message: it can.
struct Fault {
  std::string message, hint;
  bool of_numbers = false;  ///< whatever the file: they are not finite
};
/// That a position (a normal) is finite.
Fault position_fault(std::size_t vertex, const Point3& position);
Fault normal_fault(std::size_t vertex, const Point3& normal);
/// That attributes are finite, and at most so large.
Fault attribute_fault(const MeshAttributes& attributes, double largest);
/// What is said of a fault that there is.
Error error_of(Fault fault, const std::string& path);

/// "1 vertex", "8 vertices".
std::string count_of(std::size_t count, const char* one, const char* many);

/// Says why the mesh that was read cannot be refined at all, or nothing if it can.
std::string emptiness(const Polygons& mesh);

/// Calls `use(a, b, c)` for every triangle of the faces `first` to `last` - 1, as `FaceCutter` cuts
/// them.
template <class Use>
void for_each_triangle(const Polygons& mesh, Index first, Index last, Use use) {
  mesh::FaceCutter cutter(mesh);
  bool gave_up = false;
  for (Index face = first; face < last; ++face) {
    const Index* const corners = mesh.corners.data() + mesh.face_begin[face];
    for (const auto& [a, b, c] : cutter.cut(face, gave_up)) {
      use(corners[a], corners[b], corners[c]);
    }
  }
}

std::size_t triangle_count(const Polygons& mesh);

/// Whether `content` has the size that a binary STL file states for itself.
bool has_size_of_binary_stl(std::string_view content);
/// Whether what is STL is binary: by its size, else by a NUL near its head.
bool is_binary_stl(std::string_view content);
/// What files of other kinds are that come to mind, by the bytes at their head; or null.
const char* foreign_format(std::string_view content);
/// Whether nothing but blanks, line ends and NULs is left: padding that carries nothing.
bool is_padding(std::string_view rest);
/// "1 byte of padding follows the data".
std::string padding_remark(std::size_t bytes);
/// Whether OBJ statements may begin with this word.
bool is_obj_keyword(std::string_view word);
/// The length of the keyword that an OFF file begins with, in any case: 3 of "OFF4"; 0: none.
std::size_t off_keyword_length(std::string_view word);

/// A number in the file as an Index; beyond its range the nearest, which is no vertex.
inline Index to_index(std::int64_t number) {
  constexpr std::int64_t low = std::numeric_limits<Index>::min();
  constexpr std::int64_t high = std::numeric_limits<Index>::max();
  return static_cast<Index>(std::clamp(number, low, high));
}

/// The least corners that a face may have in a file.
inline std::int64_t least_corners(const ReadOptions& options) {
  return options.keep_faults || options.keep_small_faces ? 0 : 3;
}
/// What a face with fewer is told.
inline std::string small_face(std::int64_t corners) {
  return "a face of " + std::to_string(corners) + (corners == 1 ? " corner" : " corners") +
         ", expected three or more";
}
inline constexpr const char* kSmallFaceHint = "--repair drops such faces";

/// These fill `mesh`, whose `source.file` is set.
Status parse_obj(std::string_view content, const ReadOptions& options, MeshFile& mesh);
Status parse_off(std::string_view content, const ReadOptions& options, MeshFile& mesh);
Status parse_ply(std::string_view content, const ReadOptions& options, MeshFile& mesh);
Status parse_stl(std::string_view content, const ReadOptions& options, MeshFile& mesh);
Status parse_gltf(std::string_view content, const ReadOptions& options, MeshFile& mesh);

/// Preconditions of these, checked by `format_mesh`: coordinates and normals are finite, and fit
/// in a float where the format keeps floats; normals are none or one per vertex.
void format_obj(const Polygons& mesh, const WriteOptions& options, const base::Sink& sink);
void format_off(const Polygons& mesh, const WriteOptions& options, const base::Sink& sink);
void format_ply(const Polygons& mesh, const WriteOptions& options, const base::Sink& sink);
void format_stl(const Polygons& mesh, const WriteOptions& options, const base::Sink& sink);
void format_glb(const Polygons& mesh, const WriteOptions& options, const base::Sink& sink);

}  // namespace limn::io
