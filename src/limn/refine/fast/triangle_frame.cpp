#include "limn/refine/fast/triangle_frame.h"

#include <algorithm>

namespace limn::fast {
namespace {

/// The inner points of an edge along one of its half-edges: point t is first + (t - 1) · step.
struct Along {
  Along(const TriangleLayout& layout, FaceTopology::Code code)
      : step((code & 1) != 0 ? 1 : -1), first(layout.point_along(code, 1)) {}
  [[nodiscard]] Index operator()(Index t) const { return first + (t - 1) * step; }
  Index step, first;
};

/// Row r beyond a side: column r of the neighbour in the frame of its half-edge `next`.
Index* number_row(const TriangleLayout& layout, const FaceTopology::Neighbour& across, Index r,
                  Index* out) {
  const Index last = layout.n() - r;
  if (last == 0) {
    *out++ = across.apex;
    return out;
  }
  *out++ = Along(layout, across.next)(r);
  // the inner points' numbers are a quadratic sequence
  Index number = layout.face_begin(across.face), step = 0, bend = -1;
  if (across.side == 0) {
    number += r - 1;
    step = layout.n() - 2;
  } else if (across.side == 1) {
    number += layout.row_begin(r) + last - 2;
    step = -1;
    bend = 0;
  } else {
    number += layout.row_begin(last - 1);
    step = -r;
  }
  for (Index y = 1; y < last; ++y, step += bend) {
    *out++ = number;
    number += step;
  }
  *out++ = Along(layout, across.prev)(last);
  return out;
}

}  // namespace

Offset in_patch(Index n, Index side, Offset point) {
  for (; side > 0; --side) point = {n - point.a - point.b, point.a};
  return point;
}

std::vector<Offset> frame_places(Index n, Index halo) {
  std::vector<Offset> places;
  places.reserve(3 * static_cast<std::size_t>(n + halo * n));
  for (Index side = 0; side < 3; ++side) places.push_back(in_patch(n, side, {0, 0}));
  for (Index side = 0; side < 3; ++side)
    for (Index t = 1; t < n; ++t) places.push_back(in_patch(n, side, {t, 0}));
  for (Index side = 0; side < 3; ++side)
    for (Index r = 1; r <= halo; ++r)
      for (Index i = 0; i <= n - r; ++i) places.push_back(in_patch(n, side, {r + i, -r}));
  return places;
}

std::vector<Offset> inner_places(Index n) {
  std::vector<Offset> places;
  places.reserve(static_cast<std::size_t>((n - 1) * (n - 2) / 2));
  for (Index y = 1; y < n; ++y)
    for (Index x = 1; x + y < n; ++x) places.push_back({x, y});
  return places;
}

FaceTopology face_topology(const TriangleLayout& layout, Index f) {
  const Mesh& mesh = layout.control();
  FaceTopology face;
  for (std::size_t side = 0; side < 3; ++side) {
    const Index h = 3 * f + static_cast<Index>(side), twin = mesh.twin(h);
    face.corners[side] = mesh.origin(h);
    face.sides[side] = layout.code(h);
    if (twin == kNone) continue;
    const Index next = mesh.next(twin), prev = mesh.next(next), across = mesh.face(twin);
    face.across[side] = {across, next - 3 * across, mesh.origin(prev), layout.code(next),
                         layout.code(prev)};
  }
  return face;
}

void number_frame(const TriangleLayout& layout, const FaceTopology& face, Index halo, Index* out) {
  const Index n = layout.n();
  out = std::copy(face.corners.begin(), face.corners.end(), out);
  if (n > 1)
    for (const FaceTopology::Code side : face.sides) {
      const Along along(layout, side);
      for (Index t = 1; t < n; ++t) *out++ = along(t);
    }
  for (const FaceTopology::Neighbour& across : face.across)
    for (Index r = 1; r <= halo; ++r)
      out = across.face == kNone ? std::fill_n(out, n - r + 1, face.corners[0])
                                 : number_row(layout, across, r, out);
}

}  // namespace limn::fast
