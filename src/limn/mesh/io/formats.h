#pragma once
/// The single formats behind mesh_file.h, and what their readers and writers share.

#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <string_view>

#include "limn/base/error.h"
#include "limn/base/file.h"
#include "limn/mesh/io/mesh_file.h"
#include "limn/mesh/io/text_scanner.h"
#include "limn/mesh/polygons.h"

namespace limn::io {

/// Corners and vertices are counted in an `Index`.
inline constexpr std::size_t kMaxCorners = std::numeric_limits<Index>::max();

/// Remarks on what is left out: the first of each kind is kept, with its place.
class Remarks {
 public:
  Remarks(Warnings* out, std::string path) : out_(out), path_(std::move(path)) {}

  void texture_or_normals(Place place) {
    if (!said_texture_) add(place, "texture coordinates and normals are not refined yet");
    said_texture_ = true;
  }
  /// `kind` is the subject of "… left out": "vertex colours are", "keyword 'l' is".
  void left_out(Place place, std::string_view kind) {
    if (out_ != nullptr && kinds_.emplace(kind).second) {
      add(place, std::string(kind) + " left out");
    }
  }

 private:
  void add(Place place, std::string message) {
    if (out_ == nullptr) return;
    out_->push_back({std::move(message), "", path_, place.line, place.column});
  }

  Warnings* out_;
  std::string path_;
  bool said_texture_ = false;
  std::set<std::string, std::less<>> kinds_;
};

/// "1 vertex", "8 vertices".
std::string count_of(std::size_t count, const char* one, const char* many);

/// Says why the mesh that was read cannot be refined at all, or nothing if it can.
std::string emptiness(const Polygons& mesh);

/// Calls `use(a, b, c)` for every triangle of the fans from the first corner of the faces `first`
/// to `last` - 1.
template <class Use>
void for_each_triangle(const Polygons& mesh, Index first, Index last, Use use) {
  for (Index face = first; face < last; ++face) {
    const Index begin = mesh.face_begin[face];
    for (Index corner = begin + 2; corner < mesh.face_begin[face + 1]; ++corner) {
      use(mesh.corners[begin], mesh.corners[corner - 1], mesh.corners[corner]);
    }
  }
}

std::size_t triangle_count(const Polygons& mesh);

Result<Polygons> parse_obj(std::string_view content, const std::string& path, Warnings* warnings);
Result<Polygons> parse_off(std::string_view content, const std::string& path, Warnings* warnings);
Result<Polygons> parse_ply(std::string_view content, const std::string& path, Warnings* warnings);
Result<Polygons> parse_stl(std::string_view content, const std::string& path, Warnings* warnings);

/// Preconditions of these, checked by `format_mesh`: coordinates and normals are finite, and fit
/// in a float where the format keeps floats; normals are none or one per vertex.
void format_obj(const Polygons& mesh, const WriteOptions& options, const Sink& sink);
void format_off(const Polygons& mesh, const WriteOptions& options, const Sink& sink);
void format_ply(const Polygons& mesh, const WriteOptions& options, const Sink& sink);
void format_stl(const Polygons& mesh, const WriteOptions& options, const Sink& sink);
void format_glb(const Polygons& mesh, const WriteOptions& options, const Sink& sink);

}  // namespace limn::io
