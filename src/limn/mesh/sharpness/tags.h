#pragma once
/// Sharpness as a file states it: by numbers of vertices and faces, with the lines of the file for
/// messages. What it means for a mesh is found once the mesh is built.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/mesh_source.h"
#include "limn/mesh/sharpness/sharpness.h"

namespace limn {

/// Sharp edges and vertices, holes, and how they are meant. Vertices and faces are numbers from 0
/// of the mesh that the tags belong to.
struct SharpnessTags {
  /// A chain of edges from vertex to vertex.
  struct Crease {
    std::vector<Index> vertices;    ///< two or more
    std::vector<double> sharpness;  ///< one for all edges, or one for each
    int line = 0;                   ///< of the file; 0: none is known
  };
  /// A sharp vertex.
  struct Corner {
    Index vertex = 0;      ///< which one
    double sharpness = 0;  ///< at least 0
    int line = 0;          ///< of the file; 0: none is known
  };
  /// A face that is not written.
  struct Hole {
    Index face = 0;  ///< which one, among those of the file
    int line = 0;    ///< of the file; 0: none is known
  };

  std::string file;             ///< for messages; empty: none
  Index first = 0;              ///< the number that the file's lines give the first vertex and face
  std::vector<Crease> creases;  ///< of those that state an edge, the last counts
  std::vector<Corner> corners;  ///< the same
  std::vector<Hole> holes;      ///< in the order of the file
  std::optional<BoundaryMode> boundary;  ///< nothing: not stated
  std::optional<CreaseMethod> method;    ///< nothing: not stated
  std::optional<bool> smooth_triangles;  ///< Catmull–Clark's triangles are refined more evenly

  int statements = 0;  ///< lines (PLY: edges) that state them
  int line = 0;        ///< where the first of them stands; 0: unknown
  int column = 0;      ///< of that line; 0: unknown

  /// Whether nothing is stated.
  [[nodiscard]] bool empty() const;
};

/// Adds to `sharpness` what the tags say of edges, vertices, holes and how edges fade; what they
/// state anew of an edge or vertex counts. Their boundary mode is left to apply_boundary_mode, as
/// what is sharp comes first. Fails, with the line, where a number is that of no vertex or face, or
/// where no edge joins two vertices of a crease. `source` tells faces and vertices of the mesh from
/// those of its file, whose numbers the tags have: of a vertex that was joined with another, that
/// one is meant; of one that was cut, all copies; of one that was dropped, nothing. Cost O(size of
/// the tags, times the valence of their vertices; with holes, F).
[[nodiscard]] Status apply_tags(const Mesh& mesh, const MeshSource& source,
                                const SharpnessTags& tags, Sharpness& sharpness);

/// The tags that say this of a mesh: a crease for each sharp interior edge.
[[nodiscard]] SharpnessTags tags_of(const Mesh& mesh, const Sharpness& sharpness);

/// The names that USD has for them: "none", "edgeOnly", "edgeAndCorner".
[[nodiscard]] const std::vector<std::pair<std::string, BoundaryMode>>& boundary_modes();
/// And for these: "uniform", "chaikin".
[[nodiscard]] const std::vector<std::pair<std::string, CreaseMethod>>& crease_methods();

}  // namespace limn
