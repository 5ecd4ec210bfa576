#include "limn/mesh/repair/places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "limn/mesh/edge_sides.h"
#include "limn/mesh/finite_point.h"

namespace limn::mesh {
namespace {

using Cell = std::array<std::int64_t, 3>;

/// Points by the cells that they lie in: chains of points in a table of hashed cells.
class CellTable {
 public:
  explicit CellTable(std::size_t points) : next_(points, kNone) {
    std::size_t size = 16;
    while (size < 2 * points) size *= 2;
    heads_.assign(size, kNone);
  }
  void enter(const Cell& cell, Index point) {
    Index& head = heads_[slot(cell)];
    next_[point] = head;
    head = point;
  }
  /// All points that may lie in the cell, and maybe others; the later first.
  template <class Use>
  void for_each(const Cell& cell, const Use& use) const {
    for (Index i = heads_[slot(cell)]; i != kNone; i = next_[i]) use(i);
  }

 private:
  [[nodiscard]] std::size_t slot(const Cell& cell) const {
    std::uint64_t h = 0;
    for (const std::int64_t part : cell) {
      h = (h ^ static_cast<std::uint64_t>(part)) * 0x9E3779B97F4A7C15u;
      h ^= h >> 32U;
    }
    return static_cast<std::size_t>(h) & (heads_.size() - 1);
  }

  std::vector<Index> heads_, next_;
};

std::vector<Index> equal_places(const std::vector<Point3>& points) {
  CellTable table(points.size());
  std::vector<Index> place(points.size());
  for (Index i = 0; i < static_cast<Index>(points.size()); ++i) {
    const Point3 p = points[i];
    Cell bits{};
    const std::array<double, 3> numbers{p.x + 0.0, p.y + 0.0, p.z + 0.0};  // -0 is 0
    std::memcpy(bits.data(), numbers.data(), sizeof(bits));
    place[i] = i;
    table.for_each(bits, [&](Index k) {
      if (points[k] == p) place[i] = k;
    });
    if (place[i] == i && is_finite(p)) table.enter(bits, i);
  }
  return place;
}

double apart(const Point3& a, const Point3& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

struct Box {
  Point3 low, high;
  bool empty = true;
};
Box box_of(const std::vector<Point3>& points) {
  Box box;
  for (const Point3& p : points) {
    if (!is_finite(p)) continue;
    if (box.empty) box = {p, p, false};
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  }
  return box;
}

}  // namespace

double diagonal_of(const std::vector<Point3>& points) {
  const Box box = box_of(points);
  return box.empty ? 0 : apart(box.low, box.high);
}

std::vector<Index> places_of(const std::vector<Point3>& points, double distance) {
  const Point3 low = box_of(points).low;
  const double across = diagonal_of(points);
  // cells are counted in 64 bits; a smaller distance is one of equal points
  if (!(distance > across * 1e-17) || !(distance < std::numeric_limits<double>::infinity()))
    return equal_places(points);
  CellTable table(points.size());
  std::vector<Index> place(points.size());
  const auto cell_of = [distance](double x, double from) {
    return static_cast<std::int64_t>(std::floor((x - from) / distance));
  };
  for (Index i = 0; i < static_cast<Index>(points.size()); ++i) {
    const Point3& p = points[i];
    place[i] = i;
    if (!is_finite(p)) continue;
    const Cell cell{cell_of(p.x, low.x), cell_of(p.y, low.y), cell_of(p.z, low.z)};
    double nearest = distance;
    const auto look_at = [&](Index k) {
      const double d = apart(points[k], p);
      if (d > nearest || (d == nearest && place[i] != i && k > place[i])) return;
      nearest = d;
      place[i] = k;
    };
    for (std::int64_t x = -1; x <= 1; ++x)
      for (std::int64_t y = -1; y <= 1; ++y)
        for (std::int64_t z = -1; z <= 1; ++z)
          table.for_each({cell[0] + x, cell[1] + y, cell[2] + z}, look_at);
    if (place[i] == i) table.enter(cell, i);
  }
  return place;
}

OpenSeams open_seams(const std::vector<Index>& boundary, const std::vector<Point3>& points) {
  std::vector<Index> vertices = boundary;
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::vector<Point3> at;
  at.reserve(vertices.size());
  for (const Index v : vertices) at.push_back(points[v]);
  const std::vector<Index> place = places_of(at);
  OpenSeams seams;
  for (Index i = 0; i < static_cast<Index>(place.size()); ++i) seams.vertices += place[i] != i;
  if (seams.vertices == 0) return seams;
  const auto place_at = [&](Index v) {
    return place[std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin()];
  };
  std::vector<std::uint64_t> edges;
  for (std::size_t k = 0; k + 1 < boundary.size(); k += 2)
    edges.push_back(detail::edge_between(place_at(boundary[k]), place_at(boundary[k + 1])));
  std::sort(edges.begin(), edges.end());
  for (std::size_t k = 0, last = 0; k < edges.size(); k = last) {
    for (last = k + 1; last < edges.size() && edges[last] == edges[k];) ++last;
    seams.edges += last - k == 2;
  }
  return seams;
}

}  // namespace limn::mesh
