#include "limn/fast/sites/dual_places.h"

#include "limn/mesh/lattice.h"

namespace limn::fast {

SectorPoint dual_point(Index sectors, Index v) {
  Index ring = 1;
  while (face_star_size(sectors, ring) <= v) ++ring;
  const Index along = v - (ring == 1 ? 0 : face_star_size(sectors, ring - 1));
  const Index width = 2 * ring - 1, k = along % width;
  // a ring's part in a sector: up along x = ring-1, then back along y = ring-1
  return k < ring ? SectorPoint{along / width, ring - 1, k}
                  : SectorPoint{along / width, width - 1 - k, ring - 1};
}

Index dual_vertex(Index sectors, const SectorPoint& point) {
  const Index ring = dual_ring(point), width = 2 * ring - 1;
  const Index k = point.x == ring - 1 ? point.y : width - 1 - point.x;
  return (ring == 1 ? 0 : face_star_size(sectors, ring - 1)) + point.sector * width + k;
}

Offset dual_on_plane(const SectorPoint& point) {
  Offset place{point.x, point.y};
  // by quarter turns about the middle of the face
  for (Index s = 0; s < point.sector; ++s) place = {-1 - place.b, place.a};
  return place;
}

std::optional<SectorPoint> dual_from_plane(Index sectors, Offset place) {
  const auto& [a, b] = place;
  if (a >= 0 && b >= 0) return SectorPoint{0, a, b};
  if (b >= 0) return SectorPoint{1, b, -1 - a};
  if (a >= 0) return SectorPoint{sectors - 1, -1 - b, a};
  if (sectors == 4) return SectorPoint{2, -1 - a, -1 - b};
  return std::nullopt;
}

}  // namespace limn::fast
