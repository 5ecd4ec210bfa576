#pragma once
/// Where the vertices of a triangle star or fan (mesh/lattice.h) lie, in sectors and on the plane.
///
/// Sector s is the wedge between spoke s and spoke s+1; its point (x, y) lies x steps along spoke s
/// and y steps along spoke s+1. On the plane, where a whole star has six sectors, (a, b) are the
/// coordinates of sector 0: the neighbours of (0, 0) are ±(1, 0), ±(0, 1) and ±(1, -1).

#include "limn/refine/fast/stencil.h"

namespace limn::fast {

struct SectorPoint {
  Index sector = 0, x = 0, y = 0;
};

/// Of vertex v in a star, or in a fan (`open`), of so many sectors; the centre is (0, 0) of
/// sector 0, and the points of a fan's last spoke are those with x = 0 in its last sector.
[[nodiscard]] SectorPoint sector_point(Index sectors, bool open, Index v);

/// The vertex at a point; x, y ≥ 0.
[[nodiscard]] Index vertex_at(Index sectors, bool open, const SectorPoint& point);

/// The place on the plane; sector < 6.
[[nodiscard]] Offset on_plane(const SectorPoint& point);

}  // namespace limn::fast
