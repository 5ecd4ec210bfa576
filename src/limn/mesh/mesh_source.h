#pragma once
/// Where the vertices and faces of a mesh come from, so that a message speaks in the numbers and
/// lines of the file that a user has, not in limn's own.

#include <string>
#include <vector>

#include "limn/mesh/polygons.h"

namespace limn {

/// The file of a mesh, and which of its lines and numbers the vertices and faces come from.
struct MeshSource {
  std::string file;               ///< as the user named it; empty: no file
  Index first = 0;                ///< the number of the first vertex and face: 1 in OBJ, else 0
  std::vector<int> vertex_lines;  ///< line of each vertex, from 1; empty: binary, or no file
  std::vector<int> face_lines;    ///< line of each face that the file has
  /// The place of each face among those of the file, from 0, where that is not the face's own
  /// index: facets were dropped, or polygons cut into triangles. Empty: its own index.
  std::vector<Index> file_faces;
  /// The same of vertices, where some were joined or copied.
  std::vector<Index> file_vertices;
  /// Of each vertex of the file the one that it was joined with, itself where there is none. Empty:
  /// none was.
  std::vector<Index> joined_with;

  /// The number among the file's faces, from 0, of a face of the mesh.
  [[nodiscard]] Index file_face(Index face) const {
    return file_faces.empty() ? face : file_faces[static_cast<std::size_t>(face)];
  }
  /// The number among the file's vertices, from 0, of a vertex of the mesh; of what is no vertex,
  /// itself.
  [[nodiscard]] Index file_vertex(Index vertex) const {
    const bool known = vertex >= 0 && static_cast<std::size_t>(vertex) < file_vertices.size();
    return known ? file_vertices[static_cast<std::size_t>(vertex)] : vertex;
  }
  /// Its line; 0 where none is known.
  [[nodiscard]] int face_line(Index face) const { return line(face_lines, file_face(face)); }
  /// Its line; 0 where none is known.
  [[nodiscard]] int vertex_line(Index vertex) const {
    return line(vertex_lines, file_vertex(vertex));
  }

 private:
  static int line(const std::vector<int>& lines, Index number) {
    const bool known = number >= 0 && static_cast<std::size_t>(number) < lines.size();
    return known ? lines[static_cast<std::size_t>(number)] : 0;
  }
};

}  // namespace limn
