#pragma once
/// Pieces of a step (step_pieces.h), taken in groups, so that of the level before only what a group
/// reads need be in memory at once.

#include <vector>

#include "limn/fast/kernel/step_pieces.h"

namespace limn::fast {

/// Pieces first … last - 1, and the pieces of the step before that make all that they read.
struct PieceGroup {
  Index first = 0, last = 0;
  std::vector<Index> sources;
};

/// All pieces in groups that follow one another, each as large as it can be with no more than
/// `most` vertices of the level before, but at least one piece. `own_vertices` as for
/// StepPieces::sources.
[[nodiscard]] std::vector<PieceGroup> group_pieces(const StepPieces& pieces,
                                                   const StepPieces& before, Index most,
                                                   bool own_vertices);

}  // namespace limn::fast
