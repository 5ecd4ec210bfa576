#include "limn/refine/fast/quad_layout.h"

#include <cassert>
#include <cstring>
#include <utility>
#include <vector>

namespace limn::fast {
namespace {

/// The faces between two rows, begin ≤ x < end; returns past the last.
Index* write_between(const Index* low, const Index* high, Index begin, Index end, Index* out) {
  for (Index x = begin; x < end; ++x, out += 4) {
    out[0] = low[x];
    out[1] = low[x + 1];
    out[2] = high[x + 1];
    out[3] = high[x];
  }
  return out;
}

/// The same between rows low, low + 1, … and high, high + 1, …
Index* write_consecutive(Index low, Index high, Index count, Index* out) {
  typedef Index Four __attribute__((vector_size(16)));
  Four corners{low, low + 1, high + 1, high};
  for (Index x = 0; x < count; ++x, out += 4, corners += 1)
    std::memcpy(out, &corners, sizeof corners);
  return out;
}

}  // namespace

QuadLayout::QuadLayout(const Mesh& control, Index n)
    : EdgePoints(control, n),
      face_size_((n - 1) * (n - 1)),
      faces_at_(edges_end()),
      // turned by a quarter, (x, y) of a frame is (n - y, x) of the one before
      frames_{{{-n, 1, n - 1}, {0, n - 1, -1}, {n * (n - 1), -1, 1 - n}, {n * (n - 2), 1 - n, 1}}} {
}

Index QuadLayout::point_on_sides(Index h, Index x, Index y) const {
  assert(0 <= x && x <= n() && 0 <= y && y <= n());
  // corner k is where side k begins
  const auto corner = [&](Index k) { return control().origin(turned(h, k)); };
  if (y == 0) return x == 0 ? corner(0) : x == n() ? corner(1) : edge_point(h, x);
  if (x == 0) return y == n() ? corner(3) : edge_point(turned(h, 3), n() - y);
  if (x == n()) return y == n() ? corner(2) : edge_point(turned(h, 1), y);
  return edge_point(turned(h, 2), n() - x);
}

Index QuadLayout::point_beyond(Index h, Index x, Index y) const {
  // in the frame of the neighbour across the side
  const auto across = [&](Index side, Index along, Index up) {
    const Index twin = control().twin(side);
    return twin == kNone ? kNone : point(twin, along, up);
  };
  if (y < 0) return across(h, n() - x, -y);
  if (x < 0) return across(turned(h, 3), y, -x);
  if (x > n()) return across(turned(h, 1), n() - y, x - n());
  if (y > n()) return across(turned(h, 2), x, y - n());
  return point(h, x, y);
}

void QuadLayout::row(Index h, Index y, Index* out) const {
  out[0] = point(h, 0, y);
  out[n()] = point(h, n(), y);
  if (n() == 1) return;
  Index number = point(h, 1, y);
  const Index step = n() == 2 ? 0 : point(h, 2, y) - number;
  for (Index x = 1; x < n(); ++x, number += step) out[x] = number;
}

void QuadLayout::write_faces(Index first, Index last, Index* out) const {
  std::vector<Index> rows(2 * static_cast<std::size_t>(n()) + 2);
  for (Index f = first; f < last; ++f) {
    Index* low = rows.data();
    Index* high = low + n() + 1;
    row(4 * f, 0, low);
    for (Index y = 0; y < n(); ++y) {
      row(4 * f, y + 1, high);
      // the inner points of a row have consecutive numbers
      const bool inner = y > 0 && y + 1 < n();
      if (inner) {
        out = write_between(low, high, 0, 1, out);
        out = write_consecutive(low[1], high[1], n() - 2, out);
      }
      out = write_between(low, high, inner ? n() - 1 : 0, n(), out);
      std::swap(low, high);
    }
  }
}

}  // namespace limn::fast
