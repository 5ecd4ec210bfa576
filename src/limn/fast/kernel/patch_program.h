#pragma once
/// A patch plan's shape in the slots of a local grid.

#include "limn/fast/kernel/step_plan.h"

namespace limn::fast {

/// New points of one stencil: the local slots of their anchors, and where they go in the line.
struct StencilPoints {
  std::size_t stencil = 0;
  std::vector<Index> anchors, places;
};

/// A part of a run: its points first … first + count - 1.
struct RunPart {
  std::size_t run = 0;
  Index first = 0, count = 0;
};

/// New points that are made together and put into a line, which stays in the nearest cache.
struct PatchBlock {
  std::vector<StencilPoints> points;
  std::vector<RunPart> parts;  ///< of the line, in its order
};

struct PatchProgram {
  Index pitch = 1;                  ///< slots from a row to the next
  Index slots = 1;                  ///< of the local grid: all places that are read or weighed
  Index line = 0;                   ///< the largest block's points
  std::vector<Index> frame, inner;  ///< slots of the shape's old points
  std::vector<PatchBlock> blocks;

  [[nodiscard]] Index slot_step(Offset step) const { return step.b * pitch + step.a; }
};

/// A new point takes from `each` stencils, from the one that it names on.
[[nodiscard]] PatchProgram make_patch_program(const PatchShape& shape,
                                              const std::vector<Stencil>& stencils,
                                              std::size_t each = 1);

}  // namespace limn::fast
