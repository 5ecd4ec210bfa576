#pragma once
/// The frame of a patch of quads: the old points that it reads besides its own inner ones, in the
/// order of their places and as numbers.

#include "limn/fast/kernel/step_plan.h"
#include "limn/fast/layout/quad_layout.h"

namespace limn::fast {

/// Of a patch of n edges a side: its corners, the inner points of its sides, and `halo` ≤ n rows
/// beyond each side, each from the side's target to its origin.
[[nodiscard]] std::vector<Offset> quad_frame_places(Index n, Index halo);

/// The inner points of a patch, row by row.
[[nodiscard]] std::vector<Offset> quad_inner_places(Index n);

/// Where point (a, b) of the frame of side 0, 1, 2 or 3 lies in the patch.
[[nodiscard]] Offset in_quad_patch(Index n, Index side, Offset point);

/// What the numbers round a face depend on, whatever the level: read from the mesh once.
struct QuadTopology {
  /// The face across a side.
  struct Neighbour {
    Index twin = kNone;  ///< the side's half-edge there; kNone: there is none
    EdgeCode next = 0, prev = 0, opposite = 0;  ///< of the half-edges round the face from there
    Index from = 0, to = 0;                     ///< the ends of the opposite one
  };
  std::array<Index, 4> corners{};
  std::array<EdgeCode, 4> sides{};
  std::array<Neighbour, 4> across;
};
[[nodiscard]] QuadTopology quad_topology(const Mesh& mesh, Index f);

/// Finds the numbers of quad_frame_places(layout.n(), halo), patch by patch.
class QuadFrames {
 public:
  QuadFrames(const QuadLayout& layout, Index halo) : layout_(layout), halo_(halo) {}
  /// Where there is no neighbour, a corner's. Cost some 0.5 ns a number.
  void number(const QuadTopology& face, Index* out) const;

 private:
  QuadLayout layout_;
  Index halo_;
};

}  // namespace limn::fast
