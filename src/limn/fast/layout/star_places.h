#pragma once
/// Where the vertices of a star or fan (mesh/lattice.h) lie, in sectors and on the plane, and what
/// patches of a regular lattice see of one another: the difference between triangles and quads.
///
/// Sector s is the wedge between spoke s and spoke s+1; its point (x, y) lies x steps along spoke s
/// and y steps along spoke s+1. On the plane, which takes six sectors of triangles or four of
/// quads, (a, b) are the coordinates of sector 0: on quads the neighbours of (0, 0) are ±(1, 0) and
/// ±(0, 1), on triangles also ±(1, -1).
///
/// A *patch* of n edges a side is the triangle x, y ≥ 0, x + y ≤ n or the square 0 ≤ x, y ≤ n; the
/// frame of a side has that side along y = 0.

#include "limn/fast/kernel/stencil.h"
#include "limn/mesh/split/split.h"

namespace limn::fast {

struct SectorPoint {
  Index sector = 0, x = 0, y = 0;
  friend bool operator==(const SectorPoint&, const SectorPoint&) = default;
};

/// A star, a fan (`open`), or a face star (`offset`), whose points are the middles of a star's
/// squares and named by the corners next to the centre.
struct StarShape {
  Lattice lattice = Lattice::triangle;
  Index sectors = 0;
  bool open = false;
  bool offset = false;
};

/// The sectors of the plane, and of half the plane.
[[nodiscard]] constexpr Index plane_sectors(Lattice lattice) {
  return lattice == Lattice::triangle ? 6 : 4;
}
[[nodiscard]] constexpr Index half_plane_sectors(Lattice lattice) {
  return plane_sectors(lattice) / 2;
}

/// The fewest that a star may have.
[[nodiscard]] constexpr Index fewest_sectors(Lattice lattice, bool offset) {
  return lattice == Lattice::triangle || offset ? 3 : 2;
}

/// The ring round the centre of a sector's point (x, y), as mesh/lattice.h counts them.
[[nodiscard]] constexpr Index ring_of(Lattice lattice, Index x, Index y) {
  return lattice == Lattice::triangle ? x + y : x > y ? x : y;
}

/// Of vertex v of a star or fan; the centre is (0, 0) of sector 0, and the points of a fan's last
/// spoke are those with x = 0 in its last sector.
[[nodiscard]] SectorPoint sector_point(const StarShape& shape, Index v);

/// The place on the plane; sector < plane_sectors(lattice).
[[nodiscard]] Offset on_plane(Lattice lattice, const SectorPoint& point);

/// Whether a place of the plane is in sector 0 or in one of the two beside it.
[[nodiscard]] bool beside_corner(Lattice lattice, Offset place);

/// Whether a place is in the patch at the origin.
[[nodiscard]] bool patch_holds(Lattice lattice, Index n, Offset place);

/// Whether a place is in that patch or in one of those across its sides.
[[nodiscard]] bool patch_sees(Lattice lattice, Index n, Offset place);

/// How many rows beyond the patch's sides it lies.
[[nodiscard]] Index rows_beyond(Lattice lattice, Index n, Offset place);

/// How many steps a point of the patch, y rows from the side y = 0, is from the side at that one's
/// far end: its x in the frame that is the mirror image.
[[nodiscard]] constexpr Index mirrored(Lattice lattice, Index n, Index x, Index y) {
  return lattice == Lattice::triangle ? n - x - y : n - x;
}

}  // namespace limn::fast
