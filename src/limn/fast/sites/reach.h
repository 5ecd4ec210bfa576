#pragma once
/// How far the rules of a dyadic scheme, on triangles or quads, look. A rule sees the mesh by walks
/// (mesh/flag.h); where all faces that its walks visit are regular, its stencil is the regular one.
/// The walks are made here on a regular star and on fans, with every case of every rule, so the
/// answer holds for all valences and needs no weight.

#include <array>
#include <optional>
#include <set>
#include <vector>

#include "limn/fast/sites/star_places.h"
#include "limn/scheme/scheme.h"

namespace limn::fast {

/// Fine points of one class have the same stencil but for a translation: those of one parity.
/// Point (X, Y) of the refined lattice is of class [Y mod 2][X mod 2], its anchor the old vertex
/// (⌊X/2⌋, ⌊Y/2⌋).
[[nodiscard]] inline std::size_t class_of(Index fine_x, Index fine_y) {
  return static_cast<std::size_t>((fine_y & 1) * 2 + (fine_x & 1));
}
inline constexpr std::size_t kClasses = 4;

/// What the rule sees (walk_hull.h) by which fine point (x, y) of a sector is born, on a star or
/// fan. Both coordinates odd, that is an edge of triangles or a face of quads.
[[nodiscard]] std::set<Index> birth_hull(const Scheme& scheme, const Mesh& star,
                                         const StarShape& shape, const SectorPoint& fine);

/// Rings are counted round a control vertex: fine rings in steps of the finer grid, coarse rings
/// in steps of the coarser.
struct Reach {
  /// Fine points of fine rings 0 … this round an interior vertex need a table of its valence.
  Index star_zone = 0;
  /// The same round a boundary vertex of two faces or more, and of one face.
  Index fan_zone = 0, corner_zone = 0;
  /// Fine points so near to a boundary side, in rows of the finer grid, need the side's own
  /// stencils.
  Index strip_depth = 0;
  /// Coarse rings that these tables look at.
  Index star_rings = 1, fan_rings = 1;
  /// The fewest coarse edges (a power of two) that a control edge must have been cut into for all
  /// this to be so: vertices of the control mesh are then far enough apart.
  Index smallest_grid = 1;
};

/// Nothing where the rules look too far for tables (beyond 6 rings) or a walk cannot be made on
/// the lattice. `boundary`: whether boundaries count. Cost some 0.1 ms.
[[nodiscard]] std::optional<Reach> find_reach(const Scheme& scheme, bool boundary);

}  // namespace limn::fast
