#pragma once
/// How far a √3 scheme's rules look, found by walks on stars and fans (walk_hull.h): the answer
/// holds for all valences and needs no weight.
///
/// Lengths are in steps of the grid of thirds (sqrt3_layout.h), of which a patch has N = 3n a side;
/// rings are X + Y round a control vertex.

#include <optional>

#include "limn/fast/sites/sqrt3_site.h"
#include "limn/scheme/scheme.h"

namespace limn::fast {

/// Whether the control mesh has faces of i sides on the boundary, i = 0 … 3.
using BoundarySides = std::array<bool, 4>;
[[nodiscard]] BoundarySides boundary_sides(const Mesh& control);

/// Round a control vertex, the points that need a table of its number of faces: in each sector
/// X + Y ≤ size, or in a sector that is the only one at a boundary vertex, X, Y ≤ size.
struct Sqrt3Zone {
  Index size = 0;
  bool only = false;
  [[nodiscard]] bool has(Index x, Index y) const {
    return only ? x <= size && y <= size : x + y <= size;
  }
};

/// Of one step.
struct Sqrt3Reach {
  Index star_zone = 0;                  ///< round an interior vertex
  Index fan_zone = 0, corner_zone = 0;  ///< a boundary vertex of two faces or more, and of one
  /// New points so near to a boundary side, in rows, need the side's own stencils; -1: none.
  Index strip_depth = -1;
  /// Rings of old points that the rules of these zones see. At a vertex of one face they may see
  /// beyond the face's other side, so far along either of its spokes.
  Index star_rings = 0, fan_rings = 0, corner_rings = 0, corner_width = 0;
  /// The least N (a power of 3) for which all this is so: control vertices are then far enough
  /// apart.
  Index smallest_side = 3;

  [[nodiscard]] Sqrt3Zone zone(Index sectors, bool open) const {
    if (!open) return {star_zone, false};
    return sectors == 1 ? Sqrt3Zone{corner_zone, true} : Sqrt3Zone{fan_zone, false};
  }
};

/// Nothing where the rules look too far for tables (some 4 control edges). Cost some 1 ms.
[[nodiscard]] std::optional<Sqrt3Reach> find_sqrt3_reach(const Scheme& scheme, Sqrt3Step step,
                                                         const BoundarySides& sides);

}  // namespace limn::fast
