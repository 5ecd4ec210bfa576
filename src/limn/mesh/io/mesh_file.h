#pragma once
/// Mesh files: OBJ, OFF, PLY and STL (both ascii and binary) and GLB in and out, glTF in.
/// A control mesh comes in exactly as given (order, quads and n-gons, coincident but distinct
/// vertices), and what is written reads back equal: PLY binary and the text formats keep every
/// double (PLY as `double`; text in the shortest form that reads back to the same double); STL
/// and GLB keep floats. STL has no shared vertices: corners with equal coordinates become one
/// vertex on reading (-0 is +0), facets that then have less than three are dropped with a warning;
/// it holds triangles only.
/// One file per format; the format of a path is its extension, in any case.

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/attributes/attributes.h"
#include "limn/mesh/polygons.h"
#include "limn/mesh/sharpness/sharpness.h"

namespace limn {

/// Content of a file that a mesh does not keep, of one kind.
struct LeftOut {
  std::string what;       ///< plural, in a user's words: "vertex colours", "groups ('g')"
  std::size_t count = 0;  ///< how often it was met
  std::string unit;       ///< of what: "lines", "vertices"
  int line = 0;           ///< of the first; 0: binary
  int column = 0;         ///< of the first; 0: unknown
};

/// What a file gives: the mesh, and what there is to say about it.
struct MeshFile {
  Polygons polygons;              ///< as the file has it
  MeshSource source;              ///< for messages about the mesh
  Warnings warnings;              ///< faults of the file that did not keep it from being read
  std::vector<LeftOut> left_out;  ///< in the order in which they were met
  std::vector<Index> dropped;     ///< STL: numbers of the facets without area that were left out
  /// What is sharp: of OBJ, the tags ('t') of OpenSubdiv; of PLY, elements 'edge' with the
  /// properties 'vertex1', 'vertex2' and 'sharpness'.
  SharpnessTags tags;
  /// What its vertices, corners and faces carry, where that was asked for (ReadOptions).
  MeshAttributes attributes;

  /// Forgets the tags, for whoever has no use for them; `left_out` says so.
  void leave_out_tags();

  /// `left_out` in words, with file and line: one remark for each kind.
  [[nodiscard]] Warnings notes() const;
};

/// How a file is read.
struct ReadOptions {
  /// Coordinates that are not finite, corners that are no vertices and faces of less than three
  /// corners are kept, so that `survey_mesh` finds all of them; else the first is refused.
  bool keep_faults = false;
  /// Faces of less than three corners are kept in any case, for a repair that drops them.
  bool keep_small_faces = false;
  /// MeshFile::attributes is wanted: of OBJ texture coordinates, vertex colours, groups, objects,
  /// materials, smoothing groups; of PLY scalar properties of vertices and texture coordinates of
  /// vertices or faces; of glTF the first texture coordinates and colours. Else they are left out,
  /// and not looked at.
  bool attributes = false;
  /// Where the files are that glTF names, for its data; empty: they are not read. Reading a path
  /// takes its folder.
  std::string folder = {};
};

/// Reads a mesh. Faults (not a number, NaN or infinity, index out of range, truncated data, a
/// wrong count, an unknown extension, UTF-16, an empty mesh, 2^31 - 1 corners or more…) are
/// reported with file:line:column (binary: with the byte offset in the message), what was found
/// and what was expected. Nothing is allocated for a count that the file cannot hold.
/// Cost O(size), and memory of the file's size beside the mesh.
[[nodiscard]] Result<MeshFile> read_mesh_file(const std::string& path,
                                              const ReadOptions& options = {});

/// The same from a stream, standard input say, to its end; its content tells the format
/// (`format_of_content`). `name` only for messages: "standard input".
[[nodiscard]] Result<MeshFile> read_mesh_file(std::istream& in, const std::string& name,
                                              const ReadOptions& options = {});

/// The same from memory; `extension` without the dot ("obj"), or empty: the content tells.
[[nodiscard]] Result<MeshFile> parse_mesh_file(std::string_view content, std::string_view extension,
                                               const std::string& name,
                                               const ReadOptions& options = {});

/// The format that a content is in, by its first words (STL: by its size too): "obj", "off",
/// "ply", "stl", "glb" or "gltf"; or why that cannot be told. Cost O(1) for what has a sign of its
/// format near its head, else O(size).
[[nodiscard]] Result<std::string> format_of_content(std::string_view content);

/// The mesh alone, without tags; `warnings` gets the warnings, then the notes, one for each kind.
[[nodiscard]] Result<Polygons> read_mesh(const std::string& path, Warnings* warnings = nullptr);
/// The same from memory; `extension` and `path` as for `parse_mesh_file`.
[[nodiscard]] Result<Polygons> parse_mesh(std::string_view content, std::string_view extension,
                                          const std::string& path, Warnings* warnings = nullptr);

/// What is written beside positions and faces.
struct WriteOptions {
  /// Limit or vertex normals, one per vertex, or empty: written where the format has them. Behind
  /// these, further ones of corners.
  std::vector<Point3> normals;
  /// What is sharp, by numbers of vertices and faces: written where the format has it (lost_tags).
  /// Creases are single edges, of two vertices.
  SharpnessTags tags;
  /// What the mesh carries, written where the format has it (lost_attributes); they fit the mesh.
  MeshAttributes attributes = {};
  /// The normal of each corner; empty: its vertex's. Written where the format holds them
  /// (holds_corner_normals).
  std::vector<Index> normal_of_corner = {};
};

/// Whether files with this extension have normals of corners (OBJ, GLB), not of vertices alone.
[[nodiscard]] bool holds_corner_normals(std::string_view extension);

/// What of the attributes files with this extension do not hold, in words: "texture coordinates".
/// OBJ holds texture coordinates, colours, labels and material files, PLY numbers of vertices and
/// texture coordinates, GLB texture coordinates and colours, others nothing.
[[nodiscard]] std::vector<std::string> lost_attributes(std::string_view extension,
                                                       const MeshAttributes& attributes);
/// The attributes without these.
[[nodiscard]] MeshAttributes kept_attributes(std::string_view extension, MeshAttributes attributes);

/// What of the tags files with this extension do not hold: OBJ holds all, PLY creases, others none.
[[nodiscard]] SharpnessTags lost_tags(std::string_view extension, SharpnessTags tags);

/// Writes a mesh, whole or not at all (`write_file`). Fails where the format cannot hold a
/// coordinate: the error names the vertex, the value and a remedy, and no file where the value is
/// not finite, which is no fault of the file. Fails as well where the file cannot be written. Cost
/// O(size).
[[nodiscard]] Status write_mesh(const std::string& path, const Polygons& mesh,
                                const WriteOptions& options = {});

/// The same in a format that is named, whatever the path's extension.
[[nodiscard]] Status write_mesh(const std::string& path, std::string_view extension,
                                const Polygons& mesh, const WriteOptions& options);

/// The same into memory, in the format of that extension ("obj").
[[nodiscard]] Result<std::string> format_mesh(std::string_view extension, const Polygons& mesh,
                                              const WriteOptions& options = {});

/// Whether `read_mesh` knows the extension of `path`; the error lists the known ones. The file is
/// not touched.
[[nodiscard]] Status check_readable(const std::string& path);
/// The same of `write_mesh`, so that a wrong extension is refused before an hour of work.
[[nodiscard]] Status check_writable(const std::string& path);

/// What follows the last dot of a path's name, as it is; empty where there is none.
[[nodiscard]] std::string extension_of(const std::string& path);

}  // namespace limn
