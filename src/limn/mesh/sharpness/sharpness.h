#pragma once
/// Sharpness: what keeps a smooth surface from being smooth along some edges and at some vertices
/// [DeRoseKassTruong1998]. The details are those of OpenSubdiv, whose documentation is the
/// reference.
///
/// An edge or vertex has a sharpness s ≥ 0. In a step with s ≥ 1 the mesh is refined as though it
/// were cut along its sharp edges, and joined again: a crease is a boundary that is seen from
/// either side. The children have s - 1, so that s whole steps are sharp and all further ones
/// smooth; with 0 < s < 1 the point is s times that of the crease and 1 - s times the smooth one.
/// From kInfinitelySharp on it does not fade. Boundary edges are infinitely sharp, whatever is
/// stated. By the number of sharp edges that meet there, boundary edges counted, a vertex is
///
///     0, 1   as smooth as the rest (with 1 a *dart*, the end of a crease),
///     2      on a crease (or on the boundary): the scheme's boundary vertex rule, from both sides,
///     3 …    a *corner*, which rests; as does a vertex with a sharpness of its own.
///
/// Sharpness is data of a mesh, kept beside it: by its numbers of edges, vertices and faces.

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/polygons.h"
#include "limn/mesh/split/split.h"

namespace limn {

/// From this sharpness on, children inherit all of it.
inline constexpr double kInfinitelySharp = 10;

/// What the halves of an edge inherit where it fades (is sharp, not infinitely so).
enum class CreaseMethod : std::uint8_t {
  uniform,  ///< s - 1
  /// The half at an end has (3 s + m) / 4 - 1, where m is the mean over the other edges that fade
  /// there; s - 1 where there are none. Creases of changing sharpness fade more evenly.
  chaikin
};

/// The sharpness of a mesh's edges and vertices, and the faces that are left out when it is
/// written.
struct Sharpness {
  std::vector<double> edges;     ///< of each edge, at least 0; or empty: all are smooth
  std::vector<double> vertices;  ///< of each vertex, at least 0; or empty: all are smooth
  /// Whether each face is a hole: it is refined, since others depend on it, and not written.
  /// Empty: none is.
  std::vector<bool> holes;
  CreaseMethod method = CreaseMethod::uniform;  ///< how edges fade

  /// Whether an edge or a vertex is sharp.
  [[nodiscard]] bool any() const;
  /// Whether an edge or a vertex is sharp, but not infinitely so.
  [[nodiscard]] bool fades() const;
  /// Whether a face is a hole.
  [[nodiscard]] bool has_holes() const;
};

/// What is left of a sharpness after a step.
[[nodiscard]] inline double after_step(double sharpness) {
  if (sharpness >= kInfinitelySharp) return sharpness;
  return sharpness > 1 ? sharpness - 1 : 0;
}

/// The sharpness of an interior edge; of a boundary edge kInfinitelySharp.
[[nodiscard]] inline double sharpness_of_edge(const Mesh& mesh, const Sharpness& sharpness,
                                              Index e) {
  if (mesh.is_boundary_edge(e)) return kInfinitelySharp;
  return sharpness.edges.empty() ? 0 : sharpness.edges[static_cast<std::size_t>(e)];
}

/// What the children of a mesh's edges and vertices inherit, whatever the split.
struct ChildSharpness {
  /// Of the child at either end of edge e: 2e at the origin of halfedge_of_edge(e), 2e + 1 at its
  /// target.
  std::vector<double> edge_ends;
  std::vector<double> vertices;  ///< of each vertex's child
};
/// Cost O(V + E).
[[nodiscard]] ChildSharpness child_sharpness(const Mesh& mesh, const Sharpness& sharpness);

/// The sharpness of the refined mesh `fine` that a split has made of `mesh`, with holes: those of
/// its edges that lie on old ones, its vertices that are old ones, and the faces inside old ones,
/// all found by `births`. Precondition: the split keeps old edges (it refines the boundary in every
/// step, and is no dual one). Cost O(fine mesh).
[[nodiscard]] Sharpness inherit(const Mesh& mesh, const Sharpness& sharpness,
                                const ChildSharpness& children, const SplitResult& fine);

/// How a boundary is read where nothing more is stated; the names are USD's.
enum class BoundaryMode : std::uint8_t {
  none,            ///< the faces at it are holes, but for vertices whose boundary edges are sharp
  edge_only,       ///< it is a curve like a crease
  edge_and_corner  ///< the same, and a vertex of only one face is a corner
};
/// States it as sharpness: of vertices infinite (edge_and_corner), of faces holes: none makes those
/// holes that have a boundary vertex, unless all boundary edges there are stated infinitely sharp.
/// Cost O(V + H).
void apply_boundary_mode(const Mesh& mesh, BoundaryMode mode, Sharpness& sharpness);

/// Makes the interior edges infinitely sharp whose faces' normals differ by more than `degrees`; a
/// face's normal is that of its polygon's area vector. An edge at a face without area stays as it
/// is. Returns how many these are. Cost O(H).
Index sharpen_by_angle(const Mesh& mesh, const std::vector<Point3>& positions, double degrees,
                       Sharpness& sharpness);

/// The polygons without those of holes, and without the vertices that only holes have: for each
/// vertex that stays, in order, its old number is added to `kept`. Cost O(H).
[[nodiscard]] Polygons without_holes(const Polygons& polygons, const std::vector<bool>& holes,
                                     std::vector<Index>& kept);

// Sharpness as a file states it: by numbers of vertices and faces, with the lines of the file for
// messages. What it means for a mesh is found once the mesh is built.

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
