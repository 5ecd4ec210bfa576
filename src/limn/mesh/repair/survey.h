#pragma once
/// What a mesh is and what is odd about it, whatever its faults. [what `limn check` does]

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "limn/mesh/mesh_faults.h"
#include "limn/mesh/polygons.h"
#include "limn/mesh/repair/places.h"

namespace limn::mesh {

/// Lists are in order of faces or vertices. Edges are pairs of vertices that a face joins; faces
/// with a corner that is no vertex have none.
struct MeshSurvey {
  Index vertices = 0, edges = 0, faces = 0;
  Index components = 0;      ///< of the faces, as far as common vertices join them
  Index boundary_edges = 0;  ///< of one face
  /// Of boundary edges, as they follow one another round fans; where a vertex has several fans, or
  /// an edge more than two faces, as they would if sheets were cut there.
  Index boundary_loops = 0;
  std::int64_t euler = 0;  ///< V - E + F, without the isolated vertices
  /// Of all components together, of a surface that is oriented or can be; else none.
  std::optional<std::int64_t> genus = std::nullopt;
  bool orientable = true;                ///< no part is one-sided
  std::map<Index, Index> valences = {};  ///< how many vertices have so many edges; no isolated ones
  std::map<Index, Index> degrees = {};   ///< how many faces have so many corners

  MeshFaults faults = {};              ///< what keeps it from being an oriented surface
  std::vector<Index> not_finite = {};  ///< vertices with a coordinate that is NaN or infinite
  bool refinable = false;              ///< neither of these

  std::vector<Index> degenerate = {};       ///< faces without area, or that meet a vertex twice
  std::vector<Index> isolated = {};         ///< vertices without a face
  std::vector<Index> coincident = {};       ///< vertices that lie where an earlier one lies, …
  std::vector<Index> coincident_with = {};  ///< … and that one, the first there
  std::vector<Index> near =
      {};                ///< within 1e-6 of the diagonal from an earlier one, apart from those
  OpenSeams seams = {};  ///< what joining coincident vertices would close

  std::vector<Index> valence_two = {};  ///< vertices amid the surface with two edges
  std::vector<Index> concave = {};      ///< faces that turn the other way at a corner
  std::vector<Index> bent = {};         ///< faces of which a corner lies off their plane, by more
                                        ///< than a thousandth of their size, …
  double most_bent = 0;                 ///< … and by how much at most, in parts of their size
  std::vector<Index> enormous = {};  ///< vertices with a coordinate beyond 3.4e38, what floats hold
};

/// Cost O(corners log corners). Precondition: not `too_many` (mesh_limits.h); offsets that fit.
[[nodiscard]] MeshSurvey survey_mesh(const Polygons& polygons);

/// `open_seams` of the boundary of a mesh with these positions.
[[nodiscard]] OpenSeams open_seams(const Mesh& mesh, const std::vector<Point3>& points);

}  // namespace limn::mesh
