#include "limn/fast/layout/triangle_frame.h"

#include <algorithm>

namespace limn::fast {
Offset in_triangle_patch(Index n, Index side, Offset point) {
  for (; side > 0; --side) point = {n - point.a - point.b, point.a};
  return point;
}

std::vector<Offset> triangle_frame_places(Index n, Index halo) {
  std::vector<Offset> places;
  places.reserve(3 * static_cast<std::size_t>(n + halo * n));
  for (Index side = 0; side < 3; ++side) places.push_back(in_triangle_patch(n, side, {0, 0}));
  for (Index side = 0; side < 3; ++side)
    for (Index t = 1; t < n; ++t) places.push_back(in_triangle_patch(n, side, {t, 0}));
  for (Index side = 0; side < 3; ++side)
    for (Index r = 1; r <= halo; ++r)
      for (Index i = 0; i <= n - r; ++i) places.push_back(in_triangle_patch(n, side, {r + i, -r}));
  return places;
}

std::vector<Offset> triangle_inner_places(Index n) {
  std::vector<Offset> places;
  places.reserve(static_cast<std::size_t>((n - 1) * (n - 2) / 2));
  for (Index y = 1; y < n; ++y)
    for (Index x = 1; x + y < n; ++x) places.push_back({x, y});
  return places;
}

TriangleTopology triangle_topology(const Mesh& mesh, Index f) {
  TriangleTopology face;
  for (std::size_t side = 0; side < 3; ++side) {
    const Index h = 3 * f + static_cast<Index>(side), twin = mesh.twin(h);
    face.corners[side] = mesh.origin(h);
    face.sides[side] = edge_code(mesh, h);
    if (twin == kNone) continue;
    const Index next = mesh.next(twin), prev = mesh.next(next), across = mesh.face(twin);
    face.across[side] = {across, next - 3 * across, mesh.origin(prev), edge_code(mesh, next),
                         edge_code(mesh, prev)};
  }
  return face;
}

TriangleFrames::TriangleFrames(const TriangleLayout& layout, Index halo)
    : layout_(layout), halo_(halo) {
  // row r beyond a side is column r of the neighbour in the frame of its half-edge `next`
  const Index n = layout.n();
  for (Index r = 1; r <= halo; ++r)
    rows_.push_back({{{r - 1, n - 2, -1},
                      {layout.row_begin(r) + n - r - 2, -1, 0},
                      {layout.row_begin(n - r - 1), -r, -1}}});
}

void TriangleFrames::number(const TriangleTopology& face, Index* out) const {
  const TriangleLayout at = layout_;  // here, as the numbers that are written might be its own
  const Index n = at.n();
  out = std::copy(face.corners.begin(), face.corners.end(), out);
  if (n > 1)
    for (const EdgeCode side : face.sides) {
      const AlongEdge along(at, side);
      for (Index t = 1; t < n; ++t) *out++ = along(t);
    }
  for (const TriangleTopology::Neighbour& across : face.across)
    for (Index r = 1; r <= halo_; ++r) {
      const Index last = n - r;
      if (across.face == kNone || last == 0) {
        out = std::fill_n(out, last + 1, across.face == kNone ? face.corners[0] : across.apex);
        continue;
      }
      *out++ = at.point_along(across.next, r);
      auto [number, step, bend] =
          rows_[static_cast<std::size_t>(r - 1)][static_cast<std::size_t>(across.side)];
      number += at.face_begin(across.face);
      for (Index y = 1; y < last; ++y, step += bend) {
        *out++ = number;
        number += step;
      }
      *out++ = at.point_along(across.prev, last);
    }
}

}  // namespace limn::fast
