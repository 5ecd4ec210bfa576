#include "limn/fast/layout/quad_frame.h"

#include <algorithm>

namespace limn::fast {
namespace {

/// Row r beyond a side, in the frame of the neighbour's half-edge.
inline void number_row(const QuadLayout& layout, const QuadTopology::Neighbour& across, Index r,
                       Index* out) {
  const Index n = layout.n();
  if (r < n) {
    out[0] = layout.point_along(across.prev, n - r);
    Index number = layout.inner_point(across.twin, 1, r);
    const Index step = layout.inner_step(across.twin);
    for (Index x = 1; x < n; ++x, number += step) out[x] = number;
    out[n] = layout.point_along(across.next, r);
  } else {  // the opposite side, which runs the other way
    out[0] = across.to;
    if (n > 1) {
      const AlongEdge along(layout, across.opposite);
      for (Index x = 1; x < n; ++x) out[x] = along(n - x);
    }
    out[n] = across.from;
  }
}

}  // namespace

Offset in_quad_patch(Index n, Index side, Offset point) {
  for (; side > 0; --side) point = {n - point.b, point.a};
  return point;
}

std::vector<Offset> quad_frame_places(Index n, Index halo) {
  std::vector<Offset> places;
  places.reserve(static_cast<std::size_t>(4 * n + 4 * halo * (n + 1)));
  for (Index side = 0; side < 4; ++side) places.push_back(in_quad_patch(n, side, {0, 0}));
  for (Index side = 0; side < 4; ++side)
    for (Index t = 1; t < n; ++t) places.push_back(in_quad_patch(n, side, {t, 0}));
  for (Index side = 0; side < 4; ++side)
    for (Index r = 1; r <= halo; ++r)
      for (Index x = n; x >= 0; --x) places.push_back(in_quad_patch(n, side, {x, -r}));
  return places;
}

std::vector<Offset> quad_inner_places(Index n) {
  std::vector<Offset> places;
  places.reserve(static_cast<std::size_t>((n - 1) * (n - 1)));
  for (Index y = 1; y < n; ++y)
    for (Index x = 1; x < n; ++x) places.push_back({x, y});
  return places;
}

QuadTopology quad_topology(const Mesh& mesh, Index f) {
  QuadTopology face;
  for (std::size_t side = 0; side < 4; ++side) {
    const Index h = 4 * f + static_cast<Index>(side), twin = mesh.twin(h);
    face.corners[side] = mesh.origin(h);
    face.sides[side] = edge_code(mesh, h);
    if (twin == kNone) continue;
    const Index next = QuadLayout::turned(twin, 1), opposite = QuadLayout::turned(twin, 2),
                prev = QuadLayout::turned(twin, 3);
    face.across[side] = {twin,
                         edge_code(mesh, next),
                         edge_code(mesh, prev),
                         edge_code(mesh, opposite),
                         mesh.origin(opposite),
                         mesh.origin(prev)};
  }
  return face;
}

void QuadFrames::number(const QuadTopology& face, Index* out) const {
  const QuadLayout at = layout_;  // here, as the numbers that are written might be its own
  const Index n = at.n();
  out = std::copy(face.corners.begin(), face.corners.end(), out);
  if (n > 1)
    for (const EdgeCode side : face.sides) {
      const AlongEdge along(at, side);
      for (Index t = 1; t < n; ++t) *out++ = along(t);
    }
  for (const QuadTopology::Neighbour& across : face.across)
    for (Index r = 1; r <= halo_; ++r, out += n + 1) {
      if (across.twin != kNone)
        number_row(at, across, r, out);
      else
        std::fill_n(out, n + 1, face.corners[0]);
    }
}

}  // namespace limn::fast
