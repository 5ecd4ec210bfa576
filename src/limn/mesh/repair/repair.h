#pragma once
/// Polygons that are no surface, mended as asked. [what `limn … --repair` does]
///
///     const Result<Repaired> mended = repair(file.polygons, RepairOptions::everything());
///     const Result<Mesh> mesh = build_mesh(mended->polygons, source_of(*mended, file.source));

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "limn/base/error.h"
#include "limn/mesh/polygons.h"

namespace limn::mesh {

/// What may be done; what is not asked for is not done. The order is that of the fields, and
/// one-sided surfaces are cut last.
struct RepairOptions {
  /// Vertices within this times the diagonal of the mesh are joined, each with an earlier one whose
  /// position stays (`places_of`); 0: those in one place. Corners of a face that become one are
  /// one; a face that is left with less than three is dropped.
  std::optional<double> weld = std::nullopt;
  /// Faces that meet a vertex twice are cut there, into as many faces as have three corners; those
  /// without area and repeated ones are dropped.
  bool drop = false;
  /// Where an edge has more than two faces, or the faces round a vertex are not one fan, each sheet
  /// gets its own copies. One-sided surfaces are cut open at edges that no reversing of faces
  /// mends.
  bool cut = false;
  /// Of each part whose faces run different ways the fewest are reversed.
  bool orient = false;

  /// Vertices in one place are joined, and all the rest.
  [[nodiscard]] static RepairOptions everything() { return {0.0, true, true, true}; }
  /// Whether anything is asked for.
  [[nodiscard]] bool any() const { return weld.has_value() || drop || cut || orient; }
};

/// Something that was done.
struct RepairStep {
  std::string what;  ///< a name for machines, as "vertices_welded"
  Index count = 0;   ///< how often
  std::string text;  ///< in words: "16 vertices joined with one in the same place"
};

/// What repair makes. Kept faces and vertices keep their order; copies of vertices come last.
struct Repaired {
  Polygons polygons;
  std::vector<Index> vertex_of;  ///< the vertex of the input that each is, or is a copy of
  /// Of each vertex of the input the one in whose place it was joined, itself where it was not.
  std::vector<Index> joined_with;
  std::vector<Index> face_of;  ///< the face of the input that each is, or is a part of
  /// The corner of the input, of all its corners, that each is; kNone of a new one: where a facet
  /// without area lay on the longer side of its neighbour, that is cut.
  std::vector<Index> corner_of;
  /// Copies of a cut vertex that OpenSubdiv holds sharp [DeRoseKassTruong1998]:
  /// all but those where two edges of more than two faces meet and go on as a crease. For those who
  /// refine with sharpness.
  std::vector<Index> sharp_vertices;
  /// Edges that had more than two faces and have two now, both ends being one sheet's: creases.
  std::vector<std::array<Index, 2>> sharp_edges;
  /// In the order in which it was done; empty where there was nothing to do.
  std::vector<RepairStep> done;
};

/// Where nothing of what is asked for is to be done, `polygons` is the input. With everything asked
/// for, `Mesh::build` takes the result, and repairing it again changes nothing. Refused: offsets
/// that do not fit the corners, a mesh of which no face is left, and one that is `too_many`.
/// Corners that are no vertices are left as they are, for `Mesh::build` to refuse. Cost O(corners
/// log corners) each step.
[[nodiscard]] Result<Repaired> repair(const Polygons& polygons, const RepairOptions& options);

/// The source of what was repaired: `source` is that of the input.
[[nodiscard]] MeshSource source_of(const Repaired& repaired, const MeshSource& source);

}  // namespace limn::mesh
