#pragma once
/// Where the vertices of a face star (mesh/lattice.h) lie, in sectors and on the plane.
///
/// Sector s is the quadrant beyond corner s of the middle face, which itself is point (0, 0). Point
/// (x, y) lies x steps along the side that borders sector s-1 and y steps along the one that
/// borders sector s+1, so that (0, t) of sector s and (t, 0) of sector s+1 are neighbours. On the
/// plane, where a whole star has four sectors, (a, b) are the coordinates of sector 0, continued:
/// sector 1 has a < 0 ≤ b.

#include <optional>

#include "limn/fast/layout/star_places.h"

namespace limn::fast {

/// Fine points of one class have the same stencil but for a translation: those of one parity.
/// Point (X, Y) is of class [Y mod 2][X mod 2], its anchor the old point (⌊X/2⌋, ⌊Y/2⌋).
[[nodiscard]] inline std::size_t class_of(Index fine_x, Index fine_y) {
  return static_cast<std::size_t>((fine_y & 1) * 2 + (fine_x & 1));
}
inline constexpr std::size_t kClasses = 4;

/// The ring of a point, as face_star counts them: 1 round the middle face.
[[nodiscard]] inline Index dual_ring(const SectorPoint& point) {
  return (point.x > point.y ? point.x : point.y) + 1;
}

/// Of vertex v in the star of so many sectors.
[[nodiscard]] SectorPoint dual_point(Index sectors, Index v);

/// The vertex at a point; x, y ≥ 0.
[[nodiscard]] Index dual_vertex(Index sectors, const SectorPoint& point);

/// The place on the plane; sector < 4.
[[nodiscard]] Offset dual_on_plane(const SectorPoint& point);

/// The point at a place, in a star of any number of sectors: of sector 0 or one of the two beside
/// it. Nothing beyond them, but for the last sector of four.
[[nodiscard]] std::optional<SectorPoint> dual_from_plane(Index sectors, Offset place);

}  // namespace limn::fast
