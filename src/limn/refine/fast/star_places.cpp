#include "limn/refine/fast/star_places.h"

#include <array>

namespace limn::fast {
namespace {

constexpr std::array<Offset, 7> kSpokes{
    {{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}, {1, 0}}};

/// Vertices before ring r ≥ 1.
Index ring_begin(Index sectors, bool open, Index r) {
  return 1 + sectors * (r * (r - 1) / 2) + (open ? r - 1 : 0);
}

}  // namespace

SectorPoint sector_point(Index sectors, bool open, Index v) {
  if (v == 0) return {};
  Index r = 1;
  while (ring_begin(sectors, open, r + 1) <= v) ++r;
  const Index along = v - ring_begin(sectors, open, r);
  if (along == sectors * r) return {sectors - 1, 0, r};
  return {along / r, r - along % r, along % r};
}

Index vertex_at(Index sectors, bool open, const SectorPoint& point) {
  const Index r = point.x + point.y;
  if (r == 0) return 0;
  const Index along = point.sector * r + point.y;
  return ring_begin(sectors, open, r) + (open ? along : along % (sectors * r));
}

Offset on_plane(const SectorPoint& point) {
  const Offset first = kSpokes[static_cast<std::size_t>(point.sector)];
  const Offset second = kSpokes[static_cast<std::size_t>(point.sector) + 1];
  return {point.x * first.a + point.y * second.a, point.x * first.b + point.y * second.b};
}

}  // namespace limn::fast
