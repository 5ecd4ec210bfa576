#pragma once
/// The frame of a patch: the old points that it reads besides its own inner ones, in the order of
/// their places and as numbers.

#include <array>

#include "limn/fast/kernel/step_plan.h"
#include "limn/fast/layout/triangle_layout.h"

namespace limn::fast {

/// Of a patch of n edges a side: its corners, the inner points of its sides, and `halo` ≤ n rows
/// beyond each side.
[[nodiscard]] std::vector<Offset> triangle_frame_places(Index n, Index halo);

/// The inner points of a patch, row by row.
[[nodiscard]] std::vector<Offset> triangle_inner_places(Index n);

/// Where point (a, b) of the frame of side 0, 1 or 2 lies in the patch.
[[nodiscard]] Offset in_triangle_patch(Index n, Index side, Offset point);

/// What the numbers round a control face depend on, whatever the level: read from the mesh once.
struct TriangleTopology {
  /// The face across a side, seen from that side's half-edge there.
  struct Neighbour {
    Index face = kNone;  ///< kNone: there is none
    Index side = 0;      ///< the number in the face of the half-edge that comes next
    Index apex = 0;      ///< the corner that is not on the side
    EdgeCode next = 0, prev = 0;
  };
  std::array<Index, 3> corners{};
  std::array<EdgeCode, 3> sides{};
  std::array<Neighbour, 3> across;
};
[[nodiscard]] TriangleTopology triangle_topology(const Mesh& mesh, Index f);

/// Finds the numbers of triangle_frame_places(layout.n(), halo), patch by patch.
class TriangleFrames {
 public:
  TriangleFrames(const TriangleLayout& layout, Index halo);
  /// Where there is no neighbour, a corner's. Cost some 0.5 ns a number.
  void number(const TriangleTopology& face, Index* out) const;

 private:
  /// The numbers of the inner points of a row, less the face's first: start, start + step, …, each
  /// step by `bend` more than the one before.
  struct Sequence {
    Index start = 0, step = 0, bend = 0;
  };
  TriangleLayout layout_;
  Index halo_;
  std::vector<std::array<Sequence, 3>> rows_;  // beyond a side; by the neighbour's `side`
};

}  // namespace limn::fast
