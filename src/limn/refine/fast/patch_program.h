#pragma once
/// What is to be done for each patch of a level, as data: which points are read into a local grid,
/// and which fine points are made from it. The same for all patches of the level.

#include <vector>

#include "limn/refine/fast/stencil_tables.h"

namespace limn::fast {

/// Fine points of one class: the local slots of their anchors, and where they go in the line.
struct ClassPoints {
  std::vector<Index> anchors, places;
};

/// Fine points that are made together and put into a line: first those along the sides, if any,
/// then inner ones.
struct PatchBlock {
  std::array<ClassPoints, kClasses> classes;
  Index side = 0;  ///< points along each of the three sides, from one end to the other without them
  Index inner = 0;  ///< inner points, row by row, from where the block before ends
};

struct PatchProgram {
  Index n = 1;     ///< coarse edges along a side
  Index halo = 0;  ///< rows beyond the sides
  Index pitch = 1;
  Index slots = 1;                 ///< of the local grid
  std::vector<Index> inner_slots;  ///< of the coarse inner points, row by row
  std::vector<PatchBlock> blocks;  ///< the first has the sides
  Index line = 0;                  ///< the largest block's points

  /// The local slot of coarse point (x, y) of the patch, or beyond it.
  [[nodiscard]] Index slot(Index x, Index y) const { return (y + halo) * pitch + x + halo; }
  [[nodiscard]] Index slot_step(Offset step) const { return step.b * pitch + step.a; }
};

[[nodiscard]] PatchProgram make_patch_program(Index n, Index halo);

}  // namespace limn::fast
