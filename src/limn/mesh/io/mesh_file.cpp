#include "limn/mesh/io/mesh_file.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <istream>
#include <iterator>
#include <limits>
#include <utility>

#include "limn/base/files/file.h"
#include "limn/base/wide_text.h"
#include "limn/mesh/io/formats.h"

namespace limn {

std::string extension_of(const std::string& path) {
  const std::size_t name = path.rfind('/') == std::string::npos ? 0 : path.rfind('/') + 1;
  const std::size_t dot = path.rfind('.');
  return dot == std::string::npos || dot < name ? std::string() : path.substr(dot + 1);
}

namespace io {
namespace {

struct Format {
  std::string_view extension;
  Status (*parse)(std::string_view, const ReadOptions&, MeshFile&);
  void (*format)(const Polygons&, const WriteOptions&, const base::Sink&);  ///< null: not written
  bool keeps_floats;
  bool is_gltf;
};

constexpr std::array<Format, 6> kFormats{{
    {"obj", parse_obj, format_obj, false, false},
    {"off", parse_off, format_off, false, false},
    {"ply", parse_ply, format_ply, false, false},
    {"stl", parse_stl, format_stl, true, false},
    {"glb", parse_gltf, format_glb, true, true},
    {"gltf", parse_gltf, nullptr, true, true},
}};

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

/// "obj, off, ply, stl, glb": those that are read, or written.
std::string known_extensions(bool for_reading) {
  std::string list;
  for (const Format& format : kFormats) {
    if (!for_reading && format.format == nullptr) continue;
    list += (list.empty() ? "" : ", ") + std::string(format.extension);
  }
  return list;
}

Error unknown_extension(std::string_view extension, const std::string& path, bool for_reading) {
  Error error;
  error.file = path;
  error.message = extension.empty() ? "the file name has no extension that tells its format"
                                    : "unknown mesh format " + in_quotes(extension);
  if (!for_reading && lower_case(extension) == "gltf")
    error.message = "gltf files are read only, not written";
  error.hint =
      std::string("limn ") + (for_reading ? "reads " : "writes ") + known_extensions(for_reading);
  return error;
}

const Format* find_format(std::string_view extension, bool for_reading) {
  const std::string lower = lower_case(extension);
  for (const Format& format : kFormats) {
    if (format.extension == lower && (for_reading || format.format != nullptr)) return &format;
  }
  return nullptr;
}

constexpr double kLargestDouble = std::numeric_limits<double>::max();
constexpr double kLargestFloat = std::numeric_limits<float>::max();

/// A vector that a format cannot hold, in words; empty where `largest` and NaN do not occur.
std::string beyond(const Point3& p, double largest) {
  for (const auto& [name, value] : {std::pair{"x", p.x}, {"y", p.y}, {"z", p.z}})
    if (!(std::abs(value) <= largest)) {  // NaN too
      std::array<char, 64> text{};
      std::snprintf(text.data(), text.size(), "%s = %.6g", name, value);
      return text.data();
    }
  return {};
}

/// Says what a writer could not write so that it reads back, or nothing.
Fault unwritable(const Format& format, const Polygons& mesh, const WriteOptions& options) {
  const double largest = format.keeps_floats ? kLargestFloat : kLargestDouble;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const std::string what = beyond(mesh.positions[v], largest);
    if (what.empty()) continue;
    if (!beyond(mesh.positions[v], kLargestDouble).empty())
      return position_fault(v, mesh.positions[v]);
    return {"vertex " + std::to_string(v) + " has " + what + ", but " +
                std::string(format.extension) + " holds floats, up to 3.4e38 in size",
            "write obj, off or ply, which hold doubles, or scale the mesh down"};
  }
  for (std::size_t v = 0; v < options.normals.size(); ++v)
    if (Fault fault = normal_fault(v, options.normals[v]); !fault.message.empty()) return fault;
  if (Fault fault = attribute_fault(options.attributes, largest); !fault.message.empty())
    return fault;
  // No format needs 64 bytes a triangle; this can only happen where addresses have 32 bits.
  if (triangle_count(mesh) > std::numeric_limits<std::size_t>::max() / 64) {
    return {"the file would be too large for this machine", ""};
  }
  if (!format.is_gltf) return {};
  // The size of the file is a 32-bit field; 64 KiB are more than its JSON needs.
  const MeshAttributes& attributes = options.attributes;
  const std::size_t vertices = attributes.texture.empty() && options.normal_of_corner.empty()
                                   ? mesh.positions.size()
                                   : std::max(mesh.positions.size(), mesh.corners.size());
  const std::size_t each = 24 + (attributes.empty() ? 0 : 24);
  const std::size_t bytes = each * vertices + 12 * triangle_count(mesh);
  if (bytes > std::numeric_limits<std::uint32_t>::max() - 65536u) {
    return {"the mesh needs more than the 4 GiB of a glb file", ""};
  }
  return {emptiness(mesh), ""};  // glTF has no empty accessors
}

[[maybe_unused]] bool is_consistent(const Polygons& mesh, const WriteOptions& options) {
  const std::vector<Index>& of_corner = options.normal_of_corner;
  const auto normals = static_cast<Index>(options.normals.size());
  const bool normals_match = of_corner.empty()
                                 ? normals == 0 || normals == mesh.vertex_count()
                                 : normals >= mesh.vertex_count() &&
                                       of_corner.size() == mesh.corners.size() &&
                                       std::all_of(of_corner.begin(), of_corner.end(),
                                                   [&](Index i) { return i >= 0 && i < normals; });
  const bool faces_match = !mesh.face_begin.empty() && mesh.face_begin.front() == 0 &&
                           mesh.face_begin.back() == static_cast<Index>(mesh.corners.size());
  return normals_match && faces_match && attributes_fit(options.attributes, mesh) &&
         std::all_of(mesh.corners.begin(), mesh.corners.end(),
                     [&](Index vertex) { return vertex >= 0 && vertex < mesh.vertex_count(); });
}

/// What writes this mesh; or why it cannot be written.
Result<const Format*> format_for(std::string_view extension, const std::string& path,
                                 const Polygons& mesh, const WriteOptions& options) {
  const Format* format = find_format(extension, false);
  if (format == nullptr) return unknown_extension(extension, path, false);
  assert(is_consistent(mesh, options));
  if (Fault fault = unwritable(*format, mesh, options); !fault.message.empty())
    return error_of(std::move(fault), path);
  return format;
}

/// Of the units of `LeftOut`.
std::string singular(const std::string& unit) {
  if (unit == "vertices") return "vertex";
  return unit.ends_with("s") ? unit.substr(0, unit.size() - 1) : unit;
}

/// Why a file of this extension could not be read, by what it holds; else `hint`.
std::string hint_by_content(std::string_view content, const Format& format,
                            const std::string& hint) {
  if (const char* foreign = foreign_format(content))
    return "the content is " + std::string(foreign);
  if (!hint.empty()) return hint;
  const Result<std::string> seems = format_of_content(content);
  if (!seems || *seems == format.extension) return hint;
  // A NUL near the head makes a binary file, not yet STL.
  if (*seems == "stl" && is_binary_stl(content) && !has_size_of_binary_stl(content)) return hint;
  return "the content looks like " + *seems + "; is the file's extension right?";
}

Result<Polygons> mesh_of(Result<MeshFile> file, Warnings* warnings) {
  if (!file) return file.error();
  file->leave_out_tags();
  if (warnings != nullptr) {
    for (Warnings list : {std::move(file->warnings), file->notes()})
      std::move(list.begin(), list.end(), std::back_inserter(*warnings));
  }
  return std::move(file->polygons);
}

}  // namespace

bool is_extension(std::string_view extension, std::string_view known) {
  return lower_case(extension) == known;
}

Fault position_fault(std::size_t vertex, const Point3& position) {
  const std::string what = beyond(position, kLargestDouble);
  if (what.empty()) return {};
  return {"vertex " + std::to_string(vertex) + " has " + what +
              ": the coordinates are beyond what numbers can hold",
          "scale the control mesh down, its numbers are too large to calculate with", true};
}

Fault normal_fault(std::size_t vertex, const Point3& normal) {
  const std::string what = beyond(normal, kLargestFloat);
  if (what.empty()) return {};
  return {"the normal of vertex " + std::to_string(vertex) + " has " + what,
          "scale the control mesh, its numbers are too large or too small to calculate with", true};
}

Error error_of(Fault fault, const std::string& path) {
  return {"cannot write the mesh: " + fault.message, std::move(fault.hint),
          fault.of_numbers ? "" : path, 0, 0};
}

std::string count_of(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string emptiness(const Polygons& mesh) {
  if (mesh.positions.empty()) return "the mesh has no vertices";
  if (mesh.face_count() == 0) {
    return "the mesh has no faces, only " + count_of(mesh.positions.size(), "vertex", "vertices");
  }
  return {};
}

std::size_t triangle_count(const Polygons& mesh) {
  std::size_t count = 0;
  for (Index face = 0; face < mesh.face_count(); ++face) {
    count += static_cast<std::size_t>(std::max<Index>(mesh.degree(face) - 2, 0));
  }
  return count;
}

}  // namespace io

Warnings MeshFile::notes() const {
  Warnings notes;
  for (const LeftOut& kind : left_out) {
    std::string message = "left out: " + kind.what;
    message += ", " + std::to_string(kind.count) + " " +
               (kind.count == 1 ? io::singular(kind.unit) : kind.unit);
    notes.push_back({std::move(message), "", source.file, kind.line, kind.column});
  }
  return notes;
}

void MeshFile::leave_out_tags() {
  const bool of_obj = source.first == 1;  // else of PLY
  if (tags.statements > 0)
    left_out.push_back({of_obj ? "sharp edges and corners, and other tags of OpenSubdiv ('t')"
                               : "the sharpness of edges",
                        static_cast<std::size_t>(tags.statements), of_obj ? "lines" : "edges",
                        tags.line, tags.column});
  tags = {};
}

SharpnessTags lost_tags(std::string_view extension, SharpnessTags tags) {
  if (io::is_extension(extension, "obj")) return {};
  if (io::is_extension(extension, "ply")) tags.creases.clear();
  return tags;
}

Result<MeshFile> parse_mesh_file(std::string_view content, std::string_view extension,
                                 const std::string& name, const ReadOptions& options) {
  std::string recognised;
  if (extension.empty()) {
    Result<std::string> format = format_of_content(content);
    if (!format) {
      format.error().file = name;
      return format.error();
    }
    recognised = *format;
  }
  const io::Format* format = io::find_format(extension.empty() ? recognised : extension, true);
  if (format == nullptr) return io::unknown_extension(extension, name, true);
  if (content.empty()) return Error{"the file is empty", "", name, 1, 1};
  if (const std::string wide = base::wide_encoding(content); !wide.empty()) {
    const bool binary = (format->extension == "stl" && io::has_size_of_binary_stl(content)) ||
                        (format->is_gltf && content.starts_with("glTF"));
    if (!binary)
      return Error{base::wide_text_fault(wide), base::wide_text_remedy(wide), name, 1, 1};
  }
  MeshFile mesh;
  mesh.source.file = name;
  Status done = format->parse(content, options, mesh);
  if (done) return mesh;
  Error error = done.error();
  if (!extension.empty()) error.hint = io::hint_by_content(content, *format, error.hint);
  // statements that no reader knows may have been meant as vertices or faces
  if (error.hint.empty() && !mesh.left_out.empty() && io::emptiness(mesh.polygons) == error.message)
    error.hint = "left out: " + mesh.left_out.front().what + ", from line " +
                 std::to_string(mesh.left_out.front().line) + " on";
  return error;
}

Result<MeshFile> read_mesh_file(const std::string& path, const ReadOptions& options) {
  if (Status known = check_readable(path); !known) return known.error();
  const Result<std::string> content = base::read_file(path);
  if (!content) return content.error();
  ReadOptions with_folder = options;
  if (with_folder.folder.empty()) {
    const std::size_t slash = path.rfind('/');
    with_folder.folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  }
  return parse_mesh_file(*content, extension_of(path), path, with_folder);
}

Result<MeshFile> read_mesh_file(std::istream& in, const std::string& name,
                                const ReadOptions& options) {
  std::string content((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (in.bad()) return Error{"cannot be read", "", name, 0, 0};
  return parse_mesh_file(content, "", name, options);
}

Result<Polygons> parse_mesh(std::string_view content, std::string_view extension,
                            const std::string& path, Warnings* warnings) {
  if (extension.empty()) return io::unknown_extension(extension, path, true);
  return io::mesh_of(parse_mesh_file(content, extension, path), warnings);
}

Result<Polygons> read_mesh(const std::string& path, Warnings* warnings) {
  return io::mesh_of(read_mesh_file(path), warnings);
}

Result<std::string> format_mesh(std::string_view extension, const Polygons& mesh,
                                const WriteOptions& options) {
  Result<const io::Format*> format = io::format_for(extension, "", mesh, options);
  if (!format) return format.error();
  std::string content;
  (*format)->format(mesh, options, [&](std::string_view piece) { content += piece; });
  return content;
}

Status write_mesh(const std::string& path, const Polygons& mesh, const WriteOptions& options) {
  return write_mesh(path, extension_of(path), mesh, options);
}

Status write_mesh(const std::string& path, std::string_view extension, const Polygons& mesh,
                  const WriteOptions& options) {
  Result<const io::Format*> format = io::format_for(extension, path, mesh, options);
  if (!format) return format.error();
  return base::write_file(path,
                          [&](const base::Sink& sink) { (*format)->format(mesh, options, sink); });
}

Status check_readable(const std::string& path) {
  const std::string extension = extension_of(path);
  if (io::find_format(extension, true) != nullptr) return Done{};
  return io::unknown_extension(extension, path, true);
}

Status check_writable(const std::string& path) {
  const std::string extension = extension_of(path);
  if (io::find_format(extension, false) != nullptr) return Done{};
  return io::unknown_extension(extension, path, false);
}

}  // namespace limn
