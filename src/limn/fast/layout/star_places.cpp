#include "limn/fast/layout/star_places.h"

#include <algorithm>
#include <array>

#include "limn/mesh/lattice.h"

namespace limn::fast {
namespace {

constexpr std::array<Offset, 7> kTriangleSpokes{
    {{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}, {1, 0}}};
constexpr std::array<Offset, 5> kQuadSpokes{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}}};

Offset spoke(Lattice lattice, Index s) {
  const auto i = static_cast<std::size_t>(s);
  return lattice == Lattice::triangle ? kTriangleSpokes[i] : kQuadSpokes[i];
}

/// Vertices before ring r ≥ 1, or r ≥ 0 of an offset star.
Index ring_begin(const StarShape& shape, Index r) {
  if (shape.offset) return r == 0 ? 0 : mesh::face_star_size(shape.sectors, r);
  if (r == 1) return 1;
  return shape.open ? mesh::fan_size(shape.lattice, shape.sectors, r - 1)
                    : mesh::star_size(shape.lattice, shape.sectors, r - 1);
}

}  // namespace

SectorPoint sector_point(const StarShape& shape, Index v) {
  if (v == 0) return {};
  Index r = shape.offset ? 0 : 1;
  while (ring_begin(shape, r + 1) <= v) ++r;
  // in one sector
  const Index length = shape.lattice == Lattice::triangle ? r : 2 * r + (shape.offset ? 1 : 0);
  const Index along = v - ring_begin(shape, r);
  if (along == shape.sectors * length) return {shape.sectors - 1, 0, r};
  const Index sector = along / length, k = along % length;
  if (shape.lattice == Lattice::triangle) return {sector, r - k, k};
  // along the square's two sides that do not meet the centre
  return {sector, std::min(r, 2 * r - k), std::min(r, k)};
}

Offset on_plane(Lattice lattice, const SectorPoint& point) {
  const Offset first = spoke(lattice, point.sector), second = spoke(lattice, point.sector + 1);
  return {point.x * first.a + point.y * second.a, point.x * first.b + point.y * second.b};
}

bool beside_corner(Lattice lattice, Offset place) {
  return lattice == Lattice::triangle ? place.a + place.b >= 0 : place.a >= 0 || place.b >= 0;
}

bool patch_holds(Lattice lattice, Index n, Offset place) {
  const auto [a, b] = place;
  return a >= 0 && b >= 0 && (lattice == Lattice::triangle ? a + b <= n : a <= n && b <= n);
}

bool patch_sees(Lattice lattice, Index n, Offset place) {
  const auto [a, b] = place;
  if (lattice == Lattice::triangle) return a <= n && b <= n && a + b >= 0;
  const auto between = [](Index low, Index i, Index high) { return low <= i && i <= high; };
  return (between(0, a, n) && between(-n, b, 2 * n)) || (between(0, b, n) && between(-n, a, 2 * n));
}

Index rows_beyond(Lattice lattice, Index n, Offset place) {
  const auto [a, b] = place;
  const Index far = lattice == Lattice::triangle ? a + b - n : std::max(a - n, b - n);
  return std::max({Index{0}, -a, -b, far});
}

}  // namespace limn::fast
