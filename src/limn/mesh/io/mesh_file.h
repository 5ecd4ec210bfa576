#pragma once
/// Mesh files: OBJ, OFF, PLY (ascii and binary) and STL (ascii and binary) in and out, GLB out.
/// A control mesh comes in exactly as given (order, quads and n-gons, coincident but distinct
/// vertices), and what is written reads back equal: PLY binary and the text formats keep every
/// double (PLY as `double`; text in the shortest form that reads back to the same double); STL
/// and GLB keep floats. STL has no shared vertices: corners with bitwise equal coordinates become
/// one vertex on reading; it holds triangles only.
/// One file per format; the format of a path is its extension, in any case.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/polygons.h"

namespace limn {

/// Reads a mesh. Faults (not a number, NaN or infinity, index out of range, truncated data, a
/// wrong count, an unknown extension, an empty mesh, more than 2^31 corners…) are reported with
/// file:line:column (binary: with the byte offset in the message), what was found and what was
/// expected. `warnings` gets at most one remark that texture coordinates or normals are not
/// refined yet, and one per other kind of content that is left out.
[[nodiscard]] Result<Polygons> read_mesh(const std::string& path, Warnings* warnings = nullptr);

/// The same from memory; `extension` without the dot ("obj"); `path` only for error messages.
[[nodiscard]] Result<Polygons> parse_mesh(std::string_view content, std::string_view extension,
                                          const std::string& path, Warnings* warnings = nullptr);

struct WriteOptions {
  /// Limit or vertex normals, one per vertex, or empty: written where the format has them.
  std::vector<Point3> normals;
};

/// Writes a mesh, whole or not at all: to a temporary file beside the target, then a rename.
[[nodiscard]] Status write_mesh(const std::string& path, const Polygons& mesh,
                                const WriteOptions& options = {});

/// The same into memory.
[[nodiscard]] Result<std::string> format_mesh(std::string_view extension, const Polygons& mesh,
                                              const WriteOptions& options = {});

/// Whether `write_mesh` / `read_mesh` know the extension of `path`, so that a wrong one is
/// refused before an hour of work; the error lists the known ones.
[[nodiscard]] Status check_readable(const std::string& path);
[[nodiscard]] Status check_writable(const std::string& path);

}  // namespace limn
