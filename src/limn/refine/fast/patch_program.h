#pragma once
/// What is to be done for each patch of a level, as data: which points are read into a local grid,
/// and which runs of fine points are made from it. The same for all patches of the level.

#include <vector>

#include "limn/refine/fast/stencil_tables.h"

namespace limn::fast {

/// Consecutive fine points of a patch whose stencils alternate between two classes.
struct PatchRun {
  std::array<std::size_t, 2> classes{};  ///< of the first and the second, third and fourth, …
  std::array<Index, 2> anchors{};        ///< local slots of the first two points' anchors
  Index anchor_step = 0;                 ///< from the first's to the third's
  Index count = 0;
};

struct PatchProgram {
  Index n = 1;     ///< coarse edges along a side
  Index halo = 0;  ///< rows beyond the sides
  Index pitch = 1;
  Index slots = 1;  ///< of the local grid
  /// Along each side, from one end to the other without the ends; then the inner rows, in order.
  std::array<PatchRun, 3> sides;
  std::vector<PatchRun> rows;

  /// The local slot of coarse point (x, y) of the patch, or beyond it.
  [[nodiscard]] Index slot(Index x, Index y) const { return (y + halo) * pitch + x + halo; }
  [[nodiscard]] Index slot_step(Offset step) const { return step.b * pitch + step.a; }
};

[[nodiscard]] PatchProgram make_patch_program(Index n, Index halo);

}  // namespace limn::fast
