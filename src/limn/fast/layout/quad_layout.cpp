#include "limn/fast/layout/quad_layout.h"

#include <cassert>
#include <cstring>
#include <utility>
#include <vector>

namespace limn::fast {
namespace {

/// The corners of n faces between two rows of n + 1 numbers each; reads one number past them.
Index* write_between(const Index* low, const Index* high, Index n, Index* out) {
  typedef Index Four __attribute__((vector_size(16)));
  const auto put = [](const Four& four, Index* to) { std::memcpy(to, &four, sizeof four); };
  Index x = 0;
  for (; x + 1 < n; x += 2, out += 8) {
    Four l, h;
    std::memcpy(&l, low + x, sizeof l);
    std::memcpy(&h, high + x, sizeof h);
    put(__builtin_shufflevector(l, h, 0, 1, 5, 4), out);
    put(__builtin_shufflevector(l, h, 1, 2, 6, 5), out + 4);
  }
  if (x == n) return out;
  put(Four{low[x], low[x + 1], high[x + 1], high[x]}, out);
  return out + 4;
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

/// The numbers of a patch, row by row.
class QuadLayout::Rows {
 public:
  explicit Rows(const QuadLayout& layout)
      : layout_(layout),
        numbers_(static_cast<std::size_t>((layout.n() + 1) * (layout.n() + 1)) + 1) {}

  void fill(Index f) {
    const Mesh& mesh = layout_.control();
    const Index n = layout_.n(), h = 4 * f;
    const AlongEdge bottom(layout_, edge_code(mesh, h)), right(layout_, edge_code(mesh, h + 1)),
        top(layout_, edge_code(mesh, h + 2)), left(layout_, edge_code(mesh, h + 3));
    Index* row = numbers_.data();
    row[0] = mesh.origin(h);
    for (Index x = 1; x < n; ++x) row[x] = bottom(x);
    row[n] = mesh.origin(h + 1);
    row += n + 1;
    Index inside = layout_.face_begin(f);
    for (Index y = 1; y < n; ++y, row += n + 1, inside += n - 1) {
      row[0] = left(n - y);
      for (Index x = 1; x < n; ++x) row[x] = inside + x - 1;
      row[n] = right(y);
    }
    row[0] = mesh.origin(h + 3);
    for (Index x = 1; x < n; ++x) row[x] = top(n - x);
    row[n] = mesh.origin(h + 2);
  }

  void swap(Rows& other) { numbers_.swap(other.numbers_); }

  /// The corners of the patch's faces; returns past the last.
  Index* write(Index* out) const {
    const Index n = layout_.n();
    const Index* row = numbers_.data();
    for (Index y = 0; y < n; ++y, row += n + 1) out = write_between(row, row + n + 1, n, out);
    return out;
  }

 private:
  const QuadLayout& layout_;
  std::vector<Index> numbers_;  // and what write_between may read after them
};

void QuadLayout::write_faces(Index first, Index last, Index* out) const {
  // vectors are read of what was written in single numbers: not at once
  Rows patch(*this), next(*this);
  patch.fill(first);
  for (Index f = first; f < last; ++f) {
    if (f + 1 < last) next.fill(f + 1);
    out = patch.write(out);
    patch.swap(next);
  }
}

}  // namespace limn::fast
