#include "limn/fast/layout/triangle_layout.h"

#include <array>
#include <cassert>
#include <cstring>
#include <utility>
#include <vector>

namespace limn::fast {
namespace {

/// The corners of 2 · pairs faces between two rows, and unless `pairs` is even six numbers after
/// them, that are to be overwritten; reads as far as row[pairs + 2]. Returns past the last corner.
Index* write_pairs(const Index* low, const Index* high, Index pairs, Index* out) {
  typedef Index Four __attribute__((vector_size(16)));
  const auto put = [](const Four& four, Index* to) { std::memcpy(to, &four, sizeof four); };
  Index* to = out;
  for (Index x = 0; x < pairs; x += 2, to += 12) {
    Four l, h;
    std::memcpy(&l, low + x, sizeof l);
    std::memcpy(&h, high + x, sizeof h);
    put(__builtin_shufflevector(l, h, 0, 1, 4, 1), to);
    put(__builtin_shufflevector(l, h, 5, 4, 1, 2), to + 4);
    put(__builtin_shufflevector(l, h, 5, 2, 6, 5), to + 8);
  }
  return out + std::ptrdiff_t{6} * pairs;
}

}  // namespace

Index TriangleLayout::point(Index h, Index x, Index y) const {
  assert(x >= 0 && y >= 0 && x + y <= n());
  if (y == 0)
    return x == 0 ? control().origin(h) : x == n() ? control().target(h) : edge_point(h, x);
  const Index f = control().face(h);
  const Index first = 3 * f;
  for (Index k = h - first; k > 0; --k) {  // a corner back: the origin was at (n, 0)
    const Index old = x;
    x = n() - x - y;
    y = old;
  }
  if (y == 0 && x > 0) return x == n() ? control().origin(first + 1) : edge_point(first, x);
  if (y == 0) return control().origin(first);
  if (x == 0) return y == n() ? control().origin(first + 2) : edge_point(first + 2, n() - y);
  if (x + y == n()) return edge_point(first + 1, y);
  return face_begin(f) + row_begin(y) + x - 1;
}

Index TriangleLayout::point_beyond(Index h, Index x, Index y) const {
  if (x >= 0 && y >= 0 && x + y <= n()) return point(h, x, y);
  if (x < 0) {  // the next sector of the frame's corner
    const Index turned = control().twin(control().prev(h));
    return turned == kNone ? kNone : point(turned, x + y, -x);
  }
  if (y < 0) {  // the sector before it
    const Index across = control().twin(h);
    return across == kNone ? kNone : point(control().next(across), -y, x + y);
  }
  const Index across = control().twin(control().next(h));
  return across == kNone ? kNone : point(control().next(across), x + y - n(), n() - x);
}

void TriangleLayout::column(Index h, Index x, Index* out, std::ptrdiff_t stride) const {
  const Index f = control().face(h), k = h - 3 * f, last = n() - x;
  *out = x == n() ? control().target(h) : edge_point(h, x);
  if (last == 0) return;
  out[last * stride] = edge_point(control().next(h), last);
  // the inner points' numbers are a quadratic sequence, in whatever frame
  const Index row = k == 0 ? 1 : k == 1 ? x : last - 1, along = k == 0 ? x : k == 1 ? last - 1 : 1;
  Index number = face_begin(f) + row_begin(row) + along - 1;
  Index step = k == 0 ? n() - 2 : k == 1 ? -1 : -x;
  const Index bend = k == 1 ? 0 : -1;
  for (Index y = 1; y < last; ++y) {
    out[y * stride] = number;
    number += step;
    step += bend;
  }
}

/// The numbers of a patch, row by row.
class TriangleLayout::Rows {
 public:
  explicit Rows(const TriangleLayout& layout)
      : layout_(layout),
        numbers_(static_cast<std::size_t>((layout.n() + 1) * (layout.n() + 2) / 2) + 2) {}

  void fill(Index f) {
    const Mesh& mesh = layout_.control();
    const Index n = layout_.n(), h = 3 * f;
    const AlongEdge bottom(layout_, edge_code(mesh, h)), slope(layout_, edge_code(mesh, h + 1)),
        left(layout_, edge_code(mesh, h + 2));
    Index inside = layout_.face_begin(f);
    Index* row = numbers_.data();
    row[0] = mesh.origin(h);
    for (Index x = 1; x < n; ++x) row[x] = bottom(x);
    row[n] = mesh.origin(h + 1);
    row += n + 1;
    for (Index last = n - 1; last > 0; row += last + 1, --last) {
      row[0] = left(last);
      for (Index x = 1; x < last; ++x) row[x] = inside + x - 1;
      inside += last - 1;
      row[last] = slope(n - last);
    }
    row[0] = mesh.origin(h + 2);
  }

  void swap(Rows& other) { numbers_.swap(other.numbers_); }

  /// The corners of the patch's faces; returns past the last.
  Index* write(Index* out) const {
    const Index* low = numbers_.data();
    for (Index last = layout_.n(); last > 0; --last) {
      const Index* high = low + last + 1;
      out = write_pairs(low, high, last - 1, out);
      // after one pair six more corners follow: the row's last face, and the patch's
      out[0] = low[last - 1];
      out[1] = low[last];
      out[2] = high[last - 1];
      out += 3;
      low = high;
    }
    return out;
  }

 private:
  const TriangleLayout& layout_;
  std::vector<Index> numbers_;  // and what write_pairs may read after them
};

void TriangleLayout::write_faces(Index first, Index last, Index* out) const {
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
