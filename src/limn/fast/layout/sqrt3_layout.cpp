#include "limn/fast/layout/sqrt3_layout.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>
#include <vector>

namespace limn::fast {

Index CentroidLayout::point_beyond(Index h, Index x, Index y) const {
  const Mesh& mesh = control();
  const Index side = 3 * n_;
  if (x >= 0 && y >= 0 && x + y <= side) return point(h, x, y);
  if (x < 0) {  // the next sector of the frame's corner
    const Index turned = mesh.twin(mesh.prev(h));
    return turned == kNone ? kNone : point(turned, x + y, -x);
  }
  if (y < 0) {  // the sector before it
    const Index across = mesh.twin(h);
    return across == kNone ? kNone : point(mesh.next(across), -y, x + y);
  }
  const Index across = mesh.twin(mesh.next(h));
  return across == kNone ? kNone : point(mesh.next(across), x + y - side, side - x);
}

Index* CentroidLayout::column(Index h, Index x, Index* out) const {
  const Index begin = x / 3;
  if (x % 3 == 0) {
    grid_.column(h, begin, out, 1);
    return out + (n_ - begin + 1);
  }
  const bool down = x % 3 == 2;
  const Index k = h - 3 * control().face(h), count = n_ - begin - (down ? 1 : 0);
  // the numbers are a quadratic sequence, in whatever frame
  Index number = centroid(h, begin, 0, down);
  Index step = k == 0 ? 2 * n_ - 1 : k == 1 ? -2 : -2 * (begin + (down ? 1 : 0)) - 1;
  const Index bend = k == 1 ? 0 : -2;
  for (Index i = 0; i < count; ++i) {
    *out++ = number;
    number += step;
    step += bend;
  }
  return out;
}

/// The faces of a patch, row by row.
class CentroidLayout::Writer {
 public:
  explicit Writer(const CentroidLayout& layout)
      : layout_(layout), n_(layout.n_), rows_(2 * static_cast<std::size_t>(n_) + 2) {
    for (std::vector<Index>& side : across_) side.resize(static_cast<std::size_t>(n_));
    for (std::vector<Index>& side : sides_) side.resize(static_cast<std::size_t>(n_) + 1);
  }

  Index* patch(Index f, Index* out) {
    look_round(f);
    Index* low = rows_.data();
    Index* high = low + n_ + 1;
    std::copy(sides_[0].begin(), sides_[0].end(), low);
    Index inner = layout_.grid_.face_begin(f);           // of the row above
    Index own = layout_.centroid_begin(f), below = own;  // of the row, of the row below
    for (Index y = 0; y < n_; ++y) {
      const Index ups = n_ - y, above = own + 2 * ups - 1;
      high[0] = sides_[2][ups - 1];
      for (Index x = 1; x < ups - 1; ++x) high[x] = inner++;
      high[ups - 1] = sides_[1][y + 1];
      out = row(y, low, high, {below, own, above}, out);
      below = own;
      own = above;
      std::swap(low, high);
    }
    return out;
  }

 private:
  /// Where the centroids of three rows begin.
  struct Begins {
    Index below, own, above;
  };

  /// The vertices along the three sides, from the origin of each to its target, and the centroids
  /// beyond them, or at the boundary kNone.
  void look_round(Index f) {
    const Mesh& mesh = layout_.control();
    const TriangleLayout& grid = layout_.grid_;
    for (std::size_t side = 0; side < 3; ++side) {
      const Index h = 3 * f + static_cast<Index>(side), twin = mesh.twin(h);
      Index* vertex = sides_[side].data();
      vertex[0] = mesh.origin(h);
      vertex[n_] = mesh.target(h);
      const AlongEdge along(grid, edge_code(mesh, h));
      for (Index t = 1; t < n_; ++t) vertex[t] = along(t);
      for (Index t = 0; t < n_; ++t)
        across_[side][t] = twin == kNone ? kNone : layout_.centroid(twin, n_ - 1 - t, 0, false);
    }
  }

  /// The face at the half-edge from a to b.
  static Index* put(Index a, Index b, Index across, Index own, Index* out) {
    out[0] = a;
    out[1] = across == kNone ? b : across;
    out[2] = own;
    return out + 3;
  }

  Index* row(Index y, const Index* low, const Index* high, const Begins& begins, Index* out) const {
    const Index last = n_ - y - 1;  // the triangle that points up at the end of the row
    for (Index x = 0; x <= last; ++x) {
      const Index own = begins.own + 2 * x;
      const Index under = y == 0 ? across_[0][x] : begins.below + 2 * x + 1;
      if (x > 0 && x < last && y > 0) {
        out = pair(low + x, high + x, own, under, begins.above + 2 * x, out);
        continue;
      }
      out = put(low[x], low[x + 1], under, own, out);
      out = put(low[x + 1], high[x], x < last ? own + 1 : across_[1][y], own, out);
      out = put(high[x], low[x], x > 0 ? own - 1 : across_[2][last], own, out);
      if (x < last) out = down(low + x, high + x, own, begins.above + 2 * x, out);
    }
    return out;
  }

  /// A triangle that points down, and is between inner ones always.
  static Index* down(const Index* low, const Index* high, Index up, Index above, Index* out) {
    out = put(low[1], high[1], up + 2, up + 1, out);
    out = put(high[1], high[0], above, up + 1, out);
    return put(high[0], low[1], up, up + 1, out);
  }

  /// One that points up and one that points down, all neighbours being in the patch.
  static Index* pair(const Index* low, const Index* high, Index own, Index under, Index above,
                     Index* out) {
    out = put(low[0], low[1], under, own, out);
    out = put(low[1], high[0], own + 1, own, out);
    out = put(high[0], low[0], own - 1, own, out);
    return down(low, high, own, above, out);
  }

  const CentroidLayout& layout_;
  Index n_;
  std::vector<Index> rows_;
  std::array<std::vector<Index>, 3> sides_, across_;
};

void CentroidLayout::write_faces(Index first, Index last, Index* out) const {
  Writer writer(*this);
  for (Index f = first; f < last; ++f) out = writer.patch(f, out);
}

}  // namespace limn::fast
