#include "limn/refine/fast/triangle_layout.h"

#include <array>
#include <cassert>
#include <cstring>
#include <utility>
#include <vector>

namespace limn::fast {
namespace {

/// The faces between two rows, begin ≤ x < end; returns past the last.
Index* write_pairs(const Index* low, const Index* high, Index begin, Index end, Index* out) {
  for (Index x = begin; x < end; ++x, out += 6) {
    out[0] = low[x];
    out[1] = low[x + 1];
    out[2] = high[x];
    out[3] = low[x + 1];
    out[4] = high[x + 1];
    out[5] = high[x];
  }
  return out;
}

/// The same for an even number of pairs between rows low, low + 1, … and high, high + 1, …
Index* write_consecutive(Index low, Index high, Index pairs, Index* out) {
  typedef Index Four __attribute__((vector_size(16)));
  std::array<Four, 3> corners{{{low, low + 1, high, low + 1},
                               {high + 1, high, low + 1, low + 2},
                               {high + 1, low + 2, high + 2, high + 1}}};
  for (Index x = 0; x < pairs; x += 2) {
    for (Four& four : corners) {
      std::memcpy(out, &four, sizeof four);
      four += 2;
      out += 4;
    }
  }
  return out;
}

}  // namespace

Index TriangleLayout::point(Index h, Index x, Index y) const {
  assert(x >= 0 && y >= 0 && x + y <= n_);
  if (y == 0) return x == 0 ? mesh_->origin(h) : x == n_ ? mesh_->target(h) : edge_point(h, x);
  const Index f = mesh_->face(h);
  const Index first = 3 * f;
  for (Index k = h - first; k > 0; --k) {  // a corner back: the origin was at (n, 0)
    const Index old = x;
    x = n_ - x - y;
    y = old;
  }
  if (y == 0 && x > 0) return x == n_ ? mesh_->origin(first + 1) : edge_point(first, x);
  if (y == 0) return mesh_->origin(first);
  if (x == 0) return y == n_ ? mesh_->origin(first + 2) : edge_point(first + 2, n_ - y);
  if (x + y == n_) return edge_point(first + 1, y);
  return face_begin(f) + row_begin(y) + x - 1;
}

Index TriangleLayout::point_beyond(Index h, Index x, Index y) const {
  if (x >= 0 && y >= 0 && x + y <= n_) return point(h, x, y);
  if (x < 0) {  // the next sector of the frame's corner
    const Index turned = mesh_->twin(mesh_->prev(h));
    return turned == kNone ? kNone : point(turned, x + y, -x);
  }
  if (y < 0) {  // the sector before it
    const Index across = mesh_->twin(h);
    return across == kNone ? kNone : point(mesh_->next(across), -y, x + y);
  }
  const Index across = mesh_->twin(mesh_->next(h));
  return across == kNone ? kNone : point(mesh_->next(across), x + y - n_, n_ - x);
}

void TriangleLayout::column(Index h, Index x, Index* out, std::ptrdiff_t stride) const {
  const Index f = mesh_->face(h), k = h - 3 * f, last = n_ - x;
  *out = x == n_ ? mesh_->target(h) : edge_point(h, x);
  if (last == 0) return;
  out[last * stride] = edge_point(mesh_->next(h), last);
  // the inner points' numbers are a quadratic sequence, in whatever frame
  Index number = last > 1 ? point(h, x, 1) : 0;
  Index step = k == 0 ? n_ - 2 : k == 1 ? -1 : -x;
  const Index bend = k == 1 ? 0 : -1;
  for (Index y = 1; y < last; ++y) {
    out[y * stride] = number;
    number += step;
    step += bend;
  }
}

/// A patch's rows of numbers, one after the other.
class TriangleLayout::Rows {
 public:
  Rows(const TriangleLayout& layout, Index f) : n_(layout.n_), inside_(layout.face_begin(f)) {
    for (Index side = 0; side < 3; ++side) {
      const Index h = 3 * f + side;
      corners_[side] = layout.mesh_->origin(h);
      if (n_ < 2) continue;
      firsts_[side] = layout.edge_point(h, 1);
      steps_[side] = layout.leads(h) ? 1 : -1;
    }
  }

  /// The next row: n + 1 numbers, then n, … down to one.
  void next(Index* row) {
    const Index y = y_++, last = n_ - y;
    row[0] = y == 0 ? corners_[0] : last == 0 ? corners_[2] : along(2, last);
    if (last == 0) return;
    row[last] = y == 0 ? corners_[1] : along(1, y);
    if (y == 0) {
      for (Index x = 1; x < last; ++x) row[x] = along(0, x);
    } else {
      for (Index x = 1; x < last; ++x) row[x] = inside_++;
    }
  }

 private:
  /// Point t along a side.
  [[nodiscard]] Index along(std::size_t side, Index t) const {
    return firsts_[side] + (t - 1) * steps_[side];
  }

  Index n_, inside_, y_ = 0;
  std::array<Index, 3> corners_{}, firsts_{}, steps_{};
};

void TriangleLayout::write_faces(Index first, Index last, Index* out) const {
  std::vector<Index> rows(2 * static_cast<std::size_t>(n_) + 2);
  for (Index f = first; f < last; ++f) {
    Index* low = rows.data();
    Index* high = low + n_ + 1;
    Rows patch(*this, f);
    patch.next(low);
    for (Index y = 0; y < n_; ++y) {
      patch.next(high);
      const Index pairs = n_ - y - 1;  // of a face that points up and one that points down
      // the inner points of a row have consecutive numbers
      const Index even = y > 0 && pairs > 2 ? (pairs - 2) & ~1 : 0;
      if (even > 0) {
        out = write_pairs(low, high, 0, 1, out);
        out = write_consecutive(low[1], high[1], even, out);
      }
      out = write_pairs(low, high, even > 0 ? even + 1 : 0, pairs, out);
      out[0] = low[pairs];
      out[1] = low[pairs + 1];
      out[2] = high[pairs];
      out += 3;
      std::swap(low, high);
    }
  }
}

}  // namespace limn::fast
