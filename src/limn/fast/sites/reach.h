#pragma once
/// How far the rules of a scheme look. A rule sees the mesh by walks (mesh/mesh.h); where all faces
/// that its walks visit are regular, its stencil is the regular one. The walks are made here on
/// stars and fans, with every case of every rule, so the answer holds for all valences and needs no
/// weight.
///
/// Lengths are in steps of the finer grid (lattice_step.h), of which a patch has `side` a side;
/// rings (star_places.h) are counted round a control vertex.

#include <array>
#include <optional>

#include "limn/fast/sites/site.h"

namespace limn::fast {

/// Which sides of its faces a mesh has on the boundary: whether some face has those of this bit
/// set. Of a mesh that recedes it is enough that [1] says whether there is a boundary.
using BoundarySides = std::array<bool, 16>;
[[nodiscard]] BoundarySides boundary_sides(const Mesh& control);

/// Points round a control vertex, the same in each sector: x + y ≤ size, or (`square`) x, y ≤ size.
struct Zone {
  Index size = 0;
  bool square = false;
  [[nodiscard]] bool has(Index x, Index y) const {
    return square ? x <= size && y <= size : x + y <= size;
  }
};

/// Of one step.
struct Reach {
  /// The new points that need a table of their vertex: round an interior one, a boundary vertex of
  /// two faces or more, and one of one face.
  Zone star_zone, fan_zone, corner_zone;
  /// New points so near to a boundary side, in rows, need the side's own stencils.
  Index strip_depth = 0;
  /// Where the mesh recedes, new points so near need their own (rim_tables.h).
  Index rim = 0;
  /// Rings of old points that the rules of these zones see. At a vertex of one triangle they may
  /// see beyond its other side, so far along either of its spokes.
  Index star_rings = 1, fan_rings = 1, corner_rings = 0, corner_width = 0;
  /// The least side (a power of the cut) for which all this is so: control vertices are then far
  /// enough apart.
  Index smallest_side = 1;

  [[nodiscard]] Zone zone(Index sectors, bool open) const {
    return !open ? star_zone : sectors == 1 ? corner_zone : fan_zone;
  }
  /// Whether zones of two vertices may have points in common.
  [[nodiscard]] bool zones_meet(Index side) const;
};

/// Nothing where the rules look too far for tables or a walk cannot be made on the lattice. Cost
/// some 0.1 to 1 ms.
[[nodiscard]] std::optional<Reach> find_reach(const Scheme& scheme, const GridCycle& cycle,
                                              int step, const BoundarySides& sides);

}  // namespace limn::fast
