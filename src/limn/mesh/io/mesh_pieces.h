#pragma once
/// A mesh file whose vertices and faces come in pieces, in any order and from several threads, so
/// that the mesh need never be in memory as a whole. The bytes are those of `write_mesh`.

#include <memory>
#include <string>
#include <string_view>

#include "limn/base/error.h"
#include "limn/base/files/file.h"
#include "limn/mesh/polygons.h"

namespace limn::mesh {

/// What must be known of a mesh before it is written.
struct MeshCounts {
  std::size_t vertices = 0, faces = 0;
  Index corners_per_face = 0;  ///< or 0: they differ
  Index largest_face = 0;      ///< corners of the largest
  bool normals = false;        ///< each vertex has one
};

/// Takes the pieces. Its functions may be called from several threads at once. Memory is the
/// caller's, to be used again for the next piece.
class MeshPieceSink {
 public:
  MeshPieceSink(const MeshCounts& counts, const base::PlacedSink& sink);
  ~MeshPieceSink();
  MeshPieceSink(const MeshPieceSink&) = delete;
  MeshPieceSink& operator=(const MeshPieceSink&) = delete;

  /// Vertices first … first + count - 1: x, y, z of each; `normals` is null where there are none.
  void put_vertices(std::size_t first, std::size_t count, const double* positions,
                    const double* normals, std::string& memory);
  /// Faces first … first + count - 1. `first_corner`: the corners of all faces before them. Where
  /// faces differ, begin[i + 1] - begin[i] is the number of corners of the i-th of them.
  void put_faces(std::size_t first, std::size_t count, std::size_t first_corner,
                 const Index* corners, const Index* begin, std::string& memory);

  /// Fails where a vertex was not finite, and names the first, as `write_mesh` does.
  [[nodiscard]] Status status() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Whether a mesh can be written to this path in pieces: PLY, and no pipe or device.
[[nodiscard]] bool takes_mesh_pieces(const std::string& path, std::string_view extension);

/// Writes a mesh, whole or not at all; every vertex and face comes once. Precondition:
/// takes_mesh_pieces(path, …). Fails as `write_mesh`.
[[nodiscard]] Status write_mesh_pieces(const std::string& path, const MeshCounts& counts,
                                       const std::function<void(MeshPieceSink&)>& fill);

}  // namespace limn::mesh
