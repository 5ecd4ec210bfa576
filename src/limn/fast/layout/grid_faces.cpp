// The faces of the levels of a GridLayout, several corners at a time.

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

#include "limn/base/parallel.h"
#include "limn/fast/layout/grid_layout.h"

namespace limn::fast {
namespace {

typedef Index Four __attribute__((vector_size(16)));

void put(const Four& four, Index* to) { std::memcpy(to, &four, sizeof four); }

/// The corners of 2 · pairs faces between two rows, and unless `pairs` is even six numbers after
/// them, that are to be overwritten; reads as far as row[pairs + 2]. Returns past the last corner.
Index* write_pairs(const Index* low, const Index* high, Index pairs, Index* out) {
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

/// The corners of n faces between two rows of n + 1 numbers each; reads one number past them.
Index* write_between(const Index* low, const Index* high, Index n, Index* out) {
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

/// The inner points of an edge along one of its half-edges.
class AlongEdge {
 public:
  AlongEdge(const GridLayout& points, EdgeCode code)
      : origin_(points.point_along(code, 0)), step_(2 * (code & 1) - 1) {}
  /// Point t, 0 < t < n.
  [[nodiscard]] Index operator()(Index t) const { return origin_ + t * step_; }

 private:
  Index origin_, step_;
};

/// The numbers of a patch's grid points, row by row.
template <bool kTriangles>
class Rows {
 public:
  explicit Rows(const GridLayout& layout)
      : layout_(layout),
        numbers_(static_cast<std::size_t>((layout.n() + 1) * (layout.n() + 1)) + 2) {}

  void fill(Index f) {
    const Mesh& mesh = layout_.control();
    const Index n = layout_.n(), sides = kTriangles ? 3 : 4, h = sides * f;
    const auto along = [&](Index k) { return AlongEdge(layout_, edge_code(mesh, h + k)); };
    const AlongEdge bottom = along(0), right = along(1), left = along(sides - 1);
    Index inside = layout_.face_begin(f);
    Index* row = numbers_.data();
    row[0] = mesh.origin(h);
    for (Index x = 1; x < n; ++x) row[x] = bottom(x);
    row[n] = mesh.origin(h + 1);
    row += n + 1;
    for (Index y = 1; y < n; ++y) {
      const Index last = kTriangles ? n - y : n;
      row[0] = left(n - y);
      for (Index x = 1; x < last; ++x) row[x] = inside + x - 1;
      row[last] = right(y);
      inside += last - 1;
      row += last + 1;
    }
    row[0] = mesh.origin(h + sides - 1);
    if (kTriangles) return;
    const AlongEdge top = along(2);
    for (Index x = 1; x < n; ++x) row[x] = top(n - x);
    row[n] = mesh.origin(h + 2);
  }

  /// The numbers of a row of quads.
  [[nodiscard]] const Index* row(Index y) const { return numbers_.data() + y * (layout_.n() + 1); }

  [[nodiscard]] const Index* first() const { return numbers_.data(); }
  void swap(Rows& other) { numbers_.swap(other.numbers_); }

  /// The corners of the patch's faces; returns past the last.
  Index* write(Index* out) const { return kTriangles ? write_triangles(out) : write_quads(out); }

 private:
  Index* write_triangles(Index* out) const {
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

  Index* write_quads(Index* out) const {
    const Index n = layout_.n();
    const Index* row = numbers_.data();
    for (Index y = 0; y < n; ++y, row += n + 1) out = write_between(row, row + n + 1, n, out);
    return out;
  }

  const GridLayout& layout_;
  std::vector<Index> numbers_;  // and what the writers may read after them
};

/// The faces of a patch of triangles that have centres, row by row.
class CentreFaces {
 public:
  explicit CentreFaces(const GridLayout& layout)
      : layout_(layout),
        n_(layout.n()),
        points_(layout),
        down_(static_cast<std::size_t>((n_ + 1) * (n_ + 1))) {}

  Index* patch(Index f, Index* out) {
    points_.fill(f);
    number_down(f);
    const Index* low = points_.first();
    Index own = layout_.centre_begin(f);  // of the triangle that points up
    for (Index y = 0; y < n_; ++y) {
      const Index last = n_ - 1 - y, above = own + 2 * last + 1;
      const Index* high = low + last + 2;
      for (Index x = 0; x < last; ++x, own += 2) {
        out = up(low + x, high + x, x, y, own, out);
        out = add(low[x + 1], high[x + 1], own + 2, own + 1, out);
        out = add(high[x + 1], high[x], above + 2 * x, own + 1, out);
        out = add(high[x], low[x + 1], own, own + 1, out);
      }
      out = up(low + last, high + last, last, y, own, out);
      own = above;
      low = high;
    }
    return out;
  }

 private:
  /// The centre of the triangle that points down beside the one that points up at (x, y): beyond
  /// the patch where x or y is -1 or x + y is n - 1.
  [[nodiscard]] Index& down(Index x, Index y) {
    return down_[static_cast<std::size_t>((y + 1) * (n_ + 1) + x + 1)];
  }

  void number_down(Index f) {
    const Mesh& mesh = layout_.control();
    Index row = layout_.centre_begin(f);
    for (Index y = 0; y < n_; row += 2 * (n_ - y) - 1, ++y)
      for (Index x = 0; x < n_ - 1 - y; ++x) down(x, y) = row + 2 * x + 1;
    for (Index side = 0; side < 3; ++side) {
      const Index twin = mesh.twin(3 * f + side);
      for (Index t = 0; t < n_; ++t) {
        const Index last = n_ - 1 - t;
        Index& beyond = side == 0 ? down(t, -1) : side == 1 ? down(last, t) : down(-1, last);
        beyond = twin == kNone ? kNone : layout_.point(twin, 3 * last + 1, 1);
      }
    }
  }

  /// The face at the half-edge from a to b.
  static Index* add(Index a, Index b, Index across, Index own, Index* out) {
    out[0] = a;
    out[1] = across == kNone ? b : across;
    out[2] = own;
    return out + 3;
  }

  /// Those of a triangle that points up.
  Index* up(const Index* low, const Index* high, Index x, Index y, Index own, Index* out) {
    out = add(low[0], low[1], down(x, y - 1), own, out);
    out = add(low[1], high[0], down(x, y), own, out);
    return add(high[0], low[0], down(x - 1, y), own, out);
  }

  const GridLayout& layout_;
  Index n_;
  Rows<true> points_;
  std::vector<Index> down_;
};

Index* put_quad(Index a, Index b, Index c, Index d, Index* out) {
  put(Four{a, b, c, d}, out);
  return out + 4;
}

/// The faces within a patch of quads that have centres.
Index* write_inner_edges(const GridLayout& layout, Index f, const Rows<false>& points, Index* out) {
  const Index n = layout.n();
  Index own = layout.centre_begin(f);  // of the row of cells
  for (Index y = 0; y < n; ++y, own += n) {
    const Index *low = points.row(y), *high = points.row(y + 1);
    for (Index x = 1; x < n; ++x) out = put_quad(low[x], own + x, high[x], own + x - 1, out);
    for (Index x = 0; x < n && y + 1 < n; ++x)
      out = put_quad(high[x], own + x, high[x + 1], own + n + x, out);
  }
  return out;
}

template <bool kTriangles>
void write_grid(const GridLayout& layout, Index first, Index last, Index* out) {
  // vectors are read of what was written in single numbers: not at once
  Rows<kTriangles> patch(layout), next(layout);
  patch.fill(first);
  for (Index f = first; f < last; ++f) {
    if (f + 1 < last) next.fill(f + 1);
    out = patch.write(out);
    patch.swap(next);
  }
}

}  // namespace

void GridLayout::write_faces(Index first, Index last, Index* out) const {
  if (!centres_)
    return sides_ == 3 ? write_grid<true>(*this, first, last, out)
                       : write_grid<false>(*this, first, last, out);
  if (sides_ == 4) {
    Rows<false> points(*this);
    for (Index f = first; f < last; ++f) {
      points.fill(f);
      out = write_inner_edges(*this, f, points, out);
    }
    return;
  }
  CentreFaces faces(*this);
  for (Index f = first; f < last; ++f) out = faces.patch(f, out);
}

std::vector<Index> GridLayout::boundary_before() const {
  std::vector<Index> before{0};
  before.reserve(static_cast<std::size_t>(control().edge_count()) + 1);
  for (Index e = 0; e < control().edge_count(); ++e)
    before.push_back(before.back() + (control().is_boundary_edge(e) ? 1 : 0));
  return before;
}

void GridLayout::write_edge_faces(Index* out) const {
  if (edge_faces() == 0) return;
  const Mesh& mesh = control();
  const std::vector<Index> before = boundary_before();
  base::parallel_for_each(mesh.edge_count(), [&](Index e) {
    const Index h = mesh.halfedge_of_edge(e), twin = mesh.twin(h), last = n() - 1;
    Index* to = out + std::ptrdiff_t{n()} * (std::ptrdiff_t{4} * e - before[e]);
    for (Index t = 0; t <= last; ++t) {
      const Index v = point(h, unit_ * t, 0), w = point(h, unit_ * (t + 1), 0);
      const Index left = point(h, unit_ * t + 1, 1);
      if (twin != kNone) {
        to = put_quad(v, point(twin, unit_ * (last - t) + 1, 1), w, left, to);
        continue;
      }
      to[0] = v;
      to[1] = w;
      to[2] = left;
      to += 3;
    }
  });
}

void GridLayout::write_face_begin(Index* out) const {
  const Index inside = control().face_count() * patch_faces();
  for (Index f = 0; f <= inside; ++f) out[f] = sides_ * f;
  if (edge_faces() == 0) return;
  Index* to = out + inside;
  for (Index e = 0; e < control().edge_count(); ++e)
    for (Index t = 0; t < n(); ++t, ++to) to[1] = to[0] + (control().is_boundary_edge(e) ? 3 : 4);
}

}  // namespace limn::fast
