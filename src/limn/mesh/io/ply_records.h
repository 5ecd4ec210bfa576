#pragma once
/// The bytes of the PLY files that are written: binary, little-endian, coordinates as double.

#include <cstddef>
#include <string>

#include "limn/mesh/polygons.h"

namespace limn::io {

/// What decides how a file is laid out: its header, its vertices, its faces.
struct PlyRecords {
  std::size_t vertices = 0, faces = 0;
  bool normals = false;
  bool wide = false;      ///< a face has more than 255 corners
  std::size_t edges = 0;  ///< that have a sharpness

  /// With further properties of vertices and faces, as lines of the header.
  [[nodiscard]] std::string header(const std::string& of_vertices = {},
                                   const std::string& of_faces = {}) const;
  /// Of a vertex.
  [[nodiscard]] std::size_t vertex_bytes() const { return normals ? 48 : 24; }
  /// Of so many faces with so many corners in all.
  [[nodiscard]] std::size_t face_bytes(std::size_t count, std::size_t corners) const {
    return count * (wide ? 4 : 1) + corners * 4;
  }
};

/// Stores vertices, and where `normals` is not null theirs; x, y, z of each. Returns past the last.
char* put_ply_vertices(char* to, std::size_t count, const double* positions, const double* normals);

/// Appends an edge: its vertices and its sharpness.
void append_ply_edge(std::string& out, Index from, Index to, double sharpness);

/// Stores `count` faces whose corners follow one another; of `each` corners, or where that is 0,
/// face f has begin[f + 1] - begin[f].
char* put_ply_faces(char* to, std::size_t count, const Index* corners, Index each,
                    const Index* begin, bool wide);

}  // namespace limn::io
